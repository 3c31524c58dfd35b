// ashimpact.html in headless Chromium and Firefox, with what its tests do with it over and over.
'use strict';
const assert = require('node:assert/strict');
const fs = require('node:fs');
const os = require('node:os');
const path = require('node:path');
const { pathToFileURL } = require('node:url');
const { chromium, _bidiFirefox: firefox } = require('playwright-core');  // Debian's Firefox speaks WebDriver BiDi alone
const axe = fs.readFileSync(require.resolve('axe-core/axe.min.js'), 'utf8');

const minute = 60000;
const saved = fs.mkdtempSync(path.join(os.tmpdir(), 'ashimpact-saved-'));  // what Firefox downloads
process.on('exit', () => fs.rmSync(saved, { recursive: true, force: true }));

const isChromium = page => page.context().browser().browserType().name() === 'chromium';

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

const launch = {
    Chromium: () => chromium.launch({ executablePath: process.env.CHROMIUM, args: ['--no-sandbox', '--disable-gpu'] }),
    Firefox: () => firefox.launch({ executablePath: process.env.FIREFOX, firefoxUserPrefs: { 'browser.download.folderList': 2, 'browser.download.dir': saved, 'browser.download.alwaysOpenPanel': false } }),
};

// Waits until every change is answered. The page's policy forbids what playwright's own waiting does.
async function settled(page, longest = 2 * minute) {
    for (const begin = Date.now(); Date.now() - begin < longest; await page.waitForTimeout(20)) {
        const { changes, answered } = await page.evaluate(() => ({ ...document.documentElement.dataset }));
        if (changes !== undefined && changes === answered) return;
    }
    assert.fail('the page does not answer');
}

// Files to drop as from a file manager, [{name, bytes}], are brought into the page; the function that comes back drops them.
async function toDrop(page, files) {
    await page.evaluate(list => {
        window.held = new DataTransfer();
        for (const { name, base64 } of list) window.held.items.add(new File([Uint8Array.from(atob(base64), letter => letter.charCodeAt(0))], name));
    }, files.map(({ name, bytes }) => ({ name, base64: Buffer.from(bytes).toString('base64') })));
    return () => page.evaluate(() => {
        document.body.dispatchEvent(new DragEvent('drop', { dataTransfer: window.held, bubbles: true, cancelable: true }));
    });
}

const drop = async (page, files) => (await toDrop(page, files))();

// A file to choose, or to drop where the browser cannot be told to choose; the function that comes back does it.
async function toChoose(page, file) {
    if (isChromium(page)) return () => page.setInputFiles('#app-files', file);
    return toDrop(page, [{ name: path.basename(file), bytes: fs.readFileSync(file) }]);
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

// A file that the page saves: {name, bytes}. Firefox tells nothing of it but the file.
async function downloaded(page, selector) {
    if (!isChromium(page)) {
        await press(page, selector);
        for (const begin = Date.now(); Date.now() - begin < minute; await page.waitForTimeout(100)) {
            const files = fs.readdirSync(saved);
            const [name] = files;
            if (files.length !== 1 || fs.statSync(path.join(saved, name)).size === 0) continue;
            const bytes = fs.readFileSync(path.join(saved, name));
            fs.rmSync(path.join(saved, name));
            return { name, bytes };
        }
        assert.fail(`${selector} saves no file but ${fs.readdirSync(saved)}`);
    }
    const [download] = await Promise.all([page.waitForEvent('download'), press(page, selector)]);
    return { name: download.suggestedFilename(), bytes: fs.readFileSync(await download.path()) };
}

// What axe finds. The page's policy forbids its script in the page, but neither in an isolated world (Chromium) nor as a
// command of WebDriver (Firefox).
async function violations(context, page) {
    const question = "axe.run(document, {resultTypes: ['violations']}).then(r => JSON.stringify(r.violations.map(v => v.id + ': ' + v.nodes.slice(0, 3).map(n => n.html.slice(0, 160)).join(' | '))))";
    if (!isChromium(page)) return JSON.parse(await page.evaluate(`(() => { ${axe}; return ${question}; })()`));
    const session = await context.newCDPSession(page);
    const { frameTree } = await session.send('Page.getFrameTree');
    const { executionContextId: contextId } = await session.send('Page.createIsolatedWorld', { frameId: frameTree.frame.id, worldName: 'axe' });
    await session.send('Runtime.evaluate', { expression: axe, contextId });
    const answer = await session.send('Runtime.evaluate', { expression: question, contextId, awaitPromise: true, returnByValue: true });
    assert.ok(!answer.exceptionDetails, 'axe did not run');
    return JSON.parse(answer.result.value);
}

const sidewaysScroll = page => page.evaluate(() => document.documentElement.scrollWidth - document.documentElement.clientWidth);

module.exports = { downloaded, drop, launch, minute, openPage, press, settled, sidewaysScroll, tabTo, toChoose, violations, wrongTold };
