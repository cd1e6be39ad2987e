/*
 * choose.js - `make choose` as a page: the words of the scene file as a form,
 * the answer of common/choice/choose.c, and its picture.
 *
 * Words, ranges, units and examples are those of choose_data.js, which `make web`
 * makes from the program.  What is wrong with a field the program says itself.
 */
'use strict';
(() => {
const LIMIT = 60; /* seconds of one run */
const box = document.querySelector('.least-model');

function made(tag, parent, attributes) {
    const element = document.createElement(tag);
    for (const name in attributes)
        if (name === 'text') element.textContent = attributes[name];
        else element.setAttribute(name, attributes[name]);
    return parent.appendChild(element);
}
function drawn(tag, parent, attributes) {
    const element = document.createElementNS('http://www.w3.org/2000/svg', tag);
    for (const name in attributes)
        if (name === 'text') element.textContent = attributes[name];
        else element.setAttribute(name, attributes[name]);
    return parent.appendChild(element);
}

/* ---- the form ---- */
const rows = self.choose.words.split('\n').filter(line => line && line[0] !== '#')
    .map(line => line.split('\t'));
const words = rows.slice(1).map(row => Object.fromEntries(rows[0].map((c, i) => [c, row[i]])));
for (const word of words) {
    word.n = Number(word.n);
    const [, says] = self.choose.says[word.word] || ['', word.unit.replace('-', '')];
    /* of the words in a list only what explains them */
    word.says = word.n ? says : says.includes(':') ? says.replace(/^or /, '') : '';
}
function short(number) {
    const value = Number(Number(number).toPrecision(6)), size = Math.abs(value);
    const far = size >= 1e6 || (size < 1e-3 && size > 0);
    return (far ? value.toExponential() : String(value)).replace('e+', 'e');
}
const range = word => short(word.least) + ' to ' + short(word.most);

const form = made('form', box, { novalidate: '', autocomplete: 'off' });
const top = made('p', form, { class: 'example' });
made('label', top, { for: 'example', text: 'Begin with ' });
const example = made('select', top, { id: 'example' });
for (const name in self.choose.scenes) {
    const what = self.choose.scenes[name].match(/^# *(.*)/);
    made('option', example, { value: name, text: name + (what ? ': ' + what[1] : '') });
}
const grid = made('div', form, { class: 'fields' });
const AXES = [' along X1', ' along X2'];
for (const word of words) {
    const id = 'word-' + word.word, count = Math.max(1, word.n);
    made('label', grid, { for: id, text: word.word + (word.must === '1' ? ' *' : '') });
    const cell = made('span', grid, { class: 'inputs' });
    word.inputs = [];
    for (let i = 0; i < count; i++) {
        const more = { id: i ? id + i : id, name: word.word, 'aria-describedby': id + '-says' };
        if (count > 1) more['aria-label'] = word.word + AXES[i];
        if (word.n === 0) {
            const select = made('select', cell, more);
            if (word.must !== '1') made('option', select, { value: '', text: '' });
            for (const one of word.words.split(','))
                made('option', select, { value: one, text: one });
            word.inputs.push(select);
        } else word.inputs.push(made('input', cell, { ...more, type: 'text',
            inputmode: 'text', spellcheck: 'false' }));
    }
    made('span', grid, { id: id + '-says', class: 'says', text: word.says +
        (word.n ? (word.says ? '; ' : '') + range(word) : '') });
}
const last = made('div', form, { class: 'fields' });
/* A line of -h: "  --within   that a frame may take [33]; a number from ..." */
function option(name) {
    const [, says, value, allowed] = self.choose.help.match(
        new RegExp('--' + name + ' +(.*?) \\[(.*?)\\]; (.*)'));
    const check = allowed === 'one of: no yes';
    made('label', last, { for: name, text: name });
    const input = made('input', made('span', last, { class: 'inputs' }), {
        id: name, type: check ? 'checkbox' : 'text', 'aria-describedby': name + '-says' });
    if (!check) input.value = value;
    made('span', last, { id: name + '-says', class: 'says',
        text: says + (check ? '' : '; ' + allowed.replace('a number from ', '')) });
    return input;
}
const error = option('error'), within = option('within'), verify = option('verify');
const act = made('p', form, { class: 'act' });
const choose = made('button', act, { type: 'submit', text: 'Choose' });
const stop = made('button', act, { type: 'button', text: 'Stop', disabled: '' });
made('span', act, { class: 'says', text: ' * must be given; an empty field is left out' });
const wrong = made('p', form, { class: 'bad', role: 'alert', id: 'wrong' });
const state = made('p', box, { class: 'state', role: 'status' });
const answer = made('div', box, { class: 'answer', tabindex: '-1' });

/* Set the fields to a scene's text; what it does not say is empty. */
function fill(text) {
    for (const word of words) for (const input of word.inputs) input.value = '';
    for (const line of text.split('\n')) {
        const said = line.replace(/#.*/, '').trim().split(/\s+/);
        const word = words.find(one => one.word === said[0]);
        if (word) word.inputs.forEach((input, i) => { input.value = said[i + 1] || ''; });
    }
}
example.addEventListener('change', () => fill(self.choose.scenes[example.value]));
example.value = 'flap' in self.choose.scenes ? 'flap' : example.value;
fill(self.choose.scenes[example.value]);

/* The scene as a file; line k + 1 is that of the word at[k]. */
function written() {
    const at = [], lines = [];
    for (const word of words) {
        const values = word.inputs.map(input => input.value.trim());
        if (values.every(value => value === '')) continue;
        at.push(word);
        lines.push(word.word.padEnd(9) + values.join(' '));
    }
    return { at, text: lines.join('\n') + '\n' };
}

/* ---- the program, in a worker, so that it can be stopped ---- */
function inWorker(program) {
    self.onmessage = ({ data }) => {
        const out = [], err = [];
        const read = name => {
            if (!Module.FS.analyzePath(name).exists) return '';
            return Module.FS.readFile(name, { encoding: 'utf8' });
        };
        const ends = status => self.postMessage({ status, out: out.join('\n'),
            err: err.join('\n'), picture: read('picture') });
        const Module = {
            arguments: data.args, print: line => out.push(line),
            printErr: line => err.push(line), onExit: ends, onAbort: () => ends(-1),
            preRun: [() => Module.FS.writeFile(data.name, data.text)]
        };
        program(Module);
    };
}
let worker = null, clock = 0;
async function run(name, text, args) {
    if (!(self.programs || {}).choose) await new Promise((done, failed) => {
        const script = made('script', document.head, { src: box.dataset.program });
        script.onload = done;
        script.onerror = () => failed(new Error(box.dataset.program + ' is not there'));
    });
    const source = '(' + inWorker + ')(' + self.programs.choose + ')';
    const url = URL.createObjectURL(new Blob([source], { type: 'text/javascript' }));
    worker = new Worker(url);
    URL.revokeObjectURL(url);
    return new Promise((done, failed) => {
        run.stop = why => failed(new Error(why));
        clock = setTimeout(run.stop, 1000 * LIMIT, 'stopped after ' + LIMIT + ' seconds');
        worker.onmessage = ({ data }) => done(data);
        worker.onerror = event => failed(new Error(event.message));
        worker.postMessage({ name, text, args });
    }).finally(() => {
        clearTimeout(clock);
        worker.terminate();
    });
}
stop.addEventListener('click', () => run.stop('stopped'));

/* ---- the answer ---- */
const LEAST = /^(The least model|NOT SURE)/;
/* The lines without a blank at the front are heads, those that follow their text. */
function sections(out) {
    const all = [];
    for (const line of out.split('\n')) {
        const head = line && line[0] !== ' ', now = all[all.length - 1];
        if (!line) continue;
        if (!head) now.text.push(line);
        else if (now && !now.text.length) now.head += ' ' + line;
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
function show(said, name, scene, options) {
    const all = sections(said.out);
    all.sort((a, b) => LEAST.test(b.head) - LEAST.test(a.head));
    all.forEach((part, k) => {
        const section = made('section', answer, { class: LEAST.test(part.head) ? 'least' : '' });
        linked(part.head, made('h2', section, {}));
        if (part.text.length) linked(part.text.map(line => line.slice(2)).join('\n'),
                                     made('pre', section, {}));
        if (/^Price/.test(part.head)) made('p', section, { class: 'says', text: 'The ' +
            'milliseconds were measured just now, in this browser, which compiled the program ' +
            'while it was choosing; make choose measures those of your machine.' });
        if (k === 0 && said.picture) picture(said.picture, section);
    });
    const file = made('details', made('section', answer, {}), {});
    made('summary', file, { text: 'The scene as a file' });
    made('pre', file, { text: scene });
    made('p', file, { class: 'says', text: 'Save it as ' + name + ', then ' +
        'make choose SCENE=' + name + ' ' + options });
}

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
            ' allowed: ' + parts.map(([name, value]) => name + ' ' + short(Number(value)
                .toPrecision(2))).join(', ') });
    const most = 1.15 * Math.max(allowed, ...parts.map(part => Number(part[1])));
    const x = value => 96 + 250 * value / most, foot = 28 * parts.length + 22;
    parts.forEach(([name, value], i) => {
        const y = 22 + 28 * i, wide = Math.max(0, x(Number(value)) - 96);
        drawn('text', bars, { x: 90, y: y + 14, 'text-anchor': 'end', text: name });
        drawn('rect', bars, { x: 96, y, width: wide, height: 18,
            class: Number(value) > allowed ? 'over' : 'part' });
        drawn('text', bars, { x: 102 + wide, y: y + 14,
            text: short(Number(value).toPrecision(2)) + ' %' });
    });
    drawn('path', bars, { class: 'axis', d: `M96 16V${foot}` });
    drawn('path', bars, { class: 'allowed', d: `M${x(allowed)} 16V${foot}` });
    drawn('text', bars, { x: Math.min(x(allowed), 330), y: 12, 'text-anchor': 'middle',
        class: 'limit', text: 'allowed: ' + short(allowed) + ' %' });
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
        short((high[0] - low[0]).toPrecision(3)) + ' m wide)' });
}

form.addEventListener('submit', async event => {
    event.preventDefault();
    const scene = written(), name = example.value + '.scene';
    wrong.textContent = '';
    answer.replaceChildren();
    for (const input of form.querySelectorAll('[aria-invalid]'))
        input.removeAttribute('aria-invalid');
    const args = ['--scene', name, '--error', error.value.trim(), '--within',
        within.value.trim(), '--verify', verify.checked ? 'yes' : 'no',
        '--picture', 'picture'];
    state.textContent = 'Choosing ...';
    choose.disabled = true;
    stop.disabled = false;
    box.said = null;
    try {
        const said = await run(name, scene.text, args);
        state.textContent = '';
        if (said.status === 0 || (said.status === 1 && said.out)) {
            show(said, name, scene.text, 'ERROR=' + args[3] + '% WITHIN=' + args[5] + 'ms' +
                (verify.checked ? ' VERIFIED=yes' : ''));
            answer.focus({ preventScroll: true });
            answer.scrollIntoView({ block: 'start' });
        } else {
            wrong.textContent = said.err || 'The program has ended with status ' + said.status;
            mark(said.err, scene.at);
        }
        box.said = said;
    } catch (failure) {
        state.textContent = failure.message;
        box.said = { status: -1, out: '', err: failure.message };
    }
    choose.disabled = false;
    stop.disabled = true;
});
/* "line 3:", "does not say 'rho'", "--error": which field the program means. */
function mark(message, at) {
    const line = message.match(/line (\d+):/), missing = message.match(/does not say '(\w+)'/);
    const named = message.match(/--?(error|within)/);
    const word = line ? at[line[1] - 1] : missing && words.find(w => w.word === missing[1]);
    const input = word ? word.inputs[0] : named && (named[1] === 'error' ? error : within);
    if (!input) return;
    for (const one of word ? word.inputs : [input]) {
        one.setAttribute('aria-invalid', 'true');
    }
    input.focus();
}
box.fields = { words, example, error, within, verify, form };
})();
