/*
 * programs.js - bring programs of `make web`: loadProgram("../programs/NAME.js") is a
 * promise of {script, code}.  The script is the body of a function of Module; with
 * Module.wasmBinary = code it runs the program that Module.thisProgram names.
 *
 * A script element brings it, which works from a file as well as from a server; it
 * is compressed (tests/tools/web_program.js).
 */
"use strict";
(() => {
self.programs ||= {};

function brought(source) {
    return new Promise((done, failed) => {
        const script = document.createElement("script");
        script.src = source;
        script.onload = done;
        script.onerror = () => failed(new Error(source + " cannot be read"));
        document.head.append(script);
    });
}

function unpacked(letters) {
    const bytes = Uint8Array.from(atob(letters), (c) => c.charCodeAt(0));
    return new Response(new Blob([bytes]).stream().pipeThrough(new DecompressionStream("gzip")));
}

self.loadProgram = async (source) => {
    const name = /([^/]*)\.js$/.exec(source)[1];
    if (!self.DecompressionStream) throw new Error("a browser of 2023 or later is needed");
    if (!programs[name]) await brought(source);
    if (Array.isArray(programs[name])) {
        const [script, code] = programs[name].map(unpacked);
        programs[name] = {script: await script.text(), code: await code.arrayBuffer()};
    }
    return programs[name];
};
})();
