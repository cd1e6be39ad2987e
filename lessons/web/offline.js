/*
 * offline.js - a worker of the site that keeps what a browser has loaded of it: without a
 * network each page that was opened before is there again (store.js begins it).
 *
 * The network comes first, so a new version is seen at once.  The folder student/ has a
 * store of its own (student_compile.js).
 */
"use strict";
self.oninstall = () => self.skipWaiting();
self.onactivate = (event) => event.waitUntil(self.clients.claim());
self.onfetch = (event) => {
    const {request} = event, url = new URL(request.url);
    if (request.method !== "GET" || url.origin !== location.origin || url.pathname.includes("/student/")) return;
    event.respondWith(fetch(request).then((response) => {
        const copy = response.clone();
        if (response.ok) event.waitUntil(caches.open("pages").then((pages) => pages.put(url.pathname, copy)));
        return response;
    }).catch(async (error) => await (await caches.open("pages")).match(url.pathname) || Promise.reject(error)));
};
