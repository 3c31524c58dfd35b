// Whether artifacts of the page are those of the native program: direct values to 1e-9, as doubles allow, or what is given;
// fitted ones to 1e-8, intervals to 1e-6.
'use strict';
const assert = require('node:assert/strict');
const fs = require('node:fs');
const path = require('node:path');
const { distances } = require('./compare.cjs');

// map_accuracy is an estimate of an error, made of rounding. The first history of a curve is at v_c itself, where rounding
// decides how long the impact creeps.
const isCompared = place => !/map_accuracy|\/curves\/[^/]+\/histories\/0\//.test(place);

// read(file): an artifact of the page as text.
function agree(name, native, read, direct = 1e-9) {
    const allowed = { direct, fitted: 1e-8, interval: 1e-6, root: 1e-7 };
    const files = fs.readdirSync(native).filter(file => file.endsWith('.json') && file !== 'manifest.json');
    assert.equal(files.length, 10, `${native} has ten artifacts`);
    for (const file of files) {
        const worst = distances(file, JSON.parse(fs.readFileSync(path.join(native, file))).result, JSON.parse(read(file)).result, isCompared);
        for (const [kind, found] of Object.entries(worst)) {
            console.log(`${name} ${file}: ${kind} values within ${found.distance.toExponential(1)} (${found.count})`);
            assert.ok(found.distance <= allowed[kind],
                `${name}, ${file}${found.place}: ${found.one} natively, ${found.other} in the page; apart by ${found.distance}`);
        }
    }
}

module.exports = { agree };
