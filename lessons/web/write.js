/*
 * write.js - the section "Write" of a chapter: the lesson's file in an editor
 * (editor.mjs), run and judged in the page (student.js), with its hints.
 *
 * What is written is kept in this browser (store.js).  The answers to PREDICT are the
 * fields of the panel "Try it" (try.js), whose options a run has, too.
 */
"use strict";
(() => {
const box = document.querySelector("section.write"), {program} = box.dataset;
const find = (selector) => box.querySelector(selector);
const press = (name) => find(`button[name=${name}]`);
const number = program.slice(0, 2), starter = find("pre.starter").textContent;
const verdict = find(".verdict"), bar = find("progress"), state = find("[role=status]");
const view = resultView(find(".results"), {program: program + ".mine", plot: here.plot});
let editor = null;  /* once it is there */
let student = null; /* what compiles and judges */
let busy = null;    /* ends what is under way */
let hint = {slot: null, level: 0};

/* Say how it goes; with a link to an element of the page, where more is. */
function say(text, kind = "", link = null) {
    state.textContent = text;
    state.dataset.kind = kind;
    if (link) state.append(" ", make("a", {href: "#" + link[0]}, link[1]));
}

/* ---- the file ----------------------------------------------------------------- */

const PREDICT = /^( \* PREDICT (\w+) [^:\n]*: ?)(.*)$/gm;
/* Return the text with the answers of the fields. */
const filled = (text) => text.replace(PREDICT, (line, asked, key) =>
    asked + (guesses.find((field) => field.name === key)?.value.trim() || "..."));
/* Put the answers of a text into the fields. */
function answers(text) {
    let changed = false;
    for (const [, , key, answer] of text.matchAll(PREDICT)) {
        const field = guesses.find((one) => one.name === key);
        const value = answer.trim().replace(/^\.*$/, "");
        if (!field || field.value.trim() === value) continue;
        field.value = value;
        changed = true;
    }
    if (!changed) return;
    keepPredictions();
    showMeasured();
}
const text = () => editor ? editor.text() : filled(store.read(program).text ?? starter);

function changed(now) {
    const kept = now === filled(starter) ? store.write(program, {text: undefined})
        : store.write(program, {text: now, time: Date.now()});
    if (!kept) say("This browser keeps nothing of this page: download what you have written.", "refused");
    answers(now);
}

function bring(source) {
    return new Promise((done, failed) => {
        const script = document.createElement("script");
        Object.assign(script, {src: source, onload: done, onerror: failed});
        document.head.append(script);
    });
}
let begun = null;
const begin = () => begun ||= (async () => {
    try {
        await bring("../web/editor.js");
    } catch {
        return say("The editor is not with these pages. Download the file and write in an editor of your own.",
                   "refused");
    }
    const place = document.createElement("div");
    const start = text();
    find("pre.starter").replaceWith(place);
    editor = slotEditor(place, {text: start, label: `lessons/${program}.c`,
                                describedBy: "write-hint", changed, check: () => work(judge)});
    for (const field of guesses)
        field.addEventListener("input", () => editor.setPrediction(field.name, field.value.trim() || "..."));
    box.editor = editor;
})();
find("[name=all]").onchange = ({target}) => begin().then(() => editor?.showAll(target.checked));

press("download").onclick = () => {
    const link = document.createElement("a");
    link.download = program + ".c";
    link.href = URL.createObjectURL(new Blob([text()], {type: "text/x-csrc"}));
    link.click();
};
find("[name=upload]").onchange = async ({target}) => {
    const [file] = target.files;
    if (!file) return;
    const given = file.size < 1e6 ? await file.text() : "";
    target.value = "";
    const first = /SLOT (\w+)/.exec(starter)[1];
    if (!given.includes(`SLOT ${first}`))
        return say(`${file.name} has no slot ${first}: it is not lessons/${program}.c.`, "refused");
    await begin();
    editor?.setText(given.replace(/\r\n/g, "\n"));
    say(`${file.name} is in the editor.`);
};
/* The first press asks, the second does it. */
const AGAIN = press("reset").textContent;
press("reset").onblur = () => { press("reset").textContent = AGAIN; };
press("reset").onclick = async () => {
    if (press("reset").textContent === AGAIN) {
        press("reset").textContent = "Press again to throw your text away";
        return;
    }
    press("reset").textContent = AGAIN;
    await begin();
    editor?.setText(filled(starter));
    say("The starter is back; undo in the editor brings your text back.");
};

/* ---- running and judging ------------------------------------------------------- */

const PHASES = {load: "Loading the compiler", lesson: "Loading the lesson",
                compile: "Compiling", link: "Linking", run: "Running", judge: "Checking"};
function progress(phase, fraction) {
    if (!busy) return;
    bar.hidden = false;
    if (fraction === null || fraction === undefined) bar.removeAttribute("value");
    else bar.value = fraction;
    const words = `${PHASES[phase] || phase} ... Stop ends it.`;
    if (state.textContent !== words) say(words, "running");
}
async function bringStudent() {
    if (student) return;
    if (location.protocol === "file:")
        throw new Error("No browser lets a page from a file compile C. Serve the folder of these pages (in it: " +
                        "python3 -m http.server) and open http://localhost:8000, or download the file, which " +
                        `make check-${number} judges.`);
    try {
        if (!self.makeStudent) await bring("../web/student.js");
    } catch {
        throw new Error("The compiler is not with these pages: download the file, and make " +
                        `check-${number} judges it.`);
    }
    student ||= makeStudent({base: "../student/"});
}
/* Say how much the first run or check will load, or why it cannot. */
async function sizeOf() {
    try {
        await bringStudent();
        const bytes = await student.size(program), size = `${(bytes / 1e6).toFixed(0)} MB`;
        if (bytes < 1e6) return; /* the compiler is here */
        PHASES.load = `Loading the compiler, ${size}, once`;
        find(".size").textContent = `The first Run or Check loads a C compiler, ${size}, which this browser keeps.`;
    } catch (error) {
        find(".size").textContent = error.message;
    }
}

function mayWork() {
    for (const name of ["run", "check", "hand"]) if (press(name)) press(name).disabled = busy !== null;
    press("stop").disabled = busy === null;
}
/* One thing at a time: what(text, unless) waits by unless(promise), which Stop rejects. */
async function work(what) {
    if (busy) return;
    const stopped = new Promise((done, failed) => {
        busy = () => {
            student?.stop();
            failed(Object.assign(new Error("You have stopped it."), {name: "Stopped"}));
        };
    });
    const unless = (promise) => Promise.race([promise, stopped]);
    const pressed = document.activeElement.closest(".act button") || press("check");
    mayWork();
    say("It begins ...", "running");
    verdict.hidden = true;
    try {
        await unless(begin());
        await unless(bringStudent());
        await what(text(), unless);
        PHASES.load = "Loading the compiler";
        find(".size").textContent = "";
    } catch (error) {
        say(error.message, error.name === "Stopped" ? "stopped" : "crash");
    }
    busy = null;
    bar.hidden = true;
    const lost = [document.body, press("stop")].includes(document.activeElement);
    mayWork();
    if (lost) pressed.focus({preventScroll: true});
}

/* Show the messages of the compiler, in the editor too. */
function diagnosed(diagnostics) {
    const places = [...diagnostics.matchAll(/^[^:\n]*:(\d+):(\d+): (?:fatal )?(error|warning): (.*)$/gm)]
        .map(([, line, column, severity, message]) =>
            ({line: Number(line), column: Number(column), severity, message}));
    editor?.mark(places);
    if (diagnostics) report(diagnostics);
}
/* Show a report; a long line goes on below its own words, and chapters are links. */
function report(words) {
    verdict.hidden = false;
    verdict.replaceChildren(...words.split(/(?<=\n)/).map((line) => {
        const inside = /^ *([A-Za-z]+  +)?/.exec(line)[0].length;
        const parts = line.split(/(lessons\/\d\d_\w+\.md)/).map((part, k) => k % 2 === 0 ? part
            : make("a", {href: part.slice(8, -3) + ".html"}, part));
        return make("span", {style: `--inside: ${inside}ch`}, ...parts);
    }));
}

async function runIt(file, unless) {
    const args = options();
    const mine = await unless(student.run(program, file, args, {progress, seconds: Number(here.seconds)}));
    diagnosed(mine.diagnostics);
    if (mine.end === "not compiled") return say("It does not compile.", "refused");
    say("Running the reference beside it ... Stop ends it.", "running");
    const other = runProgram(await unless(loadProgram("../programs/lessons.js")), program, args, Number(here.seconds));
    const reference = await unless(other.finished).finally(other.stop);
    view.show(mine.stdout, reference.out);
    const last = lastLine(mine.stderr) || "";
    say({exit: mine.status === 0 ? "It has run; what differs from the reference is marked."
                                 : last || `It has ended with status ${mine.status}.`,
         crash: `It has crashed: ${last}`, limit: `Stopped: it has taken more than ${here.seconds} seconds.`,
         flood: "Stopped: it has printed more than 8 MB."}[mine.end],
        mine.end === "exit" ? (mine.status === 0 ? "ok" : "unsolved") : mine.end, ["mine", "The results."]);
}

async function judge(file, unless) {
    find(".results").replaceChildren();
    const result = await unless(student.check(program, file, {progress, patience: box.patience}));
    diagnosed(result.diagnostics || "");
    report(result.text);
    box.result = result;
    store.write(program, {verdict: store.read(program).verdict === "OK" ? "OK" : result.verdict});
    find(".after").hidden = result.verdict !== "OK";
    if (result.verdict === "OK") {
        shown = "all";
        showMeasured();
    }
    say(`Verdict: ${result.verdict}${result.slot ? `, slot ${result.slot}` : ""}.`,
        result.verdict === "OK" ? "ok" : "refused",
        ["report", result.verdict === "OK" ? "The report." : "The report and hints."]);
    follow(result.verdict === "WRONG" ? result.check : null, result.slot);
}
/* Run the scene of make live-NN; it ends by its button, or by Stop. */
async function inHand(file, unless) {
    const hand = await unless(student.hand(program, file, {progress}));
    diagnosed(hand.diagnostics);
    if (hand.end === "not compiled") return say("It does not compile.", "refused");
    bar.hidden = true;
    for (const name of ["live_draw", "live"])
        if (!self.liveScene) await unless(bring(`../web/${name}.js`)).catch((error) => {
            hand.close();
            throw error.name === "Stopped" ? error : new Error(`../web/${name}.js cannot be read.`);
        });
    const scene = document.createElement("div");
    scene.className = "live";
    Object.assign(scene.dataset, {label: `The scene of lesson ${number}, with your slots`, pull: "Drag here"});
    find(".hand").replaceChildren(scene);
    say("In your hand: drag in the picture. Stop ends it.", "running");
    await new Promise((over) => {
        scene.source = async (page) => {
            busy = () => {
                scene.live.press("q");
                hand.close();
            };
            for (let now; (now = await page.next());) {
                const picture = await hand.frame({x: now[0], y: now[1], down: now[2], key: String.fromCharCode(now[3])});
                if (!picture) break;
                const {x, triangle, value, held, ring, arrow, curve, alarm, caption, note, ms} = picture;
                const arrows = [];
                for (let k = 0; k < (arrow || []).length; k += 4) arrows.push([...arrow.slice(k, k + 4)]);
                page.draw({x, triangle, J: value, held: held || [], knot: ring || [], arrows, curve, ms, lost: 0, alarm,
                           text: caption, said: [...caption.split("\n"), note].filter((line) => line && !/\[/.test(line))
                               .join("; ")});
            }
            await hand.close();
            over();
            return {stdout: hand.stdout, wrong: hand.end === "exit" ? "" : hand.diagnostics || hand.end};
        };
        liveScene(scene);
        scene.scrollIntoView({block: "center"});
        scene.live.canvas.focus({preventScroll: true});
    });
    say("The scene has ended.");
}
press("run").onclick = () => work(runIt);
if (press("hand")) press("hand").onclick = () => work(inHand);
press("check").onclick = () => work(judge);
press("stop").onclick = () => busy?.();

/* ---- hints in levels ------------------------------------------------------------- */

const hints = [...box.querySelectorAll(".hint-text")];
const levels = (about) => hints.filter((one) => one.dataset.about === about);
for (const choice of box.querySelectorAll("button[name=hint]"))
    choice.onclick = () => {
        const about = choice.value, all = levels(about);
        const next = all.find((one) => one.hidden);
        if (next) next.hidden = false;
        const left = all.filter((one) => one.hidden).length;
        choice.textContent = left ? `Next hint for ${about}` : `No more hints for ${about}`;
        choice.disabled = left === 0;
        if (next) { next.tabIndex = -1; next.focus(); }
    };
/* Put the hint for the check or slot that has failed first. */
function follow(check, slot) {
    for (const choice of box.querySelectorAll("button[name=hint]")) {
        const about = choice.value;
        choice.hidden = !about.startsWith("slot ") && about !== check;
        choice.classList.toggle("first", about === check || about === `slot ${slot}`);
    }
}
follow(null, "");

/* ---- begin ------------------------------------------------------------------------ */

find(".controls").hidden = false;
find(".hints").hidden = hints.length === 0;
mayWork();
const near = new IntersectionObserver((seen) => {
    if (!seen.some((one) => one.isIntersecting)) return;
    near.disconnect();
    begin();
    sizeOf();
}, {rootMargin: "800px"});
near.observe(box);
})();
