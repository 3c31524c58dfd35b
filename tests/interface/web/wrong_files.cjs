// Files that the page has to refuse: wrongFiles() gives 200, each {name, bytes}, the same ones every time.
'use strict';
const zlib = require('node:zlib');

// Numbers in [0, 1) that look random, the same in every run.
function randomNumbers(seed) {
    let state = seed >>> 0;
    return () => {
        state = (Math.imul(state, 1664525) + 1013904223) >>> 0;
        return state / 2 ** 32;
    };
}
const random = randomNumbers(20);
const noise = (size) => Buffer.from(Array.from({ length: size }, () => Math.floor(random() * 256)));
const text = (name, content) => ({ name, bytes: Buffer.from(content, 'utf8') });

// Cases: cut off, of another shape, and with one wrong value.
function cases(example) {
    const files = [];
    for (let i = 1; i <= 30; ++i) files.push(text(`cut-${i}.json`, example.slice(0, Math.floor((example.length * i) / 32))));
    for (const content of ['', '{}', '[]', '1', 'null', '"case"', '{"samples": null}', '{"samples": []}', '{"samples": [1]}', '{"samples": {}}', '{"samples": [[]]}',
        '{"name": 1}', '\u0000', '{"samples": [{"name": "a"}]', '[' .repeat(5000), '{"a":'.repeat(3000), '\ufeff{', "{'samples': []}", '{"samples": [{},]}', 'NaN'])
        files.push(text(`shape-${files.length}.json`, content));
    const edits = [
        ['diameter', ['88 kg', '88 um m', '-88 um', '0 um', 'abc', '', null, [], {}, true, '1e999 um', 'nan um', '88 smoots', '88 um um']],
        ['density', ['2300 m', '-1 kg/m3', '0 kg/m3', 'heavy', [1], true]],
        ['name', [null, 5, [], {}, true]],
        ['composition', [null, 5, 'quartz', [], {}, { weight_fractions: {} }, { weight_fractions: { quartz: '150 %' } }, { weight_fractions: { kryptonite: '10 %' }, amorphous: 'remainder' },
            { weight_fractions: { quartz: '60 %', mullite: '60 %' } }, { weight_fractions: { quartz: -0.1 }, amorphous: 'remainder' }, { xrd: 'no-such-file.csv' }, { xrd: 5 }]],
        ['restitution', [5, 'none', [], { file: 'no-such-file.csv' }, { velocity: [1, 2], restitution: [0.1] }, { velocity: [1], restitution: [2] }, { velocity: [-1], restitution: [0.5] }, { velocity: ['fast'], restitution: [0.1] }]],
        ['unknown_key', [1, 'x', {}]],
    ];
    for (const [key, values] of edits)
        for (const value of values) {
            const document = JSON.parse(example);
            document.samples[1][key] = value;
            files.push(text(`value-${files.length}.json`, JSON.stringify(document)));
        }
    return files;
}

function xrdResults() {
    const contents = ['', '\n\n\n', 'phase', 'phase,weight %', 'phase,weight %\n', 'sample,phase,weight %\nfine,quartz,-3\n', 'sample,phase,weight %\nfine,quartz,150\n',
        'sample,phase,weight %\nfine,quartz,abc\n', 'sample,phase,weight %\nfine,quartz,nan\n', 'sample,phase,weight %\nfine,quartz,inf\n', 'sample,phase,weight %\nfine,kryptonite,100\n',
        'sample,phase\nother,quartz\n', 'sample,phase,weight %\nfine,quartz,60\nfine,mullite,60\n', 'sample,phase,weight %\nfine,quartz,1e400\n', 'phase;weight\nfine;quartz;3;4;5\n',
        '<html><body>Not found</body></html>', '%PDF-1.4\n%âãÏÓ\n', 'PK\u0003\u0004', 'x'.repeat(200000), '\u0000\u0000\u0000', 'phase,weight %\nquartz,50\nquartz,50\nquartz,1\n'];
    const files = contents.map((content, i) => text(`ash-${i}.csv`, content));
    files.push({ name: 'ash-utf16.csv', bytes: Buffer.from('\ufeffsample,phase\nfine,quartz\n', 'utf16le') });
    for (const ending of ['xlsx', 'ods', 'csv', 'str', 'lst', 'out', 'dat']) {
        for (const size of [1, 100, 5000]) files.push({ name: `noise-${size}.${ending}`, bytes: noise(size) });
        files.push({ name: `gzip.${ending}`, bytes: zlib.gzipSync('phase,weight %\nquartz,10\n') });
    }
    return files;
}

function impactTables() {
    const heading = 'velocity [m/s],rebound_velocity [m/s]\n';
    const contents = ['', 'velocity', heading, 'velocity [m/s]\n1\n2\n', `${heading}a,b\n`, `${heading}1,abc\n`, `${heading}-1,0.5\n`, `${heading}1,5\n`, `${heading}nan,0\n`, `${heading}1e999,0\n`,
        `${heading}inf,0\n`, 'velocity [kg],rebound_velocity [m/s]\n1,0.1\n', 'velocity [m/s],rebound_velocity [furlongs]\n1,0.1\n', 'velocity [m/s],velocity [m/s]\n1,1\n', `${heading}0,0\n`,
        `${heading}1;0.1\n`, `${heading}1\n`, `${heading}1,0.1,2,3,4\n`, '<table><tr><td>v_in</td></tr></table>', `${heading}1,-0.5\n`, `${heading}"1,0.1\n`];
    const files = contents.map((content, i) => text(`impacts-${i}.csv`, content));
    for (const ending of ['xlsx', 'ods', 'csv', 'txt']) for (const size of [2, 300, 4000]) files.push({ name: `impacts-noise-${size}.${ending}`, bytes: noise(size) });
    return files;
}

// Noise until there are 200.
function wrongFiles(example) {
    const files = [...cases(example), ...xrdResults(), ...impactTables()];
    while (files.length < 200) files.push({ name: `noise-${files.length}.${files.length % 2 ? 'json' : 'csv'}`, bytes: noise(files.length * 7) });
    return files;
}

// An archive with one file of zeros, which states a size of its own.
function archiveOfZeros(size, stated) {
    const [name, bytes] = [Buffer.from('ash.csv'), zlib.deflateRawSync(Buffer.alloc(size))];
    const numbers = (...all) => Buffer.concat(all.map(([value, length]) => { const part = Buffer.alloc(length); part.writeUIntLE(value, 0, length); return part; }));
    const common = numbers([20, 2], [0, 2], [8, 2], [0, 4], [0, 4], [bytes.length, 4], [stated, 4], [name.length, 2], [0, 2]);
    const file = Buffer.concat([numbers([0x04034b50, 4]), common, name, bytes]);
    const entry = Buffer.concat([numbers([0x02014b50, 4], [20, 2]), common, numbers([0, 2], [0, 2], [0, 2], [0, 4], [0, 4]), name]);
    return Buffer.concat([file, entry, numbers([0x06054b50, 4], [0, 4], [1, 2], [1, 2], [entry.length, 4], [file.length, 4], [0, 2])]);
}

module.exports = { archiveOfZeros, wrongFiles };
