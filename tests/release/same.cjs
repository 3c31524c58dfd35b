// SPDX-License-Identifier: GPL-3.0-or-later
// same.cjs ONE OTHER: the artifacts of two runs have the same bytes of result.
'use strict';
const assert = require('node:assert/strict');
const fs = require('node:fs');
const path = require('node:path');
const [one, other] = process.argv.slice(2);
const artifacts = fs.readdirSync(one).filter((file) => file.endsWith('.json') && file !== 'manifest.json');
assert.equal(artifacts.length, 10);
const result = (folder, file) => {
    const text = fs.readFileSync(path.join(folder, file), 'utf8');
    return text.slice(text.indexOf('\n  "result":'));
};
for (const file of artifacts) {
    assert.ok(result(one, file).length > 20, file);
    assert.equal(result(one, file), result(other, file), file);
}
console.log(`${artifacts.length} artifacts with the same bytes of result`);
