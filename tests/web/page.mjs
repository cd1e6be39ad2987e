/* page.mjs - a page in a headless Chromium, for the tests beside it. */
import { readFileSync } from 'node:fs';
import { createServer } from 'node:http';
import browsers from '../tools/browser.js';

/* A line of a test, which fails if one of them does: it ends with process.exit(). */
export function say(good, what, why) {
    console.log(good ? 'ok web: ' + what : 'FAIL web: ' + what + ': ' + why);
    if (!good) process.exitCode = 1;
}

/* browser.page(url): evaluate(text), errors, and until(text): true,
 * or false after four minutes: a busy machine has few frames a second. */
export async function open() {
    const browser = await browsers.open(process.env.CHROMIUM || 'chromium');
    return {
        async page(url, width = 1400, height = 900) {
            const page = await browser.page(width, height);
            page.until = async text => {
                for (let k = 0; k < 2400; k++) {
                    if (await page.evaluate(text)) return true;
                    await new Promise(done => setTimeout(done, 100));
                }
                return false;
            };
            await page.go(url);
            return page;
        },
        close: browser.close
    };
}

/* A plain file server of a folder: {address, close(), asked, hidden, change}.  asked counts
 * by path; what is hidden is not there; change(path, bytes) is what is sent. */
export async function serve(folder) {
    const types = { html: 'text/html', js: 'text/javascript', css: 'text/css', svg: 'image/svg+xml',
                    wasm: 'application/wasm' };
    const server = createServer((request, response) => {
        const path = decodeURIComponent(new URL(request.url, 'http://x').pathname);
        try {
            self.asked[path] = (self.asked[path] || 0) + 1;
            if (self.hidden?.test(path)) throw new Error();
            const bytes = self.change(path, readFileSync(folder + path));
            response.writeHead(200, { 'Content-Type': types[path.split('.').pop()] || '' }).end(bytes);
        } catch {
            response.writeHead(404).end();
        }
    });
    await new Promise(done => server.listen(0, '127.0.0.1', done));
    const self = { address: `http://127.0.0.1:${server.address().port}/`, asked: {}, change: (path, bytes) => bytes,
             close: () => { server.close(); server.closeAllConnections(); } };
    return self;
}
