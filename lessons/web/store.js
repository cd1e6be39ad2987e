/*
 * store.js - what a reader has done, in this browser alone; for each lesson a record
 * {predict: answers by their keys, text: of the file, verdict}.
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
})();
