// The reference impacts of the solver's tests: the same by the page's program and by that of this machine.
'use strict';
const assert = require('node:assert/strict');
const { execFileSync } = require('node:child_process');
const fs = require('node:fs');
const path = require('node:path');

const { sphere, cases } = JSON.parse(fs.readFileSync(path.join(__dirname, '../../data/reference/impacts.json')));
const compared = ['restitution', 'contact_time', 'maximum_overlap', 'rebound_velocity'];

// The keys of an impact, which are options of `ashimpact impact` with hyphens.
function contactOf(row) {
    return { law: row.law, detachment: row.detachment, radius: sphere.radius, mass: sphere.mass, contact_modulus: sphere.contact_modulus,
        ...(row.work_of_adhesion > 0 ? { work_of_adhesion: row.work_of_adhesion } : {}), damping: row.damping, velocity: row.velocity, ...row.parameters };
}

function natively(program, contact) {
    const options = Object.entries(contact).flatMap(([key, value]) => [`--${key.replaceAll('_', '-')}`, String(value)]);
    return JSON.parse(execFileSync(program, ['impact', '-q', '--json', ...options], { stdio: ['ignore', 'pipe', 'ignore'] }));
}

const apart = (one, other) => (one === other ? 0 : Math.abs(one - other) / Math.max(Math.abs(one), Math.abs(other)));

// Asks both for each impact, the page's program by inPage(contact): within a relative limit they are the same. `what` is told.
async function agreeOnReference(what, program, inPage, limit) {
    const worst = Object.fromEntries(compared.map(key => [key, { distance: -1 }]));
    for (const row of cases) {
        const contact = contactOf(row);
        const [native, web] = [natively(program, contact), await inPage(contact)];
        assert.equal(web.status, 0, JSON.stringify(web.error));
        assert.equal(web.outcome, native.outcome, JSON.stringify(contact));
        for (const key of compared) {
            assert.equal(web[key] === null, native[key] === null, `${key} of ${JSON.stringify(contact)}`);
            if (native[key] === null) continue;
            const distance = apart(native[key].value, web[key].value);
            if (distance > worst[key].distance) worst[key] = { distance, where: JSON.stringify(contact) };
        }
    }
    for (const [key, { distance }] of Object.entries(worst)) console.log(`${what}, ${cases.length} reference impacts: ${key} within ${distance.toExponential(1)}`);
    for (const [key, { distance, where }] of Object.entries(worst)) assert.ok(distance <= limit, `${key} apart by ${distance}: ${where}`);
}

module.exports = { agreeOnReference };
