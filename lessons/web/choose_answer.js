/*
 * choose_answer.js - the answer of choose.html: what the program prints, its
 * answer in a frame, lessons as links; and what it draws.
 */
'use strict';
(() => {
/* The lines without a blank at the front are heads, those that follow their text.
 * A head goes on where the next line begins with a small letter, and the first, the
 * answer, until there is text or an empty line; its text is why it is in doubt. */
function sections(out) {
    const all = [];
    let answer = true;
    for (const line of out.split('\n')) {
        const head = line && line[0] !== ' ', now = all[all.length - 1];
        answer = answer && line !== '';
        if (!line) continue;
        if (!head) now.text.push(line);
        else if (now && !now.text.length && (answer || /^[a-z]/.test(line)))
            now.head += ' ' + line;
        else all.push({ head: line, text: [] });
    }
    return all;
}
function linked(text, parent) {
    let at = 0;
    for (const found of text.matchAll(/lesson (\d+)/g)) {
        const page = self.choose.lessons[found[1]];
        parent.append(text.slice(at, found.index));
        if (page) made('a', parent, { href: page, text: found[0] });
        else parent.append(found[0]);
        at = found.index + found[0].length;
    }
    parent.append(text.slice(at));
}
self.showAnswer = (answer, said, name, scene, options) => {
    const all = sections(said.out);
    all.forEach((part, k) => {
        const section = made('section', answer, { class: k ? '' :
            /^NOT SURE/.test(part.head) ? 'least doubt' : 'least' });
        linked(part.head, made('h2', section, {}));
        if (part.text.length) linked(part.text.map(line => line.slice(2)).join('\n'),
                                     made('pre', section, {}));
        if (/^Price/.test(part.head)) made('p', section, { class: 'says', text: 'The ' +
            'milliseconds were measured just now, in this browser, which compiled the program ' +
            'while it was choosing; make choose measures those of your machine.' });
        if (k === 0 && said.files.picture) picture(said.files.picture, section);
    });
    const file = made('details', made('section', answer, {}), {});
    made('summary', file, { text: 'The scene as a file' });
    made('pre', file, { text: scene });
    made('p', file, { class: 'says', text: 'Save it as ' + name + ', then ' +
        'make choose SCENE=' + name + ' ' + options });
};

/* Parts of the error as bars, and the body at rest and under the load. */
function picture(text, parent) {
    const lines = text.split('\n'), allowed = Number(lines[0].split('\t')[1]);
    let k = 1;
    const parts = [];
    for (; lines[k]; k++) parts.push(lines[k].split('\t'));
    const corners = [[]];
    for (; k < lines.length; k++)
        if (lines[k]) corners[corners.length - 1].push(lines[k].split('\t').map(Number));
        else if (corners[corners.length - 1].length) corners.push([]);
    const triangles = corners.filter(one => one.length);
    const both = made('div', parent, { class: 'pictures' });

    const figure = made('figure', both, {});
    const bars = drawn('svg', figure, { viewBox: '0 0 400 ' + (28 * parts.length + 46),
        role: 'img', 'aria-label': 'Parts of the error in per cent, of ' + allowed +
            ' allowed: ' + parts.map(([name, value]) => name + ' ' + shortNumber(Number(value)
                .toPrecision(2))).join(', ') });
    const most = 1.15 * Math.max(allowed, ...parts.map(part => Number(part[1])));
    const x = value => 96 + 250 * value / most, foot = 28 * parts.length + 22;
    parts.forEach(([name, value], i) => {
        const y = 22 + 28 * i, wide = Math.max(0, x(Number(value)) - 96);
        drawn('text', bars, { x: 90, y: y + 14, 'text-anchor': 'end', text: name });
        drawn('rect', bars, { x: 96, y, width: wide, height: 18,
            class: Number(value) > allowed ? 'over' : 'part' });
        drawn('text', bars, { x: 102 + wide, y: y + 14,
            text: shortNumber(Number(value).toPrecision(2)) + ' %' });
    });
    drawn('path', bars, { class: 'axis', d: `M96 16V${foot}` });
    drawn('path', bars, { class: 'allowed', d: `M${x(allowed)} 16V${foot}` });
    drawn('text', bars, { x: Math.min(x(allowed), 330), y: 12, 'text-anchor': 'middle',
        class: 'limit', text: 'allowed: ' + shortNumber(allowed) + ' %' });
    made('figcaption', figure, { text: 'Expected error, in per cent of what is asked for' });

    const low = [Infinity, Infinity], high = [-Infinity, -Infinity];
    for (const one of triangles) for (const c of one)
        for (let i = 0; i < 4; i++) {
            low[i % 2] = Math.min(low[i % 2], c[i]);
            high[i % 2] = Math.max(high[i % 2], c[i]);
        }
    const size = Math.max(high[0] - low[0], high[1] - low[1]), s = 380 / size;
    const tall = s * (high[1] - low[1]) + 20;
    const place = (a, b) => (10 + s * (a - low[0])).toFixed(1) + ' ' +
        (10 + s * (high[1] - b)).toFixed(1);
    const outline = from => triangles.map(one => 'M' + one.map(c =>
        place(c[from], c[from + 1])).join('L')).join('');
    const body = made('figure', both, {});
    const mesh = drawn('svg', body, { viewBox: '0 0 400 ' + Math.max(60, tall).toFixed(0),
        role: 'img', 'aria-label': 'The body at rest, and deformed under the load' });
    drawn('path', mesh, { class: 'rest', d: outline(0) });
    drawn('path', mesh, { class: 'loaded', d: outline(2) });
    made('figcaption', body, { text: 'Grey: at rest; blue: under the load, to scale (' +
        shortNumber((high[0] - low[0]).toPrecision(3)) + ' m wide)' });
}
})();
