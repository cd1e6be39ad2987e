/*
 * results.js - what a program prints: resultView(box, {program, plot}).show(out,
 * reference) fills the box with bodies, a plot and tables; with the reference's output
 * these are drawn over its own, and cells that differ are marked.
 */
"use strict";
function make(name, attributes, ...children) {
    const element = document.createElement(name);
    for (const [key, value] of Object.entries(attributes)) element.setAttribute(key, value);
    element.append(...children);
    return element;
}

const MOST_ROWS = 200;
/* Return whether two cells differ: numbers by more than 1e-6 of the column's largest. */
function differs(text, other, largest) {
    if (text === other) return false;
    const off = Math.abs(text - other);
    return !(text !== "" && other && off <= 1e-6 * largest + 1e-12);
}

function tableElement(table, reference) {
    const of = (k) => (reference?.rows || []).map((row) => Math.abs(row[k])).filter(isFinite);
    const largest = table.columns.map((name, k) => extent(of(k))[1]);
    let different = 0;
    const cell = (text, k, other) => {
        const number = Number(text);
        const shown = text !== "" && isFinite(number) ? String(Number(number.toPrecision(7))) : text;
        const attributes = shown === text ? {} : {title: text};
        if (reference && table.columns[k] !== "ms" && differs(text, other, largest[k])) {
            different++;
            Object.assign(attributes, {class: "differs", title: `${text}; reference: ${other ?? "none"}`});
        }
        return make("td", attributes, shown);
    };
    const head = make("tr", {}, ...table.columns.map((c) => make("th", {scope: "col"}, c)));
    const rows = table.rows.slice(0, MOST_ROWS).map((row, i) =>
        make("tr", {}, ...row.map((text, k) => cell(text, k, reference?.rows[i]?.[k]))));
    const left = table.rows.length - rows.length, others = (reference?.rows.length ?? 0) - table.rows.length;
    return make("details", {}, make("summary", {}, make("code", {}, table.name),
        ` ${table.rows.length} ${table.rows.length === 1 ? "row" : "rows"}` +
        (different ? `, ${different} ${different === 1 ? "cell differs" : "cells differ"}` : "") +
        (reference && others ? `, the reference has ${reference.rows.length}` : "")),
        ...table.notes.map((note) => make("p", {}, note)),
        make("div", {class: "rows", tabindex: 0, role: "region",
                     "aria-label": "table " + table.name},
             make("table", {}, make("thead", {}, head), make("tbody", {}, ...rows))),
        ...(left > 0 ? [`and ${left} more rows: they are in the file.`] : []));
}

function select(label, names, chosen, change) {
    const list = make("select", {}, ...names.map((name) => make("option", {}, name)));
    if (names.includes(chosen)) list.value = chosen;
    list.onchange = () => change(list.value);
    return make("label", {}, label + " ", list);
}

function check(label, on, change) {
    const box = make("input", {type: "checkbox"});
    box.checked = on;
    box.onchange = () => change(box.checked);
    return make("label", {}, box, " " + label);
}

function resultView(results, {program, plot: line}) {
const width = () => Math.max(280, Math.min(660, results.clientWidth));

/* The plot that was chosen last stays chosen, as long as its table is there. */
const [table, x, y, ...words] = line.split(" ");
const byDefault = {table, x, y, key: (words.find((w) => w.startsWith("key=")) || "").slice(4),
                   logx: words.includes("logx"), logy: words.includes("logy")};
let chosen = {...byDefault};

function plotElement(tables, references) {
    const drawn = tables.filter((t) => t.rows.length > 0);
    const box = make("div", {class: "plot"});
    const update = (more) => {
        chosen = {...chosen, ...more};
        const t = drawn.find((one) => one.name === chosen.table) || drawn[0];
        if (t.name !== chosen.table || !t.columns.includes(chosen.x) ||
            !t.columns.includes(chosen.y))
            chosen = t.name === byDefault.table ? {...byDefault} :
                {table: t.name, x: t.columns[0], y: t.columns[1] || t.columns[0],
                 key: "", logx: false, logy: false};
        const focus = [...box.querySelectorAll("select, input")].indexOf(document.activeElement);
        box.replaceChildren(make("p", {class: "choose"},
            select("plot of table", drawn.map((one) => one.name), t.name,
                   (name) => update({table: name})),
            select("across", t.columns, chosen.x, (name) => update({x: name})),
            select("up", t.columns, chosen.y, (name) => update({y: name})),
            select("a curve for each", ["", ...t.columns], chosen.key,
                   (name) => update({key: name})),
            check("log across", chosen.logx, (on) => update({logx: on})),
            check("log up", chosen.logy, (on) => update({logy: on}))),
            plot(t, chosen, width(), references.get(t.name)));
        if (focus >= 0) box.querySelectorAll("select, input")[focus].focus();
    };
    if (drawn.length > 0) update({});
    return box;
}

function bodyElement({name}, list, references) {
    const box = make("figure", {});
    const show = (n) => box.replaceChildren(drawBody(name, list[n], width(), references[n]),
        make("figcaption", {}, `${name}: blue is pressed, white at rest, orange stretched, magenta inverted` +
        (references[n] ? "; outlines: the reference. " : ". "),
        ...(list.length < 2 ? [] : [select("picture", list.map((_, k) => String(k)), String(n),
                                           (value) => { show(Number(value));
                                                        box.querySelector("select").focus(); })])));
    show(list.length - 1);
    return box;
}

function show(out, reference = "") {
    const tables = readTables(out);
    const references = new Map(readTables(reference).map((t) => [t.name, t]));
    results.replaceChildren();
    if (tables.length === 0) return;
    const file = make("a", {download: program + ".tsv", href: URL.createObjectURL(
        new Blob([out], {type: "text/tab-separated-values"}))}, "all tables as a file");
    for (const t of tables) {
        const list = bodies(t), others = references.get(t.name);
        if (list.length > 0) results.append(bodyElement(t, list, others ? bodies(others) : []));
    }
    results.append(plotElement(tables, references), make("h3", {}, "Tables"),
                   ...tables.map((t) => tableElement(t, references.get(t.name))), make("p", {}, file));
}
return {show};
}
