// SPDX-License-Identifier: GPL-3.0-or-later
// npm.cjs PROGRAM PREFIX NATIVE RUN: the package of npm installed in PREFIX against the program of this machine: the results of
// both cases, 50 wrong inputs, commands that need no extended precision byte by byte, and the library.
'use strict';
const assert = require('node:assert/strict');
const { spawnSync } = require('node:child_process');
const fs = require('node:fs');
const os = require('node:os');
const path = require('node:path');
const { pathToFileURL } = require('node:url');
const { agree } = require('../interface/web/agree.cjs');
const { wrongFiles } = require('../interface/web/wrong_files.cjs');

const [program, prefix, native, run] = process.argv.slice(2);
for (const [name, folder] of [['built-in', 'built-in'], ['example', 'example/results']])
    agree(name, path.join(native, folder), (file) => fs.readFileSync(path.join(run, folder, file), 'utf8'));

const scratch = fs.mkdtempSync(path.join(os.tmpdir(), 'ashimpact-'));
const places = ['here', 'node'].map((name) => path.join(scratch, name));
for (const place of places) fs.cpSync(path.join(native, 'example'), place, { recursive: true });
const both = (words) => [program, path.join(prefix, 'bin/ashimpact')].map((each, i) => {
    const { status, stdout, stderr } = spawnSync(each, words, { cwd: places[i], encoding: 'utf8', argv0: 'ashimpact' });
    return { status, stdout, stderr };
});

const caseText = fs.readFileSync(path.join(native, 'example/case.json'), 'utf8').replace(/^ *\/\/.*\n/gm, '');
const wrong = wrongFiles(caseText).filter((_, i) => i % 4 === 0);
assert.equal(wrong.length, 50);
for (const { name, bytes } of wrong) {
    for (const place of places) fs.writeFileSync(path.join(place, name), bytes);
    const [here, node] = both(name.endsWith('.json') ? ['run', name, '-o', 'out'] : ['modulus', name]);
    assert.equal(here.status, 2, `${name}: ${here.stderr}`);
    assert.deepEqual(node, here, name);
}
console.log('50 wrong inputs: the same messages and exit status');

const contact = ['--radius', '44 um', '--density', '2600 kg/m3', '--contact-modulus', '90 GPa', '--work-of-adhesion', '0.3 J/m2'];
for (const words of [['--help'], ['help', 'run'], ['--version'], ['laws'], ['phases'], ['schema', 'case'], ['modulus', 'ash.csv', '--amorphous-fraction', '47 %'],
    ['contact', ...contact, '--json'], ['nothing'], ['run', '--nothing'], ['init', 'new'], ['export', 'lammps', '-o', 'deck']]) {
    const [here, node] = both(words);
    assert.deepEqual(node, here, words.join(' '));
}
const [, sweep] = both(['sweep', 'spec.json', '-o', 'out.json']);
assert.equal(sweep.status, 2);
assert.match(sweep.stderr, /needs MPI and HDF5/);

(async () => {
    const index = path.join(prefix, 'lib/node_modules/ashimpact/index.mjs');
    const { ashimpact } = await import(pathToFileURL(index));
    const table = fs.readFileSync(path.join(native, 'example/ash.csv'));
    const words = ['modulus', 'in/ash.csv', '--amorphous-fraction', '47 %', '--json'];
    const ended = await ashimpact(words, { files: { 'in/ash.csv': table } });
    assert.equal(ended.status, 0, ended.stderr);
    assert.ok(JSON.parse(ended.stdout));
    assert.deepEqual(Object.keys(ended.files), ['in/ash.csv']);
    fs.rmSync(scratch, { recursive: true });
    console.log('the library gives the same as the command');
})();
