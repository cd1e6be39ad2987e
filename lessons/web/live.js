/*
 * live.js - the page's part of window.h (common/motion/window_web.c): canvas,
 * buttons and clock of a live scene.
 *
 *     <div class="live" data-program="../programs/live.js#24_live" data-args="--n 16"></div>
 *
 * The program is one of those in a script (programs.js).  It calls
 * Module.page.next(), which waits for a frame, Module.page.draw() and, at the end,
 * Module.page.close().  A scene with data-on-demand is begun by its
 * button, and its program is loaded only then.  liveScene(box) begins a box in which
 * box.source(page), a promise of {stdout, wrong}, is the program.  data-keys are the buttons that
 * there are, all unless given; data-wide, -high and -middle are metres; data-layers
 * are heights where the colour changes, instead of colours by J.
 */
'use strict';
(() => {
const FRAME = 1000 / 30, SHOWN = 240;
const KEYS = { space: ' ' };
/* what the buttons do, by their keys */
const MEANS = {
    l: 'The law of the material. Under the log law no triangle can turn inside out; under the ' +
        'cubic law it can, and the energy is finite.',
    i: 'The time step. Backward Euler damps the motion, the implicit midpoint rule hardly does.',
    s: 'Where Newton\'s method begins each frame: at the elastic lift of the last state, at ' +
        'rows that follow the hand, or at the last state itself.',
    p: 'What follows when the fast way fails: steps downhill in the energy, or nothing, and ' +
        'the frame is lost.',
    g: 'What the hand takes: the vertices near it, or the whole right side.',
    e: 'Linear triangles, or quadratic ones on the same vertices.',
    '+': 'Twice as many squares along each side.',
    '-': 'Half as many squares along each side.',
    r: 'Puts the body back to where it was at rest.',
    ' ': 'Stops the time, or lets it go on.',
    q: 'Ends the scene; then you can save the input of your hand and the tables.'
};

function live(box) {
    const data = box.dataset;
    const titles = box.source ? {} : MEANS;
    const only = data.keys ? data.keys.split(' ') : null;

    const stage = made('div', box, { class: 'stage' });
    const invitation = made('p', stage, { class: 'pull', 'aria-hidden': 'true',
        text: data.pull || 'Pull here' });
    const id = 'live-help-' + document.querySelectorAll('.live .help').length;
    const canvas = made('canvas', stage, { tabindex: '0', role: 'application',
        'aria-label': data.label || 'A soft square, whose left side is held',
        'aria-describedby': id });
    const keys = made('div', box, { class: 'keys', role: 'group',
        'aria-label': 'What can be changed' });
    const means = made('p', box, { class: 'help means', role: 'status' });
    const said = made('p', box, { class: 'said' });
    const count = made('p', box, { class: 'said' });
    const chart = made('canvas', box, { class: 'times', role: 'img',
        'aria-label': 'Milliseconds of the last frames' });
    made('p', box, { class: 'help', text: 'Milliseconds of the last ' + SHOWN +
        ' frames, without drawing.' });
    const alert = made('p', box, { class: 'lost', role: 'status' });
    const saved = made('p', box, { class: 'saved' });
    made('p', box, { class: 'help', id, text: 'Drag with the mouse or a finger. ' +
        'With the keyboard: arrows move the hand, Enter grabs and lets go; ' +
        'letters in brackets are keys, too.' });
    const drawing = self.liveDrawing(box, canvas, chart, SHOWN);

    const hand = { x: 1, y: 0, down: 0, arrows: false };
    const pressed = [];  /* keys for the frames to come */
    const took = [];     /* ms of the last frames */
    const shownAt = [];  /* when they were drawn (ms) */
    const state = { frames: 0, lost: 0, knots: 0, stopped: false, closed: false,
                    due: 0, lines: [], status: null, fps: 0 };
    box.live = { state, hand, press, canvas, drawing };

    /* ---- the hand ---- */
    canvas.addEventListener('pointerdown', event => {
        if (event.button !== 0) return;
        [hand.x, hand.y] = drawing.metres(event);
        hand.down = 1;
        hand.arrows = false;
        invitation.remove();
        try { canvas.setPointerCapture(event.pointerId); } catch (e) { /* synthetic */ }
        canvas.focus({ preventScroll: true });
        event.preventDefault();
    });
    canvas.addEventListener('pointermove', event => {
        if (!hand.arrows || event.buttons) [hand.x, hand.y] = drawing.metres(event);
    });
    for (const ends of ['pointerup', 'pointercancel', 'lostpointercapture'])
        canvas.addEventListener(ends, () => { if (!hand.arrows) hand.down = 0; });
    document.addEventListener('keydown', event => {
        const near = box.contains(event.target) ||
            (event.target === document.body && !('onDemand' in data) && !box.source);
        if (state.closed || !near) return;
        if (event.ctrlKey || event.altKey || event.metaKey) return;
        const on = { ArrowLeft: [-0.1, 0], ArrowRight: [0.1, 0],
                     ArrowDown: [0, -0.1], ArrowUp: [0, 0.1] }[event.key];
        if (event.target !== canvas) return letter(event);
        if (on) {
            hand.x += on[0];
            hand.y += on[1];
            hand.arrows = true;
            event.preventDefault();
        } else if (event.key === 'Enter') {
            hand.down = hand.down ? 0 : 1;
            hand.arrows = true;
            invitation.remove();
        } else letter(event);
    });
    function letter(event) {
        if (event.key === ' ' && event.target !== canvas) return; /* a button's */
        if (event.key === 'Escape') press('q');
        else if (event.key.length === 1 && buttons.has(event.key)) press(event.key);
        else return;
        event.preventDefault();
    }
    function press(key) {
        if (key === ' ') {
            state.stopped = !state.stopped;
            buttons.get(' ').textContent = state.stopped ? 'go on [space]'
                                                         : 'stop [space]';
        } else if (key === 'q') state.closed = true;
        else if (!state.stopped) pressed.push(key);
    }

    /* ---- buttons, from the program's own words: "[l] law: log" ---- */
    const buttons = new Map();
    function words(text) {
        for (const [, name, does] of text.matchAll(/\[([^\]]+)\] ([^[\n]*)/g))
            for (const one of name.split(' ')) {
                const key = KEYS[one] || one;
                if (only && !only.includes(one)) continue;
                if (!buttons.has(key)) {
                    const button = made('button', keys, { type: 'button', title: titles[key] || does.trim() });
                    button.addEventListener('click', () => press(key));
                    buttons.set(key, button);
                }
                const label = (one === '-' ? 'fewer' : one === 'q' ? 'end and save' : does.trim() +
                    (one === '+' ? ', more' : '')) + ' [' + one + ']';
                if (key !== ' ' && buttons.get(key).textContent !== label) {
                    if (buttons.get(key).textContent)
                        means.textContent = does.trim() + '. ' + (titles[key] || '');
                    buttons.get(key).textContent = label;
                }
                if (key === ' ' && !buttons.get(key).textContent)
                    buttons.get(key).textContent = label;
            }
    }

    /* ---- what the program calls ---- */
    let Module = null;
    const page = {
        close: () => setTimeout(over, 0, 0), /* when main() has returned */
        next: () => new Promise(done => {
            const step = now => {
                if (state.closed) return done(null);
                if (state.stopped || now < state.due - 4)
                    return requestAnimationFrame(step);
                state.due = Math.max(state.due, now - FRAME) + FRAME;
                const key = pressed.shift() || '.';
                done([hand.x, hand.y, hand.down, key.charCodeAt(0)]);
            };
            requestAnimationFrame(step);
        }),
        draw: frame => {
            state.frames++;
            took.push(frame.ms);
            shownAt.push(performance.now());
            if (took.length > SHOWN) took.shift();
            if (shownAt.length > 61) shownAt.shift();
            words(frame.text);
            state.knots = drawing.body(frame, hand);
            drawing.times(took);
            const passed = shownAt[shownAt.length - 1] - shownAt[0];
            state.fps = passed > 0 ? 1000 * (shownAt.length - 1) / passed : 0;
            if (state.frames % 6 === 1 || frame.lost !== state.lost) {
                let least = Infinity;
                for (const J of frame.J) if (!(J >= least)) least = J;
                said.textContent = frame.said ?? frame.text.split('\n')[0] + '; least J ' +
                    least.toFixed(2) + '; knots: ' + state.knots;
                said.className = 'said' + (frame.alarm ?? /^lost/.test(frame.text) ? ' bad' : '');
                chart.setAttribute('aria-label', 'Milliseconds of the last ' +
                    took.length + ' frames, without drawing: the longest took ' +
                    Math.max(...took).toFixed(1) + ', and 33 are allowed');
                const lost = state.frames + ' frames' + (box.source ? '' : ', ' + frame.lost + ' lost');
                if (frame.lost !== state.lost) alert.textContent = 'Lost: ' + lost;
                count.textContent = lost + '; ' + state.fps.toFixed(0) +
                    ' frames per second';
            }
            state.lost = frame.lost;
        }
    };

    function over(status) {
        if (state.status !== null) return;
        state.status = status;
        state.closed = true;
        for (const button of buttons.values()) button.disabled = true;
        saved.textContent = '';
        if (status !== 0) {
            said.textContent = state.lines.slice(-1)[0] || 'The program has ended.';
            said.className = 'said bad';
            return;
        }
        for (const [name, what, text] of [
            ['live.txt', 'the input', state.input = Module ? read('input.txt') : ''],
            ['live.tsv', 'its tables', state.lines.join('\n') + '\n']]) {
            if (text) made('a', saved, { download: name, text: 'Save ' + what, href:
                URL.createObjectURL(new Blob([text], { type: 'text/plain' })) });
            saved.append(' ');
        }
        if (state.input)
            made('span', saved, { text: 'make live ARGS=\'' +
                data.args.replace(/--record \S+/, '--input live.txt') +
                '\' plays the input again. ' });
        made('button', saved, { type: 'button', text: 'Begin again' })
            .addEventListener('click', () => {
                const twin = Object.assign(box.cloneNode(false), { source: box.source });
                box.replaceWith(twin);
                live(twin);
            });
    }
    function read(name) {
        if (!Module.FS.analyzePath(name).exists) return '';
        Module.FS.chmod(name, 0o600); /* the page's umask lets nobody read it */
        return Module.FS.readFile(name, { encoding: 'utf8' });
    }

    /* ---- begin ---- */
    async function begin() {
        drawing.fit();
        new ResizeObserver(drawing.fit).observe(stage);
        if (box.source) {
            const { stdout, wrong } = await box.source(page)
                .catch(error => ({ stdout: '', wrong: error.message }));
            state.lines = (wrong || stdout).trimEnd().split('\n');
            return over(wrong ? 1 : 0);
        }
        try {
            const [source, name] = data.program.split('#');
            const { script, code } = await self.loadProgram(source);
            Module = { page, thisProgram: name, wasmBinary: code,
                       arguments: (data.args || '').split(' ').filter(word => word),
                       print: line => state.lines.push(line),
                       printErr: line => state.lines.push(line),
                       onExit: over, onAbort: () => over(1) };
            new Function('Module', script)(Module);
        } catch (error) {
            said.textContent = 'The program does not run here: ' + error.message;
            said.className = 'said bad';
        }
    }
    if (!('onDemand' in data)) return begin();
    box.classList.add('asleep');
    const start = made('button', box, { type: 'button', class: 'start',
        text: data.start || 'Take it in your hand' });
    start.addEventListener('click', () => {
        start.remove();
        box.classList.remove('asleep');
        begin();
        canvas.focus({ preventScroll: true });
    });
}

self.liveScene = live;
for (const box of document.querySelectorAll('.live')) live(box);
})();
