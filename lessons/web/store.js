/*
 * store.js - what a reader has done, in this browser alone; for each lesson a record
 * {predict: answers by their keys, text: of the file, verdict}.  It begins offline.js, too.
 */
"use strict";
(() => {
const key = (lesson) => "workbook " + lesson;
self.store = {
    read(lesson) {
        try {
            return JSON.parse(localStorage.getItem(key(lesson))) || {};
        } catch {
            return {};
        }
    },
    /* Change these members; undefined removes one.  Return whether they are kept. */
    write(lesson, members) {
        try {
            localStorage.setItem(key(lesson),
                                 JSON.stringify({...this.read(lesson), ...members}));
            return true;
        } catch {
            return false;
        }
    },
};
/* Keep the pages, where a server brings them; the first one was loaded before that. */
const keeper = location.protocol === "file:" ? null : navigator.serviceWorker;
keeper?.addEventListener("controllerchange", () => {
    for (const {name} of [{name: location.href}, ...performance.getEntriesByType("resource")])
        fetch(name).catch(() => {});
});
keeper?.register(new URL("../offline.js", document.currentScript.src)).catch(() => {});
})();
