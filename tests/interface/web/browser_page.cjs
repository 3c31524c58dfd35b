// ashimpact.html in headless Chromium, with what its tests do with it over and over.
'use strict';
const assert = require('node:assert/strict');
const fs = require('node:fs');
const { pathToFileURL } = require('node:url');
const { chromium } = require('playwright-core');
const axe = fs.readFileSync(require.resolve('axe-core/axe.min.js'), 'utf8');

const minute = 60000;

// Opens the page. Whatever it says on the console, asks of a network or throws is kept in `complaints`.
async function openPage(browser, file, width, scheme = 'light') {
    const context = await browser.newContext({ viewport: { width, height: 900 }, colorScheme: scheme, acceptDownloads: true });
    const page = await context.newPage();
    const complaints = [];
    const url = pathToFileURL(file).href;
    page.on('console', message => complaints.push(`console: ${message.text()}`));
    page.on('pageerror', error => complaints.push(`error: ${error}`));
    page.on('request', request => {
        if (request.url() !== url && !/^(blob|data):/.test(request.url())) complaints.push(`request of ${request.url()}`);
    });
    page.setDefaultTimeout(2 * minute);
    await page.goto(url);
    await settled(page);
    return { context, page, complaints };
}

const launch = () => chromium.launch({ executablePath: process.env.CHROMIUM, args: ['--no-sandbox', '--disable-gpu'] });

// Waits until every change is answered. The page's policy forbids what playwright's own waiting does.
async function settled(page, longest = 2 * minute) {
    for (const begin = Date.now(); Date.now() - begin < longest; await page.waitForTimeout(20)) {
        const { changes, answered } = await page.evaluate(() => ({ ...document.documentElement.dataset }));
        if (changes !== undefined && changes === answered) return;
    }
    assert.fail('the page does not answer');
}

// Drops files as from a file manager: [{name, bytes}].
async function drop(page, files) {
    await page.evaluate(list => {
        const transfer = new DataTransfer();
        for (const { name, base64 } of list) transfer.items.add(new File([Uint8Array.from(atob(base64), letter => letter.charCodeAt(0))], name));
        document.body.dispatchEvent(new DragEvent('drop', { dataTransfer: transfer, bubbles: true, cancelable: true }));
    }, files.map(({ name, bytes }) => ({ name, base64: Buffer.from(bytes).toString('base64') })));
}

// What the page tells of something wrong: in red above, at a field, or at the files.
const wrongTold = page => page.evaluate(() => [...document.querySelectorAll('#app-problem, .wrong, .told.bad')].map(each => each.textContent).filter(Boolean).join(' | '));

// Moves the focus by the keyboard alone until it is at an element.
async function tabTo(page, selector, most = 400) {
    for (let i = 0; i < most; ++i) {
        if (await page.evaluate(wanted => document.activeElement?.matches(wanted), selector)) return;
        await page.keyboard.press('Tab');
    }
    assert.fail(`the Tab key does not reach ${selector}`);
}

async function press(page, selector) {
    await tabTo(page, selector);
    await page.keyboard.press('Enter');
}

async function downloaded(page, selector) {
    const [download] = await Promise.all([page.waitForEvent('download'), press(page, selector)]);
    return { name: download.suggestedFilename(), bytes: fs.readFileSync(await download.path()) };
}

// What axe finds, in an isolated world that the page's policy does not concern.
async function violations(context, page) {
    const session = await context.newCDPSession(page);
    const { frameTree } = await session.send('Page.getFrameTree');
    const { executionContextId: contextId } = await session.send('Page.createIsolatedWorld', { frameId: frameTree.frame.id, worldName: 'axe' });
    await session.send('Runtime.evaluate', { expression: axe, contextId });
    const answer = await session.send('Runtime.evaluate', {
        expression: "axe.run(document, {resultTypes: ['violations']}).then(r => JSON.stringify(r.violations.map(v => v.id + ': ' + v.nodes.slice(0, 3).map(n => n.html.slice(0, 160)).join(' | '))))",
        contextId, awaitPromise: true, returnByValue: true,
    });
    assert.ok(!answer.exceptionDetails, 'axe did not run');
    return JSON.parse(answer.result.value);
}

const sidewaysScroll = page => page.evaluate(() => document.documentElement.scrollWidth - document.documentElement.clientWidth);

module.exports = { downloaded, drop, launch, minute, openPage, press, settled, sidewaysScroll, tabTo, violations, wrongTold };
