/*
 * live.js - the page's part of window.h (common/motion/window_web.c): canvas,
 * buttons and clock of a live scene.
 *
 *     <div class="live" data-program="../programs/square.js" data-args="--n 16"></div>
 *
 * The program is one of `make web`: a function programs[name](Module).  It
 * calls Module.page.next(), which waits for a frame, Module.page.draw() and, at
 * the end, Module.page.close().  A scene with data-on-demand is begun by its
 * button, and its program is loaded only then.  data-keys are the buttons that
 * there are, all unless given; data-wide, -high and -middle are metres; data-layers
 * are heights where the colour changes, instead of colours by J.
 */
'use strict';
(() => {
const FRAME = 1000 / 30, SHOWN = 240;
const KEYS = { space: ' ' };

/* Blue where it is pressed, white at rest, orange where it is stretched, magenta
 * where it is inverted: red, green, blue in the order of an ImageData. */
const packed = ([r, g, b]) => (0xff << 24 | b << 16 | g << 8 | r) >>> 0;
const INVERTED = packed([214, 0, 190]), STEPS = 64, COLOURS = [];
for (let k = 0; k <= 2 * STEPS; k++) {
    const s = k / STEPS - 1, end = s > 0 ? [235, 120, 20] : [33, 102, 196];
    COLOURS.push(packed(end.map(c => Math.round(250 + Math.abs(s) * (c - 250)))));
}
function stretched(J) {
    if (!(J > 0)) return INVERTED;
    return COLOURS[Math.round(STEPS * (1 + Math.max(-1, Math.min(1, Math.log2(J)))))];
}
/* Muscle, fat and skin: depths of one material. */
const LAYERS = [[178, 74, 66], [240, 206, 120], [232, 180, 160]].map(packed);
function layered(J, frame, e, heights) {
    let y = 0;
    if (!(J > 0)) return INVERTED;
    for (let k = 0; k < 3; k++) y += frame.rest[2 * frame.triangle[3 * e + k] + 1] / 3;
    return LAYERS[heights.filter(height => y > height).length];
}

/* The pixels whose middles are inside: no gap between neighbours, and faster than
 * thousands of paths where no graphics card helps. */
function fill(image, x0, y0, x1, y1, x2, y2, colour) {
    if (y0 > y1) [x0, y0, x1, y1] = [x1, y1, x0, y0];
    if (y1 > y2) [x1, y1, x2, y2] = [x2, y2, x1, y1];
    if (y0 > y1) [x0, y0, x1, y1] = [x1, y1, x0, y0];
    const end = Math.min(image.high, Math.ceil(y2 - 0.5));
    for (let row = Math.max(0, Math.ceil(y0 - 0.5)); row < end; row++) {
        const y = row + 0.5, far = x0 + (x2 - x0) * (y - y0) / (y2 - y0);
        const near = y < y1 ? x0 + (x1 - x0) * (y - y0) / (y1 - y0)
                            : x1 + (x2 - x1) * (y - y1) / (y2 - y1);
        const from = Math.max(0, Math.ceil(Math.min(near, far) - 0.5));
        const to = Math.min(image.wide, Math.ceil(Math.max(near, far) - 0.5));
        if (from < to) image.pixels.fill(colour, row * image.wide + from, row * image.wide + to);
    }
}

/* The edges of the triangles, each once: [vertex, vertex, ...]; those of one
 * triangle alone are the rim. */
function edgesOf(triangle, n) {
    const count = new Map();
    for (let k = 0; k < triangle.length; k++) {
        const a = triangle[k], b = triangle[k % 3 === 2 ? k - 2 : k + 1];
        const key = Math.min(a, b) * n + Math.max(a, b);
        count.set(key, (count.get(key) || 0) + 1);
    }
    const ends = keys => keys.flatMap(([key]) => [Math.floor(key / n), key % n]);
    const all = [...count];
    return { all: ends(all), rim: ends(all.filter(([, times]) => times === 1)) };
}

function made(tag, parent, attributes) {
    const element = document.createElement(tag);
    for (const name in attributes)
        if (name === 'text') element.textContent = attributes[name];
        else element.setAttribute(name, attributes[name]);
    return parent.appendChild(element);
}

function script(source) {
    return new Promise((done, failed) => {
        const element = made('script', document.head, { src: source });
        element.onload = done;
        element.onerror = () => failed(new Error(source + ' is not there'));
    });
}

function live(box) {
    const data = box.dataset;
    const wide = Number(data.wide || 5.6), high = Number(data.high || 4.4);
    const middle = Number(data.middle || 0); /* height (m) of the canvas's middle */
    const only = data.keys ? data.keys.split(' ') : null;
    const layers = data.layers ? data.layers.split(' ').map(Number) : null;

    const stage = made('div', box, { class: 'stage' });
    const id = 'live-help-' + document.querySelectorAll('.live .help').length;
    const canvas = made('canvas', stage, { tabindex: '0', role: 'application',
        'aria-label': data.label || 'A soft square, whose left side is held',
        'aria-describedby': id });
    const keys = made('div', box, { class: 'keys', role: 'group',
        'aria-label': 'What can be changed' });
    const said = made('p', box, { class: 'said' });
    const count = made('p', box, { class: 'said' });
    const chart = made('canvas', box, { class: 'times', role: 'img' });
    made('p', box, { class: 'help', text: 'Milliseconds of the last ' + SHOWN +
        ' frames, without drawing.' });
    const alert = made('p', box, { class: 'lost', role: 'status' });
    const saved = made('p', box, { class: 'saved' });
    made('p', box, { class: 'help', id, text: 'Drag with the mouse or a finger. ' +
        'With the keyboard: arrows move the hand, Enter grabs and lets go; ' +
        'letters in brackets are keys, too.' });
    const ink = canvas.getContext('2d'), bars = chart.getContext('2d');

    const hand = { x: 1, y: 0, down: 0, arrows: false };
    const pressed = [];  /* keys for the frames to come */
    const took = [];     /* ms of the last frames */
    const shownAt = [];  /* when they were drawn (ms) */
    const state = { frames: 0, lost: 0, knots: 0, stopped: false, closed: false,
                    due: 0, lines: [], status: null, fps: 0 };
    box.live = { state, hand, press, canvas };

    /* ---- size, and from pixels to metres ---- */
    let scale = 1, ratio = 1;
    function fit() {
        const width = stage.clientWidth;
        ratio = window.devicePixelRatio || 1;
        scale = width / wide;
        for (const [c, w, h] of [[canvas, width, width * high / wide],
                                 [chart, Math.min(width, 480), 84]]) {
            c.style.width = w + 'px';
            c.style.height = h + 'px';
            c.width = Math.round(w * ratio);
            c.height = Math.round(h * ratio);
        }
    }
    function metres(event) {
        const r = canvas.getBoundingClientRect();
        hand.x = (event.clientX - r.left - r.width / 2) / scale;
        hand.y = middle - (event.clientY - r.top - r.height / 2) / scale;
    }

    /* ---- the hand ---- */
    canvas.addEventListener('pointerdown', event => {
        if (event.button !== 0) return;
        metres(event);
        hand.down = 1;
        hand.arrows = false;
        try { canvas.setPointerCapture(event.pointerId); } catch (e) { /* synthetic */ }
        canvas.focus({ preventScroll: true });
        event.preventDefault();
    });
    canvas.addEventListener('pointermove', event => {
        if (!hand.arrows || event.buttons) metres(event);
    });
    for (const ends of ['pointerup', 'pointercancel', 'lostpointercapture'])
        canvas.addEventListener(ends, () => { if (!hand.arrows) hand.down = 0; });
    document.addEventListener('keydown', event => {
        const near = box.contains(event.target) ||
            (event.target === document.body && !('onDemand' in data));
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
                    const button = made('button', keys, { type: 'button' });
                    button.addEventListener('click', () => press(key));
                    buttons.set(key, button);
                }
                const label = (one === '-' ? 'fewer' : does.trim() +
                    (one === '+' ? ', more' : '')) + ' [' + one + ']';
                if (key !== ' ' && buttons.get(key).textContent !== label)
                    buttons.get(key).textContent = label;
                if (key === ' ' && !buttons.get(key).textContent)
                    buttons.get(key).textContent = label;
            }
    }

    /* ---- drawing ---- */
    let image = null, edges = null;
    function drawBody(frame) {
        const style = getComputedStyle(box), x = frame.x, t = frame.triangle;
        const s = scale * ratio, px = [], n = x.length / 2;
        const paint = layers ? layered : stretched;
        if (!image || image.wide !== canvas.width || image.high !== canvas.height) {
            const data = ink.createImageData(canvas.width, canvas.height);
            image = { data, wide: canvas.width, high: canvas.height,
                      pixels: new Uint32Array(data.data.buffer) };
        }
        if (!edges || edges.size !== t.length)
            edges = { ...edgesOf(t, n), size: t.length };
        for (let a = 0; a < n; a++)
            px.push(canvas.width / 2 + s * x[2 * a],
                    canvas.height / 2 - s * (x[2 * a + 1] - middle));
        image.pixels.fill(0);
        for (let e = 0; e < frame.J.length; e++) {
            const [a, b, c] = [2 * t[3 * e], 2 * t[3 * e + 1], 2 * t[3 * e + 2]];
            fill(image, px[a], px[a + 1], px[b], px[b + 1], px[c], px[c + 1],
                 paint(frame.J[e], frame, e, layers));
        }
        ink.putImageData(image.data, 0, 0);
        const lines = (ends, colour, width) => {
            ink.strokeStyle = colour;
            ink.lineWidth = width * ratio;
            ink.beginPath();
            for (let k = 0; k < ends.length; k += 2) {
                ink.moveTo(px[2 * ends[k]], px[2 * ends[k] + 1]);
                ink.lineTo(px[2 * ends[k + 1]], px[2 * ends[k + 1] + 1]);
            }
            ink.stroke();
        };
        if (frame.J.length <= 2048)
            lines(edges.all, layers ? 'rgba(0,0,0,.13)' : 'rgb(120,120,120)', 0.7);
        lines(edges.rim, 'rgb(110,110,110)', 1);
        ink.fillStyle = style.getPropertyValue('--ink') || '#141414';
        const size = Math.max(2.5, Math.min(5, scale / 22)) * ratio;
        for (let a = 0; a < n; a++)
            if (frame.held[a])
                ink.fillRect(px[2 * a] - size / 2, px[2 * a + 1] - size / 2, size, size);
        ink.strokeStyle = 'rgb(200,0,0)';
        ink.lineWidth = 3 * ratio;
        state.knots = 0;
        for (let a = 0; a < n; a++) {
            if (!frame.knot[a]) continue;
            state.knots++;
            ink.beginPath();
            ink.arc(px[2 * a], px[2 * a + 1], 12 * ratio, 0, 2 * Math.PI);
            ink.stroke();
        }
        if (hand.down || hand.arrows) { /* where the hand wants to be */
            ink.strokeStyle = style.getPropertyValue('--ink') || '#141414';
            ink.lineWidth = 1.5 * ratio;
            ink.beginPath();
            ink.arc(canvas.width / 2 + s * hand.x,
                    canvas.height / 2 - s * (hand.y - middle), 7 * ratio, 0, 2 * Math.PI);
            ink.stroke();
        }
    }

    /* The milliseconds of the last frames, and the line of 33. */
    function drawTimes() {
        const style = getComputedStyle(box), w = chart.width, h = chart.height;
        const plain = style.getPropertyValue('--ink') || '#141414';
        const floor = h - 2 * ratio, per = (h - 4 * ratio) / 66;
        bars.clearRect(0, 0, w, h);
        const left = 52 * ratio, step = (w - left) / SHOWN;
        for (let k = 0; k < took.length; k++) {
            const ms = took[took.length - 1 - k], tall = Math.max(ratio, per * Math.min(66, ms));
            bars.fillStyle = ms > FRAME ? 'rgb(200,60,60)' : 'rgb(90,120,160)';
            bars.fillRect(w - (k + 1) * step, floor - tall, Math.max(step, 1), tall);
        }
        bars.fillStyle = style.getPropertyValue('--bad') || '#b00020';
        bars.fillRect(left, floor - per * FRAME, w - left, ratio);
        bars.font = 12 * ratio + 'px sans-serif';
        bars.textBaseline = 'middle';
        bars.fillText('33 ms', 0, floor - per * FRAME);
        bars.fillStyle = plain;
        bars.fillText('0', 0, floor - 5 * ratio);
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
            drawBody(frame);
            drawTimes();
            const passed = shownAt[shownAt.length - 1] - shownAt[0];
            state.fps = passed > 0 ? 1000 * (shownAt.length - 1) / passed : 0;
            if (state.frames % 6 === 1 || frame.lost !== state.lost) {
                let least = Infinity;
                for (const J of frame.J) if (!(J >= least)) least = J;
                said.textContent = frame.text.split('\n')[0] + '; least J ' +
                    least.toFixed(2) + '; knots: ' + state.knots;
                said.className = 'said' + (/^lost/.test(frame.text) ? ' bad' : '');
                chart.setAttribute('aria-label', 'Milliseconds of the last ' +
                    took.length + ' frames, without drawing: the longest took ' +
                    Math.max(...took).toFixed(1) + ', and 33 are allowed');
                const lost = state.frames + ' frames, ' + frame.lost + ' lost';
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
            ['live.txt', 'the input', state.input = read('input.txt')],
            ['live.tsv', 'its tables', state.lines.join('\n') + '\n']]) {
            if (text) made('a', saved, { download: name, text: 'Save ' + what, href:
                URL.createObjectURL(new Blob([text], { type: 'text/plain' })) });
            saved.append(' ');
        }
        if (state.input)
            made('span', saved, { text: 'make live ARGS=\'--input live.txt\' plays ' +
                'the input again. ' });
        made('button', saved, { type: 'button', text: 'Begin again' })
            .addEventListener('click', () => {
                const twin = box.cloneNode(false);
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
        const name = data.program.replace(/.*\//, '').replace(/\.js$/, '');
        fit();
        new ResizeObserver(fit).observe(stage);
        try {
            if (!(self.programs || {})[name]) await script(data.program);
            Module = { page, arguments: (data.args || '').split(' ').filter(word => word),
                       print: line => state.lines.push(line),
                       printErr: line => state.lines.push(line),
                       onExit: over, onAbort: () => over(1) };
            self.programs[name](Module);
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

for (const box of document.querySelectorAll('.live')) live(box);
})();
