/*
 * browser.js - a headless Chromium, driven through its pipe: no package, no port.
 *
 *     const {open} = require("./browser.js");
 *     const browser = await open("chromium");
 *     const page = await browser.page(width, height);
 *     await page.go(url);
 *     await page.evaluate("1 + 1");     a value, or of a promise its value
 *     await page.send("Page.captureScreenshot", {});
 *     await page.nameless();            what a screen reader has no name for
 *     await page.key("Enter", "\r");    a key of the keyboard, and what it writes
 *     await page.type("a[i] = 0;\n");   a text, key by key
 *     await browser.close();
 */
"use strict";
const {spawn} = require("child_process");
const fs = require("fs");
const os = require("os");

/* What is to be used or looked at needs a name. */
const NAMED = ["application", "button", "Canvas", "checkbox", "combobox", "image", "img", "link",
    "region", "spinbutton", "textbox"];

exports.open = async (command) => {
    const folder = fs.mkdtempSync(os.tmpdir() + "/web-");
    const child = spawn(command, ["--headless=new", "--no-sandbox", "--disable-gpu",
        "--disable-quic", "--no-first-run", "--disable-background-networking",
        "--disable-component-update", "--disable-sync", "--disable-extensions",
        "--disable-dev-shm-usage", "--user-data-dir=" + folder, "--remote-debugging-pipe",
        "about:blank"], {stdio: ["ignore", "ignore", "ignore", "pipe", "pipe"]});
    const waiting = new Map(), listeners = [];
    let last = 0, text = "";
    child.on("exit", () => { for (const one of waiting.values()) one.reject(
        new Error(command + " has ended")); });
    child.stdio[3].on("error", () => {});
    child.stdio[4].setEncoding("utf8").on("data", (more) => {
        const messages = (text + more).split("\0");
        text = messages.pop();
        for (const message of messages.map((m) => JSON.parse(m))) {
            const one = waiting.get(message.id);
            waiting.delete(message.id);
            if (!one) listeners.forEach((listen) => listen(message));
            else if (message.error) one.reject(new Error(message.error.message));
            else one.resolve(message.result);
        }
    });
    const send = (method, params = {}, sessionId = undefined) =>
        new Promise((resolve, reject) => {
            waiting.set(++last, {resolve, reject});
            child.stdio[3].write(JSON.stringify({id: last, method, params, sessionId}) + "\0");
        });
    const page = async (width, height) => {
        const {targetId} = await send("Target.createTarget", {url: "about:blank"});
        const {sessionId} = await send("Target.attachToTarget", {targetId, flatten: true});
        const self = {
            errors: [], /* what scripts of the page threw, or could not load */
            onWorker: () => {}, /* 1: one begins, -1: one has ended */
            send: (method, params) => send(method, params, sessionId),
            close: () => send("Target.closeTarget", {targetId}),
        };
        let loaded = () => {};
        listeners.push((message) => {
            if (message.sessionId !== sessionId) return;
            const {method, params} = message;
            if (method === "Page.loadEventFired") loaded();
            if (method === "Target.attachedToTarget") self.onWorker(1);
            if (method === "Target.detachedFromTarget") self.onWorker(-1);
            if (method === "Runtime.exceptionThrown")
                self.errors.push(params.exceptionDetails.exception?.description || "a script");
            if (method === "Log.entryAdded" && params.entry.level === "error")
                self.errors.push(params.entry.text + " " + (params.entry.url || ""));
        });
        await self.send("Target.setAutoAttach",
                        {autoAttach: true, waitForDebuggerOnStart: false, flatten: true});
        for (const domain of ["Page", "Runtime", "Log"]) await self.send(domain + ".enable");
        await self.send("Emulation.setDeviceMetricsOverride",
                        {width, height, deviceScaleFactor: 1, mobile: width < 600});
        self.go = async (url) => {
            const done = new Promise((resolve) => { loaded = resolve; });
            self.errors.length = 0;
            await self.send("Page.navigate", {url});
            await done;
        };
        self.evaluate = async (expression) => {
            const {result, exceptionDetails} = await self.send("Runtime.evaluate",
                {expression, awaitPromise: true, returnByValue: true, userGesture: true});
            if (exceptionDetails) throw new Error(exceptionDetails.exception?.description ||
                                                  exceptionDetails.text);
            return result.value;
        };
        self.nameless = async () => {
            const {nodes} = await self.send("Accessibility.getFullAXTree");
            const blank = await self.evaluate(`[...document.querySelectorAll("img, [role=region], " +
                "[role=img], [role=group], canvas")].filter((e) => e.ariaHidden !== "true" && !(e.alt ||
                e.getAttribute("aria-label") || "").trim()).map((e) => e.src || e.outerHTML.slice(0, 80))`);
            return [...nodes.filter((n) => !n.ignored && NAMED.includes(n.role?.value) &&
                                           !n.name?.value.trim()).map((n) => n.role.value), ...blank];
        };
        self.key = async (key, text = undefined, modifiers = 0) => {
            const code = {Tab: 9, Enter: 13, Escape: 27, End: 35, Home: 36, ArrowUp: 38,
                          ArrowDown: 40}[key];
            for (const type of ["keyDown", "keyUp"])
                await self.send("Input.dispatchKeyEvent",
                                {type, key, code: key, windowsVirtualKeyCode: code, text, modifiers});
        };
        self.type = async (text) => {
            for (const letter of text)
                await (letter === "\n" ? self.key("Enter", "\r") : self.key(letter, letter));
        };
        return self;
    };
    const close = async () => {
        const ended = new Promise((resolve) => child.on("exit", resolve));
        const late = setTimeout(() => child.kill("SIGKILL"), 5000);
        send("Browser.close").catch(() => {});
        await ended;
        clearTimeout(late);
        fs.rmSync(folder, {recursive: true, force: true, maxRetries: 9, retryDelay: 200});
    };
    return {page, close};
};
