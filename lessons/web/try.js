/*
 * try.js - the panel "Try it" of a chapter.  Its form is in the page, made of the
 * program's own list of options (tests/tools/web_pages.js); here it is run, and
 * what it prints is shown.
 */
"use strict";
const panel = document.querySelector("section.try");
const form = panel.querySelector("form");
const button = (name) => form.querySelector(`button[name=${name}]`);
const results = panel.querySelector(".results");
const here = panel.dataset;
let running = null;

function make(name, attributes, ...children) {
    const element = document.createElement(name);
    for (const [key, value] of Object.entries(attributes)) element.setAttribute(key, value);
    element.append(...children);
    return element;
}

/* ---- the form --------------------------------------------------------------- */

/* What differs from the default, as on a command line. */
function options() {
    return [...form.elements].filter((field) => field.dataset.default !== undefined &&
                                                field.value !== field.dataset.default)
        .flatMap((field) => ["--" + field.name, field.value.trim()]);
}

function showCommand() {
    const args = options().join(" ");
    panel.querySelector(".command").textContent =
        `make lesson-${here.program.slice(0, 2)}${args && ` ARGS='${args}'`}`;
}

/* The program's message stands at the field that it names. */
function markField(message) {
    for (const field of form.elements) field.removeAttribute("aria-invalid");
    const named = message && /--(\w+)/.exec(message);
    const field = named && form.elements.namedItem(named[1]);
    if (!field) return;
    field.setAttribute("aria-invalid", "true");
    field.focus();
}

/* ---- predictions ------------------------------------------------------------ */

const guesses = [...form.querySelectorAll(".predict input")];
const isNumber = (text) => /^[-+]?(\d+\.?\d*|\.\d+)(e[-+]?\d+)?(\/\d+\.?\d*)?$/i.test(text);
const predicted = (field) => isNumber(field.value.trim());
let shown = "nothing"; /* of what was measured: or "predicted", or "all" */

function mayRun() {
    button("run").disabled = running !== null;
    button("stop").disabled = running === null;
}

/* As tests/checks/predict.c says it. */
function compared(text, measured) {
    const [top, bottom] = text.split("/").map(Number);
    const expected = bottom ? top / bottom : top;
    const off = Math.abs(expected - measured), part = off / Math.abs(measured);
    if (off <= 5e-7 * Math.abs(measured)) return "right";
    if (Math.abs(expected + measured) <= 5e-7 * Math.abs(measured)) return "right but for its sign";
    if (part < 10) return `off by ${Number((100 * part).toPrecision(2))} %`;
    return isFinite(part) ? `${short(Number((expected / measured).toPrecision(2)))} times as large`
                          : `off by ${Number(off.toPrecision(3))}`;
}

function showMeasured() {
    for (const field of guesses) {
        const measured = Number(field.dataset.measured), output = field.nextElementSibling;
        const verdict = predicted(field) ? ": " + compared(field.value.trim(), measured) : "";
        output.textContent = shown === "all" || (shown === "predicted" && verdict)
            ? `measured ${Number(measured.toPrecision(7))}${verdict}` : "";
    }
    const look = button("look");
    if (look) look.hidden = shown === "all" || (shown === "predicted" && guesses.every(predicted));
}

function keepPredictions() {
    store.write(here.program, {predict: Object.fromEntries(
        guesses.filter((field) => field.value.trim()).map((field) => [field.name, field.value.trim()]))});
}

function showPredictions() {
    const {predict = {}} = store.read(here.program);
    for (const field of guesses) field.value = predict[field.name] ?? "";
}

/* ---- what it prints --------------------------------------------------------- */

const MOST_ROWS = 200;
function cell(text) {
    const number = Number(text);
    const shown = text !== "" && isFinite(number) ? String(Number(number.toPrecision(7))) : text;
    return make("td", shown === text ? {} : {title: text}, shown);
}

function tableElement(table) {
    const head = make("tr", {}, ...table.columns.map((c) => make("th", {scope: "col"}, c)));
    const rows = table.rows.slice(0, MOST_ROWS)
        .map((row) => make("tr", {}, ...row.map(cell)));
    const left = table.rows.length - rows.length;
    return make("details", {}, make("summary", {}, make("code", {}, table.name),
        ` ${table.rows.length} ${table.rows.length === 1 ? "row" : "rows"}`),
        ...table.notes.map((note) => make("p", {}, note)),
        make("div", {class: "rows", tabindex: 0, role: "region",
                     "aria-label": "table " + table.name},
             make("table", {}, make("thead", {}, head), make("tbody", {}, ...rows))),
        ...(left > 0 ? [`and ${left} more rows: they are in the file.`] : []));
}

function select(label, names, chosen, change) {
    const list = make("select", {}, ...names.map((name) => make("option", {}, name)));
    if (names.includes(chosen)) list.value = chosen;
    list.onchange = () => change(list.value);
    return make("label", {}, label + " ", list);
}

function check(label, on, change) {
    const box = make("input", {type: "checkbox"});
    box.checked = on;
    box.onchange = () => change(box.checked);
    return make("label", {}, box, " " + label);
}

const width = () => Math.max(280, Math.min(660, results.clientWidth));

/* The plot that was chosen last stays chosen, as long as its table is there. */
const [table, x, y, ...words] = here.plot.split(" ");
const byDefault = {table, x, y, key: (words.find((w) => w.startsWith("key=")) || "").slice(4),
                   logx: words.includes("logx"), logy: words.includes("logy")};
let chosen = {...byDefault};

function plotElement(tables) {
    const drawn = tables.filter((t) => t.rows.length > 0);
    const box = make("div", {class: "plot"});
    const update = (more) => {
        chosen = {...chosen, ...more};
        const t = drawn.find((one) => one.name === chosen.table) || drawn[0];
        if (t.name !== chosen.table || !t.columns.includes(chosen.x) ||
            !t.columns.includes(chosen.y))
            chosen = t.name === byDefault.table ? {...byDefault} :
                {table: t.name, x: t.columns[0], y: t.columns[1] || t.columns[0],
                 key: "", logx: false, logy: false};
        const focus = [...box.querySelectorAll("select, input")].indexOf(document.activeElement);
        box.replaceChildren(make("p", {class: "choose"},
            select("plot of table", drawn.map((one) => one.name), t.name,
                   (name) => update({table: name})),
            select("across", t.columns, chosen.x, (name) => update({x: name})),
            select("up", t.columns, chosen.y, (name) => update({y: name})),
            select("a curve for each", ["", ...t.columns], chosen.key,
                   (name) => update({key: name})),
            check("log across", chosen.logx, (on) => update({logx: on})),
            check("log up", chosen.logy, (on) => update({logy: on}))), plot(t, chosen, width()));
        if (focus >= 0) box.querySelectorAll("select, input")[focus].focus();
    };
    if (drawn.length > 0) update({});
    return box;
}

function bodyElement({name}, list) {
    const box = make("figure", {});
    const show = (n) => box.replaceChildren(drawBody(name, list[n], width()), make("figcaption", {},
        `${name}: blue is pressed, white at rest, orange stretched, magenta inverted. `,
        ...(list.length < 2 ? [] : [select("picture", list.map((_, k) => String(k)), String(n),
                                           (value) => { show(Number(value));
                                                        box.querySelector("select").focus(); })])));
    show(list.length - 1);
    return box;
}

function showResult(result) {
    const tables = readTables(result.out);
    results.replaceChildren();
    if (tables.length === 0) return;
    const file = make("a", {download: here.program + ".tsv", href: URL.createObjectURL(
        new Blob([result.out], {type: "text/tab-separated-values"}))}, "all tables as a file");
    for (const t of tables) {
        const list = bodies(t);
        if (list.length > 0) results.append(bodyElement(t, list));
    }
    results.append(plotElement(tables), make("h3", {}, "Tables"), ...tables.map(tableElement),
                   make("p", {}, file));
}

/* ---- running ---------------------------------------------------------------- */

function sentence(result) {
    const {end, status, ms, err} = result;
    if (end !== "exit") return endWords(result, here.seconds);
    const took = `${ms < 10 ? ms.toFixed(1) : ms.toFixed(0)} ms`;
    if (status === 0)
        return `Solved in ${took}.${guesses.every(predicted) ? "" : " What did you expect?"}`;
    if (status === 1) return `Not solved, after ${took}: ${lastLine(err)}` +
        (results.children.length > 0 ? " What it had found by then is below." : "");
    return lastLine(err);
}

function say(text, kind) {
    const status = panel.querySelector("[role=status]");
    status.textContent = text;
    status.dataset.kind = kind;
}

async function run() {
    say("It runs; Stop ends it.", "running");
    markField(null);
    running = {stop: () => {}};
    mayRun();
    try {
        const program = await loadProgram(`${here.folder}programs/lessons.js`);
        running = runProgram(program, here.program, options(), Number(here.seconds));
        const result = await running.finished;
        showResult(result);
        const {end, status} = result;
        say(sentence(result), end !== "exit" ? end : ["ok", "unsolved"][status] || "refused");
        if (end === "exit" && status === 2) markField(result.err);
        else if (end === "exit" && shown === "nothing") shown = "predicted";
        showMeasured();
        panel.result = result;
    } catch (error) {
        say(error.message, "crash");
    }
    running = null;
    mayRun();
}

form.onsubmit = (event) => {
    event.preventDefault();
    if (!button("run").disabled && !running) run();
};
form.oninput = ({target}) => {
    if (guesses.includes(target)) keepPredictions();
    showCommand();
    showMeasured();
};
button("stop").onclick = () => { running?.stop(); button("run").focus(); };
button("defaults").onclick = () => {
    for (const field of form.elements)
        if (field.dataset.default !== undefined) field.value = field.dataset.default;
    markField(null);
    showCommand();
};
button("look")?.addEventListener("click", () => {
    shown = "all";
    showMeasured();
    button("run").focus();
});
form.hidden = false;
showPredictions();
showCommand();
mayRun();
