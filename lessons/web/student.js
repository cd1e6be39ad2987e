/*
 * student.js - compile a student's C file in the page, run it, and judge it with the
 * checks of `make check-NN`.
 *
 *     const student = makeStudent({base: "../student/"});   // the folder of its files
 *     const result = await student.check("03_dirichlet_correction", text, {progress});
 *
 * A plain script: it sets globalThis.makeStudent.  Nothing is fetched before the first
 * run(), check() or hand().  One of these at a time.  text is the whole file, as it is
 * in lessons/NN_slug.c.
 *
 * student.run(slug, text, args, {progress, seconds}) is what `make lesson-NN ARGS=` does:
 * args is an array of words.  A promise of
 *     {status, stdout, stderr, diagnostics, end}
 *     diagnostics  what the compiler says, errors and warnings with file, line and caret;
 *                  "" if nothing
 *     end          "exit": with this status; "not compiled": diagnostics says why;
 *                  "crash": stderr ends with the reason; "limit": it took more than
 *                  `seconds` (30); "flood": more than 8 MB of output.  But for "exit"
 *                  status is null.
 *
 * student.check(slug, text, {progress, patience}) is what `make check-NN` does: a promise
 * of
 *     {verdict, text, slot, check, diagnostics}
 *     verdict   "OK", "WRONG", "UNFINISHED", "CRASHED", "TIMEOUT", "NONFINITE",
 *               "NOT COMPILED" or "REFUSED" (which `make check` calls WRONG)
 *     text      the report word for word; its last line begins with VERDICT
 *     slot      of the first check that fails, as "3a", or ""
 *     check     its name, or ""
 *     diagnostics   as above
 * Seconds of a limit are those of a clock, for a page cannot ask for those of a processor;
 * patience (1) multiplies them, on a busy machine.
 *
 * student.hand(slug, text, {progress}) is what `make live-NN` does, with the slots
 * that are not written yet from the solution, a frame at a time, for a page that has its
 * own canvas and clock: a promise of
 *     {frame, close, stdout, diagnostics, end}
 *     frame({x, y, down, key})   a promise of the picture of the next frame (metres; key
 *                  is a letter or "."), or of null when it has ended
 *     end          null while it runs; then "exit", "crash" or "not compiled", and
 *                  diagnostics the line that says why, as `make live-NN` does
 *     close()      ends it; a frame that is under way has three seconds for its own end
 *     stdout       the table `frames`, complete when close() has been waited for
 * A picture has the members of struct view_picture (common/motion/view.h) as arrays, x,
 * triangle, value, held, ring, arrow and curve, alarm, caption, note, and ms of computing.
 * Its Errors have the names "NoScene", and "OldBrowser" where WebAssembly cannot wait, as
 * Chromium can since 2025.
 *
 * student.stop() ends whatever is under way, in any phase; its promise is rejected with
 * an Error whose name is "Stopped".  Others: name "Offline" (a file of `base` cannot be
 * read), "OldBrowser" (what is missing is in its message), "Died" (a worker ended by itself, as for want of memory; the next call has a
 * new one).  The message is a sentence for the reader.
 *
 * progress(phase, fraction) is called on the way: phases "load" (the compiler, on first
 * use; fraction from 0 to 1, of bytes), "lesson" (its files), "compile", "link", "run" or
 * "judge".  fraction is null where it is not known, which is after "load".
 *
 * student.size(slug) is a promise of the bytes that the next call would load.
 */
"use strict";
(() => {
const here = globalThis.document?.currentScript?.src;
const [LIMIT_CPU, LIMIT_OUTPUT] = [1, 3]; /* enum limit of tests/checks/child.h */
const SECONDS_COMPILING = 120, SECONDS_JUDGE = 60, SECONDS_FRAME = 10, SECONDS_LAST = 3, MOST_ENDED = 24;
const COMPILER = ["clang.js.gz", "library.tar.gz", "llvm.core.wasm.gz", "llvm.core2.wasm.gz",
                  "llvm.core3.wasm.gz", "llvm.core4.wasm.gz"];

class Failure extends Error {
    constructor(name, message) { super(message); this.name = name; }
}
const signals = {4: "an index beyond the end of an array, or below 0", 6: "Aborted",
                 8: "Floating point exception", 11: "Segmentation fault"};

globalThis.makeStudent = ({base, worker}) => {
    if (globalThis.document) base = new URL(base, document.baseURI).href;
    worker ||= (name) => new Worker(new URL(name, here),
                                    {type: name === "student_compile.js" ? "module" : "classic"});
    let compiler = null, current = null, last = null;

    /* Ask a worker; hear() is told of each message, and returns the answer when it is
     * one.  The promise is rejected when the worker dies, by stop(), and by late(), which
     * is called after so many seconds in which `hear` was not. */
    function ask(who, message, seconds, hear, late) {
        return new Promise((done, failed) => {
            let timer;
            const end = (settle, what) => {
                clearTimeout(timer);
                current = null;
                settle(what);
            };
            const wait = (seconds) => {
                clearTimeout(timer);
                timer = setTimeout(() => { who.terminate(); end(done, late()); }, 1e3 * seconds);
            };
            wait(seconds);
            current = () => {
                who.terminate();
                end(failed, new Failure("Stopped", "You have stopped it."));
            };
            who.onmessage = ({data}) => {
                const answer = hear(data, wait);
                if (answer) end(done, answer);
            };
            who.onerror = (event) => {
                event.preventDefault?.();
                who.terminate();
                end(done, late(event.message || "it has ended by itself"));
            };
            who.postMessage(message);
        });
    }

    async function compiled(slug, text, progress, scene = false) {
        if (last?.slug === slug && last.text === text && last.scene === scene) return last.answer;
        let phase = "load";
        const mine = compiler ||= worker("student_compile.js");
        const drop = () => { if (compiler === mine) compiler = null; };
        let answer;
        try {
            answer = await ask(mine, {base, slug, text, scene}, 600, (data, wait) => {
                if (!data.progress) return data;
                if (data.progress[0] !== phase) wait(SECONDS_COMPILING);
                [phase] = data.progress;
                progress(...data.progress);
            }, (died) => {
                drop();
                return phase === "compile" && !died
                    ? {refused: "what it includes, or its macros, have no end"}
                    : {failed: "Died", why: `The compiler has ended: ${died || "it took too long"}.`};
            });
        } catch (error) {
            drop();
            throw error;
        }
        if (answer.failed) throw new Failure(answer.failed, answer.why);
        last = {slug, text, scene, answer};
        return answer;
    }

    /* Run a program: {status, limit, files, out, err}.  A child that takes too long, or
     * with which the worker dies, has its end in a second run. */
    async function execute(job, progress, seconds, patience = 1) {
        for (const ended = {};;) {
            let out = "", err = "";
            const running = [], who = worker("student_judge.js");
            const result = await ask(who, {...job, ended}, seconds, (data, wait) => {
                if (data.out) out += data.out;
                else if (data.err) err += data.err;
                else if (data.result) return data.result;
                else {
                    if (data.begin !== undefined) running.push({k: data.begin});
                    if (data.end !== undefined) running.pop();
                    if (data.seconds) Object.assign(running.at(-1) || {}, {seconds: data.seconds});
                    wait(patience * (running.at(-1)?.seconds || seconds));
                    progress("judge", null);
                }
            }, (died) => ({late: true, died}));
            who.terminate();
            if (!result.late) return {...result, out, err};
            const child = running.at(-1);
            if (!child) return {status: null, limit: result.died ? 0 : LIMIT_CPU, files: {}, out, err,
                                died: result.died};
            if (Object.keys(ended).length === MOST_ENDED)
                throw new Failure("Died", "The judge has not come to its end.");
            ended[child.k] = result.died ? {status: -9, limit: 0}
                                         : {status: -24, limit: LIMIT_CPU, seconds: child.seconds};
        }
    }

    async function run(slug, text, args = [], {progress = () => {}, seconds = 30} = {}) {
        const nothing = {status: null, stdout: "", stderr: "", diagnostics: "", end: "not compiled"};
        const made = await compiled(slug, text, progress);
        if (made.refused) return {...nothing, diagnostics: `lessons/${slug}.c is not run: ${made.refused}.\n`};
        if (!made.code) return {...nothing, diagnostics: made.diagnostics || made.errors.join("\n") + "\n"};
        progress("run", null);
        const its = await execute({code: made.code, args: ["judge", "--run", ...args], files: {}},
                                  () => {}, seconds);
        const result = {...nothing, stdout: its.out, stderr: its.err, diagnostics: made.diagnostics};
        if (its.limit === LIMIT_OUTPUT) return {...result, end: "flood"};
        if (its.limit === LIMIT_CPU) return {...result, end: "limit"};
        if (its.status >= 0 && its.status !== null) return {...result, status: its.status, end: "exit"};
        const why = its.died || `signal ${-its.status} (${signals[-its.status] || "Killed"})`;
        return {...result, stderr: its.err + why + "\n", end: "crash"};
    }

    async function check(slug, text, {progress = () => {}, patience = 1} = {}) {
        const nn = slug.slice(0, 2), path = `lessons/${slug}.c`;
        const said = (verdict, lines, shown, next) => ({verdict, slot: "", check: "", diagnostics: "",
            text: `${lines}\nVERDICT ${nn}: ${shown}    next: make ${next}-${nn}\n`});
        if (!/\S/.test(text))
            return said("UNFINISHED", `${path} is empty.`, "UNFINISHED (empty file)", "reset");
        const made = await compiled(slug, text, progress);
        if (made.refused)
            return said("REFUSED", `  ${path} is not judged: ${made.refused}.`, "WRONG (refused)", "check");
        if (!made.code)
            return {...said("NOT COMPILED", made.errors.join("\n"), "WRONG (does not compile)", "check"),
                    diagnostics: made.diagnostics};
        progress("judge", null);
        const its = await execute({code: made.code, want: ["result"],
            files: {...made.files, [path]: new TextEncoder().encode(text)},
            args: ["judge", "--file", path, "--source", "/" + path, "--reference", "/" + slug,
                   "--mistakes", "/mistakes", "--kept", "/kept", "--result", "/result",
                   "--work", "/work"]}, progress, SECONDS_JUDGE, patience);
        const [verdict, name, slot] = (its.files.result || "").trim().split(" ");
        if (!verdict) throw new Failure("Died", `The judge has ended: ${its.err || its.died || its.status}`);
        return {verdict, text: its.out, slot: slot === "-" ? "" : slot, check: name === "-" ? "" : name,
                diagnostics: made.diagnostics};
    }

    async function hand(slug, text, {progress = () => {}} = {}) {
        if (globalThis.document && !WebAssembly.Suspending)
            throw new Failure("OldBrowser", "For this a browser is needed in which WebAssembly can " +
                "wait (JSPI), as Chromium can since 2025.");
        const made = await compiled(slug, text, progress, true);
        const scene = {end: null, diagnostics: "", stdout: "", frame: async () => null, close() {}};
        if (!made.code)
            return Object.assign(scene, {end: "not compiled", diagnostics: made.diagnostics || made.errors.join("\n")});
        const who = worker("student_judge.js");
        const late = (what, seconds = SECONDS_FRAME) => setTimeout(over, 1e3 * seconds, "crash",
                                          `live-${slug.slice(0, 2)}: TIMEOUT: ${what} does not end`);
        let err = "", waiting = null, closing = null, closed, began;
        const begun = new Promise((done, failed) => {
            const timer = late("what is before the first frame");
            const end = (settle, what) => {
                clearTimeout(timer);
                current = null;
                settle(what);
            };
            began = () => end(done);
            current = () => {
                who.terminate();
                end(failed, new Failure("Stopped", "You have stopped it."));
            };
        });
        function over(end, why) {
            if (scene.end) return;
            who.terminate();
            Object.assign(scene, {end, diagnostics: why});
            began();
            waiting?.(null);
            closed?.();
        }
        who.onmessage = ({data}) => {
            if (data.err) err += data.err;
            if (data.out) scene.stdout += data.out;
            if (data.result) over(data.result.status === 0 ? "exit" : "crash", err.trim());
            if (data.frame === undefined) return;
            if (data.frame) waiting?.(data.frame);
            else began();
        };
        who.onerror = (event) => { event.preventDefault?.(); over("crash", event.message); };
        who.postMessage({scene: true, code: made.code, files: {}, args: ["live"]});
        scene.frame = ({x, y, down = 0, key = "."}) => new Promise((done) => {
            if (scene.end || closing) return done(null);
            const timer = late("this frame");
            waiting = (picture) => { clearTimeout(timer); waiting = null; done(picture); };
            who.postMessage({pointer: [x, y, down ? 1 : 0, key.charCodeAt(0)]});
        });
        scene.close = () => closing ||= new Promise((done) => { /* with the end of its table */
            waiting?.(null);
            closed = done; /* not by the picture of a frame that is under way */
            if (scene.end) return done();
            who.postMessage({pointer: null});
            late("this frame", SECONDS_LAST);
        });
        await begun;
        return scene;
    }

    return {
        run, check, hand,
        stop() { current?.(); },
        async size(slug) {
            const response = await fetch(base + "files.json", {cache: "no-cache"}).catch(() => null);
            if (!response?.ok) throw new Failure("Offline", `${base} cannot be read: a web server must bring it.`);
            const files = await response.json();
            const store = await globalThis.caches?.open("student").catch(() => null);
            let bytes = 0;
            for (const name of [...compiler ? [] : COMPILER, `${slug}.tar.gz`])
                if (!await store?.match(`${base}${name}?${files[name].sum}`)) bytes += files[name].bytes;
            return bytes;
        },
    };
};
})();
