// agreement.test.cjs MODULE FOLDER: cases below FOLDER, each with the artifacts of the native program in "results", give
// the same through MODULE. In double precision: direct values to 1e-9, fitted ones to 1e-8, intervals to 1e-6.
'use strict';
const assert = require('node:assert/strict');
const fs = require('node:fs');
const path = require('node:path');
const { distances } = require('./compare.cjs');

const create = require(path.resolve(process.argv[2]));
const folder = process.argv[3];
const allowed = { direct: 1e-9, fitted: 1e-8, interval: 1e-6 };
// The extrapolation of measured impacts is the maximum of a likelihood, found to about 1e-8.
const allowedForImpacts = { ...allowed, fitted: 2e-8 };

async function program(files) {
    const module = await create();
    module.FS.mkdir('/case');
    module.FS.chdir('/case');
    for (const [name, bytes] of files) module.FS.writeFile(name, bytes);
    return {
        read: name => module.FS.readFile(name, { encoding: 'utf8' }),
        exists: name => module.FS.analyzePath(name).exists,
        write: (name, text) => module.FS.writeFile(name, text),
        call: (name, ...words) =>
            JSON.parse(module.UTF8ToString(module.ccall(`ashimpact_${name}`, 'number', words.map(() => 'string'), words))),
    };
}

const everything = () => true;

// Of measured impacts: all that comes before the fits, and the extrapolation of the paper. The headline is an integral over
// draws around a mode; it moves by a tenth of its uncertainty when the last bits of the posterior do (docs/web.md), so
// that it is compared by headlinesAgree(). map_accuracy is an estimate of an error, made of rounding.
function withoutHeadline(file) {
    if (/^[0-5]-/.test(file)) return place => !/map_accuracy/.test(place);
    if (/^6-fit/.test(file)) return place => /\/extrapolated\//.test(place) && !/residuals|influences|prediction_error|check/.test(place);
    if (/^7-/.test(file)) return place => /\/extrapolated\//.test(place) && !/influences|check/.test(place);
    return () => false;
}

function headlinesAgree(native, web) {
    const read = text => JSON.parse(text).result.samples;
    const one = read(fs.readFileSync(path.join(native, '7-critical-velocity.json')));
    const other = read(web.read('results/7-critical-velocity.json'));
    let compared = 0;
    one.forEach((sample, i) => {
        for (const [law, mine] of Object.entries(sample)) {
            if (!mine?.critical_velocity?.standard_uncertainty) continue;
            const { value, standard_uncertainty: u } = mine.critical_velocity;
            const apart = Math.abs(value - other[i][law].critical_velocity.value) / u;
            console.log(`headline of ${sample.name}, ${law}: ${apart.toFixed(3)} standard uncertainties apart`);
            assert.ok(apart < 0.25, `${sample.name}, ${law}: ${apart} standard uncertainties apart`);
            ++compared;
        }
    });
    assert.ok(compared >= 8, `${compared} headlines`);
}

function agree(name, native, web, taken, allowed) {
    const files = fs.readdirSync(native).filter(file => file.endsWith('.json') && file !== 'manifest.json');
    assert.equal(files.length, 10, `${native} has ten artifacts`);
    for (const file of files) {
        const worst = distances(file, JSON.parse(fs.readFileSync(path.join(native, file))).result, JSON.parse(web.read(`results/${file}`)).result, taken(file));
        for (const [kind, found] of Object.entries(worst)) {
            console.log(`${name} ${file}: ${kind} values within ${found.distance.toExponential(1)} (${found.count})`);
            assert.ok(found.distance <= allowed[kind],
                `${name}, ${file}${found.place}: ${found.one} natively, ${found.other} in the page; apart by ${found.distance}`);
        }
    }
}

(async () => {
    const builtIn = await program([]);
    const paper = builtIn.call('run', '', 'results');
    assert.equal(paper.status, 0, JSON.stringify(paper.error));
    assert.equal(paper.files.length, 12);
    assert.match(paper.text, /Report this critical velocity/);
    agree('built-in', path.join(folder, 'built-in/results'), builtIn, () => everything, allowed);
    assert.match(builtIn.read('results/report.html'), /<figure id="critical-velocity"/);

    const example = path.join(folder, 'example');
    const inputs = fs.readdirSync(example).filter(name => /\.(json|csv)$/.test(name)).map(name => [name, fs.readFileSync(path.join(example, name))]);
    const web = await program(inputs);
    const checked = web.call('validate', 'case.json');
    assert.deepEqual(checked.samples, ['fine', 'coarse']);
    const quick = web.call('evaluate', 'case.json', 'quick');
    assert.equal(quick.status, 0, JSON.stringify(quick.error));
    const run = web.call('run', 'case.json', 'results');
    assert.equal(run.status, 0, JSON.stringify(run.error));
    agree('example', path.join(example, 'results'), web, withoutHeadline, allowedForImpacts);
    headlinesAgree(path.join(example, 'results'), web);
    // The analytic stages do not see the impacts.
    assert.deepEqual(JSON.parse(web.read('quick/3-analytic.json')).result, JSON.parse(web.read('results/3-analytic.json')).result);
    const figure = web.call('figure', 'results', 'restitution', 'single');
    assert.equal(figure.status, 0, JSON.stringify(figure.error));
    assert.match(figure.svg, /^<svg[\s\S]*<\/svg>\s*$/);

    // A wrong case is told as on the command line, and nothing is written.
    web.write('wrong.json', '{"name": "wrong", "samples": [{"name": "a", "diameter": "88 furlong/s"}]}');
    const wrong = web.call('run', 'wrong.json', 'wrong');
    assert.equal(wrong.status, 2);
    assert.match(wrong.error.message, /^wrong\.json: \//);
    assert.ok(!web.exists('wrong/0-case.json'));
    const again = web.call('validate', 'case.json');
    assert.equal(again.status, 0, 'an error leaves the program usable');
    console.log('the page agrees with the program');
})().catch(error => {
    console.error(error.message);
    process.exitCode = 1;
});
