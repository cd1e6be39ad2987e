/*
 * write.mjs SITE [BUILD keys] - the editor of a chapter in a headless Chromium.
 *
 * Lesson 03 is written by keys alone, from the starter to the solution, with a reload
 * in between; the file that is downloaded passes make check-03, and in the page it is
 * run and judged; with "keys" all that before make.  Lines "ok web: WHAT" and "FAIL web: WHAT: why".
 */
import { execFileSync, spawnSync } from 'node:child_process';
import { existsSync, mkdtempSync, readFileSync, rmSync, writeFileSync, copyFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join, resolve } from 'node:path';
import { open, say, serve } from './page.mjs';

const site = resolve(process.argv[2]);
const LESSON = '03_dirichlet_correction', FILE = `${LESSON}.c`;
const starter = readFileSync(`lessons/${FILE}`, 'utf8'), solution = readFileSync(`solutions/${FILE}`, 'utf8');
const WRITE = "document.querySelector('.write')";
const code = (text, slot) => new RegExp(`/\\* SLOT ${slot}\\b[^]*?\\*/\\n([^]*?)\\n *\\/\\* END ${slot}`).exec(text)[1];
const bare = text => text.replace(/\s+/g, '');

const folder = mkdtempSync(join(tmpdir(), 'write-'));
const server = await serve(site), browser = await open();
const url = `${server.address}lessons/${LESSON}.html`, page = await browser.page(url);
const script = (f, ...args) => page.evaluate(`(${f})(${args.map(a => JSON.stringify(a))})`);
const text = () => page.evaluate(`${WRITE}.editor.text()`);
const line = () => page.evaluate(`(({state}) => state.doc.lineAt(state.selection.main.head).text)(${WRITE}.editor.view)`);
const said = () => page.evaluate(`${WRITE}.querySelector('[role=status]').textContent`);
const press = name => page.evaluate(`${WRITE}.querySelector('button[name=${name}]').click()`);
async function ready() {
    await page.evaluate(`${WRITE}.scrollIntoView()`);
    return page.until(`${WRITE}.editor !== undefined`);
}
/* Tab until the focus is in the editor. */
async function enter() {
    await page.evaluate(`${WRITE}.querySelector('#write-hint a').focus()`);
    for (let k = 0; k < 5; k++) {
        await page.key('Tab');
        if (await page.evaluate("document.activeElement.classList.contains('cm-content')")) return true;
    }
    return false;
}
/* With the cursor in the editor: replace the line todo("3a") by the code of the solution. */
async function write(slot) {
    for (let k = 0; k < 200 && !(await line()).includes(`todo("${slot}"`); k++) await page.key('ArrowDown');
    await page.key('Home');
    await page.key('End', undefined, 8); /* with Shift */
    await page.type(code(solution, slot).split('\n').map(one => one.trim()).join('\n'));
}
/* Press Run or Check and wait for its end. */
async function work(name) {
    await press(name);
    return page.until(`!${WRITE}.querySelector('[name=run]').disabled`);
}
/* Of these [role, name, what else is said of it] what a screen reader has not. */
async function spoken(...wanted) {
    const { nodes } = await page.send('Accessibility.getFullAXTree'), status = await said();
    return wanted.filter(([role, name, more = '']) => !nodes.some(node => !node.ignored && node.role?.value === role &&
        (role === 'status' ? status : node.name?.value) === name &&
        (JSON.stringify([node.description, node.properties]) || '').includes(more)));
}
async function upload(path) {
    const { root } = await page.send('DOM.getDocument');
    const { nodeId } = await page.send('DOM.querySelector', { nodeId: root.nodeId, selector: '[name=upload]' });
    await page.send('DOM.setFileInputFiles', { nodeId, files: [path] });
}

try {
    say(await ready() && await text() === starter, 'the editor has the starter', page.errors.join(' '));
    const folds = await page.evaluate(`[...${WRITE}.querySelectorAll('.folded')].map(one => one.textContent).join()`);
    say(/^\d+ lines, folded,\d+ lines, folded$/.test(folds), 'what has no slot is folded', folds);

    /* by keys alone */
    say(await enter(), 'Tab reaches the editor', await page.evaluate('document.activeElement.outerHTML.slice(0, 90)'));
    await write('3a');
    await page.key('ArrowDown');
    const before = await text();
    await page.type('x');
    say(await text() === before && /END 3a/.test(await line()), 'what is no slot cannot be changed', await line());
    await page.go(url);
    await ready();
    say(bare(await text()) === bare(before), 'what was written survives a reload', (await text()).slice(0, 80));
    await enter();
    await write('3b');
    await write('3c');
    const written = await text();
    const same = ['3a', '3b', '3c'].filter(slot => bare(code(written, slot)) === bare(code(solution, slot)));
    say(same.length === 3, 'lesson 03 is written by keys', same + code(written, '3b'));
    await page.key('Escape');
    await page.key('Tab');
    const left = [];
    for (let k = 0; k < 6; k++, await page.key('Tab')) left.push(await page.evaluate('document.activeElement.name'));
    say(`${left}` === 'run,check,download,upload,reset,all', 'Escape, then Tab leaves the editor for the buttons', left);
    const nothing = await spoken(['textbox', `lessons/${FILE}`, 'Escape, then Tab leaves the editor'],
        ...['Run', 'Check', 'Stop', 'Download', 'Begin again'].map(name => ['button', name]), ['checkbox', 'the whole file']);
    say(nothing.length === 0, 'what one writes with is spoken', nothing);

    /* predictions in the file that is downloaded */
    await script(() => {
        guesses[0].value = '-238.5';
        guesses[0].dispatchEvent(new Event('input', { bubbles: true }));
    });
    await page.send('Page.setDownloadBehavior', { behavior: 'allow', downloadPath: folder });
    await press('download');
    for (let k = 0; k < 100 && !existsSync(join(folder, FILE)); k++) await new Promise(done => setTimeout(done, 100));
    const down = existsSync(join(folder, FILE)) ? readFileSync(join(folder, FILE), 'utf8') : '';
    say(/PREDICT 1 [^:]*: -238\.5\n/.test(down) && down.replace('-238.5\n', '...\n') === written,
        'the file is downloaded, with what was predicted', down.slice(0, 200));
    if (process.argv[4] === 'keys') throw 'enough';
    const copy = join(folder, 'copy');
    execFileSync('sh', ['tests/tools/copy.sh', copy, LESSON], { env: process.env });
    copyFileSync(join(folder, FILE), join(copy, 'lessons', FILE));
    const check = spawnSync('make', ['check-03'], { cwd: copy, encoding: 'utf8', env: { ...process.env, BUILD: 'build',
        MAKEFLAGS: '' } });
    say(check.status === 0 && /VERDICT 03: OK/.test(check.stdout) && /1: -238.5, measured -238.5, right/.test(
        check.stdout.replace(/\s+/g, ' ')), 'make check-03 passes it', check.stdout.slice(-400) + check.stderr);

    /* in the page: the same words, numbers over the reference's, and how far one is */
    server.hidden = /^.student./;
    await work('check');
    say(/cannot be read/.test(await said()), 'without the compiler it says why', await said());
    server.hidden = null;
    const begin = Date.now();
    await page.evaluate(`${WRITE}.editor.view.focus()`);
    await page.key('Enter', undefined, 2); /* with Ctrl */
    await page.until(`!${WRITE}.querySelector('[name=run]').disabled`);
    const passed = await page.evaluate(`${WRITE}.result`);
    const own = passed.text.split('\n').filter(one => !check.stdout.includes(one));
    say(passed.verdict === 'OK' && passed.text.length > 300 && own.length === 0,
        'Check says what make check-03 says', `${passed.verdict} ${own}`);
    console.log(`web: the first verdict after ${((Date.now() - begin) / 1e3).toFixed(1)} s`);
    const lacks = await spoken(['region', 'the report'], ['status', 'Verdict: OK. The report.', 'polite']);
    say(lacks.length === 0, 'the verdict is spoken, and the report has a name', lacks);
    const after = await page.evaluate(`[!${WRITE}.querySelector('.after').hidden, guesses.every(field =>
        /^measured/.test(field.nextElementSibling.textContent))].join()`);
    say(after === 'true,true', 'after a pass there are the solution and what was measured', after);
    await work('run');
    const differ = () => page.evaluate(`[${WRITE}.querySelectorAll('.results .plot svg').length,
        ${WRITE}.querySelectorAll('.results .reference').length > 1,
        ${WRITE}.querySelectorAll('td.differs').length].join()`);
    say(await differ() === '1,true,0', 'Run draws over the reference, and nothing differs', await differ());
    const wrong = down.replace('-= A[i * N + node[k]]', '+= A[i * N + node[k]]');
    await script(text => document.querySelector('.write').editor.setText(text), wrong);
    await work('run');
    const cells = (await differ()).split(',');
    say(wrong !== down && cells[0] === '1' && Number(cells[2]) > 5, 'cells that differ are marked', cells);
    await work('check');
    const why = await page.evaluate(`${WRITE}.result`);
    const first = await page.evaluate(`${WRITE}.querySelector('button.first').value`);
    say(why.verdict === 'WRONG' && why.slot === '3a' && /lift_sign/.test(why.text) && first === 'slot 3a' &&
        (await page.evaluate(`${WRITE}.querySelector('.verdict').textContent`)) === why.text,
        'a wrong sign is told, with its hint first', why.text);
    await script(text => document.querySelector('.write').editor.setText(text), wrong.replace('+= A[i', '+= A[[i'));
    await work('check');
    const marked = await page.evaluate(`${WRITE}.querySelectorAll('.cm-lintRange-error').length`);
    say(/NOT COMPILED/.test(await said()) && marked > 0, 'what does not compile is marked', `${await said()} ${marked}`);
    await script(text => document.querySelector('.write').editor.setText(text), down.replace('r[i] = -b[i];',
        'for (;;) r[i] = -b[i];'));
    await press('run');
    await page.until(`/Running|Compiling/.test(${WRITE}.querySelector('[role=status]').textContent)`);
    await page.evaluate(`${WRITE}.querySelector('[name=stop]').focus()`);
    await page.key('Enter', '\r');
    say(await page.until(`!${WRITE}.querySelector('[name=run]').disabled`) && /You have stopped/.test(await said()) &&
        await page.evaluate('document.activeElement.name') === 'check', 'Stop ends it', await said());
    await page.go(`${server.address}index.html`);
    const far = await page.evaluate("document.querySelector('.progress').textContent + document.querySelector(" +
        "'[data-lesson=\"03_dirichlet_correction\"]').textContent");
    say(/passed 1 of \d\d lessons.*passed$/.test(far), 'the front knows what is passed', far);
    await page.go(url);
    await ready();

    /* reset and upload */
    await script(text => document.querySelector('.write').editor.setText(text), down);
    await press('reset');
    const asked = await text() === down;
    await press('reset');
    say(asked && bare(await text()).replace('-238.5', '...') === bare(starter), 'reset asks once', asked);
    writeFileSync(join(folder, 'other.c'), 'int main(void) { return 0; }\n');
    await upload(join(folder, 'other.c'));
    await page.until(`/no slot 3a/.test(${WRITE}.querySelector('[role=status]').textContent)`);
    const refused = await said();
    await upload(join(folder, FILE));
    const taken = await page.until(`${WRITE}.editor.text().includes('g[k];')`);
    say(/other.c has no slot 3a/.test(refused) && taken && await text() === down,
        'the very file is uploaded, another one is not', refused);

    /* hints come one by one */
    const levels = await script(() => {
        const choice = document.querySelector('.write button[value="slot 3b"]');
        return [0, 1, 2].map(() => { choice.click();
            return document.querySelectorAll('.hint-text:not([hidden])').length; }).join() + choice.disabled;
    });
    say(levels === '1,2,3true', 'hints come one by one', levels);
    const local = await browser.page(`file://${site}/lessons/${LESSON}.html`), its = `[${WRITE}.querySelector('.size'),
        ${WRITE}.querySelector('[role=status]')].map(one => one.textContent)`;
    await local.evaluate(`${WRITE}.scrollIntoView(), ${WRITE}.querySelector('[name=check]').click()`);
    await local.until(`${WRITE}.editor !== undefined && ${its}.every(text => text.length > 20)`);
    const both = await local.evaluate(its);
    say(both[0] === both[1] && /python3 -m http.server.*make check-03/.test(both[0]) && local.errors.length === 0,
        'from a file it says what to do', `${both} ${local.errors}`);
    await local.close();
    const nameless = await page.nameless();
    const wide = await page.evaluate('document.documentElement.scrollWidth - innerWidth');
    say(nameless.length === 0 && wide <= 0, 'all that can be used has its name', `${nameless}, ${wide} pixels too wide`);
    say(page.errors.length === 0, 'no error where one writes', page.errors.join(' '));

    /* lesson 12 in the hand, with the reference's slots where none is written */
    await page.go(`${server.address}lessons/12_triangles.html`);
    await ready();
    await press('hand');
    const live = "document.querySelector('.hand .live')?.live";
    const begun = await page.until(`${live}?.state.frames > 9`);
    await page.evaluate(`${live}.canvas.dispatchEvent(new KeyboardEvent('keydown', { key: 'Enter', bubbles: true }))`);
    for (let k = 0; k < 5; k++) await page.key('ArrowUp');
    await page.until(`${live}.state.frames > 60`);
    const words = await page.evaluate("document.querySelector('.hand .said').textContent");
    await press('stop');
    const over = await page.until(`/has ended/.test(${WRITE}.querySelector('[role=status]').textContent)`);
    const [frames, rows] = await page.evaluate(`[${live}.state.frames,
        ${live}.state.lines.filter(line => /^\\d/.test(line)).length]`);
    say(begun && over && /reference: 12a/.test(words) && frames > 60 && rows >= frames && page.errors.length === 0,
        'lesson 12 is taken into the hand', `${begun} ${over} ${frames} ${rows} ${words} ${page.errors}`);

    /* without a network: what was opened before, and the compiler, are kept */
    server.close();
    await page.go(url);
    const kept = await ready();
    if (kept) await script(text => document.querySelector('.write').editor.setText(text), down + '\n');
    if (kept) await work('check');
    say(kept && /Verdict: OK/.test(await said()), 'without a network it is all there', kept ? await said() : 'no page');
} catch (end) {
    if (end !== 'enough') throw end;
} finally {
    await browser.close();
    server.close();
    rmSync(folder, { recursive: true });
}
process.exit();
