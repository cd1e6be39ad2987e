/*
 * panel.mjs SITE BUILD [Stop | LESSON...] - the panel "Write" in a headless Chromium.  The nine
 * texts of cases.mjs are each put into the editor of their chapter, and checked by the
 * button: the report is that of make check-NN.  Says how many seconds there are from click
 * to verdict.  Before that, Stop ends each phase of Run, Check and In your hand.
 */
import {open, serve} from './page.mjs';
import {LOOP, differs, lessons, native, nine, read, withLine} from './cases.mjs';

const [site, build, ...asked] = process.argv.slice(2);
const server = await serve(site), browser = await open();

/* In the page: the report on a text, and the seconds until it is there. */
const check = async (text, patience) => {
    const box = document.querySelector('.write'), button = box.querySelector('[name=check]');
    box.editor.setText(text);
    Object.assign(box, {patience, result: null});
    const begin = performance.now();
    button.click();
    while (button.disabled) await new Promise(done => setTimeout(done, 20));
    const report = box.querySelector('.verdict');
    return {seconds: (performance.now() - begin) / 1e3, verdict: box.result?.verdict,
            said: report.hidden ? '' : report.textContent,
            state: box.querySelector('[role=status]').textContent};
};

/* In the page: press Stop so many ms after the status begins with these words. */
const stopIn = async (name, words, text, ms) => {
    const box = document.querySelector('.write'), button = box.querySelector(`[name=${name}]`);
    const state = box.querySelector('[role=status]');
    let begin = NaN;
    const watch = new MutationObserver(() => {
        if (!state.textContent.startsWith(words)) return;
        watch.disconnect();
        setTimeout(() => { begin = performance.now(); box.querySelector('[name=stop]').click(); }, ms);
    });
    watch.observe(state, {childList: true});
    box.editor.setText(text);
    button.click();
    while (button.disabled) await new Promise(done => setTimeout(done, 20));
    return {seconds: (performance.now() - begin) / 1e3, state: state.textContent};
};
const STOPS = [['check', 'Loading the compiler'], ['check', 'Loading the lesson'], ['check', 'Compiling'],
    ['check', 'Linking'], ['check', 'Checking'], ['run', 'Running ...'], ['run', 'Running the reference'],
    ['hand', 'Compiling'], ['hand', 'In your hand'], ['hand', 'In your hand']];
async function stops(lesson) {
    const page = await browser.page(`${server.address}lessons/${lesson}.html#write`);
    await page.until("document.querySelector('.write').editor !== undefined");
    let workers = 0;
    page.onWorker = change => { workers += change; };
    for (const [k, [name, words]] of STOPS.entries()) {
        const hand = words === 'In your hand', hangs = /^(Checking|Running \.)/.test(words) || k === STOPS.length - 1;
        const text = (hangs ? withLine(lesson, LOOP) : read(`solutions/${lesson}.c`)) + '\n'.repeat(k);
        const {seconds, state} = await page.evaluate(`(${stopIn})(${JSON.stringify([name, words, text, hand ? 1000 : 0]).slice(1, -1)})`);
        const end = hand ? 'The scene has ended.' : 'You have stopped it.';
        const what = `Stop while it says "${words}"${hand && hangs ? ', and a frame does not end' : ''}`;
        const most = /^(Load|Comp|Link)/.test(words) ? 0 : 1; /* of these the compiler's stays */
        for (let wait = 0; workers > most && wait < 50; wait++) await new Promise(done => setTimeout(done, 100));
        console.log(state === end && seconds < 5 && workers <= most ? `ok web panel: ${what}: after ${seconds.toFixed(1)} s`
                                                : `FAIL web panel: ${what}: ${state} ${seconds} s, ${workers} workers`);
    }
    await page.close();
}
if (!asked.length || asked[0] === 'Stop') await stops('12_triangles');

for (const lesson of lessons.filter(name => (asked.length ? asked : ['03', '12', '16', '20', '24', '26']).some(nn => name.startsWith(nn)))) {
    const page = await browser.page(`${server.address}lessons/${lesson}.html#write`);
    await page.until("document.querySelector('.write').editor !== undefined");
    for (const [what, verdict, text] of nine(lesson)) {
        const its = await page.evaluate(`(${check})(${JSON.stringify(text)}, ${verdict === 'TIMEOUT' ? 1 : 20})`)
            .catch(error => ({verdict: error.message, seconds: 0}));
        const bad = !its.verdict?.match(verdict) ? `it is ${its.verdict}, ${its.state}: ${its.said}`
            : differs(its.said, native(build, lesson, text));
        console.log(bad ? `FAIL web panel: ${lesson} ${what}: ${bad.replace(/\n/g, ' | ')}`
                        : `ok web panel: ${lesson} ${what}: ${its.verdict} after ${its.seconds.toFixed(1)} s`);
    }
    if (page.errors.length) console.log(`FAIL web panel: ${lesson}: ${page.errors.join(' ')}`);
    await page.close();
}
await browser.close();
server.close();
process.exit(0);
