/*
 * cases.mjs - what a student may hand in for a lesson, and what make check-NN says of it.
 *
 * Nine texts: starter, solution, the first three known mistakes, an equivalent program, a
 * crash, an endless loop, and one that does not compile.
 */
import fs from 'node:fs';
import {execFileSync} from 'node:child_process';
import {tmpdir} from 'node:os';
import path from 'node:path';

export const lessons = fs.readdirSync('solutions').filter(name => /^\d\d_.*\.c$/.test(name)).map(name => name.slice(0, -2));
export const read = path => fs.readFileSync(path, 'utf8');
const awk = (...args) => execFileSync('awk', ['-f', 'tests/tools/variant.awk', ...args], {encoding: 'utf8'});

export const LOOP = 'for (volatile int spin = 0;; spin = 1) {}';
/* The solution with this line as the first of its first slot. */
export const withLine = (lesson, line) => read(`solutions/${lesson}.c`)
    .replace(/(\/\* SLOT [^]*?\*\/\n)/, (slot) => `${slot}${line}\n`);

export const variant = (lesson, name) => awk('-v', `name=${name}`, `tests/mistakes/${lesson}.txt`, `solutions/${lesson}.c`);

/* [what, verdict, text] of each. */
export function nine(lesson) {
    const names = kind => awk('-v', `list=${kind}`, `tests/mistakes/${lesson}.txt`).trim().split('\n');
    return [['starter', 'UNFINISHED', read(`lessons/${lesson}.c`)],
        ['solution', 'OK', read(`solutions/${lesson}.c`)],
        ...names('mistake').slice(0, 3).map(name => [`mistake ${name}`, /^(WRONG|NONFINITE)$/, variant(lesson, name)]),
        ...names('equivalent').slice(0, 1).map(name => [`equivalent ${name}`, 'OK', variant(lesson, name)]),
        ['a crash', 'CRASHED', withLine(lesson, 'int *volatile nowhere = (int *)-4096L; *nowhere = 1;')],
        ['an endless loop', 'TIMEOUT', withLine(lesson, LOOP)],
        ['a compile error', 'NOT COMPILED', withLine(lesson, 'this is not C')]];
}

/* What make check-NN says of a text. */
export function native(build, lesson, text) {
    const folder = fs.mkdtempSync(path.join(tmpdir(), 'native-')), file = path.join(folder, 'mine.c');
    try {
        fs.writeFileSync(file, text);
        execFileSync('sh', ['tests/tools/student.sh', 'grade', lesson, file, `lessons/${lesson}.c`, folder],
            {env: {...process.env, BUILD: build, MAKEFLAGS: ''}});
        return read(path.join(folder, 'said'));
    } finally {
        fs.rmSync(folder, {recursive: true});
    }
}

const close = (a, b) => a === b || (isFinite(a) && isFinite(b) &&
    Math.abs(a - b) <= 1e-9 + 1e-6 * Math.max(Math.abs(a), Math.abs(b)));
const behind = word => word.replace(/^[-+]?[\d.]+(e[-+]?\d+)?/, ''); /* a number */
/* Compilers differ in their words, and in how many errors follow the first. */
const place = text => /^ {2}lessons\/.*: error: /.test(text)
    ? text.replace(/error: [^]*\n(?=VERDICT)/, 'error\n') : text;
/* The first words of a that b has not, or null; a number may be off by 1e-6. */
export function differs(a, b) {
    const [x, y] = [a, b].map(text => place(text).trim().split(/\s+/));
    for (let k = 0; k < Math.max(x.length, y.length); k++)
        if (x[k] !== y[k] && !(close(parseFloat(x[k]), parseFloat(y[k])) && behind(x[k]) === behind(y[k])))
            return `"${x.slice(k, k + 8).join(' ')}", natively "${(y.slice(k, k + 8)).join(' ')}"`;
    return null;
}
