// Whether artifacts of the page are those of the native program, within what doubles allow: direct values to 1e-9, fitted
// ones to 1e-8, intervals to 1e-6.
'use strict';
const assert = require('node:assert/strict');
const fs = require('node:fs');
const path = require('node:path');
const { distances } = require('./compare.cjs');

const allowed = { direct: 1e-9, fitted: 1e-8, interval: 1e-6 };
// The extrapolation of measured impacts is the maximum of a likelihood, found to about 1e-8.
const allowedForImpacts = { ...allowed, fitted: 2e-8 };

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

function headlinesAgree(native, readWeb) {
    const read = text => JSON.parse(text).result.samples;
    const one = read(fs.readFileSync(path.join(native, '7-critical-velocity.json')));
    const other = read(readWeb('7-critical-velocity.json'));
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

// read(file): an artifact of the page as text.
function agree(name, native, read, taken, allowed) {
    const files = fs.readdirSync(native).filter(file => file.endsWith('.json') && file !== 'manifest.json');
    assert.equal(files.length, 10, `${native} has ten artifacts`);
    for (const file of files) {
        const worst = distances(file, JSON.parse(fs.readFileSync(path.join(native, file))).result, JSON.parse(read(file)).result, taken(file));
        for (const [kind, found] of Object.entries(worst)) {
            console.log(`${name} ${file}: ${kind} values within ${found.distance.toExponential(1)} (${found.count})`);
            assert.ok(found.distance <= allowed[kind],
                `${name}, ${file}${found.place}: ${found.one} natively, ${found.other} in the page; apart by ${found.distance}`);
        }
    }
}

module.exports = { agree, allowed, allowedForImpacts, everything, headlinesAgree, withoutHeadline };
