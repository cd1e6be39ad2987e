/*
 * choose.mjs SITE BUILD [SCENE] - the page of the least model in a headless
 * Chromium: all scenes, or this one.
 *
 * For each example the page says what the program BUILD/choose says, but for what is
 * measured in seconds, and its picture has the numbers; bad fields are refused
 * in the program's own words.  Lines "ok web: WHAT" and "FAIL web: WHAT: why".
 */
import { spawnSync } from 'node:child_process';
import { mkdtempSync, readFileSync, readdirSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join, resolve } from 'node:path';
import { pathToFileURL } from 'node:url';
import { open, say } from './page.mjs';

const [site, native] = [process.argv[2], `${process.argv[3]}/choose`].map(path => resolve(path));
const only = process.argv[4];

const SCENES = readdirSync('lessons/scenes').filter(name => name.endsWith('.scene') &&
    (!only || name === only));
/* What is measured in seconds, and what follows from it. */
const timeless = out => out
    .replace(/[^ ]+ ms: (NOT )?within/g, 'MS')
    .replace(/about -?\d+ cells along/, 'about N cells along')
    .replace(/choosing took .*/, 'choosing took MS')
    .replace(/(choosing\s+pays) from run \d+ on/, '$1')
    .trimEnd();
function run(args, folder) {
    const { status, stdout, stderr } = spawnSync(native, args, { cwd: folder, encoding: 'utf8' });
    return { status, out: timeless(stdout), err: stderr.trim() };
}
/* The first line that differs. */
function differs(a, b) {
    const one = a.split('\n'), two = b.split('\n');
    const k = one.findIndex((line, i) => line !== two[i]);
    return k < 0 ? `${one.length} and ${two.length} lines` : `"${one[k]}" and "${two[k]}"`;
}

const folder = mkdtempSync(join(tmpdir(), 'choose-'));
const browser = await open();
const page = await browser.page(pathToFileURL(resolve(site, 'web/choose.html')).href);

/* Set the example and these fields, choose, and wait for the answer. */
async function answer(example, fields, error = '10', verify = false) {
    await page.evaluate(`(() => {
        const box = document.querySelector('.least-model'), f = box.fields;
        f.example.value = ${JSON.stringify(example)};
        f.example.dispatchEvent(new Event('change'));
        for (const [name, values] of Object.entries(${JSON.stringify(fields)}))
            f.words.find(w => w.word === name).inputs.forEach((input, i) => {
                input.value = values.split(' ')[i] || '';
            });
        f.error.value = ${JSON.stringify(error)};
        f.verify.checked = ${verify};
        f.form.requestSubmit();
    })()`);
    if (!await page.until("document.querySelector('.least-model').said")) return null;
    return page.evaluate("document.querySelector('.least-model').said");
}

try {
    let same = 0, pictures = 0, frames = 0, why = '';
    for (const file of SCENES) {
        const text = readFileSync(join('lessons/scenes', file), 'utf8');
        writeFileSync(join(folder, file), text);
        const verify = file === 'harder.scene';
        const there = run(['--scene', file, '--picture', 'picture', '--verify',
                           verify ? 'yes' : 'no'], folder);
        const here = await answer(file.replace('.scene', ''), {}, '10', verify);
        const good = here && here.status === there.status &&
            timeless(here.out) === there.out && here.err.trim() === there.err;
        same += good;
        if (!good) why += ` ${file}: ` + (here ? `${here.status} ${there.status} ` +
            differs(timeless(here.out) + here.err, there.out + there.err) : 'no answer');
        if (!there.out) continue;
        const bars = await page.evaluate("document.querySelectorAll('.answer rect').length");
        const links = await page.evaluate("document.querySelectorAll('.answer a').length");
        pictures += here && (!here.files.picture || bars === 7) && links > 3;
        const framed = await page.evaluate("document.querySelector('.least').textContent");
        const doubt = there.out.match(/^NOT SURE[^]*?\n  (.*)/);
        frames += here && framed.startsWith(there.out.split('\n')[0]) &&
            (doubt ? framed.includes(doubt[1]) : /Expected error/.test(framed));
    }
    say((only || SCENES.length >= 16) && same === SCENES.length,
        `the answers to ${SCENES.length} scenes are those of the program`, why);
    say(pictures >= SCENES.length - 1, 'an answer has its picture and its links', pictures);

    say(frames === SCENES.length, 'the frame has the answer, and why it is in doubt', frames);

    /* the words of the form are those of the program */
    const wrong = [
        ['nu', '0.7'], ['width', 'wide'], ['gravity', '0'], ['rho', ''], ['held', ''],
        ['height', '1'], ['end', '1'], ['E', '-3'], ['gravity', '0 0']];
    let refused = 0;
    why = '';
    for (const [name, value] of wrong) {
        const here = await answer('flap', { [name]: value });
        /* the same fields as a file */
        const file = await page.evaluate(`document.querySelector('.least-model').fields.words
            .map(w => [w.word, w.inputs.map(i => i.value.trim()).join(' ')])
            .filter(([, v]) => v.trim()).map(([w, v]) => w + ' ' + v).join('\\n') + '\\n'`);
        writeFileSync(join(folder, 'mine.scene'), file);
        const there = run(['--scene', 'mine.scene'], folder);
        const shown = await page.evaluate("document.querySelector('#wrong').textContent");
        const marked = await page.evaluate("document.activeElement.name === " +
            `${JSON.stringify(name)} && document.activeElement.getAttribute('aria-invalid')`);
        const whole = value === '0 0'; /* nothing is loaded: no field is at fault */
        const good = there.status === 2 && here && here.status === 2 &&
            here.err.trim() === there.err && shown.length > 9 && there.err.endsWith(shown) &&
            !/scene|line \d/.test(shown) && (whole || marked === 'true');
        refused += good;
        if (!good) why += ` ${name} '${value}': "${shown}" and "${there.err}", ${marked};`;
    }
    say(refused === wrong.length, 'bad fields are refused in the words of the program', why);
    const error = await answer('flap', {}, '0');
    say(error && error.status === 2 && error.err.trim() === run(['--scene', 'flap.scene', '--error', '0'],
        folder).err, 'a bad error is refused', error && error.err);

    /* a program that traps: no status, and nobody waits for the limit */
    await page.evaluate(`(() => { /* (module (func (export "f") unreachable)) */
        const trap = [0, 97, 115, 109, 1, 0, 0, 0, 1, 4, 1, 96, 0, 0, 3, 2, 1, 0, 7, 5, 1, 1, 102,
                      0, 0, 10, 5, 1, 3, 0, 0, 11];
        self.whole = programs.lessons;
        programs.lessons = { code: null, script: 'WebAssembly.instantiate(new Uint8Array([' + trap +
            '])).then(({ instance }) => instance.exports.f());' };
    })()`);
    const crashed = await answer('flap', {});
    const words = await page.evaluate("document.querySelector('[role=status]').textContent");
    say(crashed && crashed.end === 'crash' && /crashed: .*unreachable/.test(words), 'a crash is said',
        words);
    await page.evaluate("programs.lessons = self.whole");

    await answer('flap', {});
    const heard = await page.evaluate("document.activeElement.className === 'answer' && " +
        "document.querySelector('[role=status]') && document.querySelector('[role=alert]') && 'yes'");
    say(heard === 'yes', 'the answer is gone to, and what is wrong is said', heard);
    const nameless = await page.nameless();
    say(nameless.length === 0, 'each field, link and picture has a name', nameless);
    say(page.errors.length === 0, 'no error on the page of the least model',
        page.errors.join(' '));
} finally {
    await browser.close();
    rmSync(folder, { recursive: true });
}
process.exit();
