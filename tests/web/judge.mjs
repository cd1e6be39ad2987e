/*
 * judge.mjs SITE BUILD [LESSON...] - what compiles and judges in a page says what the
 * native judge says: by node alone, with the files of SITE/student.
 *
 * Of each lesson: starter, solution, the first three known mistakes, an equivalent
 * program, a crash, an endless loop, a compile error; where none is named, of six lessons,
 * and of all others starter and solution.  A number may be off by 1e-6.
 */
import fs from 'node:fs';
import {execFileSync, spawnSync} from 'node:child_process';
import {student} from './student_node.mjs';

const [site, build, ...asked] = process.argv.slice(2);
const lessons = fs.readdirSync('solutions').filter(name => /^\d\d_.*\.c$/.test(name)).map(name => name.slice(0, -2));
const whole = asked.length ? asked : ['03', '12', '16', '20', '24', '26'];
const page = student(`${site}/student`);
const awake = setInterval(() => {}, 1000);

const read = path => fs.readFileSync(path, 'utf8');
const variants = (lesson, kind) => execFileSync('awk', ['-f', 'tests/tools/variant.awk', '-v',
    `list=${kind}`, `tests/mistakes/${lesson}.txt`], {encoding: 'utf8'}).trim().split('\n');
const variant = (lesson, name) => execFileSync('awk', ['-f', 'tests/tools/variant.awk', '-v',
    `name=${name}`, `tests/mistakes/${lesson}.txt`, `solutions/${lesson}.c`], {encoding: 'utf8'});
/* The solution with this line as the first of its first slot. */
const withLine = (lesson, line) => read(`solutions/${lesson}.c`)
    .replace(/(\/\* SLOT [^]*?\*\/\n)/, (slot) => `${slot}${line}\n`);

/* What the judge of a program that is compiled in BUILD says of it. */
function native(lesson, judge) {
    const work = `${build}/test/judge.${lesson}`;
    return spawnSync(judge, ['--file', `lessons/${lesson}.c`,
        '--source', `solutions/${lesson}.c`, '--work', work,
        '--reference', `${build}/solutions/${lesson}`, '--mistakes', `${build}/mistakes/${lesson}`],
        {encoding: 'utf8'}).stdout;
}

const close = (a, b) => a === b || (isFinite(a) && isFinite(b) &&
    Math.abs(a - b) <= 1e-9 + 1e-6 * Math.max(Math.abs(a), Math.abs(b)));
/* The first word of a that b has not, or null; lines may break elsewhere. */
function differs(a, b) {
    const [x, y] = [a, b].map(text => text.trim().split(/\s+/));
    for (let k = 0; k < Math.max(x.length, y.length); k++)
        if (x[k] !== y[k] && !close(parseFloat(x[k]), parseFloat(y[k])))
            return `"${x.slice(k, k + 8).join(' ')}", natively "${(y.slice(k, k + 8)).join(' ')}"`;
    return null;
}

async function expect(what, lesson, text, verdict, said) {
    try {
        const its = await page.check(lesson, text, {patience: verdict === 'TIMEOUT' ? 1 : 20});
        const bad = its.verdict !== verdict ? `it is ${its.verdict}: ${its.text}`
            : said === undefined ? null
            : said instanceof RegExp ? (said.test(its.text.replace(/\s+/g, ' ')) ? null : its.text)
            : differs(its.text, said);
        console.log(bad ? `FAIL web judge: ${lesson} ${what}: ${bad.replace(/\n/g, ' | ')}`
                        : `ok web judge: ${lesson} ${what}`);
    } catch (error) {
        console.log(`FAIL web judge: ${lesson} ${what}: ${error.stack.replace(/\n/g, ' | ')}`);
    }
}

const CRASH = 'int *volatile nowhere = (int *)-4096L; *nowhere = 1;';
const verdictOf = text => /VERDICT \d\d: (\w+)/.exec(text)[1];
async function all(lesson) {
    for (const name of variants(lesson, 'mistake').slice(0, 3)) {
        const said = native(lesson, `${build}/mistakes/${lesson}/${name}.judge`);
        await expect(`mistake ${name}`, lesson, variant(lesson, name), verdictOf(said), said);
    }
    const [equivalent] = variants(lesson, 'equivalent');
    await expect(`equivalent ${equivalent}`, lesson, variant(lesson, equivalent), 'OK');
    await expect('a crash', lesson, withLine(lesson, CRASH), 'CRASHED', /signal 11 \(Segmentation fault\)/);
    await expect('a null pointer', lesson, withLine(lesson, 'double *volatile nothing = 0; *nothing = 1.0;'),
        'CRASHED', /signal 11 \(Segmentation fault\)/);
    await expect('an endless loop', lesson, withLine(lesson, 'for (volatile int spin = 0;; spin = 1) {}'),
        'TIMEOUT', /still running after 5 seconds of computing: is there a loop that cannot stop/);
    await expect('a compile error', lesson, withLine(lesson, 'this is not C'), 'NOT COMPILED',
        RegExp(`^ lessons/${lesson}.c:\\d+:\\d+: error: .* VERDICT ${lesson.slice(0, 2)}: WRONG \\(does not compile\\)`));
}
/* What is refused, and what a program may do: once. */
async function habits(lesson) {
    const text = read(`solutions/${lesson}.c`), nn = lesson.slice(0, 2);
    const refused = (what, more, why) => expect(what, lesson, text + more, 'REFUSED',
        RegExp(`is not judged: ${why}.* VERDICT ${nn}: WRONG \\(refused\\)`));
    await expect('an empty file', lesson, '\n', 'UNFINISHED', /VERDICT \d\d: UNFINISHED \(empty file\)/);
    await expect('the solution included', lesson, `#include "../solutions/${lesson}.c"\n`, 'REFUSED',
        /it includes what is no header/);
    await refused('a constructor', '__attribute__((constructor)) static void first(void) {}\n',
        'it has code that runs before main');
    await refused('assembler', '__asm__("nop");\n', 'it has a line of assembler');
    await refused('a section', '__attribute__((section("mine"))) int mine = 1;\n', 'it puts something');
    await refused("the judge's", 'extern void wrong(const char *, ...);\nvoid mine(void); void mine(void) { wrong("x"); }\n',
        "it uses wrong, which is the judge's");
    await refused('the page', '__attribute__((import_module("env"), import_name("x"))) void x(void);\n' +
        'void mine(void); void mine(void) { x(); }\n', 'it asks the page');
    await expect('a function of the name of the C library', lesson,
        text + 'int close(int fd);\nint close(int fd) { return fd; }\n', 'OK');
    await expect('a function that is missing', lesson, text.replace(/\bmove_known_values\b/g, 'moved'),
        'NOT COMPILED', /no longer has: move_known_values\..*New in it: moved\./);
    await expect('a macro of a name that the checks have', lesson,
        text.replace(/\bmove_known_values\b/g, 'moved').replace(/^#include/m, '#define moved move_known_values\n$&'), 'OK');
    await expect('endless output', lesson, withLine(lesson,
        'extern int puts(const char *); for (;;) puts("and on and on");'), 'CRASHED', /more than 8 MB of output/);
    await expect('macros without end', lesson, '#define A(x) x x x x x x x x x x\n#define B(x) A(A(A(x)))\n' +
        'int x = B(B(B(+))) 1;\n' + text, 'REFUSED', /what it includes, or its macros, have no end/);
    await expect('a full memory', lesson, withLine(lesson, 'extern void *malloc(unsigned long); ' +
        'for (;;) { char *more = malloc(1 << 24); *more = 1; }'), 'CRASHED', /signal 11/);
    await expect('recursion without end', lesson, text.replace(/^static void move_known_values/m, 'static int deep(volatile int k) { return k + deep(k + 1); }\n$&')
        .replace(/(\/\* SLOT [^]*?\*\/\n)/, '$1(void)deep(1);\n'), 'CRASHED', /signal 11/);
    await expect('an early exit(0)', lesson, withLine(lesson, 'extern void exit(int); exit(0);'), 'CRASHED',
        /ended in the middle of its work, with exit\(0\)/);
}

for (const lesson of lessons) {
    const some = whole.some(nn => lesson.startsWith(nn));
    if (!some && asked.length) continue;
    await expect('starter', lesson, read(`lessons/${lesson}.c`), 'UNFINISHED');
    await expect('solution', lesson, read(`solutions/${lesson}.c`), 'OK');
    if (some) await all(lesson);
    if (some && lesson.startsWith('03')) await habits(lesson);
}
clearInterval(awake);
process.exit(0);
