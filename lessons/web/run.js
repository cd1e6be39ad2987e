/*
 * run.js - run a program of the workbook in a worker, and read its tables.
 *
 * It computes in a worker, so that the page stays awake and an endless loop can be
 * ended.
 */
"use strict";

/* Run a program in the worker.  Lines are sent in heaps, each at the end of a table at the
 * latest, and all before the status.  A program that cannot go on has no status.
 * The files, texts by name, are there before, and come back with the status. */
function work(program, name, args, code, files) {
    let out = [], err = [];
    const send = (more) => {
        postMessage({out: out.join(""), err: err.join(""), ...more});
        out = [];
        err = [];
    };
    const crashed = (event) => {
        event.preventDefault();
        send({status: null, crash: String(event.reason || event.message)});
    };
    self.addEventListener("error", crashed);
    self.addEventListener("unhandledrejection", crashed);
    const begin = performance.now();
    const names = Object.keys(files);
    const Module = {
        thisProgram: name,
        arguments: args,
        wasmBinary: code,
        print: (line) => { out.push(line + "\n"); if (line === "" || out.length > 999) send({}); },
        printErr: (line) => { err.push(line + "\n"); if (err.length > 99) send({}); },
        preRun: [() => names.forEach((file) => Module.FS.writeFile(file, files[file]))],
        onExit: (status) => send({status, ms: performance.now() - begin, files: Object.fromEntries(
            names.map((file) => [file, Module.FS.readFile(file, {encoding: "utf8"})]))}),
    };
    program(Module);
}

/*
 * Run the program of this name.  Return {finished, stop, result}: a promise of the
 * result, which is {status, out, err, ms, files, end}.
 * end is "exit" with a status, or "stopped" by stop(), "limit" after so many
 * seconds, "flood" when it has printed more than 16 MB, "crash" with its reason in
 * err.  What it had printed till then is in out.
 */
function runProgram({script, code}, name, args, seconds, files = {}) {
    const text = `onmessage = ({data}) =>
        (${work})(function (Module) { ${script}\n }, ...data);`;
    const url = URL.createObjectURL(new Blob([text], {type: "text/javascript"}));
    const worker = new Worker(url);
    worker.postMessage([name, args, code, files]);
    const result = {status: null, out: "", err: "", ms: null, files, end: null};
    let stop;
    const finished = new Promise((resolve) => {
        const end = (how) => {
            if (result.end) return;
            result.end = how;
            worker.terminate();
            clearTimeout(timer);
            URL.revokeObjectURL(url);
            resolve(result);
        };
        const timer = setTimeout(end, 1e3 * seconds, "limit");
        stop = () => end("stopped");
        worker.onerror = (event) => { result.err += event.message; end("crash"); };
        worker.onmessage = ({data}) => {
            result.out += data.out;
            result.err += data.err;
            if (result.out.length > 16e6) end("flood");
            if (data.crash) { result.err += data.crash; end("crash"); }
            if (data.status === undefined) return;
            Object.assign(result, {status: data.status, ms: data.ms});
            if (data.files) result.files = data.files;
            end("exit");
        };
    });
    return {finished, stop, result};
}

/* Say why a program has no status. */
function endWords({end, err}, seconds) {
    return {stopped: "You have stopped it.",
            limit: `Stopped: it has taken more than ${seconds} seconds.`,
            flood: "Stopped: it has printed more than 16 MB.",
            crash: `It has crashed: ${lastLine(err)}`}[end];
}
const lastLine = (text) => text.trim().split("\n").at(-1);

/* Return the tables of an output: {name, notes, columns, rows}; cells are text.  A table
 * that was cut off has the rows before the cut. */
function readTables(out) {
    return out.split("\n\n\n").filter((text) => text.startsWith("# ")).map((text) => {
        const lines = text.split("\n").filter((line) => line !== "");
        const notes = lines.filter((line) => line.startsWith("# "));
        const [columns, ...rows] = lines.filter((line) => !line.startsWith("# "))
            .map((line) => line.split("\t"));
        return {name: notes.shift().slice(2), notes: notes.map((note) => note.slice(2)),
                columns: columns || [], rows};
    });
}
