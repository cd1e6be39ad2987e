/*
 * plot.js - pictures of tables as SVG: two columns, and a body with its triangles.
 */
"use strict";
const INKS = 6; /* colours of web.css */

function picture(width, height, label) {
    return drawn("svg", document.createDocumentFragment(),
                 {viewBox: `0 0 ${width} ${height}`, role: "img", "aria-label": label});
}

function short(x) {
    const text = x !== 0 && (Math.abs(x) < 1e-3 || Math.abs(x) >= 1e5)
        ? String(Number(x.toPrecision(4)).toExponential()) : String(Number(x.toPrecision(4)));
    return text.replace("e+", "e");
}

/* Return the least and the largest; Math.min has a limit of arguments. */
function extent(numbers) {
    let least = Infinity, most = -Infinity;
    for (const x of numbers) {
        if (x < least) least = x;
        if (x > most) most = x;
    }
    return [least, most];
}

/* Return an axis over these numbers: at(x) from 0 to 1, and its ticks.  Round
 * steps of 1, 2 or 5; with log whole decades, every k-th if there are many. */
function axis(numbers, log) {
    let [from, to] = extent(numbers);
    const ticks = [];
    if (log) {
        from = Math.floor(Math.log10(from));
        to = Math.max(from + 1, Math.ceil(Math.log10(to)));
        const step = Math.ceil((to - from) / 6);
        for (let k = from; k <= to; k += step) ticks.push(10 ** k);
        return {ticks, at: (x) => (Math.log10(x) - from) / (to - from)};
    }
    if (!(to - from > 1e-12 * Math.max(Math.abs(from), Math.abs(to)))) {
        const wide = Math.abs(from) || 1;
        from -= 0.5 * wide;
        to += 0.5 * wide;
    }
    const decade = 10 ** Math.floor(Math.log10((to - from) / 4));
    const step = [1, 2, 5, 10].map((k) => k * decade).find((s) => (to - from) / s <= 6);
    for (let k = Math.ceil(from / step - 1e-9); k * step <= to + 1e-9 * step; k++)
        ticks.push(k * step);
    return {ticks, at: (x) => (x - from) / (to - from)};
}

/* Return the points of two columns that can be drawn, a list for each word of the key. */
function curves(table, {x, y, key, logx, logy}) {
    const [i, j, k] = [x, y, key].map((name) => table.columns.indexOf(name));
    const lists = new Map();
    for (const row of table.rows) {
        const [a, b] = [parseFloat(row[i]), parseFloat(row[j])];
        if (!isFinite(a) || !isFinite(b) || (logx && a <= 0) || (logy && b <= 0)) continue;
        const name = k < 0 ? "" : row[k];
        if (!lists.has(name)) lists.set(name, []);
        lists.get(name).push([a, b]);
    }
    return lists;
}

/* Draw a table.  The width in pixels gives the letters the size of the page's.  The
 * curves of the reference lie below the others. */
function plot(table, setting, width, reference = null) {
    const lists = curves(table, setting);
    const below = reference ? [...curves(reference, setting).values()] : [];
    const all = [...lists.values(), ...below].flat();
    const {x, y, logx, logy} = setting;
    const what = `${y} over ${x} of table ${table.name}`;
    if (all.length === 0) return picture(width, 20, `${what}: no numbers to draw`);
    const names = [...lists.keys()].filter((name) => name !== "" || reference).slice(0, INKS);
    const W = width, H = Math.round(0.3 * W + 170), left = 78, right = 12, foot = 46;
    const top = 14 + 18 * (names.length + (reference ? 1 : 0));
    const across = axis(all.map((p) => p[0]), logx), up = axis(all.map((p) => p[1]), logy);
    const px = (v) => left + (W - left - right) * across.at(v);
    const py = (v) => H - foot - (H - top - foot) * up.at(v);
    const range = (c) => extent(all.map((p) => p[c])).map(short).join(" to ");
    const svg = picture(W, H, `${what}: ${all.length} points, ${x} from ${range(0)}, ` +
        `${y} from ${range(1)}`);
    for (const t of across.ticks) {
        drawn("path", svg, {class: "grid", d: `M${px(t)},${top}V${H - foot}`});
        drawn("text", svg, {x: px(t), y: H - foot + 18, "text-anchor": "middle", text: short(t)});
    }
    for (const t of up.ticks) {
        drawn("path", svg, {class: "grid", d: `M${left},${py(t)}H${W - right}`});
        drawn("text", svg, {x: left - 6, y: py(t) + 4, "text-anchor": "end", text: short(t)});
    }
    drawn("text", svg, {x: (left + W - right) / 2, y: H - 8, "text-anchor": "middle",
                        text: x + (logx ? " (log)" : "")});
    drawn("text", svg, {"text-anchor": "middle", text: y + (logy ? " (log)" : ""),
                        transform: `translate(12 ${(top + H - foot) / 2}) rotate(-90)`});
    const places = (points) => points.map((p) => `${px(p[0]).toFixed(1)},${py(p[1]).toFixed(1)}`).join(" ");
    for (const points of below)
        drawn("polyline", svg, {class: "curve reference", points: places(points)});
    if (reference) {
        drawn("path", svg, {class: "curve reference", d: `M${left},${12 + 18 * names.length}h24`});
        drawn("text", svg, {x: left + 30, y: 16 + 18 * names.length, text: "reference"});
    }
    [...lists].forEach(([name, points], n) => {
        const ink = `ink${n % INKS}`;
        drawn("polyline", svg, {class: `curve ${ink}`, points: places(points)});
        if (points.length <= 80)
            for (const p of points)
                drawn("circle", svg, {class: ink, cx: px(p[0]), cy: py(p[1]), r: 2.6});
        if (names.includes(name)) {
            drawn("path", svg, {class: `curve ${ink}`, d: `M${left},${12 + 18 * n}h24`});
            drawn("text", svg, {x: left + 30, y: 16 + 18 * n, text: name || "yours"});
        }
    });
    return svg;
}

/* Bodies of a table with columns X Y u_x u_y, one after the other where it has
 * several: its vertices row by row, as common/plane/mesh.h numbers them, each cell
 * cut from its lower left to its upper right corner.  Or of triangles with J, x0 to
 * y2 and the frame k; or of particles with x y and F.  A body is {corners: lists of
 * [x, y], J: of each}, or {points, J}. */
function bodies(table) {
    const column = (name) => table.columns.indexOf(name);
    const take = (names) => names.map(column);
    const number = (row, i) => parseFloat(row[i]);
    const moved = take(["X", "Y", "u_x", "u_y"]);
    const particles = take(["x", "y", "F11", "F12", "F21", "F22"]);
    if (table.rows.length > 2 && !particles.includes(-1)) {
        const rows = table.rows.map((row) => particles.map((i) => number(row, i)));
        return [{points: rows.map((r) => [r[0], r[1]]),
                 J: rows.map((r) => r[2] * r[5] - r[3] * r[4])}];
    }
    const film = take(["k", "J", "x0", "y0", "x1", "y1", "x2", "y2"]);
    if (!film.includes(-1)) {
        const frames = {};
        for (const row of table.rows) (frames[row[film[0]]] ||= []).push(row);
        return Object.values(frames).map((rows) => ({
            J: rows.map((row) => number(row, film[1])),
            corners: rows.map((row) => [2, 4, 6].map((c) =>
                [number(row, film[c]), number(row, film[c + 1])]))}));
    }
    if (moved.includes(-1)) return [];
    const vertex = table.rows.map((row) => moved.map((i) => number(row, i)));
    const same = (a, b, i) => Math.abs(a[i] - b[i]) < 1e-12;
    const starts = vertex.flatMap((v, a) =>
        same(v, vertex[0], 0) && same(v, vertex[0], 1) ? [a] : []);
    return starts.map((start, s) => body(vertex.slice(start, starts[s + 1]))).filter(Boolean);
}

function body(vertex) {
    const wide = vertex.findIndex((v) => v[1] !== vertex[0][1]);
    if (wide < 2 || vertex.length % wide !== 0) return null;
    const corners = [], J = [];
    for (let a = 0; a + wide + 1 < vertex.length; a++) {
        if (a % wide === wide - 1) continue;
        for (const t of [[a, a + 1, a + wide + 1], [a, a + wide + 1, a + wide]]) {
            const area = (p) => (p[1][0] - p[0][0]) * (p[2][1] - p[0][1]) -
                                (p[2][0] - p[0][0]) * (p[1][1] - p[0][1]);
            const X = t.map((b) => vertex[b]);
            const x = X.map((v) => [v[0] + v[2], v[1] + v[3]]);
            corners.push(x);
            J.push(area(x) / area(X));
        }
    }
    return {corners, J};
}

/* Blue where it is pressed, white at rest, orange where it is stretched, magenta
 * where J <= 0, as in the window of lesson 24. */
function colour(J) {
    if (!(J > 0)) return "rgb(214 0 190)";
    const s = Math.max(-1, Math.min(1, Math.log2(J))), t = Math.abs(s);
    const c = s > 0 ? [235, 120, 20] : [33, 102, 196];
    return `rgb(${c.map((k) => Math.round(250 + t * (k - 250))).join(" ")})`;
}

function drawBody(name, {corners, points, J}, width, reference = null) {
    const at = [points, corners?.flat(), reference?.points, reference?.corners?.flat()]
        .filter(Boolean).flat();
    const [x0, x1] = extent(at.map((p) => p[0])), [y0, y1] = extent(at.map((p) => p[1]));
    const W = width, scale = Math.min((W - 20) / (x1 - x0), (0.3 * W + 230) / (y1 - y0));
    const H = scale * (y1 - y0) + 20, shift = (W - scale * (x1 - x0)) / 2;
    const inverted = J.filter((j) => !(j > 0)).length;
    const svg = picture(W, H, `The ${corners ? "body, " + J.length + " triangles" : J.length +
        " particles"} of table ${name}: J from ` +
        `${extent(J).map(short).join(" to ")}, ${inverted} inverted`);
    const pixel = (p) => [shift + scale * (p[0] - x0), H - 10 - scale * (p[1] - y0)]
        .map((c) => c.toFixed(1));
    J.forEach((j, e) => {
        if (corners)
            drawn("polygon", svg, {class: "element", fill: colour(j),
                                  points: corners[e].map(pixel).join(" ")});
        else {
            const [cx, cy] = pixel(points[e]);
            drawn("circle", svg, {class: "element", fill: colour(j), cx, cy, r: 4});
        }
    });
    for (const t of reference?.corners || [])
        drawn("polygon", svg, {class: "outline", points: t.map(pixel).join(" ")});
    for (const p of reference?.points || []) {
        const [cx, cy] = pixel(p);
        drawn("circle", svg, {class: "outline", cx, cy, r: 4});
    }
    return svg;
}
