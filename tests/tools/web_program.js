/*
 * web_program.js - what emcc has made of a program, as a script that a page can
 * bring from a file as well as from a server: programs.NAME is its script and its
 * code, each compressed and as letters (lessons/web/programs.js reads them).
 *
 *     node tests/tools/web_program.js NAME SCRIPT CODE > NAME.js
 */
"use strict";
const fs = require("fs");
const {gzipSync} = require("zlib");
const [name, ...files] = process.argv.slice(2);
const packed = files.map((file) => gzipSync(fs.readFileSync(file), {level: 9}).toString("base64"));
console.log(`(self.programs ||= {})[${JSON.stringify(name)}] = ${JSON.stringify(packed)};`);
