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
const view = resultView(results, panel.dataset);
const here = panel.dataset;
let running = null;

/* ---- the form --------------------------------------------------------------- */

/* Return the options that differ from their defaults, as on a command line. */
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

/* Mark the field that the program's message names. */
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
    button("stop").disabled = running === null;
}

/* Compare as tests/checks/predict.c does. */
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
        view.show(result.out);
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
    if (!running) run();
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
