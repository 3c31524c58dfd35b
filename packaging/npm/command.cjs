#!/usr/bin/env node
// SPDX-License-Identifier: GPL-3.0-or-later
// The command line on the files of this machine: each folder at the root is mounted, on Windows each drive as /C:.
'use strict';
const fs = require('node:fs');
const path = require('node:path');
const { command } = require('./index.cjs');

const windows = process.platform === 'win32';
const inside = (place) => (windows ? `/${path.resolve(place).replaceAll('\\', '/')}` : place);

function mount({ FS, NODEFS }) {
    const roots = windows
        ? [...'ABCDEFGHIJKLMNOPQRSTUVWXYZ'].map((drive) => `${drive}:`).filter((drive) => fs.existsSync(`${drive}\\`))
        : fs.readdirSync('/', { withFileTypes: true }).filter((each) => each.isDirectory() || each.isSymbolicLink()).map((each) => each.name);
    for (const root of roots) {
        if (!windows && ['dev', 'proc', 'sys'].includes(root)) continue;
        const place = windows ? `${root}\\` : `/${root}`;
        if (!fs.statSync(place, { throwIfNoEntry: false })?.isDirectory()) continue;
        if (!FS.analyzePath(`/${root}`).exists) FS.mkdir(`/${root}`);
        FS.mount(NODEFS, { root: fs.realpathSync(place) }, `/${root}`);
    }
    FS.chdir(inside(process.cwd()));
}

// On Windows a path may be written with a drive or backslashes; the program knows neither.
const word = (text) => (windows && (/^[A-Za-z]:[\\/]/.test(text) || text.includes('\\')) ? (path.isAbsolute(text) ? inside(text) : text.replaceAll('\\', '/')) : text);

const write = (stream) => (bytes) => {
    for (let done = 0; done < bytes.length;) {
        try {
            done += fs.writeSync(stream, bytes, done);
        } catch (error) {
            if (error.code === 'EPIPE') process.exit(1);
            if (error.code !== 'EAGAIN') throw error;
        }
    }
};

const input = Buffer.alloc(1 << 16);
let [next, count] = [0, 0];
function read() {
    if (next === count) {
        try {
            [next, count] = [0, fs.readSync(0, input)];
        } catch (error) {
            if (error.code !== 'EOF' && error.code !== 'EAGAIN') throw error;
            count = 0;
        }
        if (count === 0) return null;
    }
    return input[next++];
}

command(process.argv.slice(2).map(word), { stdin: read, stdout: write(1), stderr: write(2), prepare: mount })
    .then(({ status }) => { process.exitCode = status; });
