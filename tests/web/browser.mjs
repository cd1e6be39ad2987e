/*
 * browser.mjs - a headless Chromium over a pipe, without a package.
 *
 *     const browser = await open();
 *     const page = await browser.page('file:///...', 1400, 900);
 *     await page.eval('1 + 1');          a value, or what a promise gives
 *     await page.send('Input.dispatchMouseEvent', {...});
 *     await page.shot('page.png');
 *     await browser.close();
 */
import { spawn } from 'node:child_process';
import { mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';

export async function open(more = []) {
    const folder = mkdtempSync(join(tmpdir(), 'web-'));
    const child = spawn(process.env.CHROMIUM || 'chromium', [
        '--headless=new', '--no-sandbox', '--disable-gpu', '--disable-quic',
        '--no-first-run', '--disable-background-networking',
        '--disable-component-update', '--disable-sync', '--hide-scrollbars',
        '--user-data-dir=' + folder, '--remote-debugging-pipe', ...more,
        'about:blank'], { stdio: ['ignore', 'ignore', 'ignore', 'pipe', 'pipe'] });
    const gone = new Promise(done => child.once('exit', done));
    const waiting = new Map(), heard = [];
    let last = 0, rest = '';
    child.stdio[4].on('data', data => {
        const parts = (rest + data).split('\0');
        rest = parts.pop();
        for (const part of parts) {
            const message = JSON.parse(part);
            const call = waiting.get(message.id);
            if (!call) { for (const hear of heard) hear(message); continue; }
            waiting.delete(message.id);
            if (message.error) call.fail(new Error(message.error.message));
            else call.done(message.result);
        }
    });
    gone.then(() => {
        for (const call of waiting.values()) call.fail(new Error('the browser has ended'));
    });
    function send(method, params = {}, sessionId) {
        const id = ++last;
        return new Promise((done, fail) => {
            waiting.set(id, { done, fail });
            child.stdio[3].write(JSON.stringify({ id, method, params, sessionId }) + '\0');
        });
    }
    async function page(url, width = 1400, height = 900, mobile = false) {
        const { targetId } = await send('Target.createTarget', { url: 'about:blank' });
        const { sessionId } = await send('Target.attachToTarget', { targetId, flatten: true });
        const on = (method, params) => send(method, params, sessionId);
        const errors = [];
        heard.push(message => {
            if (message.sessionId !== sessionId) return;
            if (message.method === 'Runtime.exceptionThrown') {
                const d = message.params.exceptionDetails;
                errors.push((d.exception && d.exception.description) || d.text);
            }
            if (message.method === 'Log.entryAdded' && message.params.entry.level === 'error')
                errors.push(message.params.entry.text + ' ' + (message.params.entry.url || ''));
        });
        await on('Page.enable');
        await on('Runtime.enable');
        await on('Log.enable');
        await on('Emulation.setDeviceMetricsOverride',
                 { width, height, deviceScaleFactor: 1, mobile });
        const loaded = new Promise(done => heard.push(message => {
            if (message.sessionId === sessionId &&
                message.method === 'Page.loadEventFired') done();
        }));
        await on('Page.navigate', { url });
        await loaded;
        return {
            send: on, errors,
            async eval(text) {
                const { result, exceptionDetails: bad } = await on('Runtime.evaluate',
                    { expression: text, awaitPromise: true, returnByValue: true });
                if (bad) throw new Error((bad.exception && bad.exception.description) || bad.text);
                return result.value;
            },
            async until(text, seconds = 60) { /* true, or the time is over */
                for (let k = 0; k < 10 * seconds; k++) {
                    if (await this.eval(text)) return true;
                    await new Promise(done => setTimeout(done, 100));
                }
                return false;
            },
            async shot(path, whole = true) {
                const { data } = await on('Page.captureScreenshot',
                    { captureBeyondViewport: whole, format: 'png' });
                writeFileSync(path, Buffer.from(data, 'base64'));
            },
            close: () => send('Target.closeTarget', { targetId })
        };
    }
    async function close() {
        send('Browser.close').catch(() => {});
        await Promise.race([gone, new Promise(done => setTimeout(done, 5000))]);
        child.kill('SIGKILL');
        rmSync(folder, { recursive: true, force: true, maxRetries: 5 });
    }
    return { page, close };
}
