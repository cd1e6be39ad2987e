/*
 * student_compile.js - a worker that makes of a student's text the judge of its lesson,
 * or says why it cannot: clang and wasm-ld as WebAssembly.
 *
 * It is sent {base, slug, text}, with {scene: true} for the lesson's scene in the hand in
 * place of its judge, and posts {progress: [phase, fraction]}, then one of
 *     {code, files, diagnostics}    a WebAssembly.Module for student_judge.js, the files
 *                                   that it reads, and the compiler's warnings
 *     {refused: WHY}                as tests/tools/program.sh refuses it
 *     {errors: TEXT, diagnostics}   what `make check` says of it
 *     {failed: NAME, why}           a file of `base` is not there; see student.js
 * Compiler and library are loaded once, and a lesson's files once.
 *
 * The steps are those of program.sh: the text is preprocessed, which ends its macros; what
 * the checks call is set behind it; and in its object all names become its own but those
 * by which they call it.
 */
const loaded = {};
const progress = (phase, fraction = null) => self.postMessage({progress: [phase, fraction]});

/* ---- files --------------------------------------------------------------- */

class Failure extends Error {
    constructor(name, message) { super(message); this.name = name; }
}
const offline = (url) => new Failure("Offline", `${url} cannot be read: a web server must bring it.`);
/* Return the checksums of the files on the server, or those it had when last reached. */
async function versionsOf(base, store) {
    const url = base + "files.json";
    const response = await fetch(url, {cache: "no-cache"}).catch(() => null);
    if (response?.ok) await store?.put(url, response.clone()).catch(() => {});
    const last = response?.ok ? response : await store?.match(url);
    if (!last) throw offline(url);
    return last.json();
}
/* Return a file of base, unpacked: from the browser's store, unless the server has
 * another version. */
async function bytesOf(base, name, count = () => {}) {
    const store = await self.caches?.open("student").catch(() => null);
    const version = (await (loaded.versions ||= versionsOf(base, store)))[name];
    const url = `${base}${name}?${version?.sum}`;
    let response = await store?.match(url);
    if (!response) {
        response = await fetch(url).catch(() => null);
        if (!response?.ok) throw offline(base + name);
        await store?.delete(base + name, {ignoreSearch: true});
        store?.put(url, response.clone()).catch(() => {});
    }
    const parts = [];
    for (const reader = response.body.getReader();;) {
        const {done, value} = await reader.read();
        if (done) break;
        parts.push(value);
        count(value.length);
    }
    const [a, b] = parts[0] || [];
    if (a !== 0x1f || b !== 0x8b) return new Uint8Array(await new Blob(parts).arrayBuffer());
    if (!self.DecompressionStream)
        throw new Failure("OldBrowser", "A browser of 2023 or later is needed.");
    const whole = new Blob(parts).stream().pipeThrough(new DecompressionStream("gzip"));
    return new Uint8Array(await new Response(whole).arrayBuffer());
}

/* Return the files of an archive of tar: bytes by path. */
function untar(bytes) {
    const files = {}, ascii = new TextDecoder();
    const word = (at, size) => ascii.decode(bytes.subarray(at, at + size)).replace(/\0.*$/s, "");
    for (let at = 0; at + 512 <= bytes.length && bytes[at];) {
        const size = parseInt(word(at + 124, 12), 8) || 0, type = word(at + 156, 1);
        if (type === "0" || type === "")
            files[word(at, 100).replace(/^\.\//, "")] = bytes.slice(at + 512, at + 512 + size);
        at += 512 + 512 * Math.ceil(size / 512);
    }
    return files;
}
/* Return the same as the compiler wants it: each folder an object. */
function treeOf(files) {
    const root = {};
    for (const [path, content] of Object.entries(files)) {
        const parts = path.split("/"), name = parts.pop();
        let folder = root;
        for (const part of parts) folder = folder[part] ||= {};
        folder[name] = content;
    }
    return root;
}

const CODE = ["llvm.core.wasm", "llvm.core2.wasm", "llvm.core3.wasm", "llvm.core4.wasm"];
const BYTES = 24e6; /* of all, packed; for the bar alone */

/* Read a number of a module. */
function numberAt(bytes, here) {
    for (let value = 0, shift = 0;; shift += 7) {
        const byte = bytes[here.at++];
        value |= (byte & 127) << shift;
        if (byte < 128) return value >>> 0;
    }
}
/* Bound the compiler's memory: the second number of the memory section. */
function bounded(bytes, megabytes) {
    const here = {at: 8}, number = () => numberAt(bytes, here);
    while (here.at < bytes.length) {
        const id = bytes[here.at++], size = number(), end = here.at + size;
        if (id === 5 && number() === 1 && number() === 1) {
            number();
            let pages = 16 * megabytes;
            for (; here.at < end; here.at++, pages >>= 7) bytes[here.at] = pages & 127 | (here.at < end - 1 ? 128 : 0);
        }
        here.at = end;
    }
    return bytes;
}

async function loadCompiler(base) {
    if (loaded.app) return;
    let count = 0;
    const more = (size) => progress("load", Math.min(1, (count += size) / BYTES));
    progress("load", 0);
    const [{Application, instantiate, Exit}, library, ...code] = await Promise.all([
        bytesOf(base, "clang.js.gz", more).then((bytes) =>
            import("data:text/javascript," + encodeURIComponent(new TextDecoder().decode(bytes)))),
        bytesOf(base, "library.tar.gz", more),
        ...CODE.map((name) => bytesOf(base, name + ".gz", more)
            .then((bytes) => WebAssembly.compile(bounded(bytes, 512))))]);
    const {usr, ...rest} = treeOf(untar(library));
    const modules = Object.fromEntries(CODE.map((name, k) => [name, code[k]]));
    loaded.files = rest;
    loaded.Exit = Exit;
    loaded.app = new Application({modules: async () => modules, filesystem: async () => ({usr}),
                                  totalSize: 1}, instantiate, "llvm");
    progress("load", 1);
}
/* Unpack the output of the reference and of the known mistakes (tests/tools/web_kept.mjs). */
function kept({lines, files}) {
    const coder = new TextEncoder();
    return Object.fromEntries(Object.entries(files).map(([name, parts]) => {
        let text = "";
        for (let k = 0; k < parts.length; k += 2)
            text += lines.slice(parts[k], parts[k] + parts[k + 1]).join("");
        return [name, coder.encode(text)];
    }));
}
async function loadLesson(base, slug) {
    loaded.lessons ||= {};
    if (loaded.lessons[slug]) return loaded.lessons[slug];
    progress("lesson");
    const files = untar(await bytesOf(base, `${slug}.tar.gz`));
    const words = (name) => new TextDecoder().decode(files[name]).trimEnd().split("\n");
    const lesson = {
        object: files["checks.o"], checks: files["checks.c"],
        contract: new TextDecoder().decode(files["checks.h"]),
        calls: words("checks.calls").map((line) => line.split("\t")),
        owner: new Map(words("checks.words").map((line) => line.split(" "))),
        scene: files["hand.c"], solution: files["solution.c"],
        files: kept(JSON.parse(new TextDecoder().decode(files["checks.json"]))),
    };
    return loaded.lessons[slug] = lesson;
}

/* ---- the compiler -------------------------------------------------------- */

class Refusal extends Error {}
const NO_END = "what it includes, or its macros, have no end", MOST_TEXT = 4e6;

/* Run clang or wasm-ld: {ok, files, out, said}. */
async function tool(args, files) {
    const out = [], said = [];
    let size = 0;
    const collect = (list) => (bytes) => {
        if (!bytes) return;
        list.push(new Uint8Array(bytes));
        if ((size += bytes.length) > MOST_TEXT) throw new Refusal(NO_END);
    };
    const text = (list) => new Blob(list).text();
    let made = null;
    try {
        made = await loaded.app.run(args, {...loaded.files, ...files},
            {stdout: collect(out), stderr: collect(said), decodeASCII: false, fetchProgress: () => {}});
    } catch (error) {
        /* a trap: for want of memory */
        if (error instanceof WebAssembly.RuntimeError) throw new Refusal(NO_END);
        if (!(error instanceof loaded.Exit)) throw error;
    }
    return {ok: made !== null, files: made, out: await text(out), said: await text(said)};
}
const LANGUAGE = ["-std=c17", "-D_POSIX_C_SOURCE=200809L", "-ffp-contract=off"];
const PATHS = ["-Icommon", "-I.",
    ...["SIGNAL", "GETPID", "PROCESS_CLOCKS", "MMAN"].map((name) => `-D_WASI_EMULATED_${name}`)];
const STRICT = ["-Wall", "-Wextra", "-Wpedantic", "-Wshadow", "-Wconversion",
    "-Wstrict-prototypes", "-Wmissing-prototypes"];
/* An index beyond an array that clang knows is a trap, and so is a null pointer. */
const CHECKED = ["-fsanitize=bounds,null", "-fsanitize-trap=bounds", "-fno-sanitize-recover=null",
    "-fsanitize-minimal-runtime"];
const STACK = 8 << 20; /* as elsewhere */
const MEMORY = 384 << 20; /* of one instance of the judge; student_judge.js, too */

/* ---- the student's program ----------------------------------------------- */

/* Read the preprocessed text (tests/tools/program.awk).  Return {text, missing, contract}:
 * the program with the calls of the checks behind it, the functions that it lacks, and the
 * contract anew where one of its structs has other members. */
function readProgram(text, path, lesson) {
    const members = new Map(Array.from(
        lesson.contract.matchAll(/(?<=\n)struct ([A-Za-z_0-9]+) \{[^}]*\}/g), ([all, tag]) => [tag, all]));
    const tokens = (struct) => struct.replace(/\/\*([^*]|\*[^/])*\*\//g, " ")
        .replace(/[^A-Za-z0-9_ \n]/g, " $& ").replace(/[ \n]+/g, " ");
    const missing = new Set(lesson.calls.map(([name]) => name));
    const program = [];
    let contract = lesson.contract, depth = 0, struct = "", behind = [], other = false;
    const changed = (struct) => {
        const tag = /^struct +([A-Za-z_0-9]+)/.exec(struct)[1], mine = members.get(tag);
        if (tokens(struct) === tokens(mine)) return;
        contract = contract.replace("\n" + mine, () => "\n" + struct);
        members.set(tag, struct);
        other = true;
    };
    for (const line of text.split("\n")) {
        const begin = /^# \d+ "(.*)" 1( 3)?( 4)?$/.exec(line);
        if (begin && begin[1] !== path && begin[1] !== "./" + path && !/^<.*>$/.test(begin[1]) &&
            (!begin[1].endsWith(".h") || /^\/(dev|proc)\//.test(begin[1])))
            throw new Refusal(`it includes what is no header, ${begin[1]}`);
        if (/^program_has/.test(line)) {
            behind = line.trim().split(/\s+/);
            continue;
        }
        program.push(line);
        if (line.startsWith("# ")) depth += / 1[ 134]*$/.test(line) - / 2[ 134]*$/.test(line);
        if (line.startsWith("#")) continue;
        if (depth === 1) {
            for (const name of missing)
                if (line.includes(name) && RegExp(`(^|[^A-Za-z_0-9])${name}([^A-Za-z_0-9]|$)`).test(line))
                    missing.delete(name);
            if (/\b(asm|__asm|__asm__)\b/.test(line.replace(/"([^"\\]|\\.)*"/g, "")))
                throw new Refusal("it has a line of assembler");
        }
        let rest = line;
        if (struct === "") {
            const at = line.search(/struct +[A-Za-z_0-9]+ *(\{.*)?$/);
            if (at < 0) continue;
            struct = line.slice(at);
            if (!members.has(struct.split(/[^A-Za-z_0-9]+/)[1])) { struct = ""; continue; }
            if (!struct.includes("}")) continue;
            rest = "";
        }
        struct += "\n" + rest;
        if (!/^struct +[A-Za-z_0-9]+[ \n]*(\{|$)/.test(struct)) struct = "";
        else if (struct.includes("}") && struct.split("}").length >= struct.split("{").length) {
            changed(struct.slice(0, struct.lastIndexOf("}") + 1));
            struct = "";
        }
    }
    lesson.calls.forEach(([name, call], k) => {
        let mine = name;
        if (/^[A-Za-z_]\w*$/.test(behind[k + 1] ?? "") && behind[k + 1] !== name) {
            missing.delete(name);
            mine = behind[k + 1];
        }
        program.push(`# 1 "the call of ${name}" 3`, call.replace("%", () => mine));
    });
    return {text: program.join("\n") + "\n", missing: [...missing], contract: other ? contract : null};
}

/* Read an object: its symbols, with the place of their flags, the names of its data
 * segments, the number of functions that run before main(), and its imports. */
function readObject(bytes) {
    const here = {at: 8}, number = () => numberAt(bytes, here);
    const string = () => {
        const size = number();
        here.at += size;
        return new TextDecoder().decode(bytes.subarray(here.at - size, here.at));
    };
    const limits = () => { if (number() & 1) number(); number(); };
    const object = {symbols: [], segments: [], before: 0, imports: []};
    const names = {0: [], 2: [], 4: [], 1: []}; /* imported, by kind of symbol */
    const readImport = () => {
        const from = string(), name = string(), kind = bytes[here.at++];
        object.imports.push({from, name});
        if (kind === 0) { number(); names[0].push(name); }
        else if (kind === 1) { here.at++; limits(); names[1].push(name); }
        else if (kind === 2) limits();
        else if (kind === 3) { here.at += 2; names[2].push(name); }
        else { here.at++; number(); names[4].push(name); }
    };
    const readSymbol = () => {
        const kind = bytes[here.at++], place = here.at, flags = number(), undefined_ = flags & 0x10;
        let name = "";
        if (kind === 1) {
            name = string();
            if (!undefined_) { number(); number(); number(); }
        } else if (kind === 3) {
            number();
        } else {
            const index = number();
            name = !undefined_ || flags & 0x40 ? string() : (names[kind === 5 ? 1 : kind][index] ?? "");
        }
        object.symbols.push({kind, place, flags, name, undefined: undefined_ !== 0});
    };
    while (here.at < bytes.length) {
        const id = bytes[here.at++], size = number(), end = here.at + size;
        if (id === 2) {
            for (let n = number(); n > 0; n--) readImport();
        } else if (id === 0 && string() === "linking") {
            number();
            while (here.at < end) {
                const type = number(), length = number(), stop = here.at + length;
                if (type === 8) for (let n = number(); n > 0; n--) readSymbol();
                else if (type === 5)
                    for (let n = number(); n > 0; n--) { object.segments.push(string()); number(); number(); }
                else if (type === 6) object.before = number();
                here.at = stop;
            }
        }
        here.at = end;
    }
    return object;
}

/* Make all names of the object local but those that the checks call, in place
 * (tests/tools/assembler.awk). */
function close(bytes, lesson) {
    const [UNDEFINED_NAME, WEAK, LOCAL, VISIBLE] = [0x40, 1, 2, 7];
    const object = readObject(bytes), {owner} = lesson;
    if (object.before) throw new Refusal("it has code that runs before main()");
    if (object.segments.some((name) => !/^\.(data|rodata|bss|tdata|tbss)([.,]|$)/.test(name)))
        throw new Refusal("it puts something into a section of the object file");
    if (object.imports.some(({from}) => !/^(env|GOT\.\w+)$/.test(from)))
        throw new Refusal("it asks the page for something");
    const has = new Set(object.symbols.filter((s) => !s.undefined).map((s) => s.name));
    const keep = new Set(lesson.calls.map(([name]) => "program_" + name));
    for (const {name, kind, place, flags, undefined: missing} of object.symbols) {
        if (missing && flags & UNDEFINED_NAME) throw new Refusal("it asks the page for something");
        if (missing && (owner.get(name) === "judge" || /^page_/.test(name)) && !has.has(name))
            throw new Refusal(`it uses ${name}, which is the judge's`);
        if (missing || flags & LOCAL || kind === 3 || keep.has(name)) continue;
        if (owner.get(name) === "library" && !(flags & WEAK))
            throw new Refusal(`it has a function ${name}, as the library has`);
        bytes[place] = bytes[place] & ~VISIBLE | LOCAL;
    }
}

/* ---- what is said where it does not compile ------------------------------- */

const errorsOf = (said) => said.split("\n").filter((line) => /error|undefined|cannot find|not found/.test(line));
const some = (names) => [...new Set(names)].sort().slice(0, 4).join(", ");
/* Return the names of the functions that a text defines. */
const heads = (text) => [...text.matchAll(/^[a-z][^;=(\n]*[ *]([A-Za-z_]\w*)\(/gm)].map(([, name]) => name);

/* Say why it does not compile, as explain_compile() of tests/tools/student.sh does. */
async function explain(path, text, {missing = [], said = ""}, lesson) {
    const alone = await tool(["clang", "-fsyntax-only", ...LANGUAGE, ...PATHS, ...STRICT, path], {...put(path, text)});
    const diagnostics = alone.said;
    if (!alone.ok) {
        const own = alone.said.split("\n").filter((line) => line.startsWith(path + ":") &&
            /:\d+: (fatal )?error/.test(line));
        const lines = own.length ? own : errorsOf(alone.said);
        return {diagnostics, errors: lines.slice(0, 5).map((line) => "  " + line)};
    }
    const other = [...said.matchAll(/^the call of (\w+):\d.*error/gm)].map(([, name]) => name);
    if (missing.includes("main") || some(other) === "main")
        return {diagnostics, errors: ["  main() must be there, and begin: int main(int argc, char *argv[])"]};
    if (missing.length) {
        const known = new Set(heads(lesson.contract.replace(/ AS_PROGRAM/g, "")));
        const fresh = heads(text).filter((name) => !known.has(name) && name !== "main");
        return {diagnostics, errors: [`  The checks call what your file no longer has: ${some(missing)}.`,
            ...fresh.length ? [`  New in it: ${some(fresh)}.`] : [],
            "  Keep the names of the starter's functions."]};
    }
    if (other.length) return {diagnostics, errors: [
        "  The checks call what in your file has other parameters, or another",
        `  type: ${some(other)}. Keep them as in the starter.`]};
    return {diagnostics: diagnostics + said, errors: [...errorsOf(said).slice(0, 5),
        "  Does your program still have all functions of the starter?"]};
}

const put = (path, text) => ({lessons: {[path.replace(/^lessons\//, "")]: text},
    solutions: {[path.replace(/^lessons\//, "")]: ""}});

async function compile({base, slug, text}) {
    await loadCompiler(base);
    const lesson = await loadLesson(base, slug), path = `lessons/${slug}.c`;
    progress("compile");
    const names = lesson.calls.map(([name]) => name).join(" ");
    const whole = await tool(["clang", "-w", "-E", ...LANGUAGE, ...PATHS, "program.c"],
        {...put(path, text), "program.c": `#include "${path}"\nprogram_has ${names}\n`});
    if (!whole.ok) return explain(path, text, whole, lesson);
    const program = readProgram(whole.out, path, lesson);
    if (program.missing.length) return explain(path, text, program, lesson);
    const made = await tool(["clang", "-c", ...LANGUAGE, ...STRICT, ...CHECKED, "-O0", "-fno-common",
        "-x", "cpp-output", "program.i", "-o", "program.o"], {"program.i": program.text});
    if (!made.ok) return explain(path, text, made, lesson);
    const object = made.files["program.o"];
    close(object, lesson);
    let checks = lesson.object;
    if (program.contract) {
        const anew = await tool(["clang", "-c", "-w", ...LANGUAGE, ...PATHS, "-O0", "-Itests/checks",
            "-includetests/web/posix.h", '-DPROGRAM="contract.h"', "tests/checks/checks.c", "-o", "checks.o"],
            {"contract.h": program.contract, tests: {...loaded.files.tests,
                checks: {...loaded.files.tests.checks, "checks.c": lesson.checks}}});
        if (!anew.ok) throw new Refusal("a struct of the starter has a member of a type of its own");
        checks = anew.files["checks.o"];
    }
    const code = await link(["program.o", "checks.o", "--export=page_body", "--export=__stack_pointer"],
                            {"program.o": object, "checks.o": checks});
    if (code.said) return explain(path, text, code, lesson);
    return {code, files: lesson.files, diagnostics: made.said};
}

/* Fill the slots that are not written yet from the solution (tests/tools/hand.awk).  Return
 * the text, and a line that says which slots are whose. */
function together(solution, mine) {
    const slot = /(\/\* SLOT (\d+[a-z])\([^]*?\*\/\n)([^]*?)(?=^.*\/\* END \2 \*\/)/gm;
    const bodies = new Map([...solution.matchAll(slot)].map(([, , name, body]) => [name, body]));
    const [yours, theirs] = [[], []];
    const text = mine.replace(slot, (whole, head, name, body) => {
        const unwritten = body.includes(`todo("${name}"`) && bodies.has(name);
        (unwritten ? theirs : yours).push(name);
        return head + (unwritten ? bodies.get(name) : body);
    });
    return {text, whose: `yours: ${yours.join(" ") || "none"}` +
                         (theirs.length ? `; reference: ${theirs.join(" ")}` : "")};
}
async function compileScene({base, slug, text}) {
    await loadCompiler(base);
    const lesson = await loadLesson(base, slug), path = `lessons/${slug}.c`;
    if (!lesson.scene) throw new Failure("NoScene", "There is nothing to hold in this lesson.");
    progress("compile");
    const all = together(new TextDecoder().decode(lesson.solution), text.replace(/\r\n/g, "\n"));
    const made = await tool(["clang", "-c", "-w", ...LANGUAGE, ...PATHS, ...CHECKED, "-O1",
        "-includetests/web/posix.h", `-DPROGRAM="${path}"`, `-DHAND_WHOSE="${all.whose}"`,
        `figures/${slug}/hand.c`, "-o", "hand.o"],
        {...put(path, all.text), figures: {[slug]: {"hand.c": lesson.scene}}});
    if (!made.ok) return explain(path, all.text, made, lesson);
    const code = await link(["hand.o", "view.o", "--export=page_trapped"], {"hand.o": made.files["hand.o"]});
    if (code.said) return explain(path, all.text, code, lesson);
    return {code, diagnostics: ""};
}

/* Return a WebAssembly.Module, or the words of the linker. */
async function link(objects, files) {
    progress("link");
    const lib = (name) => `/usr/lib/wasm32-wasip1/lib${name}.a`;
    const page = ["run", "pair", "seconds", "limit", "signal", "frame", "draw"];
    const linked = await tool(["wasm-ld", "--import-memory", `--initial-memory=${2 * STACK}`,
        `--max-memory=${MEMORY}`, "--stack-first", "-z", `stack-size=${STACK}`, "--strip-all",
        "--allow-undefined-file=page.symbols",
        ...["malloc", "calloc", "realloc", "free", "posix_memalign", "aligned_alloc"].map((name) => "--wrap=" + name),
        "/usr/lib/wasm32-wasip1/crt1-command.o", ...objects,
        "libjudge.a", "libworkbook.a", "libgsl.a",
        ...["wasi-emulated-signal", "wasi-emulated-getpid", "wasi-emulated-process-clocks", "c"].map(lib),
        "/usr/lib/wasm32-unknown-wasip1/libclang_rt.builtins.a", "-o", "judge.wasm"],
        {...files, "page.symbols": page.map((name) => `page_${name}\n`).join("")});
    return linked.ok ? WebAssembly.compile(linked.files["judge.wasm"]) : linked;
}

self.onmessage = async ({data}) => {
    let answer;
    try {
        answer = await (data.scene ? compileScene : compile)(data);
    } catch (error) {
        if (error instanceof Refusal) answer = {refused: error.message};
        else answer = {failed: error instanceof Failure ? error.name : "Died", why: error.message || String(error)};
    }
    if (answer.failed) loaded.versions = null;
    self.postMessage(answer);
};
