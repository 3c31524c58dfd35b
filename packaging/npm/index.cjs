// SPDX-License-Identifier: GPL-3.0-or-later
// The program as a function. Each call has a fresh module, whose files are in memory unless folders of the machine are
// mounted, so that no call leaves anything to the next.
'use strict';
const fs = require('node:fs');
const path = require('node:path');
const program = require('./ashimpact-node.js');

const wasm = path.join(__dirname, 'ashimpact-node.wasm');
let compiled; // once for all calls

async function open(streams) {
    compiled ??= WebAssembly.compile(fs.readFileSync(wasm));
    const binary = await compiled;
    return program({
        ...streams,
        thisProgram: 'ashimpact',
        instantiateWasm: (imports, done) => { WebAssembly.instantiate(binary, imports).then(done); return {}; },
    });
}

// Collects the bytes of a stream, which the module writes one by one.
class Bytes {
    #bytes = Buffer.alloc(1 << 16);
    #count = 0;
    #full;
    constructor(full) { this.#full = full; }
    put = (byte) => {
        if (byte === null) return;
        this.#bytes[this.#count++] = byte & 255;
        if (this.#count === this.#bytes.length) this.flush();
    };
    flush() {
        this.#full(Buffer.from(this.#bytes.subarray(0, this.#count)));
        this.#count = 0;
    }
}

// Runs words of a command line. prepare(module) makes the files that they name.
async function command(words, { stdin, stdout, stderr, prepare }) {
    const [out, error] = [new Bytes(stdout), new Bytes(stderr)];
    const module = await open({ stdin, stdout: out.put, stderr: error.put });
    prepare(module);
    const status = module.ccall('ashimpact_command', 'number', ['string'], [JSON.stringify(['ashimpact', ...words])]);
    out.flush();
    error.flush();
    return { status, module };
}

// All files below a folder of the module, by their path.
function filesBelow(FS, folder, found = {}) {
    for (const name of FS.readdir(folder)) {
        if (name === '.' || name === '..') continue;
        const file = `${folder === '/' ? '' : folder}/${name}`;
        if (FS.isDir(FS.lstat(file).mode)) filesBelow(FS, file, found);
        else found[path.posix.relative('/work', file)] = Buffer.from(FS.readFile(file));
    }
    return found;
}

async function ashimpact(words, { files = {}, input = '' } = {}) {
    const [texts, given] = [{ stdout: [], stderr: [] }, Buffer.from(input)];
    let next = 0;
    const { status, module } = await command(words, {
        stdin: () => (next < given.length ? given[next++] : null),
        stdout: (bytes) => texts.stdout.push(bytes),
        stderr: (bytes) => texts.stderr.push(bytes),
        prepare: ({ FS }) => {
            FS.mkdir('/work');
            FS.chdir('/work');
            for (const [name, content] of Object.entries(files)) {
                FS.mkdirTree(path.posix.dirname(path.posix.join('/work', name)));
                FS.writeFile(name, content);
            }
        },
    });
    return {
        status,
        stdout: Buffer.concat(texts.stdout).toString(),
        stderr: Buffer.concat(texts.stderr).toString(),
        files: filesBelow(module.FS, '/work'),
    };
}

module.exports = { ashimpact, command };
