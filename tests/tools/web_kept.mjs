/*
 * web_kept.mjs SITE MISTAKES/NN_slug - what the judge of a lesson in a page compares with:
 * the output of the reference and of the known mistakes (kept.c), mistakes/NAME.why, and
 * mistakes/NAME.judge, which is what the check that catches NAME says to it.  SITE has what
 * the page loads, MISTAKES what variant.awk has made.
 *
 * The page's own compiler and judge make it: what hangs on round-off is another number
 * natively.  It is JSON, {lines, files}, for most lines are the reference's: a file is
 * [first, number] of lines, and so on, of those that are different.
 * lessons/web/student_compile.js unpacks it.
 */
import fs from 'node:fs';
import path from 'node:path';
import {ask, thread, urlOf} from '../web/student_node.mjs';

const [site, mistakes] = process.argv.slice(2);
const read = path => fs.readFileSync(path, 'utf8'), slug = path.basename(mistakes);
const {code, ...why} = await ask(thread('student_compile.js'), {base: urlOf(site), slug,
    text: read(`${mistakes}/all.c`)}, data => data.progress ? null : data);
if (!code) throw Error(JSON.stringify(why));

const worker = thread('student_judge.js'), coder = new TextEncoder();
/* Run the judge, whose program is the entry of this number (variant.awk). */
async function judge(number, args, given, want) {
    const files = Object.fromEntries(Object.entries(given).map(([name, text]) => [name, coder.encode(text)]));
    const its = await ask(worker, {code, args: ['judge', ...args], files, want,
        environment: [`MISTAKE=${number}`]}, data => data.result);
    return its.files;
}
/* Return what an entry prints in each run of the lesson, which takes no time in the page. */
async function outputs(number, name) {
    const want = [...Array(16).keys()].flatMap(run => ['out', 'err', 'ending'].map(what => `kept/${name}/${run}.${what}`));
    const files = await judge(number, ['--keep', '/kept', name], {}, want);
    for (const path in files)
        if (path.endsWith('.ending')) files[path] = files[path].replace(/\S+\n/, '0\n');
    return files;
}

const reference = await outputs(0, slug), files = {...reference};
for (const [number, kind, name] of read(`${mistakes}/list`).trim().split('\n').map(line => line.split(' '))) {
    if (kind !== 'mistake') continue;
    const its = await outputs(number, name), why = read(`${mistakes}/${name}.why`);
    const {report} = await judge(number, ['--file', name, '--reference', slug, '--kept', '/kept', '--as', name,
        '--report', '/report', '--work', '/work'], {...reference, ...its}, ['report']);
    const [, , verdict, check, , , , said] = report.split('\x1e')[0].split('\x1f');
    if (verdict === 'TIMEOUT') throw Error(`${slug}: ${name} takes too long: ${said}`);
    Object.assign(files, its, {[`mistakes/${name}.why`]: why});
    if (why.startsWith(check + '\n') && /^(WRONG|NONFINITE)$/.test(verdict)) files[`mistakes/${name}.judge`] = said;
}

const lines = new Map(), packed = {};
for (const name of Object.keys(files).sort()) {
    const parts = packed[name] = [];
    for (const line of files[name].split(/(?<=\n)/)) {
        if (!lines.has(line)) lines.set(line, lines.size);
        const k = lines.get(line);
        if (parts.length && k === parts.at(-2) + parts.at(-1)) parts[parts.length - 1]++;
        else parts.push(k, 1);
    }
}
console.log(JSON.stringify({lines: [...lines.keys()], files: packed}));
