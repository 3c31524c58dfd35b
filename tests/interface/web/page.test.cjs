// page.test.cjs PAGE FOLDER PROGRAM: ashimpact.html as its users meet it, in headless Chromium and Firefox. FOLDER/example is a case
// of `ashimpact init` with the artifacts of PROGRAM, that of this machine, in "results"; FOLDER/built-in/results has those of the paper's.
'use strict';
const assert = require('node:assert/strict');
const { spawnSync } = require('node:child_process');
const fs = require('node:fs');
const path = require('node:path');
const { agree } = require('./agree.cjs');
const { downloaded, drop, launch, minute, openPage, press, settled, sidewaysScroll, tabTo, toChoose, violations, wrongTold } = require('./browser_page.cjs');
const { agreeOnReference } = require('./reference.cjs');
const { unzip } = require('./unzip.cjs');
const { archiveOfZeros, wrongFiles } = require('./wrong_files.cjs');

const [file, folder, program] = process.argv.slice(2);
const whole = Boolean(process.env.ASHIMPACT_WHOLE);  // all wrong files, not every fifth, and all parts in each browser
const inShort = ['agreement', 'typing', 'large'];  // of Firefox
const example = path.join(folder, 'example');
const inputs = fs.readdirSync(example).filter(name => /\.(json|csv)$/.test(name)).map(name => ({ name, bytes: fs.readFileSync(path.join(example, name)) }));
const caseText = fs.readFileSync(path.join(example, 'case.json'), 'utf8').replace(/^ *\/\/.*\n/gm, '');

const opened = page => page.evaluate(() => document.getElementById('app-told').textContent);

async function isClean({ context, page, complaints }, where) {
    assert.deepEqual(await violations(context, page), [], `${where}: axe`);
    assert.deepEqual(complaints, [], where);
    assert.ok((await sidewaysScroll(page)) <= 0, `${where}: scrolls sideways`);
}

function oneStrictFile() {
    assert.ok(fs.statSync(file).size < 6e6, `${fs.statSync(file).size} bytes`);
    const text = fs.readFileSync(file, 'utf8');
    const policy = /http-equiv="Content-Security-Policy" content="([^"]*)"/.exec(text)[1];
    assert.match(policy, /^default-src 'none'; /);
    assert.doesNotMatch(policy, /unsafe-inline|'unsafe-eval'|https?:|\*/);
    console.log(`one file of ${(fs.statSync(file).size / 1e6).toFixed(2)} MB`);
}

// From dropping the files of `init`'s case to the downloaded report, by the keyboard alone.
async function journey(browser, width, scheme) {
    const where = `${width} px, ${scheme}`;
    const opening = await openPage(browser, file, width, scheme);
    const { context, page } = opening;
    await isClean(opening, `${where}, empty`);
    await drop(page, inputs);
    while ((await opened(page)) !== 'case.json is open.') await page.waitForTimeout(20);
    await settled(page);
    assert.equal(await wrongTold(page), '', where);
    await press(page, '#app-run');
    await page.waitForSelector('#app-results:not([hidden])', { timeout: 5 * minute });
    assert.match(await page.locator('#app-answers').textContent(), /a particle sticks when it is slower than/);
    assert.match(await page.locator('#app-answers').textContent(), /Holds for normal impact on a flat wall, dry, at room temperature/);
    assert.match(await page.locator('#app-answers').textContent(), /Other sizes: From 87.4 to 107 um the assumptions on damping agree/);
    await isClean(opening, `${where}, with results`);
    assert.ok(await page.locator('#app-stale').isHidden(), where);
    assert.match(await page.locator('#app-answers').textContent(), /Diameter 88 um, density 2300 kg\/m3, E\* [\d.]+ GPa and w 0.3 J\/m2/, where);
    assert.match(await page.locator('#app-report nav').textContent(), /Static force/, where);
    assert.match(await page.locator('#app-report').textContent(), /Extrapolated v.*fitted to the rebounds alone/, where);
    const report = await downloaded(page, '#app-save-report');
    assert.equal(report.name, 'report.html');
    assert.match(report.bytes.toString(), /<figure id="critical-velocity"/);
    const saved = await downloaded(page, '#app-save-case');
    assert.deepEqual(JSON.parse(saved.bytes), JSON.parse(caseText), `${where}: the case is saved as it was`);
    const archive = await downloaded(page, '#app-save-all');
    const files = unzip(archive.bytes);
    for (const { name, bytes } of inputs) if (name !== 'case.json') assert.equal(files.get(name), bytes.toString(), `${where}: ${name} in the archive`);
    agree(`${browser.browserType().name()} at ${where}`, path.join(example, 'results'), name => files.get(`results/${name}`));
    await whatIfAgrees(page, where);
    await estimatesTube(opening, where);
    await page.getByLabel('Particle diameter', { exact: true }).fill('90');
    assert.ok(await page.locator('#app-stale').isVisible(), `${where}: results of another case are told`);
    await drop(page, [archive]);
    await page.getByText('case.json is open.').waitFor();
    await settled(page);
    assert.deepEqual([await wrongTold(page), await page.getByLabel('Particle diameter', { exact: true }).inputValue()], ['', '88'], `${where}: its archive opens again`);
    await context.close();
    console.log(`from files to report by keyboard at ${where}`);
}

// The paper's case and the reference impacts give what the program of this machine gives.
async function agreement(browser) {
    const name = browser.browserType().name();
    const { context, page, complaints } = await openPage(browser, file, 1000);
    await page.click('#app-paper');
    await settled(page);
    await page.click('#app-run');
    await page.waitForSelector('#app-results:not([hidden])', { timeout: 5 * minute });
    const files = unzip((await downloaded(page, '#app-save-all')).bytes);
    agree(`${name}, built-in`, path.join(folder, 'built-in/results'), each => files.get(`results/${each}`));
    await agreeOnReference(name, program, contact => page.evaluate(asked => window.ashimpact.ask('impact', JSON.stringify(asked)), contact), 1e-9);
    assert.deepEqual(complaints, []);
    await context.close();
}

// What a new user types, told at its field when it is wrong, and the answer as fast as it is typed.
async function typing(browser) {
    const opening = await openPage(browser, file, 1000);
    const { context, page } = opening;
    const field = label => page.getByLabel(label, { exact: true });
    assert.equal(await page.locator('#app-missing').textContent(), 'Still missing: sample 1: the particle diameter and an XRD result or typed phases.');
    assert.ok(await page.locator('#app-run').isDisabled(), 'nothing of the ash is taken for granted');
    assert.equal(await wrongTold(page), '', 'nothing is wrong before anything is typed');
    for (const [row, [phase, weight]] of [['quartz', '10'], ['mullite', '59']].entries()) {
        await field(`Phase, row ${row + 1}`).fill(phase);
        await field(`Weight [%], row ${row + 1}`).fill(weight);
    }
    await field('Amorphous (glass)').selectOption('remainder');
    const times = [];
    for (const diameter of ['40', '50', '60', '70', '80']) {
        const begin = Date.now();
        await field('Particle diameter').fill(diameter);
        await settled(page);
        times.push(Date.now() - begin);
    }
    console.log(`answers after ${times.join(', ')} ms, a pause of 80 ms among them`);
    if (whole) assert.ok(Math.min(...times) < 300, `the fastest answer takes ${Math.min(...times)} ms`);  // other tests run beside the short form
    const before = await page.locator('#app-live').textContent();
    await field('Particle diameter').fill('eighty');
    await settled(page);
    const told = await page.locator('.field:has-text("Particle diameter") .wrong').textContent();
    assert.match(told, /^(?!case\.json).*allowed: a length/);
    assert.equal(await field('Particle diameter').getAttribute('aria-invalid'), 'true');
    assert.ok(await page.locator('#app-run').isDisabled(), 'a wrong case cannot be computed');
    await field('Particle diameter').fill('0.08');
    await page.getByLabel('Unit of: Particle diameter').selectOption('mm');
    await settled(page);
    assert.equal(await wrongTold(page), '');
    assert.equal(await page.locator('#app-live').textContent(), before, '0.08 mm are 80 um');
    await page.getByLabel('Amorphous (glass)').focus();
    await page.keyboard.press('ArrowDown');
    await page.keyboard.press('ArrowDown');
    await settled(page);
    const focused = await page.evaluate(() => document.activeElement.labels?.[0]?.textContent);
    assert.equal(focused, 'Amorphous (glass)', 'the focus stays where the form is made anew');
    assert.ok(await field('Amorphous fraction').isVisible());
    await field('Velocity, row 1').fill('1.5');
    await field('Rebound velocity, row 1').fill('fast');
    await settled(page);
    assert.match(await page.locator('#app-impacts').textContent(), /"fast"|fast/);
    assert.notEqual(await wrongTold(page), '');
    await field('Rebound velocity, row 1').fill('0.2');
    await settled(page);
    assert.equal(await wrongTold(page), '');
    assert.deepEqual(opening.complaints, []);
    await context.close();
}

// Tables as people have them: decimal commas in tables, pasted with their heading, German columns in files of any name.
async function asPeopleWrite(browser) {
    const { context, page, complaints } = await openPage(browser, file, 1000);
    const field = label => page.getByLabel(label, { exact: true }).first();  // sliders have the same names
    const downloadedCase = async () => JSON.parse((await downloaded(page, '#app-save-case')).bytes);
    const paste = async (label, text, shown) => {
        await field(label).evaluate((input, held) => {
            const clipboardData = new DataTransfer();  // Firefox takes dataType and data in its place
            clipboardData.setData('text/plain', held);
            input.dispatchEvent(new ClipboardEvent('paste', { clipboardData, dataType: 'text/plain', data: held, bubbles: true, cancelable: true }));
        }, text);
        if (shown) await page.getByText(shown).waitFor();
        await settled(page);
    };
    await field('Work of adhesion w').fill('0.25');
    await field('Particle diameter').fill('88');
    await field('Phase, row 1').fill('quartz');
    await field('Weight [%], row 1').fill('60');
    await field('Amorphous (glass)').selectOption('remainder');
    await settled(page);
    assert.equal(await wrongTold(page), '');
    await paste('Velocity, row 1', '0,9\t0\n1,4\t0,2\n2,1\t0,5', 'Measured impacts: impacts-pasted-1.csv');
    await page.getByText('Read: 2 rebounds, 1 that stayed; 0.9 to 2.1 m/s.').waitFor();
    await page.getByText('Type the impacts instead').click();
    await paste('Velocity, row 3', '2.2\t0.4');
    assert.deepEqual([await field('Velocity, row 2').inputValue(), await field('Velocity, row 3').inputValue()], ['1.4', '2.2']);
    assert.equal(await wrongTold(page), '');
    await paste('Velocity, row 1', 'v_ein [m/s]\tv_aus [m/s]\n0,9\thaftet\n1,4\t0,2\n2,1\t0,5\n2,6\t0,8\n3,3\t1,2', 'Measured impacts: impacts-pasted-1.csv');
    assert.equal(await wrongTold(page), '');
    await paste('Phase, row 1', 'Phase\tGew.-%\nMullit\t31,4\nQuarz\t58,6\nHämatit\t10,0', 'XRD result: ash-pasted-1.csv');
    assert.match(await page.locator('.field:has-text("Amorphous (glass)") .wrong').textContent(), /amorphous fraction of the sample is not stated/, 'glass is asked for');
    await field('Amorphous (glass)').selectOption('fraction');
    await field('Amorphous fraction').fill('40');
    await settled(page);
    assert.equal(await wrongTold(page), '');
    await drop(page, [{ name: 'Messung 3.csv', bytes: Buffer.from('v_ein [m/s];v_aus [m/s]\n0,9;haftet\n1,4;0,2\n2,1;0,5\n2,6;0,8\n3,3;1,2\n') }, { name: 'Probe 3.csv', bytes: Buffer.from('Phase;Gew.-%\nMullit;40,0\nQuarz;60,0\n') }]);
    for (const shown of ['Measured impacts: Messung 3.csv', 'XRD result: Probe 3.csv']) await page.getByText(shown).waitFor();
    await settled(page);
    assert.equal(await wrongTold(page), '');
    for (const shown of ['Read: 4 rebounds, 1 that stayed; 0.9 to 3.3 m/s.', 'Read: Mullit 24 %, Quarz 36 %, glass 40 % by weight.']) await page.getByText(shown).waitFor();
    assert.match(await opened(page), /Messung 3.csv is taken .* Probe 3.csv is taken /, 'both files are told of');
    await drop(page, [{ name: 'foto.png', bytes: Buffer.from([0x89, 0x50, 0x4e, 0x47, 0, 1, 2, 3]) }]);
    await page.getByText('foto.png is neither an XRD result').waitFor();
    assert.ok(await page.getByText('XRD result: Probe 3.csv').isVisible(), 'a picture takes nothing away');
    await page.getByText('Type the phases instead').click();
    await page.getByText('Undo: Type the phases instead').click();
    await settled(page);
    await drop(page, [{ name: 'Messung 3.csv', bytes: Buffer.from('v_ein [m/s];v_aus [m/s]\n0,9;haftet\n1,4;0,2\n2,1;0,5\n2,6;0,8\n3,3;1,2\n') }]);
    await page.getByText('Messung 3.csv is taken').waitFor();
    await page.getByText('Fit: outliers').click();
    await page.getByLabel('A few wrong impacts are given little weight').check();
    await field('The particle meets').selectOption('sphere');
    await field('Diameter of the second sphere').fill('120');
    await settled(page);
    assert.equal(await wrongTold(page), '');
    await page.click('#app-run');
    await page.waitForSelector('#app-results:not([hidden])', { timeout: 5 * minute });
    const top = await page.evaluate(() => document.getElementById('app-results-title').getBoundingClientRect().top);
    assert.ok(top >= -1 && top < 400, `the results are brought into view, their heading ${top} px from the top`);
    const saved = await downloadedCase();
    assert.deepEqual([saved.wall, saved.partner.diameter, saved.fit], [undefined, '120 um', { robust: true }]);
    assert.match(String(saved.work_of_adhesion.value ?? saved.work_of_adhesion), /^0\.25( J\/m2)?$/);  // a text where the browser empties the field first
    await field('The particle meets').selectOption('elastic');
    await settled(page);
    assert.equal(await wrongTold(page), '', 'a wall again');
    assert.deepEqual(complaints, []);
    await context.close();
}

// What first users did: units in the number, two files of one kind, files that are none, typed slips, steps taken by mistake.
async function slips(browser) {
    const { context, page, complaints } = await openPage(browser, file, 1000);
    const field = label => page.getByLabel(label, { exact: true }).first();
    const unit = page.getByLabel('Unit of: Particle diameter');
    const table = (name, text) => ({ name, bytes: Buffer.from(text) });
    const impacts = '0.9,0\n1.4,0.2\n2.1,0.5\n2.6,0.8\n3.3,1.2\n';
    const dropAndTell = async (files, told) => {
        await drop(page, files);
        await page.getByText(told).waitFor();
        await settled(page);
    };
    const undo = async what => {
        await page.getByRole('button', { name: `Undo: ${what}` }).click();
        await settled(page);
    };
    const isGuarded = () => page.evaluate(() => {
        const leaving = new Event('beforeunload', { cancelable: true });
        window.dispatchEvent(leaving);
        return leaving.defaultPrevented;
    });
    assert.ok(!(await isGuarded()), 'an empty page is left without a question');
    await unit.selectOption('mm');
    await dropAndTell([table('one.csv', `v_in,v_r\n${impacts}`), table('two.csv', `v_in,v_r\n${impacts}`)], 'two.csv is taken as the measured impacts of sample 1, in place of one.csv');
    assert.equal(await unit.inputValue(), 'mm', 'the unit of an empty field stays');
    await page.getByText('Read: 4 rebounds, 1 that stayed').waitFor();  // before there is a diameter
    await dropAndTell([table('ash.csv', 'Phase,wt%\nQuartz,60\nMullite,40\n')], 'the amorphous fraction of the sample is not stated');
    assert.ok(await isGuarded(), 'what was dropped is not lost without a question');
    for (const [name, text] of [['three.csv', 'c1;c2\n1;0,5\n2;0,6\n'], ['four.csv', impacts], ['five.zip', 'PK\u0003\u0004']]) {
        await dropAndTell([table(name, text)], name.endsWith('zip') ? `${name}: cannot be unpacked` : `${name} is neither`);
        assert.ok(await page.getByText('XRD result: ash.csv').isVisible(), `${name} displaces nothing`);
    }
    for (const stated of [60e6, 100]) await dropAndTell([{ name: `${stated}.zip`, bytes: archiveOfZeros(60e6, stated) }], `${stated}.zip: is more than 50 MB when unpacked`);
    await dropAndTell([table('three.csv', 'c1;c2\n1;0,5\n')], 'three.csv is neither');
    await page.getByRole('button', { name: 'Take three.csv as the measured impacts' }).click();
    await page.getByText('Measured impacts: three.csv').waitFor();
    await undo('take three.csv');
    await page.getByText('Measured impacts: two.csv').waitFor();
    await field('Particle diameter').fill('abc');
    await dropAndTell([table('ash.csv', 'Phase,wt%\nQuartz,50\nMullite,50\n')], 'ash.csv is taken as the XRD result of sample 1, in place of the file of that name');
    assert.deepEqual([await field('Particle diameter').inputValue(), await unit.inputValue()], ['abc', 'mm']);
    await field('Amorphous (glass)').selectOption('none');
    for (const [typed, number, chosen] of [['44.5 um', '44.5', 'um'], ['0.044mm', '0.044', 'mm'], ['44µm', '44', 'µm'], ['4.4e-5 m', '4.4e-5', 'm']]) {
        await field('Particle diameter').fill(typed);
        await field('Particle density').focus();
        await settled(page);
        assert.equal(await wrongTold(page), '', typed);
        assert.deepEqual([await field('Particle diameter').inputValue(), await unit.inputValue()], [number, chosen], typed);
    }
    assert.match(await page.locator('#app-live').textContent(), /adhesion alone is not the answer/);
    // A number is read by the program, and refused in its words, whatever marks it has.
    const refusal = typed => spawnSync(program, ['contact', '--radius', '22 um', '--work-of-adhesion', '0.3', '--contact-modulus', '60 GPa', '--density', typed],
        { encoding: 'utf8' }).stderr.trim().replace(/\s+/g, ' ').replace('--density: ', '');
    for (const typed of ['2,650 kg/m3', '2.650,5', '2650,5 kg/m3', "2'650 kg/m3", '2 650 kg/m3', '2,65 g/cm3', '193,000 MPa', '1e-3 m', '2650 k g/m3']) {
        await field('Particle density').fill(typed);
        await settled(page);
        const told = await page.locator('.field:has-text("Particle density") .wrong').textContent();
        assert.equal(told, refusal(/\/|m$|MPa/.test(typed) ? typed : `${typed} kg/m3`), typed);
    }
    await field('Particle density').fill('2650');
    await page.getByLabel('Unit of: Particle density').selectOption('kg/m3');
    await settled(page);
    assert.equal(await wrongTold(page), '');
    await page.getByText('Type the impacts instead').click();
    await field('Velocity, row 5').waitFor();
    assert.deepEqual([await field('Velocity, row 5').inputValue(), await field('Rebound velocity, row 5').inputValue()], ['3.3', '1.2'], 'rows of the file');
    await field('Rebound velocity, row 2').fill('stuck');
    await settled(page);
    await page.getByText('Read: 3 rebounds, 2 that stayed').waitFor();
    for (const [typed, told] of [['fast', /Rebound velocity, row 3: is "fast"/], ['2.2', /Rebound velocity, row 3: restitution is 1.04762;/]]) {
        await field('Rebound velocity, row 3').fill(typed);
        await settled(page);
        assert.match(await wrongTold(page), told);
        assert.equal(await field('Rebound velocity, row 3').getAttribute('aria-invalid'), 'true');
    }
    await undo('Type the impacts instead');
    assert.equal(await wrongTold(page), '');
    await page.getByText('Type the phases instead').click();
    for (const [typed, weight, told] of [['quartz', '102.9', /row 1: the fraction is 102.9 %/], ['kryptonite', '60', /row 1: no phase is called "kryptonite".*the field “Phase” lists/]]) {
        await field('Phase, row 1').fill(typed);
        await field('Weight [%], row 1').fill(weight);
        await settled(page);
        assert.match(await wrongTold(page), told);
        assert.doesNotMatch(await wrongTold(page), /--phases/);
    }
    await undo('Type the phases instead');
    for (const law of ['Hertz', 'DMT', 'Brach-Dunn', 'JKR', 'Maugis-Dugdale']) await field(law).uncheck();
    await settled(page);
    assert.equal(await page.locator('#app-missing').textContent(), 'Still missing: a contact law.');
    await field('Maugis-Dugdale').check();
    assert.equal(await page.getByLabel('Unit of: z0, range of the attraction').inputValue(), 'nm');
    await page.click('#app-new');
    await settled(page);
    await undo('Begin anew');
    await page.getByText('XRD result: ash.csv').waitFor();
    await page.getByRole('button', { name: 'Redo: Begin anew' }).click();
    await page.getByText('XRD result: none yet').waitFor();
    await settled(page);
    assert.deepEqual(complaints, []);
    await context.close();
}

// The greatest turn of a path above its first height, in degrees over three units of length.
function sharpestCorner(path) {
    const points = path.slice(1).split('L').map(each => each.split(' ').map(Number));
    const above = points.filter(([, y]) => y < points[0][1] - 1);
    const apart = above.slice(0, 1);
    for (const [x, y] of above) if (Math.hypot(x - apart.at(-1)[0], y - apart.at(-1)[1]) >= 3) apart.push([x, y]);
    const angles = apart.slice(1).map(([x, y], i) => Math.atan2(y - apart[i][1], x - apart[i][0]) * 180 / Math.PI);
    return Math.max(...angles.slice(1).map((angle, i) => Math.abs(angle - angles[i])));
}

// The what-if of computed impacts: as measured it tells the velocity of the answer, and with a slider that of its own curve.
async function whatIfAgrees(page, where) {
    const told = () => page.locator('#app-what-if .answer').textContent();
    const numbers = async () => (await told()).match(/[\d.e-]+(?= m\/s)/g)?.map(Number) ?? [];
    const law = await page.locator('#app-what-if-law').inputValue();
    const answers = await page.locator('#app-answers').textContent();
    assert.equal(law, 'maugis-dugdale');  // the reported one
    const answer = Number(/([\d.]+) m\/s/.exec(answers)[1]);
    assert.ok(answer > 0, answers);
    for (let i = 0; i < 200 && (await numbers()).length < 2; ++i) await page.waitForTimeout(20);
    assert.deepEqual(await numbers(), [answer, answer], `${where}: as measured`);
    await page.focus('#app-slider-damping');
    for (let i = 0; i < 10; ++i) await page.keyboard.press('ArrowRight');
    for (let i = 0; i < 200 && (await numbers())[1] === answer; ++i) await page.waitForTimeout(20);
    await page.waitForTimeout(300);  // the last of the curves
    const { before, after, mark } = await page.evaluate(() => {
        const points = document.querySelector('#app-what-if path.new').getAttribute('d').slice(1).split('L').map(each => each.split(' ').map(Number));
        const first = points.findIndex(([, y]) => y < points[0][1]);
        const marks = [...document.querySelectorAll('#app-what-if path.new')].map(each => /^M([\d.]+) [\d.]+v-26$/.exec(each.getAttribute('d'))).filter(Boolean);
        return { before: points[first - 1][0], after: points[first][0], mark: Number(marks[0][1]) };
    });
    assert.ok(before - 0.1 <= mark && mark <= after + 0.1, `${where}: the mark at ${mark} is where the curve leaves zero, ${before} to ${after}`);
    for (const kind of ['base', 'new']) {
        const corner = sharpestCorner(await page.locator(`#app-what-if path.${kind}`).first().getAttribute('d'));
        assert.ok(corner < 6, `${where}: the curve turns by ${corner.toFixed(1)} degrees at once`);
    }
}

// What stays on a tube, after the run: what is missing, a wrong quantity at its field, the answer with its figures.
async function estimatesTube(opening, where) {
    const { page } = opening;
    await press(page, '#app-tube-run');
    assert.match(await page.locator('#app-tube .problem').textContent(), /^Still missing: outer diameter of the tube;.*sizes of the ash\.$/, where);
    assert.equal(await page.locator('#app-tube-assumption').inputValue(), '', where);
    await page.getByText('Fill in an example of a tube').click();
    const diameter = page.getByLabel('Outer diameter of the tube');
    await diameter.fill('38 kg');
    await press(page, '#app-tube-run');
    await page.locator('#app-tube .wrong').filter({ hasText: 'kg' }).waitFor();
    await diameter.fill('38 mm');
    await press(page, '#app-tube-run');
    await page.locator('#app-tube-answer figure').first().waitFor();
    assert.equal(await page.locator('#app-tube-answer figure').count(), 3, where);
    assert.match(await page.locator('#app-tube-answer').textContent(), /g\/\(m2 h\) of ash stays on the clean tube[^]*What this is not/, where);
    await isClean(opening, `${where}, with a tube`);
    await page.locator('#app-results').focus();  // the Tab key of Firefox does not go back to the top by itself
    assert.equal(JSON.parse(unzip((await downloaded(page, '#app-save-all')).bytes).get('tube/deposit.json')).schema, 'deposit', where);
}

// Each step has an example at a click, and together they are a case that can be computed.
async function examples(browser) {
    const { context, page, complaints } = await openPage(browser, file, 1000);
    for (const step of ['an ash', 'a steel wall', 'measured impacts']) await page.getByText(`Fill in an example of ${step}`).click();
    await settled(page);
    assert.equal(await wrongTold(page), '');
    await page.click('#app-paper');
    await settled(page);
    assert.equal(await wrongTold(page), '');
    assert.equal(await page.locator('#app-live tbody tr').count(), 3);
    await page.selectOption('#app-sample', '2');
    await settled(page);
    assert.equal(await page.getByLabel('Name of the sample').inputValue(), '104 um');
    assert.deepEqual(complaints, []);
    await context.close();
}

// Sliders move the dashed curve alone, and come back; a long computation stops.
async function slidersAndStop(browser) {
    const { context, page, complaints } = await openPage(browser, file, 1000);
    await page.click('#app-example');
    await settled(page);
    const curve = kind => page.locator(`#app-what-if path.${kind}`).first().getAttribute('d');
    await page.waitForSelector('#app-what-if path.new');
    for (const key of ['work_of_adhesion', 'density', 'damping', 'contact_modulus']) {
        const [base, start] = [await curve('base'), await curve('new')];
        await page.focus(`#app-slider-${key}`);
        await page.keyboard.press('End');
        for (let i = 0; i < 200 && (await curve('new')) === start; ++i) await page.waitForTimeout(20);
        assert.notEqual(await curve('new'), start, `${key} moves the curve`);
        assert.equal(await curve('base'), base, `${key} leaves the other curve`);
        await page.getByText('Reset the sliders').click();
        for (let i = 0; i < 200 && (await curve('new')) !== start; ++i) await page.waitForTimeout(20);
        assert.equal(await curve('new'), start, `${key} comes back`);
    }
    assert.match(await page.locator('#app-what-if .answer').textContent(), /a guess .* not the critical velocity of your ash/);
    await page.click('#app-run');
    await page.click('#app-stop');
    assert.equal(await page.locator('#app-progress').textContent(), 'Stopped.');
    await page.waitForTimeout(500);
    assert.ok(await page.locator('#app-results').isHidden());
    assert.ok(await page.locator('#app-run').isEnabled());
    assert.deepEqual(complaints, []);
    await context.close();
}

async function wrongOnes(browser) {
    const { context, page, complaints } = await openPage(browser, file, 1000);
    const files = wrongFiles(caseText).filter((_, i) => whole || i % 5 === 0);
    const untold = [];
    for (const wrong of files) {
        await page.click('#app-example');
        await settled(page);
        assert.equal(await wrongTold(page), '', `before ${wrong.name}`);
        await drop(page, [wrong]);
        let told = '';
        for (const begin = Date.now(); told === '' && Date.now() - begin < minute / 20; await page.waitForTimeout(20)) told = (await wrongTold(page)) || (await page.locator('#app-missing').textContent());
        if (told === '') untold.push(`${wrong.name}: ${wrong.bytes.toString('utf8').slice(-200)}`);
        assert.doesNotMatch(told, /cannot go on/, `${wrong.name} breaks the program: ${told}`);
        await settled(page);
    }
    assert.deepEqual(untold, [], 'files that are not told');
    await page.click('#app-example');
    await settled(page);
    assert.equal(await wrongTold(page), '', 'after all of them');
    assert.deepEqual(complaints, []);
    await context.close();
    console.log(`${files.length} wrong files, each told`);
}

// A million impacts: the page answers its user meanwhile, within a fifth of a second.
async function millionLines(browser) {
    const { context, page, complaints } = await openPage(browser, file, 1000);
    await page.click('#app-example');
    await settled(page);
    const table = path.join(folder, 'impacts-million.csv');
    const lines = Array.from({ length: 1e6 }, (_, i) => `${(1.4 + (i % 4000) / 1000).toFixed(3)},${((i % 4000) / 2500).toFixed(3)}`);
    fs.writeFileSync(table, `velocity [m/s],rebound_velocity [m/s]\n${lines.join('\n')}\n`);
    const choose = await toChoose(page, table);
    await page.evaluate(() => {
        let last = performance.now();
        window.longestPause = 0;
        window.beating = setInterval(() => {
            window.longestPause = Math.max(window.longestPause, performance.now() - last);
            last = performance.now();
        }, 10);
    });
    await choose();
    const begin = Date.now();
    while (!(await opened(page)).startsWith('impacts-million.csv')) await page.waitForTimeout(50);
    await settled(page, 5 * minute);
    const pause = await page.evaluate(() => window.longestPause);
    console.log(`a million lines read after ${((Date.now() - begin) / 1000).toFixed(1)} s, the longest pause of the page ${pause.toFixed(0)} ms; ${await wrongTold(page) || 'nothing wrong'}`);
    assert.ok(pause < 1000, `the page freezes for ${pause} ms`);
    assert.doesNotMatch(await wrongTold(page), /cannot go on/);
    await page.click('#app-example');
    await settled(page);
    assert.equal(await wrongTold(page), '');
    assert.deepEqual(complaints, []);
    await context.close();
}

async function allParts(name) {
    const browser = await launch[name]();
    const parts = { agreement, typing, slips, asPeopleWrite, examples, slidersAndStop, small: each => journey(each, 360, 'dark'), large: each => journey(each, 1440, 'light'), wrongOnes, millionLines };
    const chosen = process.env.ASHIMPACT_PAGE_PART;
    for (const [part, run] of Object.entries(parts)) {
        if (chosen ? chosen !== part : !whole && name === 'Firefox' && !inShort.includes(part)) continue;
        const begin = Date.now();
        await run(browser);
        console.log(`${name}, ${part}: passed in ${((Date.now() - begin) / 1000).toFixed(1)} s`);
    }
    await browser.close();
}

(async () => {
    oneStrictFile();
    for (const name of ['Chromium', 'Firefox']) if (!process.env.ASHIMPACT_BROWSER || process.env.ASHIMPACT_BROWSER === name) await allParts(name);
})().catch(error => {
    console.error(error);
    process.exit(1);
});
