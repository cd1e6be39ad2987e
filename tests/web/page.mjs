/* page.mjs - a page in a headless Chromium, for the tests beside it. */
import browsers from '../tools/browser.js';

/* browser.page(url): evaluate(text), errors, and until(text, seconds): true, or the
 * time is over. */
export async function open() {
    const browser = await browsers.open(process.env.CHROMIUM || 'chromium');
    return {
        async page(url, width = 1400, height = 900) {
            const page = await browser.page(width, height);
            page.until = async (text, seconds = 60) => {
                for (let k = 0; k < 10 * seconds; k++) {
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
