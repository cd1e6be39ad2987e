/*
 * write.mjs SITE - the editor of a chapter in a headless Chromium.
 *
 * Lesson 03 is written by keys alone, from the starter to the solution, with a reload
 * in between; the file that is downloaded passes make check-03, and in the page it is
 * run and judged.  Lines "ok web: WHAT" and "FAIL web: WHAT: why".
 */
import { execFileSync, spawnSync } from 'node:child_process';
import { existsSync, mkdtempSync, readFileSync, rmSync, writeFileSync, copyFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join, resolve } from 'node:path';
import { open, serve } from './page.mjs';

const site = resolve(process.argv[2]);
const LESSON = '03_dirichlet_correction', FILE = `${LESSON}.c`;
const starter = readFileSync(`lessons/${FILE}`, 'utf8'), solution = readFileSync(`solutions/${FILE}`, 'utf8');
const WRITE = "document.querySelector('.write')";
let failed = 0;
function say(good, what, why) {
    console.log(good ? 'ok web: ' + what : 'FAIL web: ' + what + ': ' + why);
    failed += !good;
}
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
    return page.until(`${WRITE}.editor !== undefined`, 20);
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
    const left = await page.evaluate('document.activeElement.name');
    say(left === 'run', 'Escape, then Tab leaves the editor', left);

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
    const copy = join(folder, 'copy');
    execFileSync('sh', ['tests/tools/copy.sh', copy, LESSON], { env: process.env });
    copyFileSync(join(folder, FILE), join(copy, 'lessons', FILE));
    const check = spawnSync('make', ['check-03'], { cwd: copy, encoding: 'utf8', env: { ...process.env, BUILD: 'build',
        MAKEFLAGS: '' } });
    say(check.status === 0 && /VERDICT 03: OK/.test(check.stdout) && /1: -238.5, measured -238.5, right/.test(
        check.stdout.replace(/\s+/g, ' ')), 'make check-03 passes it', check.stdout.slice(-400) + check.stderr);

    /* reset and upload */
    await press('reset');
    const asked = await text() === down;
    await press('reset');
    say(asked && bare(await text()).replace('-238.5', '...') === bare(starter), 'reset asks once', asked);
    writeFileSync(join(folder, 'other.c'), 'int main(void) { return 0; }\n');
    await upload(join(folder, 'other.c'));
    await page.until(`/no slot 3a/.test(${WRITE}.querySelector('[role=status]').textContent)`, 5);
    const refused = await said();
    await upload(join(folder, FILE));
    const taken = await page.until(`${WRITE}.editor.text().includes('g[k];')`, 5);
    say(/other.c has no slot 3a/.test(refused) && taken && await text() === down,
        'the very file is uploaded, another one is not', refused);

    /* hints come one by one */
    const levels = await script(() => {
        const choice = document.querySelector('.write button[value="slot 3b"]');
        return [0, 1, 2].map(() => { choice.click();
            return document.querySelectorAll('.hint-text:not([hidden])').length; }).join() + choice.disabled;
    });
    say(levels === '1,2,3true', 'hints come one by one', levels);
    const nameless = await page.nameless();
    const wide = await page.evaluate('document.documentElement.scrollWidth - innerWidth');
    say(nameless.length === 0 && wide <= 0, 'all that can be used has its name', `${nameless}, ${wide} pixels too wide`);
    say(page.errors.length === 0, 'no error where one writes', page.errors.join(' '));
} finally {
    await browser.close();
    server.close();
    rmSync(folder, { recursive: true });
}
process.exit(failed ? 1 : 0);
