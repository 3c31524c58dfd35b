// agreement.test.cjs MODULE FOLDER PROGRAM DIRECT ["example"]: the built-in case, and if it is said that of `init`, below FOLDER, each with the artifacts of PROGRAM, that of this machine, in
// "results", give the same through MODULE: direct values to 1e-9, those of the paper's case and the reference impacts to DIRECT,
// fitted ones to 1e-8, intervals to 1e-6.
'use strict';
const assert = require('node:assert/strict');
const fs = require('node:fs');
const path = require('node:path');
const { execFileSync } = require('node:child_process');
const { walk } = require('./compare.cjs');
const { agree } = require('./agree.cjs');
const { agreeOnReference } = require('./reference.cjs');

const create = require(path.resolve(process.argv[2]));
const [folder, native] = process.argv.slice(3, 5);
const direct = Number(process.argv[5]);
const withExample = process.argv[6] === 'example';  // measured impacts, whose fits end where rounding lets them
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

// Whether artifacts or tables have the same numbers to 1e-6, that of the trajectories.
function sameButForRounding(one, other, what) {
    const parsed = text => (what.includes('.json') ? JSON.parse(text).result : text.split(/[,\n]/).map(cell => (cell === '' || isNaN(cell) ? cell : Number(cell))));
    walk(parsed(one), parsed(other), '', 0, (place, left, right, distance) => assert.ok(distance <= 1e-6, `${what}${place}: ${left}, ${right}`));
}

// The estimate on a tube from a run that the page made is the command line's from the same files; drawings are rounded.
function agreeOnTube(web, run, sizes) {
    const tube = { '--tube-diameter': '51 mm', '--gas-velocity': '9 m/s', '--gas-temperature': '1050 C', '--ash-load': '6 g/Nm3', '--sizes': sizes };
    const answer = web.call('deposit', JSON.stringify({ run: 'results', ...tube }), 'tube');
    assert.equal(answer.status, 0, JSON.stringify(answer.error));
    const place = fs.mkdtempSync(path.join(folder, 'tube-'));
    fs.mkdirSync(path.join(place, 'results'));
    for (const file of run.files) fs.writeFileSync(path.join(place, 'results', file), web.read(`results/${file}`));
    execFileSync(native, ['deposit', '-q', 'results', ...Object.entries(tube).flat(), '-o', 'tube'], { cwd: place, stdio: 'ignore' });
    assert.ok(answer.files.length >= 3);
    for (const file of answer.files.filter(name => !name.endsWith('.html')))
        sameButForRounding(web.read(`tube/${file}`), fs.readFileSync(path.join(place, 'tube', file), 'utf8'), `${file} for ${sizes}`);
    const wrong = web.call('deposit', JSON.stringify({ run: 'results', ...tube, '--tube-diameter': '51 kg' }), 'tube');
    assert.deepEqual([wrong.status, wrong.error.place], [2, '--tube-diameter']);
}

(async () => {
    const builtIn = await program([]);
    const paper = builtIn.call('run', '', 'results');
    assert.equal(paper.status, 0, JSON.stringify(paper.error));
    assert.equal(paper.files.length, 12);
    assert.match(paper.text, /Particles of 88 um stick below 1\.86 m\/s/);
    agree('built-in', path.join(folder, 'built-in/results'), file => builtIn.read(`results/${file}`), direct);
    assert.match(builtIn.read('results/report.html'), /<figure id="critical-velocity"/);

    const example = path.join(folder, 'example');
    const inputs = fs.readdirSync(example).filter(name => /\.(json|csv)$/.test(name)).map(name => [name, fs.readFileSync(path.join(example, name))]);
    const web = await program(inputs);
    const checked = web.call('validate', 'case.json');
    assert.deepEqual(checked.samples, ['fine', 'coarse']);
    const quick = web.call('evaluate', 'case.json', 'quick');
    assert.equal(quick.status, 0, JSON.stringify(quick.error));
    await agreeOnReference('node', native, contact => web.call('impact', JSON.stringify(contact)), direct);
    if (!withExample) return;
    const run = web.call('run', 'case.json', 'results');
    assert.equal(run.status, 0, JSON.stringify(run.error));
    // Measured impacts are read from a map of the law, which is made by a fit.
    agree('example', path.join(example, 'results'), file => web.read(`results/${file}`));
    // The analytic stages do not see the impacts.
    assert.deepEqual(JSON.parse(web.read('quick/3-analytic.json')).result, JSON.parse(web.read('results/3-analytic.json')).result);
    const figure = web.call('figure', 'results', 'restitution', 'single');
    assert.equal(figure.status, 0, JSON.stringify(figure.error));
    assert.match(figure.svg, /^<svg[\s\S]*<\/svg>\s*$/);

    for (const sizes of ['rosin-rammler: 31 um, 1.1', '25 um']) agreeOnTube(web, run, sizes);

    // Restitution and critical velocity of one contact, as the sliders ask for them.
    const contact = JSON.parse(web.read('results/2-contact.json')).result.samples[0];
    const found = JSON.parse(web.read('results/7-critical-velocity.json')).result.samples[0].jkr;
    const asked = { law: 'jkr', diameter: 88e-6, density: contact.density.value, contact_modulus: contact.contact_modulus.value,
        work_of_adhesion: contact.work_of_adhesion.value, damping: found.damping.value, velocities: [0.9, 1.1].map(each => each * found.critical_velocity.value) };
    const curve = web.call('curve', JSON.stringify(asked));
    assert.ok(Math.abs(curve.critical_velocity / found.critical_velocity.value - 1) < 1e-8, `${curve.critical_velocity} m/s by the sliders`);
    assert.equal(curve.restitution[0], 0);
    assert.ok(curve.restitution[1] > 0);

    // A contact whose damping is not known gets a guess in the unit of its damping law.
    const { damping, ...unknown } = { ...asked, damping_law: 'tsuji', velocities: [1] };
    assert.equal(web.call('curve', JSON.stringify(unknown)).damping, 1);
    assert.equal(web.call('laws').damping_laws.tsuji.unit, '1');
    assert.ok(web.call('laws').laws['maugis-dugdale'].parameters.some(({ name }) => name === 'cohesion_range'));

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
