/*
 * editor.mjs - the editor of a lesson's file: self.slotEditor(parent, settings), bundled
 * with CodeMirror into editor.js (tests/web.mk).
 *
 *     settings: {text, label, describedBy, changed(text), check()}
 *     {view, text(), setText(text), setPrediction(key, answer), showAll(on), mark(places)}
 *
 * Only the slots can be changed; what has no slot in it is folded.  showAll(true) shows
 * all of the file and lets it be changed, too.
 */
import { Annotation, Compartment, EditorState, StateField } from "@codemirror/state";
import { Decoration, EditorView, drawSelection, keymap, lineNumbers } from "@codemirror/view";
import { defaultKeymap, history, historyKeymap, indentWithTab } from "@codemirror/commands";
import { bracketMatching, codeFolding, foldEffect, indentOnInput, indentUnit, syntaxHighlighting,
    unfoldAll } from "@codemirror/language";
import { setDiagnostics } from "@codemirror/lint";
import { cpp } from "@codemirror/lang-cpp";
import { classHighlighter } from "@lezer/highlight";

const SLOT = /^[ \t]*\/\* SLOT (\w+)\b[^]*?\*\/\n([^]*?)\n[ \t]*\/\* END \1 \*\//gm;
const ours = Annotation.define(); /* a change that the page makes */

/* Return the slots of a text: {name, from, to} of the lines that may be changed; first and
 * last enclose the function and its contract. */
function slotsOf(text) {
    return [...text.matchAll(SLOT)].map((found) => {
        const end = found.index + found[0].length;
        const to = end - /\n.*$/.exec(found[0])[0].length, from = to - found[2].length;
        const brace = text.lastIndexOf("\n{\n", from), close = text.indexOf("\n}\n", end);
        const first = text.lastIndexOf("\n\n", brace) + 2;
        return {name: found[1], from, to, first, last: close < 0 ? text.length : close + 2};
    });
}
const slots = StateField.define({
    create: (state) => slotsOf(state.doc.toString()),
    update: (value, change) => change.docChanged ? slotsOf(change.newDoc.toString()) : value,
});
/* Mark the lines that may be changed. */
const shaded = EditorView.decorations.compute([slots], (state) => {
    const lines = [];
    for (const {from, to} of state.field(slots))
        for (let at = from; at <= to; at = state.doc.lineAt(at).to + 1)
            lines.push(Decoration.line({class: "slot"}).range(state.doc.lineAt(at).from));
    return Decoration.set(lines, true);
});
function allowed(change) {
    if (!change.docChanged || change.annotation(ours)) return true;
    let all = true;
    change.changes.iterChanges((from, to) => {
        all &&= change.startState.field(slots).some((slot) => from >= slot.from && to <= slot.to);
    }, true);
    return all;
}
/* Return the folds: three lines or more between two functions with slots. */
function folds(state) {
    const gaps = [], {doc} = state;
    let from = 0;
    for (const {first, last} of [...state.field(slots), {first: doc.length + 1, last: 0}]) {
        const begin = from > 0 ? Math.min(from + 2, doc.length) : 0; /* behind "}" and an empty line */
        if (first > begin && doc.lineAt(first - 1).number - doc.lineAt(begin).number > 1)
            gaps.push(foldEffect.of({from: begin, to: first - 1}));
        from = Math.max(from, last);
    }
    return gaps;
}

self.slotEditor = (parent, {text, label, describedBy, changed, check}) => {
    const guard = new Compartment(), filter = EditorState.changeFilter.of(allowed);
    const placeholderDOM = (view, open, lines) => {
        const button = document.createElement("button");
        button.type = "button";
        button.className = "folded";
        button.tabIndex = -1; /* by keys: the whole file */
        button.textContent = `${lines} lines, folded`;
        button.onclick = open;
        return button;
    };
    const view = new EditorView({parent, state: EditorState.create({doc: text, extensions: [
        slots, shaded, guard.of(filter), lineNumbers(), history(), drawSelection(), indentOnInput(),
        bracketMatching(), indentUnit.of("    "), EditorState.tabSize.of(4), cpp(),
        syntaxHighlighting(classHighlighter), EditorView.lineWrapping,
        codeFolding({placeholderDOM, preparePlaceholder: (state, {from, to}) =>
            state.doc.lineAt(to).number - state.doc.lineAt(from).number + 1}),
        EditorView.contentAttributes.of({"aria-label": label, "aria-describedby": describedBy,
                                         spellcheck: "false"}),
        keymap.of([{key: "Mod-Enter", run: () => { check(); return true; }}, indentWithTab,
                   ...historyKeymap, ...defaultKeymap]),
        EditorView.updateListener.of((update) => {
            if (update.docChanged) changed(update.state.doc.toString());
        }),
    ]})});
    const fold = () => view.dispatch({effects: folds(view.state)});
    fold();
    const [first] = view.state.field(slots);
    if (first) view.dispatch({selection: {anchor: first.to}});
    const replace = (from, to, insert) => view.dispatch({changes: {from, to, insert},
                                                         annotations: ours.of(true)});
    return {
        view,
        text: () => view.state.doc.toString(),
        setText(text) {
            unfoldAll(view);
            replace(0, view.state.doc.length, text);
            fold();
        },
        setPrediction(key, answer) {
            const line = new RegExp(`^ \\* PREDICT ${key} [^:]*: ?(.*)$`, "md").exec(this.text());
            if (line && line[1] !== answer) replace(...line.indices[1], answer);
        },
        showAll(on) {
            view.dispatch({effects: guard.reconfigure(on ? [] : filter)});
            unfoldAll(view);
            if (!on) fold();
        },
        /* places: {line, column, severity, message} */
        mark(places) {
            const {doc} = view.state;
            view.dispatch(setDiagnostics(view.state, places.filter(({line}) => line <= doc.lines)
                .map(({line, column, severity, message}) => {
                    const {from, to} = doc.line(line), at = Math.min(from + column - 1, to);
                    return {from: at, to: Math.min(to, at + 1), severity, message};
                })));
        },
    };
};
