/*
 * live_draw.js - how a live scene is drawn: body, held vertices, knots, hand, and
 * the milliseconds of the last frames.
 */
'use strict';
(() => {
const BUDGET = 1000 / 30; /* ms */

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

/* liveDrawing(box, canvas, chart, most): the size, place, and pictures of one. */
self.liveDrawing = (box, canvas, chart, most) => {
    const data = box.dataset, ink = canvas.getContext('2d'), bars = chart.getContext('2d');
    const wide = Number(data.wide || 5.6), high = Number(data.high || 4.4);
    const middle = Number(data.middle || 0); /* height (m) of the canvas's middle */
    const layers = data.layers ? data.layers.split(' ').map(Number) : null;

    /* Size, and from pixels to metres. */
    let scale = 1, ratio = 1;
    function fit() {
        /* the buttons and the chart fit on the screen, too; whole pixels, for the
         * browser rounds others */
        const width = Math.floor(Math.min(canvas.parentElement.clientWidth,
                                          Math.max(280, 0.5 * innerHeight * wide / high)));
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
        return [(event.clientX - r.left - r.width / 2) / scale,
                middle - (event.clientY - r.top - r.height / 2) / scale];
    }

    let image = null, edges = null;
    function body(frame, hand) {
        const x = frame.x, t = frame.triangle;
        const s = scale * ratio, px = [], n = x.length / 2;
        const paint = layers ? layered : stretched;
        if (!image || image.wide !== canvas.width || image.high !== canvas.height) {
            const data = ink.createImageData(canvas.width, canvas.height);
            image = { data, wide: canvas.width, high: canvas.height,
                      pixels: new Uint32Array(data.data.buffer) };
        }
        if (!edges || edges.size !== t.length || edges.n !== n) /* or it was cut */
            edges = { ...edgesOf(t, n), size: t.length, n };
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
        /* dark with a light rim: seen on the body and on either ground */
        const square = (size, colour) => {
            ink.fillStyle = colour;
            for (let a = 0; a < n; a++)
                if (frame.held[a])
                    ink.fillRect(px[2 * a] - size / 2, px[2 * a + 1] - size / 2, size, size);
        };
        const size = Math.max(2.5, Math.min(5, scale / 22)) * ratio;
        square(size + 2 * ratio, 'rgb(250,250,250)');
        square(size, 'rgb(20,20,20)');
        ink.strokeStyle = 'rgb(200,0,0)';
        ink.lineWidth = 3 * ratio;
        let knots = 0;
        for (let a = 0; a < n; a++) {
            if (!frame.knot[a]) continue;
            knots++;
            ink.beginPath();
            ink.arc(px[2 * a], px[2 * a + 1], 12 * ratio, 0, 2 * Math.PI);
            ink.stroke();
        }
        ink.strokeStyle = ink.fillStyle = 'rgb(20,20,20)';
        ink.lineWidth = 2.5 * ratio;
        const at = (x, y) => [canvas.width / 2 + s * x, canvas.height / 2 - s * (y - middle)];
        for (const [x0, y0, x1, y1] of frame.arrows || []) {
            const [x, y] = at(x1, y1);
            ink.beginPath();
            ink.moveTo(...at(x0, y0));
            ink.lineTo(x, y);
            ink.stroke();
            ink.fillRect(x - 4 * ratio, y - 4 * ratio, 8 * ratio, 8 * ratio);
        }
        ink.beginPath();
        for (let k = 0; k < (frame.curve || []).length; k += 2)
            ink.lineTo(...at(frame.curve[k], frame.curve[k + 1]));
        ink.stroke();
        if (hand.down || hand.arrows) { /* where the hand wants to be */
            for (const [width, colour] of [[3.5, 'rgb(250,250,250)'], [1.5, 'rgb(20,20,20)']]) {
                ink.strokeStyle = colour;
                ink.lineWidth = width * ratio;
                ink.beginPath();
                ink.arc(canvas.width / 2 + s * hand.x,
                        canvas.height / 2 - s * (hand.y - middle), 7 * ratio, 0, 2 * Math.PI);
                ink.stroke();
            }
        }
        return knots;
    }

    /* The milliseconds of the last frames, and the line of 33. */
    function times(took) {
        const style = getComputedStyle(box), w = chart.width, h = chart.height;
        const plain = style.getPropertyValue('--ink') || '#141414';
        const floor = h - 2 * ratio, per = (h - 4 * ratio) / 66;
        bars.clearRect(0, 0, w, h);
        const left = 52 * ratio, step = (w - left) / most;
        for (let k = 0; k < took.length; k++) {
            const ms = took[took.length - 1 - k], tall = Math.max(ratio, per * Math.min(66, ms));
            bars.fillStyle = ms > BUDGET ? 'rgb(200,60,60)' : 'rgb(90,120,160)';
            bars.fillRect(w - (k + 1) * step, floor - tall, Math.max(step, 1), tall);
        }
        bars.fillStyle = style.getPropertyValue('--bad') || '#b00020';
        bars.fillRect(left, floor - per * BUDGET, w - left, ratio);
        bars.font = 12 * ratio + 'px sans-serif';
        bars.textBaseline = 'middle';
        bars.fillText('33 ms', 0, floor - per * BUDGET);
        bars.fillStyle = plain;
        bars.fillText('0', 0, floor - 5 * ratio);
    }
    return { fit, metres, body, times };
};
})();
