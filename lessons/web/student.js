/*
 * student.js - compile a student's C file in the page, run it, and judge it with the
 * checks of `make check-NN`.
 *
 *     const student = makeStudent({base: "../student/"});   // the folder of its files
 *     const result = await student.check("03_dirichlet_correction", text, {progress});
 *
 * A plain script: it sets globalThis.makeStudent.  Nothing is fetched before the first
 * run() or check().  One call at a time; a second one waits for the first.  text is the
 * whole file, as it is in lessons/NN_slug.c.
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
 * student.check(slug, text, {progress}) is what `make check-NN` does: a promise of
 *     {verdict, text, slot, check, mistakes, diagnostics}
 *     verdict   "OK", "WRONG", "UNFINISHED", "CRASHED", "TIMEOUT", "NONFINITE",
 *               "NOT COMPILED" or "REFUSED" (which `make check` calls WRONG)
 *     text      the report word for word; its last line begins with VERDICT
 *     slot      of the first check that fails, as "3a", or ""
 *     check     its name, or ""
 *     mistakes  the names of the known mistakes that give the same numbers
 *     diagnostics   as above
 *
 * student.stop() ends whatever is under way, in any phase; its promise is rejected with
 * an Error whose name is "Stopped".  Others: name "Offline" (a file of `base` cannot be
 * read; from file:// a browser reads none), "OldBrowser" (what is missing is in its
 * message), "Died" (a worker ended by itself, as for want of memory; the next call has a
 * new one).  The message is a sentence for the reader.
 *
 * progress(phase, fraction) is called on the way: phases "load" (the compiler, on first
 * use; fraction from 0 to 1, of bytes), "lesson" (its files), "compile", "link", "run" or
 * "judge" (fraction: of the checks).  fraction is null where it is not known.
 *
 * student.size(slug) is a promise of {bytes, cached}: what the next call would load.
 */
"use strict";
(() => {
globalThis.makeStudent = ({base}) => {
    const none = async () => { throw new Error(`${base}: not there yet`); };
    return {run: none, check: none, stop() {}, size: async () => ({bytes: 0, cached: false})};
};
})();
