/*
 * pictures.mjs SITE - the pictures of the site are to the eye those of figures/.
 *
 * Both are drawn at twice their size; then no square of 8 pixels differs in its mean
 * colour by more than 14 of 255, and at most 0.5 % of them by more than 3.  The
 * mistakes are changes to tests/tools/web_small.js, each with the picture that must
 * show it.  Lines "ok web: WHAT" and "FAIL web: WHAT: why".
 */
import { readFileSync, readdirSync } from 'node:fs';
import { createRequire } from 'node:module';
import { join } from 'node:path';
import { open, say } from './page.mjs';

const [site] = process.argv.slice(2);

/* In the page: the mean colours of both, and how far they are from each other. */
async function compare(texts) {
    const drawn = async text => {
        const image = new Image();
        image.src = URL.createObjectURL(new Blob([text], { type: 'image/svg+xml' }));
        await image.decode();
        const sheet = (scale, from) => {
            const canvas = document.createElement('canvas');
            canvas.width = Math.round(image.width * scale);
            canvas.height = Math.round(image.height * scale);
            const ink = canvas.getContext('2d', { willReadFrequently: true });
            ink.imageSmoothingQuality = 'high';
            ink.drawImage(from, 0, 0, canvas.width, canvas.height);
            return { canvas, ink };
        };
        const { canvas, ink } = sheet(1 / 8, sheet(2, image).canvas);
        return ink.getImageData(0, 0, canvas.width, canvas.height);
    };
    const [a, b] = await Promise.all(texts.map(drawn));
    if (a.width !== b.width || a.height !== b.height) return { most: 255, many: 100 };
    let most = 0, many = 0;
    a.data.forEach((value, k) => {
        const off = Math.abs(value - b.data[k]);
        most = Math.max(most, off);
        many += off > 3 ? 100 / a.data.length : 0;
    });
    return { most, many };
}
const close = ({ most, many }) => most <= 14 && many <= 0.5;
const words = ({ most, many }) => `${most} of 255, ${many.toFixed(2)} % of the squares`;

/* name, from, to, picture */
const TOOL = 'tests/tools/web_small.js';
const MISTAKES = [
    ['a tenth of a pixel', 'floatPrecision: 2', 'floatPrecision: 1', '16_invertible/scramble.svg'],
    ['the next class', 'own.class = name(k)', 'own.class = name(k + 1)', '12_triangles/cost.svg'],
    ['letters have no unit', '"px"', '""', '12_triangles/hat.svg'],
    ['dashes are lost', 'attrs: "class"', 'attrs: "stroke-dasharray"', '12_triangles/cost.svg'],
    ['labels lose their ground', 'attrs: "class"', 'attrs: "style"', '01_deformation/cost.svg'],
    ['what is pale is not', 'attrs: "class"', 'attrs: "fill-opacity"', '09_linear_bar/signs.svg'],
    ['indices stand on the line', 'attrs: "class"', 'attrs: "dy"', '12_triangles/hat.svg']
];

const load = text => {
    const module = { exports: {} };
    new Function('exports', 'require', text)(module.exports, createRequire(import.meta.url));
    return module.exports;
};
const browser = await open();
const page = await browser.page('about:blank');
const off = texts => page.evaluate(`(${compare})(${JSON.stringify(texts)})`)
    .catch(() => ({ most: 255, many: 100 })); /* one that cannot be drawn */
try {
    const names = readdirSync(site + '/figures', { recursive: true }).map(String)
        .filter(name => name.endsWith('.svg'));
    let why = '';
    for (const name of names) {
        const far = await off([join('figures', name), join(site, 'figures', name)]
            .map(file => readFileSync(file, 'utf8')));
        if (!close(far)) why += ` ${name}: ${words(far)};`;
    }
    say(names.length > 100 && why === '',
        `${names.length} pictures are to the eye those of figures/`, why);
    const tool = readFileSync(TOOL, 'utf8');
    for (const [name, from, to, picture] of MISTAKES) {
        const text = readFileSync(join('figures', picture), 'utf8');
        const right = await off([text, load(tool).picture(picture, text)]);
        const far = tool.split(from).length !== 2 ? null :
            await off([text, load(tool.replace(from, () => to)).picture(picture, text)]);
        say(far && !close(far) && close(right), 'mistake: ' + name,
            far ? `with it ${words(far)}, without ${words(right)}` : 'does not fit ' + TOOL);
    }
} finally {
    await browser.close();
}
process.exit();
