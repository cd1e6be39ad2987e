/*
 * student_judge.js - a worker that runs a program linked for WASI: the judge of a
 * lesson, with the student's program compiled in.
 *
 * It is sent {code, args, files, ended}: a WebAssembly.Module, its arguments, what files
 * there are (paths without the first /, and bytes), and the children that have an end
 * already (see below); from tests/tools/web_kept.mjs its environment, too.  It posts {out}
 * and {err}, text as it is printed; {begin: k, seconds} and {end: k} of each child;
 * {result: {status, limit, files}}.
 *
 * The program has files in memory alone, a clock, and nothing else of the machine.
 *
 * tests/web/child.c asks for children.  A child is a copy of the instance that asks: the
 * module once more, with a copy of its memory, in which body(context) is called.  It
 * ends by exit(), by a trap, or at a limit, and its parent goes on.  They are counted in
 * the order in which they begin.  One that does not end ends this worker, from outside;
 * a new one is told that child k has ended in such a way, and runs all others again,
 * which do what they did before.
 *
 * With {scene: true} the program is a scene in the hand (tests/web/view.c), which waits for
 * its frames: it posts {frame: PICTURE}, the first time null, and is sent {pointer: [x, y,
 * down, code of the key]}, or {pointer: null} at the end.
 */
"use strict";
(() => {
const [LIMIT_OUTPUT, LIMIT_FILES] = [3, 4]; /* enum limit of child.h */
const MOST_OUTPUT = 8e6, MOST_FILES = 64, SECONDS = 5;
const PAGES = 384 << 4; /* of 64 kB, as student_compile.js has linked it */
const [BADF, EXIST, INVAL, NOENT, NOTDIR, NOSYS] = [8, 20, 28, 44, 54, 52];

class End extends Error {
    constructor(status, limit = 0) { super(); Object.assign(this, {status, limit}); }
}

/* Return the signal that a native program would have; three browsers word a trap. */
function signalOf(error) {
    const words = String(error);
    if (/divi|unrepresentable|integer overflow/i.test(words)) return 8;
    return /unreachable/i.test(words) ? 4 : 11;
}
function endOf(error) {
    if (error instanceof End) return error;
    if (error instanceof WebAssembly.RuntimeError || error instanceof RangeError ||
        error.name === "InternalError") return new End(-signalOf(error));
    throw error;
}

class File {
    constructor(bytes = new Uint8Array(0)) { this.bytes = bytes; this.size = bytes.length; }
    text() { return this.bytes.subarray(0, this.size); }
    write(at, from) {
        const end = at + from.length;
        if (end > MOST_OUTPUT) throw new End(-25, LIMIT_OUTPUT);
        if (end > this.bytes.length) {
            const more = new Uint8Array(Math.max(1024, 2 * end));
            more.set(this.text());
            this.bytes = more;
        }
        this.bytes.set(from, at);
        this.size = Math.max(this.size, end);
    }
}

/* The files, limits and children that all instances of a run share. */
class World {
    constructor({code, args, environment = [], files, ended = {}}, post) {
        Object.assign(this, {code, args, environment, ended, post, children: 0, begun: performance.now()});
        this.spent = 0; /* by children that are not run again */
        this.files = new Map(Object.entries(files).map(([path, bytes]) => [path, new File(bytes)]));
        this.folders = new Set([""]);
        for (const path of this.files.keys()) this.folderOf(path);
        this.room = []; /* memories to use again */
    }
    folderOf(path) {
        for (let at = path.lastIndexOf("/"); at > 0; at = path.lastIndexOf("/", at - 1))
            this.folders.add(path.slice(0, at));
    }
    /* Return the names in a folder. */
    list(folder) {
        const from = folder && folder + "/";
        return [...this.files.keys(), ...this.folders]
            .filter((path) => path.startsWith(from) && path !== folder &&
                              !path.slice(from.length).includes("/"))
            .map((path) => path.slice(from.length));
    }
    seconds() { return (performance.now() - this.begun) / 1e3 + this.spent; }
}

/* A descriptor: a file that is read or written, a folder, or one end of a pair. */
const reader = (file) => ({file, at: 0});
const writer = (file) => ({file, at: 0, writes: true});

class Process {
    constructor(world, memory, descriptors) {
        Object.assign(this, {world, memory, descriptors});
        const env = {memory, page_run: this.run.bind(this), page_pair: this.pair.bind(this),
            page_seconds: () => world.seconds(),
            page_limit: (seconds) => world.post({seconds}),
            page_signal: (number) => { throw new End(-number); }};
        if (world.scene) Object.assign(env, {
            page_frame: new WebAssembly.Suspending((keys, to) => this.frame(to)),
            page_draw: (picture, seconds) => { world.picture = this.picture(picture, seconds); }});
        const wasi = {};
        for (const {module, name} of WebAssembly.Module.imports(world.code))
            if (module !== "env") wasi[name] = (this[name] || (() => NOSYS)).bind(this);
        this.exports = new WebAssembly.Instance(world.code, {env, wasi_snapshot_preview1: wasi}).exports;
    }
    get view() { return new DataView(this.memory.buffer); }
    bytes(at, size) { return new Uint8Array(this.memory.buffer, at, size); }
    string(at, size) { return new TextDecoder().decode(this.bytes(at, size)); }
    /* Return a path from a string of C, without its first slash. */
    path(at) {
        const bytes = new Uint8Array(this.memory.buffer, at);
        return this.string(at, bytes.indexOf(0)).replace(/^\/+/, "");
    }
    open(what) {
        let fd = 0;
        while (this.descriptors[fd]) fd++;
        this.descriptors[fd] = what;
        return fd;
    }

    /* ---- children */
    run(body, context, out, err, handed, limit) {
        const world = this.world, k = world.children++;
        const files = [out, err].map((at) => {
            const file = new File();
            world.files.set(this.path(at), file);
            return writer(file);
        });
        let end;
        if (world.ended[k]) {
            end = world.ended[k];
            world.spent += end.seconds || 0;
        } else {
            world.post({begin: k, seconds: SECONDS});
            end = this.copy(body, context, [reader(new File()), ...files, this.descriptors[3],
                                            handed ? this.descriptors[handed] : null]);
            world.post({end: k});
        }
        this.view.setInt32(limit, end.limit, true);
        return end.status;
    }
    copy(body, context, descriptors) {
        const world = this.world, mine = this.memory.buffer, pages = mine.byteLength / 65536;
        const memory = world.room.pop() || new WebAssembly.Memory({initial: pages, maximum: PAGES});
        const more = pages - memory.buffer.byteLength / 65536;
        if (more > 0) memory.grow(more);
        let end;
        try {
            const child = new Process(world, memory, descriptors);
            new Uint8Array(memory.buffer).set(new Uint8Array(mine));
            child.exports.__stack_pointer.value = this.exports.__stack_pointer.value;
            child.exports.page_body(body, context);
        } catch (error) {
            end = endOf(error);
        }
        /* a memory that has grown would be larger than the next parent's */
        if (memory.buffer.byteLength === mine.byteLength) world.room.push(memory);
        return end;
    }
    pair(both) {
        const ends = [{queue: []}, {queue: []}];
        ends[0].other = ends[1];
        ends[1].other = ends[0];
        ends.forEach((end, k) => this.view.setInt32(both + 4 * k, this.open(end), true));
    }

    /* ---- a scene in the hand */
    async frame(to) {
        const pointer = await this.world.next();
        pointer?.forEach((number, k) => this.view.setFloat64(to + 8 * k, number, true));
        return pointer ? 1 : 0;
    }
    /* Copy a struct view_picture of view.h. */
    picture(at, seconds) {
        const word = (k) => this.view.getInt32(at + k, true), behind = 32 + 32 * 64;
        const numbers = (from, n) => new Float64Array(this.memory.buffer.slice(from, from + 8 * n));
        const whole = (from, n) => from ? new Int32Array(this.memory.buffer.slice(from, from + 4 * n)) : null;
        const text = (from, size) => this.string(from, size).replace(/\0[^]*$/, "");
        const n = word(0), n_triangle = word(8);
        return {x: numbers(word(4), 2 * n), triangle: whole(word(12), 3 * n_triangle),
                value: numbers(word(16), n_triangle), held: whole(word(20), n), ring: whole(word(24), n),
                arrow: numbers(at + 32, 4 * word(28)), curve: numbers(word(behind + 4), 2 * word(behind)),
                alarm: word(behind + 8) !== 0, caption: text(at + behind + 12, 480),
                note: text(at + behind + 492, 80), ms: 1e3 * seconds};
    }

    /* ---- WASI */
    args_get(pointers, at, list = this.world.args) {
        for (const text of list) {
            const bytes = new TextEncoder().encode(text + "\0");
            this.view.setUint32(pointers, at, true);
            this.bytes(at, bytes.length).set(bytes);
            pointers += 4;
            at += bytes.length;
        }
        return 0;
    }
    args_sizes_get(count, size, list = this.world.args) {
        this.view.setUint32(count, list.length, true);
        this.view.setUint32(size, new TextEncoder().encode(list.join("\0") + "\0").length, true);
        return 0;
    }
    environ_get(pointers, at) { return this.args_get(pointers, at, this.world.environment); }
    environ_sizes_get(count, size) { return this.args_sizes_get(count, size, this.world.environment); }
    clock_time_get(clock, precision, to) {
        const ms = clock ? performance.now() : Date.now();
        this.view.setBigUint64(to, BigInt(Math.round(1e6 * ms)), true);
        return 0;
    }
    proc_exit(status) { throw new End(status); }

    fd_prestat_get(fd, to) {
        if (fd !== 3) return BADF;
        this.view.setUint32(to, 0, true);
        this.view.setUint32(to + 4, 1, true);
        return 0;
    }
    fd_prestat_dir_name(fd, to) { return this.bytes(to, 1).set([47]), 0; }
    fd_close(fd) {
        if (!this.descriptors[fd]) return BADF;
        if (fd !== 3) this.descriptors[fd] = null;
        return 0;
    }
    kind({folder, queue}) { return folder !== undefined ? 3 : queue ? 6 : 4; }
    fd_fdstat_get(fd, to) {
        const d = this.descriptors[fd];
        if (!d) return BADF;
        this.bytes(to, 24).fill(0);
        this.view.setUint8(to, this.kind(d));
        this.view.setUint16(to + 2, d.append ? 1 : 0, true);
        this.bytes(to + 8, 16).fill(255);
        return 0;
    }
    fd_fdstat_set_flags() { return 0; }
    stat(to, kind, size) {
        this.bytes(to, 64).fill(0);
        this.view.setUint8(to + 16, kind);
        this.view.setBigUint64(to + 24, 1n, true);
        this.view.setBigUint64(to + 32, BigInt(size), true);
        return 0;
    }
    fd_filestat_get(fd, to) {
        const d = this.descriptors[fd];
        return d ? this.stat(to, this.kind(d), d.file?.size || 0) : BADF;
    }
    fd_seek(fd, offset, whence, to) {
        const d = this.descriptors[fd];
        if (!d?.file) return d?.queue ? 70 : BADF;
        const at = Number(offset) + [0, d.at, d.file.size][whence];
        if (at < 0) return INVAL;
        d.at = at;
        this.view.setBigUint64(to, BigInt(at), true);
        return 0;
    }
    /* Return the pieces of memory of a read or a write. */
    parts(at, n) {
        const view = this.view;
        return Array.from({length: n}, (_, k) => this.bytes(view.getUint32(at + 8 * k, true),
                                                            view.getUint32(at + 8 * k + 4, true)));
    }
    fd_read(fd, at, n, count) {
        const d = this.descriptors[fd];
        if (!d?.file && !d?.queue) return BADF;
        let all = 0;
        for (const part of this.parts(at, n)) {
            const from = d.file ? d.file.text().subarray(d.at, d.at + part.length)
                                : d.queue.splice(0, part.length);
            part.set(from);
            if (d.file) d.at += from.length;
            all += from.length;
        }
        this.view.setUint32(count, all, true);
        return 0;
    }
    fd_write(fd, at, n, count) {
        const d = this.descriptors[fd];
        if (!d?.writes && !d?.queue) return BADF;
        let all = 0;
        for (const part of this.parts(at, n)) {
            if (d.queue) d.other.queue.push(...part);
            else if (d.file) {
                if (d.append) d.at = d.file.size;
                d.file.write(d.at, part);
                d.at += part.length;
            } else d.print(part);
            all += part.length;
        }
        this.view.setUint32(count, all, true);
        return 0;
    }
    fd_readdir(fd, at, size, cookie, used) {
        const d = this.descriptors[fd];
        if (d?.folder === undefined) return NOTDIR;
        const begin = at, end = at + size;
        const list = this.world.list(d.folder);
        for (let k = Number(cookie); k < list.length && at < end; k++) {
            const name = new TextEncoder().encode(list[k]);
            const entry = new Uint8Array(24 + name.length), view = new DataView(entry.buffer);
            view.setBigUint64(0, BigInt(k + 1), true);
            view.setUint32(16, name.length, true);
            view.setUint8(20, 4);
            entry.set(name, 24);
            this.bytes(at, Math.min(entry.length, end - at)).set(entry.subarray(0, end - at));
            at += entry.length;
        }
        this.view.setUint32(used, Math.min(at, end) - begin, true);
        return 0;
    }
    named(fd, at, size) {
        const folder = this.descriptors[fd]?.folder;
        const parts = [];
        for (const part of `${folder}/${this.string(at, size)}`.split("/"))
            if (part === "..") parts.pop();
            else if (part && part !== ".") parts.push(part);
        return parts.join("/");
    }
    path_filestat_get(fd, flags, at, size, to) {
        const path = this.named(fd, at, size), file = this.world.files.get(path);
        if (this.world.folders.has(path)) return this.stat(to, 3, 0);
        return file ? this.stat(to, 4, file.size) : NOENT;
    }
    path_open(fd, follow, at, size, how, rights, inherited, flags, to) {
        const world = this.world, path = this.named(fd, at, size);
        const [create, folder, excl, trunc] = [1, 2, 4, 8].map((bit) => how & bit);
        const is = world.folders.has(path);
        let file = world.files.get(path);
        if (is) {
            this.view.setUint32(to, this.open({folder: path}), true);
            return 0;
        }
        if (folder) return file ? NOTDIR : NOENT;
        if (file && create && excl) return EXIST;
        if (!file && !create) return NOENT;
        const parent = path.replace(/\/?[^/]*$/, "");
        if (!world.folders.has(parent)) return NOENT;
        if (!file) {
            if (world.list(parent).length > MOST_FILES && !parent.includes("mistakes"))
                throw new End(-9, LIMIT_FILES);
            world.files.set(path, file = new File());
        }
        if (trunc) file = world.files.set(path, new File()).get(path);
        const writes = (rights & 64n) !== 0n;
        this.view.setUint32(to, this.open({file, at: 0, writes, append: flags & 1}), true);
        return 0;
    }
    path_create_directory(fd, at, size) {
        const path = this.named(fd, at, size);
        if (this.world.folders.has(path)) return EXIST;
        this.world.folders.add(path);
        return 0;
    }
    path_unlink_file(fd, at, size) { return this.world.files.delete(this.named(fd, at, size)) ? 0 : NOENT; }
    path_rename(fd, at, size, other, to, length) {
        const path = this.named(fd, at, size), file = this.world.files.get(path);
        if (!file) return NOENT;
        this.world.files.delete(path);
        this.world.files.set(this.named(other, to, length), file);
        return 0;
    }
    path_remove_directory(fd, at, size) { return this.world.folders.delete(this.named(fd, at, size)) ? 0 : NOENT; }
}

/* Return the first process. */
function processOf(world, post) {
    const printer = (what) => {
        const decoder = new TextDecoder();
        let size = 0;
        return {writes: true, print: (bytes) => {
            size += bytes.length;
            if (size > MOST_OUTPUT) throw new End(-25, LIMIT_OUTPUT);
            post({[what]: decoder.decode(bytes, {stream: true})});
        }};
    };
    const memory = new WebAssembly.Memory({initial: 256, maximum: PAGES});
    return new Process(world, memory, [reader(new File()), printer("out"), printer("err"), {folder: ""}]);
}

/* Run a job to its end.  Return {status, limit, files}. */
function runToEnd(job, post) {
    const world = new World(job, post);
    let end = new End(0);
    try {
        processOf(world, post).exports._start();
    } catch (error) {
        end = endOf(error);
    }
    const files = {};
    for (const name of job.want || [])
        if (world.files.has(name)) files[name] = new TextDecoder().decode(world.files.get(name).text());
    return {status: end.status, limit: end.limit, files};
}

/* Run a scene; the next message has the pointer of its next frame. */
let pointed = null;
async function play(job, post) {
    const world = new World(job, post);
    world.scene = true;
    world.picture = null;
    world.next = () => new Promise((done) => {
        pointed = done;
        post({frame: world.picture});
    });
    let end = new End(0), process;
    try {
        process = processOf(world, post);
        await WebAssembly.promising(process.exports._start)();
    } catch (error) {
        end = endOf(error);
    }
    if (end.status < 0 && process)
        try { process.exports.page_trapped(-end.status); } catch (error) { end = endOf(error); }
    return {status: end.status, limit: end.limit};
}

self.onmessage = async ({data}) => {
    const post = (what) => self.postMessage(what);
    if (data.pointer !== undefined) pointed?.(data.pointer);
    else post({result: data.scene ? await play(data, post) : runToEnd(data, post)});
};
})();
