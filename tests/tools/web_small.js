/*
 * web_small.js - pages and pictures of the site in fewer bytes: {svg, html}.
 *
 * svg(text): a picture of gnuplot's, to the eye the same (tests/cli/web.js looks).
 * Coordinates are whole tenths of a pixel, each from the last; what is repeated at
 * every line becomes a class; what has one style and no other between becomes one
 * path.  Other pictures stay as they are; what gnuplot has not written before is an
 * error.  html(text): without what no reader sees: the TeX beside a formula, and
 * marks for colours of code that book.css has not.
 */
"use strict";
const FINE = 10; /* of a pixel */
const fine = (x) => Math.round(FINE * x);

/* ---- reading ------------------------------------------------------------------- */

function parse(text) {
    const token = /<\?[^>]*>|<!--[^]*?-->|<(\/?)([\w:]+)((?:\s+[\w:-]+\s*=\s*(?:"[^"]*"|'[^']*'))*)\s*(\/?)>|[^<]+/g;
    const root = {name: "", own: {}, inside: []}, open = [root];
    for (const [whole, ends, name, attributes, empty] of text.matchAll(token)) {
        const last = open[open.length - 1];
        if (whole[0] !== "<") last.inside.push(whole);
        else if (ends) open.pop();
        else if (name) {
            const own = {};
            for (const [, key, , a, b] of attributes.matchAll(/([\w:-]+)\s*=\s*("([^"]*)"|'([^']*)')/g))
                own[key] = a ?? b;
            const node = {name, own, inside: []};
            last.inside.push(node);
            if (!empty) open.push(node);
        }
    }
    if (open.length !== 1) throw new Error(`<${open.pop().name}> is not closed`);
    return root.inside.find((node) => node.name === "svg");
}

const hex = (c) => Number(c).toString(16).padStart(2, "0");
function colour(text) {
    const rgb = /^rgb\(([\d, ]+)\)$/.exec(text);
    const all = rgb ? "#" + rgb[1].split(",").map(hex).join("") : text.toLowerCase();
    return all.replace("black", "#000").replace(/^#(.)\1(.)\2(.)\3$/, "#$1$2$3");
}

/* ---- paths: lists of points, of which some are closed ---------------------------- */

function subpaths(d) {
    const lists = [];
    for (const [, letter, numbers] of d.matchAll(/([A-Za-z])([^A-Za-z]*)/g)) {
        const at = (numbers.match(/-?[\d.]+/g) || []).map(Number);
        if (letter === "M") lists.push({points: [], closed: false});
        const last = lists[lists.length - 1];
        if (/z/i.test(letter)) last.closed = true;
        else if (!/[ML]/.test(letter)) throw new Error(`path with ${letter}`);
        for (let k = 0; k < at.length; k += 2) last.points.push([FINE * at[k], FINE * at[k + 1]]);
    }
    return lists;
}

/* A curve without the points that are less than half a tenth of a pixel beside it:
 * between neighbours that are close, rounding would turn a thick line about. */
function fewer(p) {
    const [a, b] = [p[0], p[p.length - 1]], long = Math.hypot(b[0] - a[0], b[1] - a[1]);
    let most = 0.5, at = 0;
    for (let k = 1; k < p.length - 1; k++) {
        const far = long > 0 && along(a, b, p[k]) ? Math.abs(turn(a, b, p[k])) / long
            : Math.min(...[a, b].map((c) => Math.hypot(p[k][0] - c[0], p[k][1] - c[1])));
        if (far > most) [most, at] = [far, k];
    }
    return at === 0 ? [a, b] : [...fewer(p.slice(0, at + 1)).slice(0, -1), ...fewer(p.slice(at))];
}
const along = (a, b, c) => [[a, b], [b, a]].every(([f, t]) =>
    (t[0] - f[0]) * (c[0] - f[0]) + (t[1] - f[1]) * (c[1] - f[1]) >= 0);

/* Without points that have become equal; what is filled goes round one way. */
function tidy(lists, {filled, dots}) {
    return lists.map(({points: exact, closed, arc}) => {
        const points = (filled || exact.length < 3 ? exact : fewer(exact)).map((c) => c.map(Math.round));
        if (arc) return {points, closed, arc};
        let p = points.filter(([x, y], k) => k === 0 || x !== points[k - 1][0] || y !== points[k - 1][1]);
        const [first, last] = [p[0], p[p.length - 1]];
        if ((closed || filled) && p.length > 1 && first[0] === last[0] && first[1] === last[1])
            p = p.slice(0, -1);
        return {points: filled && area(p) < 0 ? p.reverse() : p, closed: closed || filled};
    }).filter(({points: {length}, arc}) => filled ? length > 2 : length > 1 || arc || dots);
}
const turn = (a, b, c) => (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
const area = (p) => p.reduce((sum, a, k) => sum + turn([0, 0], a, p[(k + 1) % p.length]), 0);
/* Of such polygons several may be one path: none cuts a hole into another. */
const convex = ({points: p}) => {
    const bends = p.map((a, k) => {
        const [b, c] = [p[(k + 1) % p.length], p[(k + 2) % p.length]];
        return Math.atan2(turn(a, b, c), (b[0] - a[0]) * (c[0] - b[0]) + (b[1] - a[1]) * (c[1] - b[1]));
    });
    return bends.every((angle) => angle >= 0) && bends.reduce((sum, angle) => sum + angle) < 6.5;
};

function written(lists) {
    let text = "", letter = "", at = [0, 0];
    const add = (name, ...numbers) => {
        if (name !== letter) text += letter === "m" && name === "l" ? "" : name;
        const bare = name === letter || (letter === "m" && name === "l");
        numbers.forEach((n, k) => { text += (n >= 0 && (k > 0 || bare) ? " " : "") + n; });
        letter = name;
    };
    for (const {points, closed, arc} of lists) {
        add("m", points[0][0] - at[0], points[0][1] - at[1]);
        at = points[0];
        for (const p of points.slice(1)) {
            const [dx, dy] = [p[0] - at[0], p[1] - at[1]];
            if (dy === 0) add("h", dx);
            else if (dx === 0) add("v", dy);
            else add("l", dx, dy);
            at = p;
        }
        if (arc) for (const way of [2, -2]) add("a", arc, arc, 0, 1, 0, way * arc, 0);
        else if (points.length === 1) add("h", 0);
        if (closed) { add("z"); at = points[0]; }
    }
    return text;
}

/* ---- gnuplot's symbols ----------------------------------------------------------- */

const CROSS = [[[-1, 0], [1, 0]], [[0, -1], [0, 1]]], X = [[[-1, -1], [1, 1]], [[-1, 1], [1, -1]]];
const SQUARE = [[-1, -1], [1, -1], [1, 1], [-1, 1]], UP = [[0, -1.33], [-1.33, 0.67], [1.33, 0.67]];
const DOWN = UP.map(([x, y]) => [-x, -y]), R = Math.SQRT2, DIAMOND = [[0, -R], [R, 0], [0, R], [-R, 0]];
const LINES = [CROSS, X, [...CROSS, ...X]];
const SHAPES = [, , , SQUARE, SQUARE, , , UP, UP, DOWN, DOWN, DIAMOND, DIAMOND];
function symbol(own, style, thick) {
    const place = /^translate\(([-\d.]+),([-\d.]+)\) scale\(([\d.]+)\)$/.exec(own.transform);
    const k = Number(/^#gpPt(\d+)$/.exec(own["xlink:href"])?.[1]);
    if (!place || !(k < 13)) throw new Error("a symbol " + JSON.stringify(own));
    const [x, y, s] = place.slice(1).map(Number), line = thick * s;
    const points = (list) => list.map(([a, b]) => [fine(x + s * a), fine(y + s * b)]);
    const look = {stroke: colour(own.color || style.color), "stroke-width": line,
                  ...(style["stroke-dasharray"] && {"stroke-dasharray": style["stroke-dasharray"]
                      .split(",").map((n) => n * s).join(",")})};
    if (k === 6) /* a disc is a line of no length with round ends */
        return [{stroke: look.stroke, "stroke-width": 2 * s + line, "stroke-linecap": "round"},
                [{points: points([[0, 0]])}]];
    if (k === 5) return [look, [{points: points([[-1, 0]]), arc: fine(s), closed: true}]];
    if (k < 3) return [look, LINES[k].map((list) => ({points: points(list)}))];
    if (k % 2 === 0) look.fill = look.stroke;
    return [look, [{points: points(SHAPES[k]), closed: true}]];
}

/* ---- the leaves, each with all of its style --------------------------------------- */

const STYLE = ["fill", "stroke", "color", "stroke-width", "stroke-linecap", "stroke-linejoin",
    "stroke-dasharray", "font-family", "font-size", "font-weight", "font-style", "text-anchor",
    "shape-rendering", "fill-opacity", "opacity"];
const UNSEEN = ["class", "id", "xml:space", "transform", "x", "y", "d", "points", "dy", "width", "height"];
const USUAL = {fill: "none", stroke: "none", "stroke-linecap": "butt", "stroke-linejoin": "miter",
    "text-anchor": "start", "font-weight": "normal", "font-style": "normal", "fill-opacity": "1", opacity: "1"};
function styled(style, own) {
    const both = {...style};
    for (const key in own)
        if (STYLE.includes(key)) both[key] = own[key];
        else if (!UNSEEN.includes(key)) throw new Error(`attribute ${key}`);
    return both;
}
/* What of it shows, as attributes. */
function seen(style, keys) {
    const all = {};
    for (const key of keys) {
        let value = style[key];
        if (value === undefined) continue;
        if (key === "fill" || key === "stroke")
            value = colour(value === "currentColor" ? style.color : value);
        if (/width|size|array/.test(key))
            value = String(value).trim().split(/[ ,]+/).map((n) => Math.round(FINE * parseFloat(n))).join(" ");
        if (value !== USUAL[key] && !(/^stroke-/.test(key) && !all.stroke)) all[key] = value;
    }
    return all;
}
const SHAPE = STYLE.filter((key) => !/color|font|anchor/.test(key));
const LETTERS = STYLE.filter((key) => /fill|font|anchor|opacity/.test(key));

function leaves(svg) {
    const list = [], thick = Number(/id='gpPt0' stroke-width='([\d.]+)'/.exec(svg.text)?.[1]);
    const shape = (look, lists) => {
        const filled = look.fill && !look.stroke, strokes = look.stroke && !look.fill;
        const rest = tidy(lists, {filled, dots: look["stroke-linecap"]});
        if (rest.length === 0 || !(look.fill || look.stroke)) return;
        const joins = !look.opacity && !look["fill-opacity"] &&
            (strokes || look.fill === look.stroke || rest.every(convex));
        const key = JSON.stringify(look), last = list[list.length - 1];
        if (joins && last?.joins && last.key === key) last.lists.push(...rest);
        else list.push({look, key, joins, lists: rest});
    };
    const walk = (node, style, transform) => {
        const {name, own} = node;
        if (typeof node === "string" || /^(title|desc|defs)$/.test(name)) return;
        if (name === "use") return shape(...symbolOf(own, style));
        const now = styled(style, own);
        if (name === "text") return list.push({look: seen(now, LETTERS), transform,
            space: own["xml:space"], text: words(node, now)});
        if (own.transform && transform) throw new Error("two transforms");
        if (name === "g")
            return node.inside.forEach((one) => walk(one, now, own.transform || transform));
        if (transform) throw new Error(`${name} with a transform`);
        const look = seen(now, SHAPE);
        if (name === "path") return shape(look, subpaths(own.d));
        if (name === "polygon") return shape(look, subpaths("M" + own.points).map((one) =>
            ({...one, closed: true})));
        if (name !== "rect") throw new Error(`element ${name}`);
        const [x, y, w, h] = ["x", "y", "width", "height"].map((key) => Number(own[key]));
        shape(look, subpaths(`M${x},${y} ${x + w},${y} ${x + w},${y + h} ${x},${y + h}Z`));
    };
    const symbolOf = (own, style) => {
        const [look, lists] = symbol(own, style, thick);
        return [seen(look, SHAPE), lists];
    };
    svg.inside.forEach((node) => walk(node, {}, ""));
    return list;
}

/* A text's spans; what says nothing new is left out. */
function words(node, style) {
    return node.inside.map((one, k) => {
        if (typeof one === "string") return one;
        const now = styled(style, one.own), inside = words(one, now);
        const [before, after] = [seen(style, LETTERS), seen(now, LETTERS)];
        const more = Object.entries(after).filter(([key, value]) => before[key] !== value);
        if (one.own.dy) more.push(["dy", fine(parseFloat(one.own.dy))]);
        if (inside === "" && !node.inside.slice(k + 1).some((next) => next.inside?.length)) return "";
        if (more.length === 0) return inside;
        return `<tspan${attributes(Object.fromEntries(more))}>${inside}</tspan>`;
    }).join("");
}

/* ---- writing ------------------------------------------------------------------------ */

const attributes = (all) => Object.entries(all).map(([key, value]) => ` ${key}="${value}"`).join("");

exports.svg = (text) => {
    if (!text.includes('<g id="gnuplot_canvas">')) return text;
    const svg = parse(text), {width, height} = svg.own, times = new Map();
    const list = leaves({...svg, text});
    for (const {look} of list)
        times.set(JSON.stringify(look), (times.get(JSON.stringify(look)) || 0) + 1);
    const often = [...times].filter(([, n]) => n > 1).sort((a, b) => b[1] - a[1]).map(([key]) => key);
    const name = (k) => (k < 26 ? "" : name(Math.floor(k / 26) - 1)) + String.fromCharCode(97 + k % 26);
    const rules = often.map((key, k) => `.${name(k)}{` + Object.entries(JSON.parse(key)).map(
        ([property, value]) => `${property}:${value}${property === "font-size" ? "px" : ""}`).join(";") + "}");
    const elements = list.map(({look, lists, transform, space, text: inside}) => {
        const k = often.indexOf(JSON.stringify(look));
        const style = k < 0 ? attributes(look) : ` class="${name(k)}"`;
        if (lists) return `<path${style} d="${written(lists)}"/>`;
        const place = /^translate\(([-\d.]+),([-\d.]+)\)(?: rotate\(([-\d.]+)\))?$/.exec(transform);
        if (!place) throw new Error("a text at " + transform);
        const [x, y] = [fine(place[1]), fine(place[2])];
        return `<text${style}${Number(place[3]) ? ` transform="translate(${x} ${y})rotate(${Number(place[3])})"`
            : ` x="${x}" y="${y}"`}${space ? ` xml:space="${space}"` : ""}>${inside}</text>`;
    });
    return `<svg xmlns="http://www.w3.org/2000/svg" width="${width}" height="${height}" viewBox="0 0 ` +
        `${FINE * width} ${FINE * height}" fill="none">${rules.length ? `<style>${rules.join("")}</style>` : ""}` +
        elements.join("\n") + "</svg>\n";
};

exports.html = (text) => text
    .replace(/<annotation[^]*?<\/annotation>|<\/?semantics>/g, "")
    .replace(/<math display="inline"/g, "<math")
    .replace(/ xmlns="http:\/\/www.w3.org\/1998\/Math\/MathML"/g, "")
    .replace(/<pre class="sourceCode[^]*?<\/pre>/g, (pre) => pre.replace(/<\/?span[^>]*>|<a href="#cb[^>]*><\/a>/g, ""));
