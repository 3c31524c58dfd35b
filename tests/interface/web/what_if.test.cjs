// what_if.test.cjs: what the sliders of the page ask of the program, without a browser or the program.
'use strict';
const assert = require('node:assert/strict');
const fs = require('node:fs');
const path = require('node:path');
const vm = require('node:vm');

const page = path.join(__dirname, '../../../interface/web/page');
const asked = [];
let zero = null;
const laws = {
    laws: { dmt: { parameters: [] }, 'maugis-dugdale': { parameters: [{ name: 'tabor' }, { name: 'cohesion_range' }] } },
    damping_laws: { constant: { unit: 'kg/s' }, 'contact-radius': { unit: 'Pa s' }, tsuji: { unit: '1' } },
};
const quick = {
    ask: async ({ words }) => {
        asked.push(JSON.parse(words[0]));
        return { answer: { status: 0, damping: 1, restitution: [0], critical_velocity: zero } };
    },
};
const context = vm.createContext({ quick, embedded: laws, state: { sample: 0 }, JSON, Math, Object, Promise });
vm.runInContext(`${fs.readFileSync(path.join(page, 'what_if.js'), 'utf8')}\nObject.assign(this, { contactOf, curveOf, curveUpTo, dampingAt });`, context);

const quantity = (value, unit) => ({ value, unit });
function artifacts(law, dampingLaw, measured, second) {
    const contact = { contact_modulus: quantity(9e10, 'Pa'), effective_radius: quantity(44e-6, 'm'), mass: quantity(9e-10, 'kg'),
        density: quantity(2600, 'kg/m3'), work_of_adhesion: quantity(0.3, 'J/m2'), tabor: quantity(2, '1'),
        ...(second && { partner: { radius: quantity(60e-6, 'm'), mass: quantity(2e-9, 'kg') } }) };
    const results = {
        '0-case.json': { damping_law: dampingLaw, detachments: { dmt: 'zero-force' } },
        '1-modulus.json': { samples: [{ diameter: quantity(88e-6, 'm') }] },
        '2-contact.json': { samples: [contact] },
        ...(measured && {
            '5-damping.json': { samples: [{ [law]: { velocity: { values: [2, 0.4, 1] }, damping: { values: [1.2, 9, 1.7] } } }] },
            '7-critical-velocity.json': { samples: [{ [law]: { detachment: 'zero-overlap', damping_law: dampingLaw, damping: measured, critical_velocity: quantity(0.5, 'm/s') } }] },
        }),
    };
    return Object.fromEntries(Object.entries(results).map(([file, result]) => [file, JSON.stringify({ result })]));
}
const plain = (value) => JSON.parse(JSON.stringify(value));

(async () => {
    // The damping is asked for by the law of the case, and labelled in its unit.
    const units = [['constant', 'kg/s', { unit: 'g/s', scale: 1e3 }], ['contact-radius', 'Pa s', { unit: 'Pa s', scale: 1 }], ['tsuji', '1', { unit: '', scale: 1 }]];
    for (const [dampingLaw, unit, shown] of units) {
        const contact = await context.contactOf(artifacts('dmt', dampingLaw, quantity(1.65, unit)), 'dmt');
        assert.equal(contact.damping, 1.65);
        assert.deepEqual(plain(contact.dampingUnit), shown);
        await context.curveOf(contact, [1, 2]);
        assert.equal(asked.at(-1).damping_law, dampingLaw);
        assert.equal(asked.at(-1).detachment, 'zero-overlap');
        assert.ok(!('dampingUnit' in asked.at(-1)) && !('course' in asked.at(-1)));
    }
    // Before any was measured the program guesses it, by the law of the case as well.
    const guessed = await context.contactOf(artifacts('dmt', 'tsuji'), 'dmt');
    assert.deepEqual([guessed.damping, asked.at(-1).damping_law, asked.at(-1).detachment, 'damping' in asked.at(-1)], [1, 'tsuji', 'zero-force', false]);
    // A law gets its own parameters and no other's.
    assert.equal((await context.contactOf(artifacts('maugis-dugdale', 'constant'), 'maugis-dugdale')).tabor, 2);
    assert.ok(!('tabor' in guessed));
    // A second sphere comes along.
    const pair = await context.contactOf(artifacts('dmt', 'constant', quantity(1.65, 'kg/s'), true), 'dmt');
    assert.deepEqual([pair.partner_radius, pair.partner_mass], [60e-6, 2e-9]);
    // The damping begins with that of the critical velocity, follows what was measured above it, and has no corner.
    const { course } = pair;
    const velocities = Array.from({ length: 2000 }, (_, i) => 0.3 * 1.001 ** i);
    const dampings = velocities.map((v) => context.dampingAt(course, v));
    velocities.forEach((v, i) => v > 0.5 || assert.equal(dampings[i], 1.65));
    assert.ok(Math.abs(context.dampingAt(course, 1) - 1.7) < 0.15 && Math.abs(context.dampingAt(course, 2) - 1.2) < 0.15);
    const bends = dampings.slice(2).map((value, i) => Math.abs(value - 2 * dampings[i + 1] + dampings[i]));
    assert.ok(Math.max(...bends) < 2e-4, `bends by ${Math.max(...bends)}`);
    assert.ok(context.dampingAt({ begin: [0.1, 3], points: [[0.1, 3], [5, 2]] }, 0.7) < 3.1, 'far from every impact');
    // A curve has many steps where it leaves zero, and begins there with the damping of the critical velocity.
    zero = 0.2;
    const { velocities: steps } = await context.curveUpTo(3, pair, 0.5);
    assert.ok(steps.filter((v) => v > 0.2 && v < 0.21).length > 5 && steps.includes(0.2));
    const { dampings: halves } = asked.at(-1);
    assert.ok(Math.abs(halves[steps.indexOf(0.2)] - 1.65 / 2) < 1e-9 && Math.abs(halves.at(-1) - context.dampingAt(course, 3) / 2) < 1e-9);
    zero = 0.9;
    const above = await context.curveUpTo(3, pair, 2);
    assert.ok(Math.abs(above.critical_velocity - 0.9) < 1e-6);
    assert.ok(Math.abs(asked.at(-1).dampings[1] - 2 * context.dampingAt(course, 0.9)) < 1e-5, 'what was measured there');
    console.log('the sliders ask for the law of the case');
})().catch((error) => {
    console.error(error.message);
    process.exitCode = 1;
});
