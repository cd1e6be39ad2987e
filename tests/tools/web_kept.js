/*
 * web_kept.js FOLDER... - the files of these folders as JSON: {lines, files}.  Most lines
 * of what mistakes print are the reference's: a file is [first, number] of lines, and so
 * on, of those that are different.  lessons/web/student_compile.js unpacks it.
 */
"use strict";
const fs = require("fs");
const number = new Map(), files = {};
for (const folder of process.argv.slice(2))
    for (const name of fs.readdirSync(folder, {recursive: true}).map(String).sort()) {
        if (!fs.statSync(`${folder}/${name}`).isFile()) continue;
        const parts = files[`${folder.split("/").at(-1)}/${name}`] = [];
        for (const line of fs.readFileSync(`${folder}/${name}`, "utf8").split(/(?<=\n)/)) {
            if (!number.has(line)) number.set(line, number.size);
            const k = number.get(line);
            if (parts.length && k === parts.at(-2) + parts.at(-1)) parts[parts.length - 1]++;
            else parts.push(k, 1);
        }
    }
console.log(JSON.stringify({lines: [...number.keys()], files}));
