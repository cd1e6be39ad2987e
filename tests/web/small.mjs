/*
 * small.mjs - by node alone: can the site take every picture of figures/, and is one
 * that it cannot take copied as it is?  Lines "ok web: WHAT", "FAIL web: WHAT: why".
 */
import { readFileSync, readdirSync } from 'node:fs';
import small from '../tools/web_small.js';
import { say } from './page.mjs';

const names = readdirSync('figures', { recursive: true }).map(String)
    .filter(name => name.endsWith('.svg'));
const refused = [];
console.error = words => refused.push(words);
const bytes = names.map(name => {
    const text = readFileSync('figures/' + name, 'utf8');
    return [text.length, small.picture(name, text).length];
});
const [before, after] = [0, 1].map(k => bytes.reduce((sum, both) => sum + both[k], 0) / 1e6);
say(names.length > 100 && refused.length === 0 && after < before / 2,
    `${names.length} pictures have ${after.toFixed(1)} MB, not ${before.toFixed(1)}`,
    refused.join('; '));
for (const cut of ['<svg><path d="M0 0', '<svg><g></svg>', '']) {
    refused.length = 0;
    say(small.picture('cut.svg', cut) === cut && /^web: cut.svg is copied as it is: ./.test(refused),
        `a picture that is cut off, ${JSON.stringify(cut)}, is copied with a warning`, refused);
}
process.exit();
