/*
 * student.mjs SITE BUILD - a student's file is compiled and judged in a headless Chromium: how
 * long that takes, from a plain server, for the first time and later; that the page stays
 * awake, and that what is loaded is loaded once.
 */
import {execFileSync} from 'node:child_process';
import {LOOP, read, withLine} from './cases.mjs';
import {open, serve} from './page.mjs';

const [site, build] = process.argv.slice(2);
const [L03, L12] = ['03_dirichlet_correction', '12_triangles'];
const solution = lesson => read(`solutions/${lesson}.c`);

const server = await serve(site), {asked} = server, origin = server.address;
const browser = await open();

async function attempt(what, body) {
    try {
        const said = await body();
        console.log(`ok web student: ${what}${said ? ': ' + said : ''}`);
    } catch (error) {
        console.log(`FAIL web student: ${what}: ${error.message.replace(/\n/g, ' | ')}`);
    }
}
function expect(condition, said) { if (!condition) throw new Error(JSON.stringify(said)); }

/* A page with a student, and what may be asked in it. */
async function begin(url) {
    const page = await browser.page(url);
    await page.evaluate(`new Promise((done, failed) => {
        const script = document.createElement("script");
        script.src = "${url.replace(/index.html$/, '')}web/student.js";
        script.onload = done;
        script.onerror = failed;
        document.head.append(script);
    }).then(() => { self.mine = makeStudent({base: "student/"}); })`);
    page.check = (lesson, text, options = '') => page.evaluate(`(async () => {
        const begin = performance.now();
        let ticks = 0;
        const clock = setInterval(() => ticks++, 20);
        try {
            return {...await mine.check("${lesson}", ${JSON.stringify(text)}, {${options}}),
                    seconds: (performance.now() - begin) / 1e3, ticks};
        } catch (error) {
            return {name: error.name, message: error.message};
        } finally {
            clearInterval(clock);
        }
    })()`);
    return page;
}
const ok = (result) => {
    expect(result.verdict === 'OK', result);
    return `${result.seconds.toFixed(1)} s`;
};

let page = await begin(`${origin}index.html`);
const patient = 'patience: 20';
await attempt('its size is said', async () => {
    const bytes = await page.evaluate(`mine.size("${L03}")`);
    expect(bytes > 20e6 && bytes < 35e6, bytes);
    return (bytes / 1e6).toFixed(1) + ' MB';
});
await attempt('the first time, lesson 03', async () => ok(await page.check(L03, solution(L03), patient)));
await attempt('again, lesson 03 with a blank more', async () => ok(await page.check(L03, solution(L03) + '\n', patient)));
await attempt('it runs with options', async () => {
    const its = await page.evaluate(`mine.run("${L03}", ${JSON.stringify(solution(L03))}, ["--n", "4"])`);
    expect(its.end === 'exit' && its.status === 0 && its.stdout.startsWith('# '), its);
});
await attempt('an endless loop is a TIMEOUT, and the page stays awake', async () => {
    const its = await page.check(L03, withLine(L03, LOOP));
    expect(its.verdict === 'TIMEOUT' && its.ticks > 100, its);
    return `${its.seconds.toFixed(1)} s`;
});
await attempt('300 frames of lesson 12 in the hand have the native numbers', async () => {
    const input = `${build}/test/student.txt`;
    const native = execFileSync('sh', ['tests/tools/hand.sh', L12, `solutions/${L12}.c`], {encoding: 'utf8',
        env: {...process.env, WINDOW: 'no', MINE: `${build}/test/student`, ARGS: `--input hard --record ${input}`}}) &&
        read(`${build}/test/student/${L12}.hand.tsv`);
    const pointers = read(input).trim().split('\n').map(line => line.split(' '))
        .map(([x, y, down, key]) => ({x: +x, y: +y, down: +down, key}));
    const its = await page.evaluate(`(async () => {
        const hand = await mine.hand("${L12}", ${JSON.stringify(read(`lessons/${L12}.c`))});
        const begin = performance.now();
        let frames = 0, last = null, most = 0;
        for (const pointer of ${JSON.stringify(pointers)}) {
            const picture = await hand.frame(pointer);
            if (!picture) break;
            frames++;
            most = Math.max(most, picture.ms);
            last = {points: picture.x.length / 2, triangles: picture.value.length, caption: picture.caption};
        }
        const seconds = (performance.now() - begin) / 1e3;
        await hand.close();
        return {end: hand.end, said: hand.diagnostics, stdout: hand.stdout, frames, last, most, seconds};
    })()`);
    const rows = text => text.split('\n').filter(line => /^\d/.test(line));
    const [a, b] = [its.stdout, native].map(rows);
    const bad = a.findIndex((row, k) => row !== b[k]);
    expect(its.frames === 300 && a.length === 300 && bad < 0, {...its, stdout: a[bad], native: b[bad], rows: [a.length, b.length]});
    expect(/yours: none; reference: 12a/.test(its.last.caption), its.last);
    return `${its.seconds.toFixed(1)} s, the longest ${its.most.toFixed(1)} ms`;
});
await attempt('a scene that is closed within a frame has its whole table', async () => {
    const its = await page.evaluate(`(async () => {
        const hand = await mine.hand("${L12}", ${JSON.stringify(solution(L12))});
        for (let k = 0; k < 5; k++) await hand.frame({x: 1, y: 0});
        hand.frame({x: 1, y: 0});
        await hand.close();
        return {end: hand.end, said: hand.diagnostics, stdout: hand.stdout};
    })()`);
    expect(its.end === 'exit' && its.stdout.split('\n').filter(line => /^\d/.test(line)).length === 6, its);
});
await attempt('a slot that crashes ends the scene with its name', async () => {
    const text = solution(L12).replace(/(\/\* SLOT 12e[^]*?\*\/\n)/, '$1int *volatile nowhere = (int *)-4096L; *nowhere = 1;\n');
    const its = await page.evaluate(`(async () => {
        const hand = await mine.hand("${L12}", ${JSON.stringify(text)});
        const picture = await hand.frame({x: 1, y: 0});
        return {picture, end: hand.end, said: hand.diagnostics};
    })()`);
    expect(its.picture === null && its.end === 'crash' && /^live-12: CRASHED \(slot 12e\)/.test(its.said), its);
});
await attempt('after a reload nothing is asked of the server again', async () => {
    page = await begin(`${origin}index.html`);
    const bytes = await page.evaluate(`mine.size("${L03}")`);
    const said = ok(await page.check(L03, solution(L03), patient));
    expect(bytes === 0 && asked['/student/llvm.core.wasm.gz'] === 1, [bytes, asked]);
    return said;
});
await attempt('a new version of a lesson is loaded, and nothing else', async () => {
    server.change = (path, bytes) => path !== '/student/files.json' ? bytes
        : String(bytes).replace(RegExp(`("${L03}.tar.gz"[^}]*"sum": ")`), '$11');
    page = await begin(`${origin}index.html`);
    const said = ok(await page.check(L03, solution(L03), patient));
    expect(asked[`/student/${L03}.tar.gz`] === 2 && asked['/student/llvm.core.wasm.gz'] === 1, asked);
    return said;
});
await browser.close();
server.close();
process.exit(0);
