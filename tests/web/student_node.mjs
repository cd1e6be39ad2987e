/* student_node.mjs - student.js in node: its workers are threads, `base` is a folder,
 * and the clock is the processor's, which a busy machine does not change. */
import fs from 'node:fs';
import vm from 'node:vm';
import path from 'node:path';
import {Worker, isMainThread, parentPort, workerData} from 'node:worker_threads';
import {fileURLToPath, pathToFileURL} from 'node:url';

const web = path.join(path.dirname(fileURLToPath(import.meta.url)), '../../lessons/web');
const plain = name => vm.runInThisContext(fs.readFileSync(path.join(web, name), 'utf8'), name);

if (!isMainThread) {
    globalThis.self = globalThis;
    performance.now = () => { const {user, system} = process.cpuUsage(); return (user + system) / 1e3; };
    globalThis.postMessage = message => parentPort.postMessage(message);
    globalThis.fetch = async url => new Response(fs.readFileSync(fileURLToPath(url)));
    if (workerData === 'student_compile.js') await import(path.join(web, workerData));
    else plain(workerData);
    parentPort.on('message', data => self.onmessage({data}));
}

class Thread {
    constructor(name) {
        this.thread = new Worker(fileURLToPath(import.meta.url), {workerData: name});
        this.thread.on('message', data => this.onmessage({data}));
        this.thread.on('error', error => this.onerror({message: String(error)}));
        this.thread.unref();
    }
    postMessage(message) { this.thread.postMessage(message); }
    terminate() { this.thread.terminate(); }
}
export const thread = name => new Thread(name), urlOf = folder => pathToFileURL(path.resolve(folder)) + '/';

/* A student for the files in this folder. */
export function student(folder) {
    plain('student.js');
    return globalThis.makeStudent({base: urlOf(folder), worker: thread});
}
/* Ask a thread for what answer() finds in one of its messages, within ten minutes. */
export const ask = (who, message, answer) => new Promise((done, failed) => {
    const late = setTimeout(failed, 6e5, Error('no answer'));
    who.onmessage = ({data}) => { const its = answer(data); if (its) done(its, clearTimeout(late)); };
    who.onerror = ({message}) => failed(Error(message));
    who.postMessage(message);
});
