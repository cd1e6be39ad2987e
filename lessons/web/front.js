/*
 * front.js - in the contents, which lessons the reader has begun and passed, as far
 * as this browser knows (store.js).
 */
"use strict";
(() => {
let last = null, passed = 0, begun = 0;
const places = [...document.querySelectorAll(".done")];
for (const place of places) {
    const {text, verdict, time} = store.read(place.dataset.lesson);
    if (verdict !== "OK" && text === undefined) continue;
    begun++;
    passed += verdict === "OK";
    place.textContent = verdict === "OK" ? "passed" : "begun";
    place.classList.toggle("passed", verdict === "OK");
    if (verdict !== "OK" && (!last || time > last.time))
        last = {time, lesson: place.dataset.lesson};
}
const progress = document.querySelector(".progress");
if (begun > 0) {
    progress.hidden = false;
    progress.textContent = `You have passed ${passed} of ${places.length} lessons in this browser. `;
    if (last) {
        const link = document.createElement("a");
        link.href = `lessons/${last.lesson}.html#write`;
        link.textContent = "Go on with lesson " + last.lesson.slice(0, 2);
        progress.append(link, ".");
    }
}
})();
