/*
 * choose.js - `make choose` as a page: the words of the scene file as a form,
 * the answer of lessons/choose/choose.c, and its picture.
 *
 * Words, ranges, units and examples are those of choose_data.js, which `make web`
 * makes from the program.  What is wrong with a field the program says itself.
 */
'use strict';
(() => {
const LIMIT = 60; /* seconds of one run */
const box = document.querySelector('.least-model');

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
const range = word => shortNumber(word.least) + ' to ' + shortNumber(word.most);

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
let filled = null; /* what the example says */
function fill(text) {
    for (const word of words) for (const input of word.inputs) input.value = '';
    for (const line of text.split('\n')) {
        const said = line.replace(/#.*/, '').trim().split(/\s+/);
        const word = words.find(one => one.word === said[0]);
        if (word) word.inputs.forEach((input, i) => { input.value = said[i + 1] || ''; });
    }
    filled = written().text;
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

/* ---- running ---- */
let running = null;
stop.addEventListener('click', () => running?.stop());

form.addEventListener('submit', async event => {
    event.preventDefault();
    const scene = written();
    const name = (scene.text === filled ? example.value : 'mine') + '.scene';
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
    let said;
    try {
        const program = await loadProgram(box.dataset.program);
        running = runProgram(program, 'choose', args, LIMIT, { [name]: scene.text, picture: '' });
        said = await running.finished;
        state.textContent = said.end === 'exit' ? '' : endWords(said, LIMIT);
        if (said.status === 0 || (said.status === 1 && said.out)) {
            showAnswer(answer, said, name, scene.text, 'ERROR=' + args[3] + '% WITHIN=' + args[5] + 'ms' +
                (verify.checked ? ' VERIFIED=yes' : ''));
            answer.focus({ preventScroll: true });
            answer.scrollIntoView({ block: 'start' });
        } else if (said.end === 'exit') {
            wrong.textContent = plainly(said.err, name) || 'The program has ended with status ' + said.status;
            mark(said.err, scene.at);
        }
    } catch (failure) {
        state.textContent = failure.message;
        said = { status: null, out: '', err: failure.message };
    }
    box.said = said;
    choose.disabled = false;
    stop.disabled = true;
});
/* The message without program, file and line: the field is marked. */
const plainly = (message, name) => message.trim().replace(/^choose: /, '')
    .replace(name + ': ', '').replace(/^line \d+: /, '');
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
