/*
 * judge.mjs SITE BUILD [LESSON...] - what compiles and judges in a page gives its verdict by
 * node alone, with the files of SITE/student: of all lessons starter and solution, some
 * mistakes, and of lesson 03 what is refused, and what a program may do.  Of each LESSON
 * instead the nine texts of cases.mjs, which panel.mjs has in a browser, with native words.
 */
import {student} from './student_node.mjs';
import {differs, lessons, native, nine, read, variant, withLine} from './cases.mjs';

const [site, build, ...asked] = process.argv.slice(2);
const page = student(`${site}/student`);
const awake = setInterval(() => {}, 1000);
/* Known mistakes whose numbers hang on round-off, which is another natively. */
const ROUNDED = {'01': 'gradient_the_wrong_way', 16: 'line_search_on_another_energy',
                 18: 'one_node_too_far_left', 24: 'rim_counted'};

async function expect(what, lesson, text, verdict, said) {
    try {
        const its = await page.check(lesson, text, {patience: verdict === 'TIMEOUT' ? 1 : 20});
        const bad = !its.verdict.match(verdict) ? `it is ${its.verdict}: ${its.text}`
            : said === undefined ? null
            : said instanceof RegExp ? (said.test(its.text.replace(/\s+/g, ' ')) ? null : its.text)
            : differs(its.text, said);
        console.log(bad ? `FAIL web judge: ${lesson} ${what}: ${bad.replace(/\n/g, ' | ')}`
                        : `ok web judge: ${lesson} ${what}`);
    } catch (error) {
        console.log(`FAIL web judge: ${lesson} ${what}: ${error.stack.replace(/\n/g, ' | ')}`);
    }
}

/* What is refused, and what a program may do: once. */
async function habits(lesson) {
    const text = read(`solutions/${lesson}.c`), nn = lesson.slice(0, 2);
    const refused = (what, more, why) => expect(what, lesson, text + more, 'REFUSED',
        RegExp(`is not judged: ${why}.* VERDICT ${nn}: WRONG \\(refused\\)`));
    await expect('an empty file', lesson, '\n', 'UNFINISHED', /VERDICT \d\d: UNFINISHED \(empty file\)/);
    await expect('the solution included', lesson, `#include "../solutions/${lesson}.c"\n`, 'REFUSED',
        /it includes what is no header/);
    await expect('a null pointer', lesson, withLine(lesson, 'double *volatile nothing = 0; *nothing = 1.0;'),
        'CRASHED', /signal 11 \(Segmentation fault\)/);
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
    if (asked.some(nn => lesson.startsWith(nn)))
        for (const [what, verdict, text] of nine(lesson))
            await expect(what, lesson, text, verdict, native(build, lesson, text));
    if (asked.length) continue;
    for (const [what, verdict, text] of nine(lesson).slice(0, 2)) await expect(what, lesson, text, verdict);
    const name = ROUNDED[lesson.slice(0, 2)];
    if (name) await expect(`mistake ${name} is named`, lesson, variant(lesson, name), /^(WRONG|NONFINITE)$/,
        RegExp(`known mistakes?.* \\(${name}\\)`));
    if (lesson.startsWith('03')) await habits(lesson);
}
clearInterval(awake);
process.exit(0);
