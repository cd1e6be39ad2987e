/*
 * web_live.js - the live scenes and the least model in the pages of SITE: their
 * programs, what the form knows, and what leads to them.  And student/, the FILEs that
 * a page needs to compile and judge, with files.json, which says how large they are.
 *
 *     node tests/tools/web_live.js WASM SITE FILE...
 *
 * Chapter 24 gets the square, which is begun by a button; the front and the chapter
 * of choosing get links.  A page that has no longer the place for it is an error.
 */
"use strict";
const fs = require("fs");
const {basename} = require("path");
const {createHash} = require("crypto");
const [wasm, site, ...files] = process.argv.slice(2);

/* Behind the line of the page that has the words `after`; once. */
function insert(page, after, words) {
    const path = `${site}/${page}`, lines = fs.readFileSync(path, "utf8").split("\n");
    if (lines.includes(words)) return;
    const at = lines.findIndex((line) => line.includes(after));
    if (at < 0) {
        console.error(`web: ${path} has no "${after}"`);
        process.exit(1);
    }
    lines.splice(at + 1, 0, words);
    fs.writeFileSync(path, lines.join("\n"));
}

insert("workbook.html", 'figures/24_live/tissue.c"',
    '<p><a href="web/tissue.html">Cut such a strip and pull at it</a>, here in the browser.</p>');
insert("lessons/CHOOSE.html", '<h2 id="a-scene-of-your-own">',
    '<p><a href="../web/choose.html">The same as a form</a>, which runs here in the browser.</p>');
insert("lessons/24_live.html", "opens a window (with SDL2)",
    '<div class="live" data-program="../programs/live.js#24_live" data-on-demand ' +
    'data-args="--n 16 --record input.txt"></div>' +
    '<p><a href="../web/live.html">The square on a page of its own</a>, and ' +
    '<a href="../web/tissue.html">a strip of tissue</a>.</p>' +
    ["programs", "elements", "live_draw", "live"].map((name) =>
        `<script src="../web/${name}.js" defer></script>`).join(""));
fs.copyFileSync(`${wasm}/live.js`, `${site}/programs/live.js`);
fs.copyFileSync(`${wasm}/choose_data.js`, `${site}/web/choose_data.js`);
fs.rmSync(`${site}/student`, {recursive: true, force: true});
fs.mkdirSync(`${site}/student`);
const student = {};
for (const file of files) {
    const content = fs.readFileSync(file), name = basename(file);
    fs.writeFileSync(`${site}/student/${name}`, content);
    student[name] = {bytes: content.length, sum: createHash("md5").update(content).digest("hex")};
}
fs.writeFileSync(`${site}/student/files.json`, JSON.stringify(student, null, 1));
