/*
 * web_front.js - the first page of the site: the live square, and the contents with
 * what the reader has done.
 *
 *     front(page, files): {index, workbook, moved(html)}
 *
 * page is the book's front as HTML.  Of it the index keeps the contents; the rest,
 * from why to the library, is workbook.html, and moved() turns the links of a page.
 */
"use strict";
const {execFileSync} = require("child_process");
const fs = require("fs");

/* The tree as it was committed, for whoever wants files; or nothing without git. */
exports.archive = (path) => {
    const name = "elasticity-workbook";
    try {
        fs.writeFileSync(path, execFileSync("git", ["archive", "--format=tar.gz",
            `--prefix=${name}/`, "HEAD"], {maxBuffer: 1e8, stdio: ["ignore", "pipe", "ignore"]}));
        return `<p>As files, for <code>make</code> and your own editor: <a download
href="${name}.tar.gz">${name}.tar.gz</a>, ${(fs.statSync(path).size / 1e6).toFixed(1)} MB. Its README.md says how to begin.</p>\n`;
    } catch {
        return "<p>Whoever hosts these pages has the workbook as files, too, for <code>make</code> " +
               "and your own editor.</p>\n";
    }
};

exports.front = (page, files) => {
    const head = page.indexOf("<h1"), from = page.indexOf('<h2 id="contents">');
    const to = page.indexOf("<h2", from + 1), foot = page.indexOf("</main>");
    if (head < 0 || from < head || to < from || foot < to) throw new Error("the front has no contents");
    const rest = page.slice(head, from) + page.slice(to, foot);
    const there = new Set([...rest.matchAll(/ id="([^"]*)"/g)].map(([, id]) => id));
    const turned = (html, here) => html.replace(/href="((?:\.\.\/)*)(index\.html)?#([^"]*)"/g,
        (link, up, index, id) => {
            if (!index && !here) return link;
            const page = there.has(id) ? "workbook" : "index";
            return `href="${page === here ? "" : up + page + ".html"}#${id}"`;
        });
    const scripts = ["programs", "elements", "live_draw", "live", "store", "front"]
        .map((name) => `<script src="web/${name}.js" defer></script>\n`).join("");
    /* the small pictures have their chapter's name */
    const contents = page.slice(from, to).replace(
        /<img ((?:class="fits" )?src="[^"]*" width="120")>(<\/a><\/td>\s*<td><a [^>]*>)([^<]*)<\/a>/g,
        (whole, picture, between, title) => `<img ${picture} loading="lazy" alt="A picture of ${title}">${between}${title}</a>`)
        .replace(/(<td><a href="lessons\/(\d\d_\w+)\.html)(">[^<]*<\/a>)/g, (whole, link, lesson, title) =>
            `${link}${title}<br><span class="go">${link.slice(4)}#try-it">Try it</a> ${link.slice(4)}#write">Write</a>
<span class="done" data-lesson="${lesson}"></span></span>`);
    const [opening, ending] = [page.slice(0, head), page.slice(foot)];
    for (const id of ["why-anyone-cares", "the-course-and-its-rooms", "how-to-use-it", "notation", "equations",
                      "map-of-the-library"])
        if (!there.has(id)) throw new Error(`the front has no #${id}`);
    return {
        moved: (html) => turned(html).replace(/(<a href="(?:\.\.\/)*)index\.html">contents, notation and equations</g,
            '$1index.html">contents</a>, $1workbook.html">notation and equations<'),
        workbook: turned(opening + '<p class="nav"><a href="index.html">Contents</a></p>\n' + rest +
                         ending, "workbook"),
        index: turned(opening.replace("</head>", '<link rel="stylesheet" href="web/live.css"></head>') +
            `<h1>The Elasticity Workbook</h1>
<div class="live" data-program="programs/live.js#24_live" data-args="--n 16 --record input.txt" data-keys="l r"
data-bare></div>
<p>This is lesson 24, and it runs in your browser. In this course you write the solvers behind it, a few
lines of C at a time: exercises with reference solutions for J. Teran's lecture notes <em>Simulation of
elasticity, biomechanics, and virtual surgery</em>. <a href="workbook.html#why-anyone-cares">Why</a>,
<a href="workbook.html#the-course-and-its-rooms">the course and its rooms</a>, and <a href="workbook.html#how-to-use-it">how to use it</a>.</p>
<p>In your hand: <a href="web/live.html">the square with all its keys</a>, <a href="web/tissue.html">a strip of
tissue, a knife and a hand</a>. For a scene of your own: <a href="web/choose.html">the least model</a>.</p>
<p>To look things up: <a href="workbook.html#notation">notation</a>, <a href="workbook.html#equations">equations</a>,
<a href="workbook.html#map-of-the-library">the library</a>, <a href="lessons/CHEATSHEET.html">cheat sheet</a>,
<a href="lessons/INDEX.html">index of the notes</a>, <a href="lessons/TROUBLE.html">when it does not work</a>,
<a href="lessons/PROJECTS.html">projects</a>. <a href="lessons/TEACHING.html">For teachers</a>.</p>
${files}<p class="progress" hidden></p>
` + contents + scripts + ending, "index"),
    };
};
