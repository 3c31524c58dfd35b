// Opens reports in headless Chromium and looks at them as a reader would: report.test.cjs FOLDER.
// FOLDER holds the runs `paper`, `example/results` and `hostile`, sweep.html and both.html. Every failure is listed; status 1 then.
'use strict';
const fs = require('fs');
const path = require('path');
const { pathToFileURL } = require('url');
const { chromium } = require('playwright-core');
const axe = fs.readFileSync(require.resolve('axe-core/axe.min.js'), 'utf8');

const folder = process.argv[2];
const whole = Boolean(process.env.ASHIMPACT_WHOLE);  // accessibility at each width in each scheme, not at two
const failures = [];
const check = (holds, what) => {
  checks += 1;
  if (!holds) failures.push(what);
};
let checks = 0;

const figureIds = ['composition', 'static-force', 'regime-map', 'restitution', 'damping', 'damping-fit', 'damping-laws', 'contact-time', 'sizes', 'histories', 'energy', 'critical-velocity', 'which-sizes', 'critical-velocity-by-size', 'sensitivity'];
const json = (run, name) => JSON.parse(fs.readFileSync(path.join(folder, run, name + '.json'), 'utf8')).result;

// Everything drawn within the frame of its panel, and every text within its drawing; in the page.
const outside = () => {
  const found = [];
  for (const svg of document.querySelectorAll('figure svg')) {
    if (!svg.getBoundingClientRect().width) continue;
    const own = svg.getBoundingClientRect();
    const id = svg.closest('figure').id;
    for (const text of svg.querySelectorAll('text')) {
      if (!text.textContent.trim()) continue;
      const box = text.getBoundingClientRect();
      if (box.left < own.left - 2 || box.right > own.right + 2 || box.top < own.top - 2 || box.bottom > own.bottom + 2)
        found.push(id + ': text ' + text.textContent);
    }
    for (const panel of svg.querySelectorAll('.panel')) {
      const frame = panel.querySelector('rect.frame').getBoundingClientRect();
      for (const mark of panel.querySelectorAll('.series path, .series use, .series rect')) {
        const box = mark.getBoundingClientRect();
        const slack = mark.tagName === 'use' ? 6 : 2;
        if (box.left < frame.left - slack || box.right > frame.right + slack || box.top < frame.top - slack || box.bottom > frame.bottom + slack)
          found.push(id + ': ' + mark.parentElement.dataset.name);
      }
    }
  }
  return found;
};

// Marks of a figure as numbers again: [{title, name, x, y}], from the wide form; in the page.
const marksOf = (id) => {
  const value = (panel, which, pixel) => {
    const [from, to, start, end, spacing] = panel.getAttribute('data-' + which).split(' ');
    const share = (pixel - start) / (end - start);
    return spacing === 'log' ? from * Math.pow(to / from, share) : +from + share * (to - from);
  };
  const marks = [];
  for (const panel of document.querySelectorAll('#' + id + ' svg.wide .panel'))
    for (const series of panel.querySelectorAll('.series'))
      for (const mark of series.querySelectorAll('use'))
        marks.push({
          title: panel.dataset.title, name: series.dataset.name,
          x: value(panel, 'x', +mark.getAttribute('x')),
          y: panel.hasAttribute('data-y') ? value(panel, 'y', +mark.getAttribute('y')) : 0,
          widthX: Math.abs(panel.getAttribute('data-x').split(' ')[1] - panel.getAttribute('data-x').split(' ')[0]),
          widthY: panel.hasAttribute('data-y') ? Math.abs(panel.getAttribute('data-y').split(' ')[1] - panel.getAttribute('data-y').split(' ')[0]) : 1,
        });
  return marks;
};

// The points of Figure 5 against 4-restitution.json, those of Figure 6 against 5-damping.json.
const comparePoints = async (page, run) => {
  const restitution = await page.evaluate(marksOf, 'restitution');
  const samples = json(run, '4-restitution').samples;
  let compared = 0;
  for (const sample of samples)
    for (const series of sample.series)
      series.velocity.values.forEach((v, i) => {
        const e = series.restitution.values[i];
        const near = restitution.some((m) => m.title === sample.name && Math.abs(m.x - v) < 2e-4 * m.widthX && Math.abs(m.y - e) < 2e-4 * m.widthY);
        check(near, `${run}: the point ${v} m/s, ${e} of ${sample.name} is not drawn`);
        compared += 1;
      });
  const drawn = samples.reduce((sum, s) => sum + s.series.reduce((n, each) => n + each.velocity.values.length, 0), 0);
  check(compared === drawn && restitution.length === drawn, `${run}: ${restitution.length} points drawn, ${drawn} in the artifact`);
  const damping = await page.evaluate(marksOf, 'damping');
  const laws = json(run, '0-case').laws;
  for (const sample of json(run, '5-damping').samples)
    for (const law of laws) {
      if (!sample[law]) continue;
      sample[law].velocity.values.forEach((v, i) => {
        const eta = sample[law].damping.values[i] * 1e3;
        const near = damping.some((m) => m.title === sample.name && m.name.toLowerCase().includes(law) && Math.abs(m.x - v) < 2e-4 * m.widthX && Math.abs(m.y - eta) < 2e-4 * m.widthY);
        check(near, `${run}: damping ${eta} g/s at ${v} m/s of ${sample.name}, ${law} is not drawn`);
      });
    }
};

const look = async (browser, file, name, width, scheme) => {
  const context = await browser.newContext({ viewport: { width, height: 900 }, colorScheme: scheme, bypassCSP: false });
  const page = await context.newPage();
  const where = `${name} at ${width} px, ${scheme}`;
  const url = pathToFileURL(file).href;
  page.on('console', (message) => check(false, `${where}: console: ${message.text()}`));
  page.on('pageerror', (error) => check(false, `${where}: error: ${error}`));
  page.on('request', (request) => check(request.url() === url || request.url().startsWith('data:'), `${where}: request of ${request.url()}`));
  await page.goto(url);
  const scrolled = await page.evaluate(() => document.documentElement.scrollWidth - document.documentElement.clientWidth);
  check(scrolled <= 0, `${where}: scrolls sideways by ${scrolled} px`);
  const hidden = await page.evaluate(() => [...document.querySelectorAll('.scroll.wide')].map((table) => table.scrollWidth - table.clientWidth));
  check(width < 1440 || hidden.every((each) => each <= 0), `${where}: the table of velocities is cut by ${hidden} px`);
  const out = await page.evaluate(outside);
  check(out.length === 0, `${where}: outside of its frame: ${out.slice(0, 5).join('; ')} (${out.length})`);
  return { context, page, where };
};

// Leaves a few of the rows and marks that are all alike, which take axe most of its time; in the page.
const thin = () => {
  for (const row of document.querySelectorAll('.tall tbody tr:nth-child(n+6)')) row.remove();
  for (const svg of document.querySelectorAll('figure svg')) {
    if (!svg.getBoundingClientRect().width) svg.remove();
    for (const mark of svg.querySelectorAll('use:nth-of-type(n+4)')) mark.remove();
  }
};

// axe in an isolated world of the browser, which the page's policy does not concern. The short form looks at the page
// without most of its rows and marks.
const audit = async (context, page, where) => {
  if (!whole) await page.evaluate(thin);
  const session = await context.newCDPSession(page);
  const { frameTree } = await session.send('Page.getFrameTree');
  const { executionContextId } = await session.send('Page.createIsolatedWorld', { frameId: frameTree.frame.id, worldName: 'axe' });
  await session.send('Runtime.evaluate', { expression: axe, contextId: executionContextId });
  const answer = await session.send('Runtime.evaluate', {
    expression: "axe.run(document, {resultTypes: ['violations']}).then((r) => JSON.stringify(r.violations.map((v) => v.id + ': ' + v.nodes.slice(0, 3).map((n) => n.html.slice(0, 160)).join(' | '))))",
    contextId: executionContextId, awaitPromise: true, returnByValue: true,
  });
  check(!answer.exceptionDetails, `${where}: axe did not run`);
  for (const violation of JSON.parse(answer.result.value ?? '[]')) check(false, `${where}: axe: ${violation}`);
};

const keys = async (page, where) => {
  const plot = page.locator('#restitution .plot');
  await plot.focus();
  await page.keyboard.press('ArrowRight');
  const first = await page.locator('#restitution .readout').textContent();
  await page.keyboard.press('ArrowRight');
  const second = await page.locator('#restitution .readout').textContent();
  check(/v in = .* m\/s, e n = /.test(first) && first !== second, `${where}: arrow keys read out '${first}', then '${second}'`);
};

// The mouse over the first point of Figure 5 reads out the numbers of the artifact; a tap does the same.
const pointed = async (page, where, by) => {
  const mark = page.locator('#restitution svg:visible .series use').first();
  await mark.scrollIntoViewIfNeeded();
  const box = await mark.boundingBox();
  await by(box.x + box.width / 2, box.y + box.height / 2);
  const text = await page.locator('#restitution .readout').textContent();
  check(/v in = .* m\/s, e n = /.test(text), `${where}: pointed at a point, read out '${text}'`);
};
const mouse = (page, where) => pointed(page, where, (x, y) => page.mouse.move(x, y));

// A telephone, paper, and a browser that runs no scripts.
const others = async (browser, file) => {
  const telephone = await browser.newContext({ viewport: { width: 360, height: 740 }, hasTouch: true, isMobile: true });
  const page = await telephone.newPage();
  await page.goto(pathToFileURL(file).href);
  await pointed(page, 'by touch', (x, y) => page.touchscreen.tap(x, y));
  await telephone.close();
  const paper = await browser.newContext({ viewport: { width: 700, height: 1000 } });
  const sheet = await paper.newPage();
  await sheet.goto(pathToFileURL(file).href);
  await sheet.emulateMedia({ media: 'print' });
  const ends = await sheet.evaluate(() => [...document.querySelectorAll('table')].map((table) => table.getBoundingClientRect().right));
  check(ends.length > 2 && Math.max(...ends) <= 700, `on paper: a table ends at ${Math.max(...ends)} of 700 px`);
  await paper.close();
  const without = await browser.newContext({ viewport: { width: 768, height: 900 }, javaScriptEnabled: false });
  const still = await without.newPage();
  await still.goto(pathToFileURL(file).href);
  for (const id of figureIds) check(await still.locator('#' + id + ' svg.wide').isVisible(), `without scripts: figure ${id} is not to be seen`);
  await still.locator('#restitution summary').click();
  check(await still.locator('#restitution td').first().isVisible(), 'without scripts: the numbers do not open');
  const [download] = await Promise.all([still.waitForEvent('download'), still.locator('#restitution a[download]').click()]);
  const csv = fs.readFileSync(await download.path(), 'utf8').split('\n');
  check(csv[0].startsWith('sample,law,origin,v_in [m/s],e_n') && csv.length > 10, `without scripts: the CSV begins ${csv[0]}`);
  await without.close();
};

(async () => {
  const browser = await chromium.launch({ executablePath: process.env.CHROMIUM, args: ['--no-sandbox', '--disable-gpu'] });
  const pages = [['paper', path.join(folder, 'paper/report.html')], ['example', path.join(folder, 'example/results/report.html')], ['sweep', path.join(folder, 'sweep.html')]];
  for (const [name, file] of pages) {
    check(fs.statSync(file).size < 1e6, `${name}: ${fs.statSync(file).size} bytes`);
    for (const width of [360, 768, 1440])
      for (const scheme of ['light', 'dark']) {
        const { context, page, where } = await look(browser, file, name, width, scheme);
        if (whole || (width === 360 && scheme === 'light') || (width === 1440 && scheme === 'dark')) await audit(context, page, where);
        if (name !== 'sweep' && width === 1440 && scheme === 'light') {
          for (const id of figureIds) check((await page.locator('figure#' + id).count()) === 1, `${where}: no figure ${id}`);
          await comparePoints(page, name === 'paper' ? 'paper' : 'example/results');
          await keys(page, where);
          await mouse(page, where);
        }
        await context.close();
      }
  }
  for (const [name, file] of [['both', path.join(folder, 'both.html')], ['hostile', path.join(folder, 'hostile/report.html')]]) {
    const { context, page, where } = await look(browser, file, name, 768, 'light');
    await audit(context, page, where);
    if (name === 'hostile') {
      const names = JSON.parse(fs.readFileSync(path.join(folder, 'hostile.json'), 'utf8')).samples.map((sample) => sample.name);
      const text = await page.locator('.answers').textContent();
      for (const each of names) check(text.includes(each), `${where}: the name ${each} does not come out as text`);
      check((await page.locator('.answers b, .answers script, .answers img').count()) === 0, `${where}: a name became markup`);
    }
    await context.close();
  }
  await others(browser, path.join(folder, 'paper/report.html'));
  await browser.close();
  for (const failure of failures) console.error('FAILED ' + failure);
  console.log(`${checks} checks, ${failures.length} failed`);
  process.exit(failures.length ? 1 : 0);
})().catch((error) => {
  console.error(error);
  process.exit(1);
});
