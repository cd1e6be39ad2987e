/*
 * mistakes.mjs SITE BUILD - do the tests of the pages notice mistakes?
 *
 * Each mistake changes a script in a copy of the site; the test of its part must then say
 * FAIL to the check that is named.  Lines "ok web: WHAT" and "FAIL web: WHAT: why".
 */
import { spawn } from 'node:child_process';
import { cpSync, mkdtempSync, readFileSync, rmSync, symlinkSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join, resolve } from 'node:path';
import { say } from './page.mjs';

const [site, build] = process.argv.slice(2).map(path => resolve(path));
const LIVE = (part, frames = 60) => ['tests/web/live.mjs', build, part, frames];
const CHOOSE = (scene = 'flap') => ['tests/web/choose.mjs', build, scene + '.scene'];
const WRITE = ['tests/web/write.mjs', build, 'keys'];
/* name, script, from, to, test, the check that fails */
const MISTAKES = [
    ['the hand is upside down', 'live_draw.js', 'middle - (event', 'middle + (event',
     LIVE('log'), 'the input is where the pointer was'],
    ['the input that is saved is that of the next frame', 'live.js',
     "read('input.txt') : ''", "read('input.txt').slice(read('input.txt').indexOf('\\n') + 1) : ''",
     LIVE('log'), 'rungs, systems and knots'],
    ['a key is lost', 'live.js', "pressed.shift() || '.'", "(pressed.shift(), '.')",
     LIVE('losses'), 'frames that are lost are said'],
    ['lost frames are not said', 'live.js', 'if (frame.lost !== state.lost) alert',
     'if (false) alert', LIVE('losses'), 'frames that are lost are said'],
    ['Enter does not grab', 'live.js', 'hand.down = hand.down ? 0 : 1', 'hand.down = 0',
     LIVE('tissue'), 'the tissue is pulled by the keyboard'],
    ['the edges are those of before the cut', 'live_draw.js', ' || edges.n !== n', '',
     LIVE('tissue'), 'each edge that is cut is drawn'],
    ['the program is loaded before it is asked for', 'live.js',
     "if (!('onDemand' in data)) return begin();", 'begin();', LIVE('pages'),
     'the chapter begins the square'],
    ['what an example does not say is kept', 'choose.js',
     "for (const input of word.inputs) input.value = '';", '', CHOOSE('thread'),
     'the answers to'],
    ['verify is not passed on', 'choose.js', "verify.checked ? 'yes' : 'no'", "'no'",
     CHOOSE('harder'), 'the answers to'],
    ['a crash is not noticed', 'run.js', 'self.addEventListener("unhandledrejection", crashed);', '',
     CHOOSE(), 'a crash is said'],
    ['a doubt is not in the frame', 'choose_answer.js', "now.head += ' ' + line;",
     'all.push({ head: line, text: [] });', CHOOSE('straight'), 'the frame has the answer'],
    ['the line above is marked', 'choose.js', 'at[line[1] - 1]', 'at[line[1] - 2]', CHOOSE(),
     'bad fields are refused'],
    ['a field without a label', 'choose.js', "made('label', last, { for: name, text: name })",
     "made('b', last, { text: name })", CHOOSE(), 'each field, link and picture'],
    ['the picture is mute', 'choose_answer.js', "'aria-label': 'Parts of the error in per cent, of '",
     "'data-label': 'Parts of the error in per cent, of '", CHOOSE(), 'each field, link and picture'],
    ['what is written is not kept', 'write.js', 'store.write(program, {text: now, time: Date.now()})',
     'true', WRITE, 'what was written survives'],
    ['a prediction does not go into the file', 'write.js',
     'editor.setPrediction(field.name, field.value.trim() || "...")', '{}', WRITE, 'the file is downloaded'],
    ['the canvas is mute', 'live.js', "'aria-label': data.label ||", "'data-label': data.label ||",
     LIVE('pages'), 'what is on the live page has its name']
];

function run(args) {
    return new Promise(done => {
        const child = spawn(process.execPath, args, { stdio: ['ignore', 'pipe', 'ignore'] });
        let out = '';
        child.stdout.on('data', data => { out += data; });
        child.on('close', () => done(out));
    });
}
for (const [name, script, from, to, [test, ...args], check] of MISTAKES) {
    const copy = mkdtempSync(join(tmpdir(), 'mistake-'));
    cpSync(join(site, 'web'), join(copy, 'web'), { recursive: true });
    for (const folder of ['programs', 'book.css', 'lessons', 'index.html', 'figures'])
        symlinkSync(join(site, folder), join(copy, folder));
    const path = join(copy, 'web', script), text = readFileSync(path, 'utf8');
    let why = text.split(from).length === 2 ? '' : 'does not fit ' + script;
    if (!why) {
        writeFileSync(path, text.split(from).join(to));
        const out = await run([test, copy, ...args]);
        if (!out.includes('FAIL web: ' + check)) why = 'not caught by: ' + check;
    }
    say(!why, 'mistake: ' + name, why);
    rmSync(copy, { recursive: true });
}
process.exit();
