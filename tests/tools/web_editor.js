/*
 * web_editor.js - lessons/web/editor.mjs with CodeMirror as one script that a page can
 * bring from a file, too.  The packages are those that make deps-web installs.
 *
 *     node tests/tools/web_editor.js [SCRIPT]      without SCRIPT: are they here?
 */
"use strict";
const modules = `${process.env.BUILD || "build"}/source/node_modules`;
const here = {paths: [modules]};
for (const name of ["codemirror", "@codemirror/lang-cpp", "@lezer/highlight"]) require.resolve(name, here);
const {buildSync} = require(require.resolve("esbuild", here));
if (process.argv[2])
    buildSync({entryPoints: ["lessons/web/editor.mjs"], outfile: process.argv[2], bundle: true,
               minify: true, format: "iife", target: "es2022", nodePaths: [modules],
               banner: {js: "/* with CodeMirror 6, codemirror.net: MIT licence, Marijn Haverbeke and others */"},
               logLevel: "warning"});
