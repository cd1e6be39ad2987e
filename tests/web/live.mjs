/*
 * live.mjs SITE BUILD [PART [FRAMES]] - the live pages in a headless Chromium:
 * all parts, or log, cubic, losses, tissue, touch or pages.
 *
 * 600 frames of a hand that goes at random, by synthetic pointer events and keys:
 * none is lost, and the native program of lesson 24 has the same rungs, systems and
 * knots for the input that the page has recorded.  Frames per second are
 * printed, not asserted.  Lines "ok web: WHAT" and "FAIL web: WHAT: why".
 */
import { execFileSync } from 'node:child_process';
import { mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join, resolve } from 'node:path';
import { pathToFileURL } from 'node:url';
import { open, say } from './page.mjs';

const [site, build, part = 'all', frames = 600] = process.argv.slice(2);
const native = `${build}/solutions/24_live`;
const url = name => pathToFileURL(resolve(site, name)).href;

/* In the page: an event for each frame, as pointer and keys of a person make
 * them, from numbers that are the same each time.  keys: frame, key. */
function drive(frames, keys, seed) {
    const { state, canvas } = document.querySelector('.live').live;
    let random = seed, x = 1, y = 0, tx = 1, ty = 0, speed = 0.05, down = false;
    const next = () => (random = (random * 48271) % 2147483647) / 2147483647;
    const box = canvas.getBoundingClientRect(), scale = box.width / 5.6;
    const fire = type => canvas.dispatchEvent(new PointerEvent(type, {
        pointerId: 7, pointerType: 'touch', button: 0, buttons: down ? 1 : 0, bubbles: true,
        clientX: box.left + box.width / 2 + scale * x,
        clientY: box.top + box.height / 2 - scale * y }));
    return new Promise(done => {
        let before = state.frames;
        const first = before, began = performance.now(), sent = [];
        const step = () => {
            if (state.closed) return done({ frames: state.frames - first, seconds: 0, sent });
            if (state.frames - first >= frames)
                return done({ first, sent, frames: state.frames - first,
                              seconds: (performance.now() - began) / 1000 });
            for (; before < state.frames; before++) {
                const chance = next(), k = before - first;
                if (chance < 0.06) {
                    tx = 4 * next() - 2;
                    ty = 4 * next() - 2;
                    speed = 0.02 * Math.pow(200, next());
                } else if (chance < 0.1) {
                    down = !down;
                    fire(down ? 'pointerdown' : 'pointerup');
                }
                const way = Math.hypot(tx - x, ty - y), s = way > speed ? speed / way : 1;
                x += s * (tx - x);
                y += s * (ty - y);
                fire('pointermove');
                sent.push([x, y, down ? 1 : 0]);
                for (const [at, key] of keys)
                    if (at === k) canvas.dispatchEvent(new KeyboardEvent('keydown',
                        { key, bubbles: true }));
            }
            requestAnimationFrame(step);
        };
        requestAnimationFrame(step);
    });
}

/* The rows of a table, as objects. */
function rows(lines, name) {
    const begin = lines.indexOf('# ' + name);
    if (begin < 0) return [];
    let k = begin + 1;
    while (lines[k].startsWith('# ')) k++;
    const columns = lines[k++].split('\t'), all = [];
    for (; lines[k]; k++) {
        const cells = lines[k].split('\t');
        all.push(Object.fromEntries(columns.map((c, i) => [c, cells[i]])));
    }
    return all;
}

const SEEN = ['first', 'rung', 'status', 'systems', 'part', 'knots'];
async function square(browser, folder, law, keys, seed) {
    const page = await browser.page(url('web/live.html'));
    const begun = await page.until("document.querySelector('.live').live.state.frames > 5");
    say(begun, 'the live page begins', page.errors.join(' ') || 'no frame');
    if (!begun) return page.close();
    const run = await page.evaluate(`(${drive})(${frames}, ${JSON.stringify(keys)}, ${seed})`);
    await page.evaluate("document.querySelector('.live').live.canvas.dispatchEvent(" +
        "new KeyboardEvent('keydown', { key: 'q', bubbles: true }))");
    await page.until("document.querySelector('.live').live.state.status !== null");
    const { status, lines, input } = await page.evaluate("(({status, lines, input}) => " +
        "({status, lines, input}))(document.querySelector('.live').live.state)");
    const here = rows(lines, 'frames');
    const lost = here.filter(row => row.rung === 'lost').length;
    say(status === 0 && run.frames >= frames && here.length >= frames && lost === 0,
        `${frames} frames by pointer events, ${law}: none lost`,
        `status ${status}, ${here.length} frames, ${lost} lost; ${page.errors.join(' ')}`);
    console.log(`web: ${(run.frames / run.seconds).toFixed(1)} frames per second, ${law}, n = 16`);
    /* What a frame was given are the events of one of the last frames. */
    const given = input.trim().split('\n').map(line => line.split(' ').map(Number));
    let strange = 0;
    for (let k = 3; k < run.frames; k++) {
        const now = given[run.first + k];
        strange += !run.sent.slice(k - 3, k + 1).some(sent => now &&
            sent.every((value, i) => Math.abs(value - now[i]) < 1e-6));
    }
    say(strange === 0, `the input is where the pointer was, ${law}`,
        `not in ${strange} of ${run.frames} frames`);

    const file = join(folder, law + '.txt');
    writeFileSync(file, input);
    const there = rows(execFileSync(native, ['--input', file, '--n', '16'],
        { encoding: 'utf8', maxBuffer: 1e8 }).split('\n'), 'frames');
    const knots = there.filter(row => row.knots !== '0').length;
    const other = here.findIndex((row, k) => !there[k] || SEEN.some(c => row[c] !== there[k][c]));
    say(here.length === there.length && other < 0,
        `rungs, systems and knots are those of the native replay, ${law}`,
        `${here.length} and ${there.length} frames; frame ${other + 1}: ` + SEEN.map(c =>
            `${c} ${(here[other] || {})[c]} ${(there[other] || {})[c]}`).join(', '));
    if (law === 'cubic') say(knots > 0, 'the cubic hand ties a knot', 'none');
    let off = 0;
    here.forEach((row, k) => { if (there[k]) off = Math.max(off,
        Math.abs(row.energy - there[k].energy) / Math.max(1, Math.abs(there[k].energy))); });
    console.log(`web: energies differ by ${off.toExponential(1)} of themselves, ${law}`);
    /* libraries differ in the last digit of log and hypot, and 600 frames of a hand
     * amplify that; 1e-13 to 4e-10 were seen */
    say(off < 1e-6, `energies are those of the native replay, ${law}`, off);
    say(page.errors.length === 0, `no error on the live page, ${law}`, page.errors.join(' '));
    await page.close();
}

/* Without the second rung frames are lost, and the page says how many. */
async function losses(browser) {
    const page = await browser.page(url('web/live.html'));
    await page.until("document.querySelector('.live').live.state.frames > 5");
    await page.evaluate(`(${drive})(150, [[1, 'l'], [2, 'p']], 7)`);
    await page.evaluate("document.querySelector('.live').live.canvas.dispatchEvent(" +
        "new KeyboardEvent('keydown', { key: 'q', bubbles: true }))");
    await page.until("document.querySelector('.live').live.state.status !== null");
    const { lines, lost } = await page.evaluate("(({lines, lost}) => " +
        "({lines, lost}))(document.querySelector('.live').live.state)");
    const really = rows(lines, 'frames').filter(row => row.rung === 'lost').length;
    const shown = await page.evaluate("document.querySelector('.live .lost').textContent");
    say(really > 0 && lost === really && shown.includes(`${really} lost`),
        'frames that are lost are said', `${really} lost, ${lost} counted, "${shown}"`);
    await page.close();
}

/* The strip of the front page is cut, and opens under a hand: both by the keyboard. */
async function tissue(browser) {
    const page = await browser.page(url('web/tissue.html'));
    const begun = await page.until("document.querySelector('.live').live.state.frames > 5");
    say(begun, 'the tissue begins', page.errors.join(' ') || 'no frame');
    if (!begun) return page.close();
    await page.evaluate(`(async () => {
        const { state, canvas, hand, drawing } = document.querySelector('.live').live;
        const edges = () => new Promise(done => { /* drawn in the next frame */
            const draw = drawing.body, ink = canvas.getContext('2d');
            drawing.body = (...frame) => {
                let n = 0;
                ink.moveTo = (x, y) => { n++; CanvasRenderingContext2D.prototype.moveTo.call(ink, x, y); };
                const knots = draw(...frame);
                delete ink.moveTo;
                drawing.body = draw;
                done(n);
                return knots;
            };
        });
        const key = name => canvas.dispatchEvent(new KeyboardEvent('keydown',
            { key: name, bubbles: true }));
        const frames = async n => {
            for (const end = state.frames + n; state.frames < end;)
                await new Promise(done => requestAnimationFrame(done));
        };
        self.edges = [await edges()];
        hand.x = 0.01, hand.y = 0.83;
        key('Enter');
        for (let k = 0; k < 8; k++) { key('ArrowDown'); await frames(3); }
        key('Enter');
        await frames(3);
        self.edges.push(await edges());
        hand.x = 0.2, hand.y = 0.4;
        key('Enter');
        for (let k = 0; k < 8; k++) { key('ArrowUp'); await frames(3); }
        await frames(20);
        key('q');
    })()`);
    await page.until("document.querySelector('.live').live.state.status !== null");
    const { status, lines } = await page.evaluate("(({status, lines}) => ({status, lines}))" +
        "(document.querySelector('.live').live.state)");
    const frames = rows(lines, 'frames');
    const least = Math.min(...frames.map(row => Number(row.min_J)));
    const lost = frames.filter(row => row.rung === 'lost').length;
    const [whole, cut] = [0, frames.length - 1].map(k => Number(frames[k].vertices));
    say(whole === 816 && cut === whole + 7, 'the knife opens the tissue along seven edges',
        `${whole} vertices, then ${cut}`);
    const [before, after] = await page.evaluate('self.edges');
    say(after === before + 21, 'each edge that is cut is drawn twice, and as the rim',
        `${before} lines, then ${after}`);
    say(status === 0 && frames.length > 40 && lost === 0 && least < 0.95 && least > 0,
        'the tissue is pulled by the keyboard, no frame lost',
        `status ${status}, ${frames.length} frames, ${lost} lost, least J ${least}`);
    await page.close();
    await lips(browser);
}

/* At the edge of the right lip of the cut the hand takes vertices of that lip alone. */
async function lips(browser) {
    const page = await browser.page(url('web/tissue.html'));
    await page.until("document.querySelector('.live').live.state.frames > 5");
    const taken = await page.evaluate(`(async () => {
        const { canvas, hand, drawing, press, state } = document.querySelector('.live').live;
        const enter = () => canvas.dispatchEvent(new KeyboardEvent('keydown',
            { key: 'Enter', bubbles: true }));
        const frames = async (n, x, y) => {
            Object.assign(hand, { x, y });
            for (const end = state.frames + n; state.frames < end;)
                await new Promise(done => requestAnimationFrame(done));
        };
        await frames(1, 0, 0.8);
        enter();
        await frames(3, 0, 0.8);
        await frames(3, 0, 0.05);
        enter();
        await frames(3, 0.04, 0.45);
        enter();
        const draw = drawing.body;
        for (let k = 0; k < 9; k++) await new Promise(done => { drawing.body = (frame, hand) => {
            const at = [...frame.rest], lowest = Math.min(...at.filter((y, r) => r % 2));
            self.taken = [...frame.held].map((held, a) => held && at[2 * a + 1] > lowest ?
                at[2 * a] : 0).filter(x => x !== 0);
            done();
            return draw(frame, hand);
        }; });
        press('q');
        return self.taken;
    })()`);
    say(taken.length > 5 && taken.every(x => x > 0), 'a hand on the right lip of the cut takes ' +
        'nothing of the left one', taken);
    say(page.errors.length === 0, 'no error on the page of the tissue', page.errors.join(' '));
    await page.close();
}

/* A finger on a small screen drags the square, and not the page. */
async function touch(browser) {
    const page = await browser.page(url('web/live.html'), 390, 800);
    await page.send('Emulation.setTouchEmulationEnabled', { enabled: true });
    await page.until("document.querySelector('.live').live.state.frames > 5");
    const box = await page.evaluate(`(() => {
        const canvas = document.querySelector('.live canvas');
        canvas.scrollIntoView({ block: 'center' });
        const r = canvas.getBoundingClientRect();
        return { x: r.left + r.width / 2, y: r.top + r.height / 2, scale: r.width / 5.6,
                 top: scrollY, wide: document.documentElement.scrollWidth };
    })()`);
    const finger = (type, x, y) => page.send('Input.dispatchTouchEvent', { type, touchPoints:
        type === 'touchEnd' ? [] : [{ x: box.x + x * box.scale, y: box.y - y * box.scale }] });
    await finger('touchStart', 0.95, 0.5);
    const begun = await page.evaluate("document.querySelector('.live').live.state.frames");
    for (let k = 1; k <= 20; k++) {
        await finger('touchMove', 0.95 + 0.03 * k, 0.5 - 0.06 * k);
        await new Promise(done => setTimeout(done, 40));
    }
    await page.until(`document.querySelector('.live').live.state.frames > ${begun + 20}`);
    const { top, hand } = await page.evaluate("({ top: scrollY, " +
        "hand: document.querySelector('.live').live.hand })");
    await finger('touchEnd');
    await page.until("!document.querySelector('.live').live.hand.down");
    await page.evaluate("document.querySelector('.live').live.press('q')");
    await page.until("document.querySelector('.live').live.state.status !== null");
    const { lines } = await page.evaluate("(({lines}) => ({lines}))" +
        "(document.querySelector('.live').live.state)");
    const frames = rows(lines, 'frames'), end = frames[frames.length - 1] || {};
    const strained = Math.max(...frames.map(row => Number(row.energy)));
    say(hand.down === 1 && Math.abs(hand.x - 1.55) < 0.02 && Math.abs(hand.y + 0.7) < 0.02 &&
        top === box.top && box.wide <= 390 && strained > 10,
        'a finger drags the square, and not the page', JSON.stringify({ hand, top, box,
            strained, end }));
    say(page.errors.length === 0, 'no error under a finger', page.errors.join(' '));
    await page.close();
}

/* The front leads to the pages, and the chapter begins the square when it is asked. */
async function pages(browser) {
    const front = await browser.page(url('index.html'));
    const leads = await front.evaluate("['tissue', 'live', 'choose'].filter(name => " +
        "document.querySelector(`a[href='web/${name}.html']`)).length");
    say(leads === 3, 'the front leads to the three pages', leads);
    await front.close();
    const live = await browser.page(url('web/live.html'));
    await live.until("document.querySelector('.live').live.state.frames > 10");
    const nameless = await live.nameless();
    const seen = await live.evaluate("(() => { const { canvas } = document.querySelector('.live').live; " +
        "canvas.focus(); return document.activeElement === canvas && " +
        "!!document.getElementById(canvas.getAttribute('aria-describedby')) && " +
        "document.querySelectorAll('.live .keys button').length > 3; })()");
    say(nameless.length === 0 && seen, 'what is on the live page has its name', `${nameless} ${seen}`);
    await live.close();
    const page = await browser.page(url('lessons/24_live.html'));
    const before = await page.evaluate("!self.programs.live");
    await page.evaluate("document.querySelector('.live .start').click()");
    const begun = await page.until("document.querySelector('.live').live.state.frames > 5");
    say(before && begun && page.errors.length === 0, 'the chapter begins the square when ' +
        'it is asked', `without a program ${before}, begun ${begun}, ${page.errors.join(' ')}`);
    await page.close();
}

const folder = mkdtempSync(join(tmpdir(), 'live-'));
const browser = await open();
try {
    const asked = name => part === 'all' || part === name;
    if (asked('log')) await square(browser, folder, 'log', [], 2026);
    if (asked('cubic'))
        await square(browser, folder, 'cubic', [[3, 'l'], [200, 'i'], [400, 'i']], 14);
    if (asked('losses')) await losses(browser);
    if (asked('tissue')) await tissue(browser);
    if (asked('touch')) await touch(browser);
    if (asked('pages')) await pages(browser);
} finally {
    await browser.close();
    rmSync(folder, { recursive: true });
}
process.exit();
