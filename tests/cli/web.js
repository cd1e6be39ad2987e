/*
 * web.js - the pages of make web in a headless Chromium; prints a line "ok WHAT" or
 * "FAIL WHAT: why" for each thing that is tried.
 *
 *     node tests/cli/web.js BUILD [WORDS]
 *
 * Every chapter is opened from its file, its default scene is run, and the tables
 * are those that the native program prints (BUILD/data/NN_slug.tsv).  One with an
 * endless loop has it when all is printed.  At the end the tests themselves are
 * tried: each is run with a page that a mistake has spoiled.  With WORDS only what
 * has them in its name is tried.
 */
"use strict";
const fs = require("fs");
const http = require("http");
const path = require("path");
const {spawnSync} = require("child_process");
const {open} = require("../tools/browser.js");
const build = path.resolve(process.argv[2] || "build");
const site = build + "/web";
const lessons = fs.readdirSync("solutions").filter((f) => /^\d\d_.*\.c$/.test(f))
    .map((f) => f.slice(0, -2)).sort();

/* ---- comparison with the native program --------------------------------------- */

/* Why the outputs differ, or "".  Words, notes and whole numbers are equal; other
 * numbers to 1e-9 of the largest of their column, and to 1e-12, since a momentum
 * that is nothing but round-off is another one.  Milliseconds are left out. */
function difference(got, want) {
    const [a, b] = [got.split("\n"), want.split("\n")];
    if (a.length !== b.length) return `${a.length} lines, not ${b.length}`;
    const whole = /^-?\d+$/;
    let columns = [], largest = [];
    for (let i = 0; i < b.length; i++) {
        if (i > 0 && b[i - 1].startsWith("# ") && !b[i].startsWith("# ")) {
            columns = b[i].split("\t");
            largest = columns.map(() => 0);
            for (let k = i + 1; b[k]; k++)
                b[k].split("\t").forEach((c, j) => {
                    if (isFinite(c)) largest[j] = Math.max(largest[j], Math.abs(c));
                });
        }
        if (a[i] === b[i]) continue;
        const [x, y] = [a[i].split("\t"), b[i].split("\t")];
        const bad = y.findIndex((c, j) => columns[j] !== "ms" && x[j] !== c &&
            !(isFinite(c) && isFinite(x[j]) && !(whole.test(c) && whole.test(x[j])) &&
              Math.abs(x[j] - c) <= 1e-9 * largest[j] + 1e-12));
        if (bad >= 0 || x.length !== y.length)
            return `line ${i + 1}, ${columns[bad]}: got ${x[bad]}, want ${y[bad]}`;
    }
    return "";
}

const native = (lesson, args) => {
    const {status, stdout, stderr} = spawnSync(`${build}/solutions/${lesson}`, args,
                                               {encoding: "utf8"});
    return {status, out: stdout, err: stderr};
};

/* ---- in the page ---------------------------------------------------------------- */

let browser, page, workers = 0;
/* Seconds of waiting: on a machine that may have much to do, and for what a mistake
 * makes one wait for in vain, which is said in these words. */
const PATIENCE = 60, SHORT = 3;
let vain = null;
const script = (f, ...args) => page.evaluate(`(${f})(${args.map((a) => JSON.stringify(a))})`);
/* What an earlier test has left in the browser is forgotten. */
async function chapter(lesson, root = site) {
    await page.evaluate("try { localStorage.clear(); } catch {}");
    await page.go(`file://${root}/lessons/${lesson}.html`);
}

function expect(condition, words) {
    if (!condition) throw new Error(words);
}

/* Fill the fields, run, and wait for the end: {kind, said, result}. */
async function run(fields = {}) {
    await script((fields) => {
        for (const field of document.querySelectorAll(".predict input"))
            field.value = "1/2";
        for (const name in fields) form.elements.namedItem(name).value = fields[name];
        form.dispatchEvent(new Event("input"));
    }, fields);
    await script(() => button("run").click());
    return settled();
}
async function wait(what, condition) {
    const patience = vain && what.includes(vain) ? SHORT : PATIENCE;
    for (const end = Date.now() + 1e3 * patience; Date.now() < end;) {
        const now = await condition();
        if (now) return now;
        await new Promise((resolve) => setTimeout(resolve, 20));
    }
    throw new Error(`after ${patience} s: ${what}`);
}
const settled = () => wait("it still runs", () => script(() => {
    const status = panel.querySelector("[role=status]"), {kind} = status.dataset;
    return kind && kind !== "running" &&
           {kind, said: status.textContent, result: panel.result};
}));
const noWorker = () => wait("a worker still runs", () => workers === 0);
const endless = () => script(async () => {
    const {script, code} = await loadProgram("../programs/lessons.js");
    programs.lessons = {script: `Module.onExit = () => { for (;;); };\n${script}`, code};
});

/* ---- what is tried ---------------------------------------------------------------- */

const tests = {
    async numbers(root, lesson = "12_triangles") {
        await chapter(lesson, root);
        const before = await script(() => ({
            loaded: document.querySelector('script[src*="programs/"]') !== null,
            wide: document.documentElement.scrollWidth - innerWidth,
            unnamed: [...form.elements].filter((e) => /INPUT|SELECT/.test(e.tagName) &&
                (e.labels.length === 0 || !document.getElementById(
                    e.getAttribute("aria-describedby") || e.labels[0].htmlFor))).length}));
        expect(!before.loaded, "the program is loaded before it is run");
        expect(before.wide <= 0, `the page is ${before.wide} pixels too wide`);
        expect(before.unnamed === 0, `${before.unnamed} fields without a label or hint`);
        const {kind, said, result} = await run();
        expect(kind === "ok" && result.status === 0, `the default scene: ${said}`);
        const want = fs.readFileSync(`${build}/data/${lesson}.tsv`, "utf8");
        const why = difference(result.out, want);
        expect(why === "", why);
        const shown = await script(() => ({
            tables: results.querySelectorAll("details table").length,
            cells: results.querySelectorAll("td").length,
            pictures: [...results.querySelectorAll("svg")].every((s) => s.getAttribute(
                "aria-label").length > 20 && s.children.length > 5),
            drawn: results.querySelectorAll(".plot svg").length,
            measured: guesses.every((field) => /^measured [-\d.e]+: \S/.test(
                field.nextElementSibling.textContent)),
            wide: document.documentElement.scrollWidth - innerWidth}));
        const tables = want.split("\n\n\n").filter((t) => t !== "").length;
        expect(shown.tables === tables, `${shown.tables} tables are shown, not ${tables}`);
        expect(shown.drawn === 1 && shown.pictures, "a picture is missing, empty or unnamed");
        expect(shown.measured, "a prediction has no measured number beside it");
        expect(shown.wide <= 0, `with its tables the page is ${shown.wide} pixels too wide`);
        await script(() => results.querySelectorAll("details").forEach((d) => { d.open = true; }));
        const nameless = await page.nameless();
        expect(nameless.length === 0, `without a name: ${nameless}`);
        expect(page.errors.length === 0, page.errors.join("; "));
        return `${tables} tables`;
    },
    /* What was measured is shown of what is predicted; a prediction survives a reload. */
    async predictions(root) {
        await chapter("03_dirichlet_correction", root);
        const said = () => script(() => guesses.map((field) => field.nextElementSibling.textContent));
        const type = (text) => script((text) => {
            guesses[0].value = text;
            guesses[0].dispatchEvent(new Event("input", {bubbles: true}));
        }, text);
        await script(() => button("run").click());
        const {kind} = await settled();
        expect(kind === "ok" && (await said()).join("") === "", "it tells what is not predicted yet");
        for (const [text, words] of [["-238.5", "right"], ["238.5", "right but for its sign"],
                                     ["-477/4", "off by 50 %"], ["1e9", "-4.2e6 times as large"]]) {
            await type(text);
            const [first, ...others] = await said();
            expect(first === "measured -238.5: " + words && others.join("") === "",
                   `${text} is not compared: ${first} ${others}`);
        }
        await page.go(`file://${root}/lessons/03_dirichlet_correction.html`);
        const kept = await script(() => guesses.map((field) => field.value).join());
        expect(kept === "1e9,,", `after a reload the predictions are ${kept}`);
        await script(() => button("look").click());
        expect((await said()).every((text) => /^measured/.test(text)), "not all is shown when asked");
    },
    /* on the page that is open, or of lesson 12 and then run again */
    async refusal(root, lesson = "12_triangles", opened = false) {
        if (!opened) await chapter(lesson, root);
        const name = await script(() => [...form.querySelectorAll(".field.input")].find((field) =>
            / number from /.test(field.textContent)).querySelector("input").name);
        const {kind, said} = await run({[name]: "1e99x"});
        const want = native(lesson, ["--" + name, "1e99x"]);
        expect(kind === "refused" && want.status === 2 && said === want.err.trim(),
               `it says "${said}", the native program "${want.err.trim()}"`);
        expect(await script(() => document.activeElement.name) === name &&
               await script(() => document.activeElement.ariaInvalid) === "true",
               "the field that is refused is not marked");
        if (opened) return;
        const again = await run({[name]: await script((n) =>
            form.elements.namedItem(n).dataset.default, name)});
        expect(again.kind === "ok", `after it: ${again.said}`);
    },
    async unsolved(root) {
        await chapter("04_neumann_compatibility", root);
        const {kind, said, result} = await run({project: "no"});
        const want = native("04_neumann_compatibility", ["--project", "no"]);
        expect(kind === "unsolved" && want.status === 1 && said.includes(want.err.trim()) &&
               said.includes("INCOMPATIBLE"), said);
        expect(difference(result.out, want.out) === "", difference(result.out, want.out));
        expect(await script(() => results.querySelectorAll("details table").length) > 1,
               "its tables are not shown");
    },
    async options(root) {
        await chapter("13_backward_euler_2d", root);
        const {result} = await run({scene: "spin", n: "5"});
        const want = native("13_backward_euler_2d", ["--scene", "spin", "--n", "5"]);
        expect(difference(result.out, want.out) === "", difference(result.out, want.out));
        expect(await script(() => panel.querySelector(".command").textContent) ===
               "make lesson-13 ARGS='--scene spin --n 5'", "the command is another one");
    },
    async body(root) {
        await chapter("12_triangles", root);
        const {result} = await run({scene: "compress", n: "5"});
        const least = await script((out) => {
            const tables = readTables(out), of = (name) => tables.find((t) => t.name === name);
            const [last] = of("result").rows, k = of("result").columns.indexOf("min_J");
            return {got: Math.min(...bodies(of("nodes"))[0].J), want: Number(last[k]),
                    drawn: results.querySelectorAll("figure polygon").length};
        }, result.out);
        expect(Math.abs(least.got - least.want) < 1e-12 && least.drawn === 50,
               `min J ${least.got}, of the program ${least.want}; ${least.drawn} triangles`);
    },
    async limit(root) {
        await chapter("12_triangles", root);
        await endless();
        await script(() => { here.seconds = 1.5; });
        const {kind, said} = await run();
        expect(kind === "limit" && said === "Stopped: it has taken more than 1.5 seconds.",
               `an endless loop ends with ${kind}: ${said}`);
        await noWorker();
    },
    async stop(root) {
        await chapter("12_triangles", root);
        await endless();
        const want = fs.readFileSync(`${build}/data/12_triangles.tsv`, "utf8");
        const end = run();
        const tables = want.split("\n\n\n").length;
        const pressed = wait("its tables do not come", () => script((tables) =>
            running?.result?.out.split("\n\n\n").length === tables && (button("stop").click(), true),
                                                                    tables));
        const [{kind, said, result}] = await Promise.all([end, pressed]);
        expect(kind === "stopped" && said === "You have stopped it.",
               `the button stop ends it with ${kind}: ${said}`);
        expect(difference(result.out, want) === "", "what it had printed is lost");
        expect(await script(() => results.querySelectorAll("details table").length) ===
               tables - 1, "its tables are not shown");
        await noWorker();
        expect(await script(() => document.activeElement === button("run") &&
                                  !button("run").disabled), "then it cannot be run again");
    },
    async crash(root) {
        await chapter("12_triangles", root);
        await script(() => {
            programs.lessons = {script: 'throw new Error("unreachable");', code: null};
        });
        const {kind, said} = await run();
        expect(kind === "crash" && said.includes("unreachable"), `${kind}: ${said}`);
        await noWorker();
    },
    async keyboard(root) {
        await chapter("12_triangles", root);
        const order = await script(() => {
            const all = [...form.elements].filter((e) => /^(INPUT|SELECT|BUTTON)$/.test(e.tagName) && !e.disabled);
            all[0].focus();
            return all.map((e) => e.name || e.id);
        });
        const reached = [];
        for (const _ of order) {
            reached.push(await script(() => {
                const {outlineStyle, outlineWidth} = getComputedStyle(document.activeElement);
                const seen = outlineStyle !== "none" && parseFloat(outlineWidth) >= 1;
                return (document.activeElement.name || document.activeElement.id) +
                       (seen ? "" : ", whose focus is not seen");
            }));
            await page.key("Tab");
        }
        expect(String(reached) === String(order), `Tab goes to ${reached}, not ${order}`);
        await script(() => form.elements.namedItem("n").focus());
        await page.key("Enter", "\r");
        const {kind} = await settled();
        expect(kind === "ok", `Enter in a field: ${kind}`);
        expect(await script(() => panel.querySelector("[role=status]").ariaLive) === "polite" &&
               await script(() => [...results.querySelectorAll(".rows")].every((e) =>
                   e.tabIndex === 0)), "how it ended is not said, or a table is not reached");
    },
};

async function attempt(what, test) {
    if (!what.includes(process.argv[3] || "")) return;
    try {
        const more = await test();
        console.log(`ok web: ${what}${more ? ", " + more : ""}`);
    } catch (error) {
        console.log(`FAIL web: ${what}: ${error.message}`);
    }
}

/* A plain file server, without compression and without a word about types but that
 * of its pages and scripts. */
async function served(test) {
    const type = {".html": "text/html", ".js": "text/javascript", ".css": "text/css",
                  ".svg": "image/svg+xml"};
    const server = http.createServer((request, response) => {
        const file = site + decodeURIComponent(new URL(request.url, "http://x").pathname);
        if (!fs.existsSync(file)) return response.writeHead(404).end();
        response.writeHead(200, {"Content-Type": type[path.extname(file)] || ""});
        response.end(fs.readFileSync(file));
    });
    await new Promise((resolve) => server.listen(0, "127.0.0.1", resolve));
    await page.go(`http://127.0.0.1:${server.address().port}/lessons/12_triangles.html`);
    const {kind, said} = await run();
    server.close();
    server.closeAllConnections();
    expect(kind === "ok" && page.errors.length === 0, `${said} ${page.errors.join("; ")}`);
}

/* Mistakes of the scripts: file, what stands there, what instead, the test that must
 * notice, and how it says so. */
const mistakes = [
    ["programs.js", ".map(unpacked)", ".slice(0, 1).map(unpacked)", "numbers", "default scene"],
    ["run.js", "worker.terminate();", "", "stop", "a worker still runs"],
    ["run.js", "setTimeout(end, 1e3 * seconds, \"limit\")", "0", "limit", "it still runs"],
    ["run.js", "line === \"\" || ", "", "stop", "its tables do not come"],
    ["run.js", 'out.push(line + "\\n")', 'if (!line.startsWith("3\\t")) out.push(line + "\\n")',
     "numbers", "lines, not"],
    ["run.js", "if (data.crash) {", "if (false) {", "crash", "reading 'toFixed'"],
    ["try.js", '(shown === "predicted" && verdict)', 'shown === "predicted"', "predictions", "not predicted"],
    ["try.js", "keepPredictions();", "", "predictions", "after a reload"],
    ["try.js", "field.value !== field.dataset.default", "false", "refusal", "it says"],
    ["try.js", "if (end === \"exit\" && status === 2) markField", "if (false) markField",
     "refusal", "not marked"],
    ["try.js", 'shown = "predicted";', "", "numbers", "measured"],
    ["try.js", "view.show(result.out);", "if (result.status === 0) view.show(result.out);",
     "unsolved", "are not shown"],
    ["try.js", '["--" + field.name, field.value.trim()]', '["--" + field.name, "5"]', "options", "line"],
    ["results.js", '"aria-label": "table " + table.name', '"aria-label": ""', "numbers", "without a name"],
    ["results.js", 'class: "rows", tabindex: 0', 'class: "rows", tabindex: -1', "keyboard", "not reached"],
    ["web.css", ".try :focus-visible {", ".try *, .try :focus { outline: none; } .try .none {",
     "keyboard", "is not seen"],
    ["plot.js", "const lists = curves(table, setting);", "return picture(1, 1, \"\");", "numbers", "picture"],
    ["plot.js", "[a, a + wide + 1, a + wide]", "[a + 1, a + wide + 1, a + wide]", "body", "min J"],
    ["plot.js", "area(x) / area(X)", "area(X) / area(x)", "body", "min J"],
];
async function noticed([file, from, to, test, words]) {
    const copy = build + "/wasm/spoiled";
    fs.rmSync(copy, {recursive: true, force: true});
    fs.cpSync(site + "/web", copy + "/web", {recursive: true});
    for (const name of ["lessons", "programs", "figures", "book.css"])
        fs.symlinkSync(`${site}/${name}`, `${copy}/${name}`);
    const text = fs.readFileSync(`${copy}/web/${file}`, "utf8");
    expect(text.includes(from), `${file} has no ${from}`);
    fs.writeFileSync(`${copy}/web/${file}`, text.replace(from, () => to));
    vain = words;
    const why = await tests[test](copy).then(() => `${test} does not notice`, (error) => error.message);
    vain = null;
    expect(why.includes(words), why);
    await page.go("about:blank");
    workers = 0;
}

async function main() {
    browser = await open("chromium");
    page = await browser.page(1400, 900);
    page.onWorker = (change) => { workers += change; };
    for (const lesson of lessons) {
        await attempt(`${lesson} has the native numbers`, () => tests.numbers(site, lesson));
        await attempt(`${lesson} refuses a bad field with the program's own words`,
                      () => tests.refusal(site, lesson, true));
    }
    await attempt("predictions are compared and kept", () => tests.predictions(site));
    await attempt("what is refused runs when it is mended", () => tests.refusal(site));
    await attempt("a scene that cannot be solved has its reason and its tables",
                  () => tests.unsolved(site));
    await attempt("options reach the program", () => tests.options(site));
    await attempt("the body that is drawn is the program's", () => tests.body(site));
    await attempt("an endless loop ends at the limit", () => tests.limit(site));
    await attempt("an endless loop is stopped by its button", () => tests.stop(site));
    await attempt("a crash is said", () => tests.crash(site));
    await attempt("Tab reaches all fields in their order, and Enter runs", () => tests.keyboard(site));
    await attempt("a plain server will do", () => served());
    const files = fs.readdirSync(site, {recursive: true}).map((name) => `${site}/${name}`)
        .filter((name) => fs.statSync(name).isFile());
    await attempt("the pages have at most 9 MB", () => {
        const bytes = files.filter((name) => !/\.tar\.gz$|\/student\//.test(name))
            .reduce((sum, name) => sum + fs.statSync(name).size, 0);
        expect(bytes > 1e6 && bytes <= 9e6, `${bytes} bytes`);
        return (bytes / 1e6).toFixed(1) + " MB";
    });
    await attempt("what compiles and judges has at most 35 MB", () => {
        const bytes = files.filter((name) => name.includes("/student/"))
            .reduce((sum, name) => sum + fs.statSync(name).size, 0);
        expect(bytes > 20e6 && bytes <= 35e6, `${bytes} bytes`);
        return (bytes / 1e6).toFixed(1) + " MB";
    });
    await attempt("no page needs a network", () => {
        const loads = /<(script|link|img|iframe)[^>]* (src|href)="(https?:)?\/\/|@import|url\((?!#|["']?data:)/;
        const bad = files.filter((name) => /\.(html|css|js)$/.test(name) && !/\/programs\//.test(name) &&
            loads.test(fs.readFileSync(name, "utf8")));
        expect(bad.length === 0 && loads.test('<img alt="x" src="https://x/y.png">'), bad);
    });
    await attempt("the front is short, begins with the square, and what is on it has its name", async () => {
        await page.go(`file://${site}/index.html`);
        const {tall, where} = await script(() => ({tall: document.documentElement.scrollHeight,
            where: document.querySelector("canvas").getBoundingClientRect().bottom}));
        expect(tall < 7000 && where < 900, `it is ${tall} pixels high, its square ends at ${where}`);
        const nameless = await page.nameless();
        expect(nameless.length === 0, `without a name: ${nameless}`);
    });
    await attempt("a difference of 1e-8 is one", async () => {
        const want = fs.readFileSync(`${build}/data/12_triangles.tsv`, "utf8");
        const cell = /0\.\d{12,}/.exec(want)[0];
        expect(difference(want.replace(cell, cell * (1 + 1e-8)), want) !== "" &&
               difference(want.replace("\n81\t", "\n82\t").replace("OK", "NO"), want) !== "",
               "it is not noticed");
    });
    page.close();
    page = await browser.page(390, 800);
    page.onWorker = (change) => { workers += change; };
    workers = 0;
    for (const lesson of ["12_triangles", "19_mpm_force"])
        await attempt(`${lesson} on a phone`, () => tests.numbers(site, lesson));
    for (const mistake of mistakes)
        await attempt(`${mistake[0]} without ${mistake[1]} is noticed`, () => noticed(mistake));
    await browser.close();
}
main().catch((error) => {
    console.log(`FAIL web: ${error.stack}`);
    process.exitCode = 1;
    return browser?.close();
});
