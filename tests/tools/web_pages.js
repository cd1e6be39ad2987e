/*
 * web_pages.js - the pages of build/web/: those of the book, and in every chapter
 * of a lesson the panels "Try it" and "Write", before the section Measured.
 *
 *     node tests/tools/web_pages.js BOOK BUILD SITE LESSON...
 *
 * BOOK is the book as HTML.  The form is made of the list that BUILD/solutions/LESSON
 * prints with -h; what is asked comes from the PREDICT lines of its source, what was
 * measured from the judge of its solution, and the columns to plot from its line
 * Plot.  A list or a line that is not as it should be is an error.
 */
"use strict";
const fs = require("fs");
const {execFileSync} = require("child_process");
const small = require("./web_small.js");
const {archive, front} = require("./web_front.js");
const [book, build, site, ...lessons] = process.argv.slice(2);

function fail(words) {
    console.error("web: " + words);
    process.exit(1);
}
const escape = (text) => text.replace(/[&<>"]/g, (c) => `&#${c.charCodeAt(0)};`);
/* Words of a source as HTML: what stands in backquotes and options are code. */
const prose = (text) => escape(text).replace(/`([^`]*)`|(--\w+)/g,
    (whole, quoted, option) => `<code>${quoted ?? option}</code>`);
const read = (path) => fs.readFileSync(path, "utf8");

/* A line of -h (common/base/options.c): "  --name  help [default]; what is allowed" */
function field(lesson, line) {
    const part = /^ {2}--(\w+) +(.*?)(?: \[([^\][]*)\])?; (one of: .*|a whole number .*|a number .*|[^;]*)$/
        .exec(line);
    if (!part) fail(`${lesson} -h: ${line}`);
    const [, name, help, initial = "", allowed] = part;
    if (allowed === "a file's name") return ""; /* a browser has none */
    const common = `id="option-${name}" name="${name}" data-default="${escape(initial)}"` +
                   ` aria-describedby="hint-${name}"`;
    const words = /^one of: ([^;]*)/.exec(allowed);
    const kind = words ? "select" : "input";
    const input = words
        ? `<select ${common}>` + words[1].split(" ").map((word) =>
            `<option${word === initial ? " selected" : ""}>${word}</option>`).join("") +
          "</select>"
        : `<input ${common} value="${escape(initial)}" autocomplete="off" spellcheck="false">`;
    const hint = words ? allowed.slice(words[0].length).replace(/^; /, "")
        : allowed.replace(/(?<![.\d])\d{6,}(?!\.)/g, (digits) => Number(digits).toExponential().replace("+", ""));
    return `<div class="field ${kind}"><label for="option-${name}"><code>${name}</code></label>
${input}<span class="hint" id="hint-${name}">${prose(help)}${hint && "; " + prose(hint)}</span></div>\n`;
}

function questions(lesson, source) {
    const measured = new Map(execFileSync(`${build}/solutions/${lesson}.judge`,
        ["--measured", `${build}/solutions/${lesson}`], {encoding: "utf8"}).trim().split("\n")
        .map((line) => line.split(" ")));
    return [...source.matchAll(/^ \* PREDICT (\w+) ([^:]*): \.\.\.$/gm)].map(([, key, asked]) => {
        if (!isFinite(measured.get(key) ?? NaN)) fail(`${lesson}: no number for PREDICT ${key}`);
        return `<div class="field"><label for="predict-${key}">${key}. ${prose(asked)}</label>
<input id="predict-${key}" name="${key}" inputmode="text" autocomplete="off" data-measured="${measured.get(key)}">
<output for="predict-${key}"></output></div>\n`;
    }).join("");
}

function panel(lesson) {
    const source = read(`solutions/${lesson}.c`);
    const usage = execFileSync(`${build}/solutions/${lesson}`, ["-h"], {encoding: "utf8"});
    const fields = usage.trimEnd().split("\n").slice(1).map((line) => field(lesson, line));
    const plot = /^ \* Plot: (.*)$/m.exec(source);
    if (!plot) fail(`${lesson}: no line Plot`);
    return `<section class="try" aria-labelledby="try-it" data-program="${lesson}" data-folder="../"
data-plot="${plot[1]}" data-seconds="30">
<h2 id="try-it">Try it</h2>
<p>This is the finished program of the lesson: it runs in your browser, and what it prints are the
numbers of the reference.</p>
<noscript><p>For this your browser must run JavaScript.</p></noscript>
<form hidden>
<fieldset class="predict"><legend>Predict first</legend>
<p class="hint" id="predict-hint">Write a number or a fraction before you run. Then what the reference
gives, whatever the options below are, appears beside it. Your numbers are kept in this browser, and you may change them.</p>
${questions(lesson, source)}<p><button type="button" name="look">Show what was measured</button></p></fieldset>
<fieldset><legend>Options</legend>
${fields.join("")}<p class="hint">The same with your own program: <code class="command"></code></p></fieldset>
<p><button name="run" aria-describedby="predict-hint">Run</button> <button type="button" name="stop">Stop</button>
<button type="button" name="defaults">Defaults</button></p>
<p role="status" aria-live="polite"></p>
</form>
<div class="results"></div>
</section>
${["store", "programs", "run", "elements", "plot", "results", "try"].map((name) => `<script src="../web/${name}.js" defer></script>\n`).join("")}`;
}

/* The hints of a lesson, each hidden, and a button for what each is about. */
function hints(lesson) {
    const page = read(`${book}/solutions/${lesson}.html`);
    const all = [...page.matchAll(/<details>\s*<summary>Hint (\d): ([^<]*)<\/summary>([^]*?)<\/details>/g)];
    if (!all.some(([, , about]) => about.startsWith("slot "))) fail(`${lesson}: no hints`);
    const about = [...new Set(all.map((one) => one[2]))];
    const text = all.map(([, level, about, words]) => `<div class="hint-text" data-about="${about}" hidden>
<p><strong>Hint ${level}: ${about}.</strong></p>${small.html(words).replace(/href="#/g, `href="../solutions/${lesson}.html#`)}</div>\n`);
    return `<div class="hints" hidden><h3>Hints</h3>
<p>${about.map((one) => `<button type="button" name="hint" value="${one}">Hint for ${one}</button>`).join("\n")}</p>
${text.join("")}</div>`;
}

function editor(lesson) {
    const file = read(`lessons/${lesson}.c`), number = lesson.slice(0, 2);
    const slots = [...file.matchAll(/\/\* SLOT (\w+)/g)].map(([, name]) => name);
    if (slots.length === 0) fail(`lessons/${lesson}.c has no slot`);
    return `<section class="try write" aria-labelledby="write" data-program="${lesson}">
<h2 id="write">Write</h2>
<p>This is the file <code>lessons/${lesson}.c</code>. Replace <code>todo()</code> in the slots ${slots.join(", ")}.
What you write stays in this browser; the file that you download is the one that <code>make check-${number}</code>
judges.</p>
<p class="hint size"></p>
<p class="hint" id="write-hint">Tab indents; Escape, then Tab leaves the editor; Ctrl-Enter checks. The
<code>PREDICT</code> lines are the fields of <a href="#try-it">Try it</a>.</p>
<pre class="starter" tabindex="0" role="region" aria-label="lessons/${lesson}.c"><code>${escape(file)}</code></pre>
<noscript><p>To write here, your browser must run JavaScript.</p></noscript>
<div class="controls" hidden>
<p class="act"><button type="button" name="run">Run</button> <button type="button" name="check">Check</button>
${fs.existsSync(`figures/${lesson}/hand.c`) ? '<button type="button" name="hand">In your hand</button>\n' : ""}<button type="button" name="stop">Stop</button> <button type="button" name="download">Download</button>
<label class="button">Upload <input type="file" name="upload" accept=".c"></label>
<button type="button" name="reset">Begin again</button>
<label><input type="checkbox" name="all"> the whole file</label></p>
<progress aria-label="progress" max="1" hidden></progress>
<p role="status" aria-live="polite"></p></div>
<pre class="verdict" id="report" tabindex="0" role="region" aria-label="the report" hidden></pre>
<p class="after" hidden>Now compare with <a href="../solutions/${lesson}.html#code-${slots[0]}">the solution</a>.</p>
<div class="hand"></div>
<div class="results" id="mine"></div>
${hints(lesson)}
</section>
<script src="../web/write.js" defer></script>
`;
}

const part = `${site}.part`;
fs.rmSync(part, {recursive: true, force: true});
fs.cpSync(book, part, {recursive: true});
fs.mkdirSync(part + "/web");
fs.mkdirSync(part + "/programs");
for (const name of fs.readdirSync("lessons/web").filter((name) => !/\.(c|mjs)$/.test(name)))
    fs.copyFileSync("lessons/web/" + name, `${part}/${name === "offline.js" ? "" : "web/"}${name}`);
const {index, workbook, moved} = front(read(part + "/index.html"),
                                       archive(`${part}/elasticity-workbook.tar.gz`));
fs.writeFileSync(part + "/index.html", index);
fs.writeFileSync(part + "/workbook.html", workbook);
for (const name of fs.readdirSync(part, {recursive: true}).map(String)) {
    if (name.endsWith(".svg"))
        fs.writeFileSync(`${part}/${name}`, small.picture(name, read(`${part}/${name}`)));
    if (!name.endsWith(".html")) continue;
    const up = "../".repeat(name.split("/").length - 1);
    const css = `<link rel="stylesheet" href="${up}book.css">`;
    fs.writeFileSync(`${part}/${name}`, moved(small.html(read(`${part}/${name}`))).replace(css,
        `<meta name="color-scheme" content="light dark">\n<link rel="icon" href="data:,">\n${css}\n` +
        `<link rel="stylesheet" href="${up}web/web.css">`));
}
for (const lesson of lessons) {
    const page = `${part}/lessons/${lesson}.html`, text = read(page);
    const at = text.indexOf('<h2 id="measured">');
    if (at < 0) fail(`${page} has no section Measured`);
    const ways = ' | <a href="#try-it">Try it</a> | <a href="#write">Write</a>';
    fs.writeFileSync(page, text.slice(0, at).replace(/(<p class="nav">.*)<\/p>/, `$1${ways}</p>`)
        .replace(/<link rel="stylesheet" href="..\/web\/web.css">/, `$&<link rel="stylesheet" href="../web/live.css">`)
        .replace(`<p>Open <code>lessons/${lesson}.c</code>`, `<p>Open <code>lessons/${lesson}.c</code> or
<a href="#write">write here</a>`) +
                     panel(lesson) + editor(lesson) + text.slice(at));
}
fs.copyFileSync(`${build}/wasm/editor.js`, `${part}/web/editor.js`);
fs.copyFileSync(`${build}/wasm/lessons.js`, `${part}/programs/lessons.js`);
fs.rmSync(site, {recursive: true, force: true});
fs.renameSync(part, site);
