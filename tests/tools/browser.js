/*
 * browser.js - a headless Chromium, driven through its pipe: no package, no port.
 *
 *     const {open} = require("./browser.js");
 *     const browser = await open("chromium");
 *     const page = await browser.page(width, height);
 *     await page.go(url);
 *     await page.evaluate("1 + 1");     a value, or of a promise its value
 *     await page.send("Page.captureScreenshot", {});
 *     await browser.close();
 */
"use strict";
const {spawn} = require("child_process");
const fs = require("fs");
const os = require("os");

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
            send: (method, params) => send(method, params, sessionId),
            close: () => send("Target.closeTarget", {targetId}),
        };
        let loaded = () => {};
        listeners.push((message) => {
            if (message.sessionId !== sessionId) return;
            const {method, params} = message;
            if (method === "Page.loadEventFired") loaded();
            if (method === "Runtime.exceptionThrown")
                self.errors.push(params.exceptionDetails.exception?.description || "a script");
            if (method === "Log.entryAdded" && params.entry.level === "error")
                self.errors.push(params.entry.text + " " + (params.entry.url || ""));
        });
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
        return self;
    };
    const close = async () => {
        await Promise.race([send("Browser.close").catch(() => {}),
                            new Promise((resolve) => setTimeout(resolve, 3000))]);
        child.kill("SIGKILL");
        fs.rmSync(folder, {recursive: true, force: true, maxRetries: 5, retryDelay: 100});
    };
    return {page, close};
};
