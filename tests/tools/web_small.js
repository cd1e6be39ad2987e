/*
 * web_small.js - pictures and pages of the site in fewer bytes.
 *
 * svg(text): by svgo, which make deps-web installs; to the eye the same
 * (tests/web/pictures.mjs looks).  picture(name, text): the same, but one that svgo
 * does not take stays as it is, with a warning.  html(text): without what no reader
 * sees: the TeX beside a formula, marks for colours of code that book.css has not, and
 * which bracket opens and which closes.
 */
"use strict";
const {optimize} = require(require.resolve("svgo",
    {paths: [`${process.env.BUILD || "build"}/source`]}));

/* A plugin of svgo: what several elements have in common of these becomes a class. */
const LOOK = /^(fill|stroke|color|font|text-anchor|shape-rendering)/;
const classes = {name: "classes", fn: () => {
    const looks = new Map();
    const enter = ({attributes: own}) => {
        const look = Object.keys(own).filter((key) => LOOK.test(key)).map((key) =>
            `${key}:${own[key]}${key === "font-size" ? "px" : ""}`).join(";");
        if (look) looks.set(look, [...looks.get(look) || [], own]);
    };
    const exit = (root) => {
        const often = [...looks].filter(([, all]) => all.length > 1);
        const name = (k) => "c" + k.toString(36);
        often.forEach(([, all], k) => all.forEach((own) => {
            for (const key in own) if (LOOK.test(key)) delete own[key];
            own.class = name(k);
        }));
        const value = often.map(([look], k) => `.${name(k)}{${look}}`).join("");
        root.children.find((node) => node.name === "svg").children.unshift({type: "element",
            name: "style", attributes: {}, children: [{type: "text", value}]});
    };
    return {element: {enter}, root: {exit}};
}};

/* gnuplot writes two digits behind the point. */
exports.svg = (text) => optimize(text, {floatPrecision: 2, plugins: ["removeTitle",
    {name: "removeDesc", params: {removeAny: true}}, "removeXlink",
    {name: "removeAttrs", params: {attrs: "class"}}, "preset-default", classes]})
    .data.replace(/<tspan>([^<]*)<\/tspan>/g, "$1");

exports.picture = (name, text) => {
    try {
        return exports.svg(text);
    } catch (error) {
        console.error(`web: ${name} is copied as it is: ${error.message.split("\n")[0]}`);
        return text;
    }
};

exports.html = (text) => text
    .replace(/<annotation[^]*?<\/annotation>|<\/?semantics>/g, "")
    .replace(/<math display="inline"/g, "<math")
    .replace(/ xmlns="http:\/\/www.w3.org\/1998\/Math\/MathML"/g, "")
    .replace(/ form="(pre|post)fix"(?=>[()[\]{}]<)/g, "")
    .replace(/<pre class="sourceCode[^]*?<\/pre>/g, (pre) => pre.replace(/<\/?span[^>]*>|<a href="#cb[^>]*><\/a>/g, ""));
