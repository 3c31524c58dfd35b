// build.cjs PROGRAM VERSION OUTPUT: joins the files of this folder, the program (PROGRAM.js and .wasm) and the cases of the
// repository to one page that asks nothing of a network.
'use strict';
const crypto = require('node:crypto');
const fs = require('node:fs');
const path = require('node:path');
const zlib = require('node:zlib');

const [program, version, output] = process.argv.slice(2);
const root = path.resolve(__dirname, '../../..');
const own = (file) => fs.readFileSync(path.join(__dirname, file), 'utf8');
const data = (file) => fs.readFileSync(path.join(root, 'data', file), 'utf8');
const report = (file) => fs.readFileSync(path.join(root, 'pipeline/present/report/page', file), 'utf8');
const hash = (text) => `'sha256-${crypto.createHash('sha256').update(text).digest('base64')}'`;
const packed = (bytes) => zlib.gzipSync(bytes, { level: 9 }).toString('base64');

// In the order in which they are joined: each uses those before it.
const parts = ['state', 'dom', 'history', 'quantity', 'fields', 'zip', 'program', 'grid', 'ash', 'wall', 'impacts', 'plot', 'what_if', 'live', 'tube', 'results', 'files', 'main'];

// The report's reader of figures, as a function that is called when there are figures.
function readouts() {
    const text = report('readout.js');
    const begin = text.indexOf('(() => {');
    const end = text.lastIndexOf('})();');
    if (begin < 0 || end < 0) throw new Error('readout.js of the report is no longer one function');
    return `function readFigures() {\n${text.slice(begin + '(() => {'.length, end)}}\n`;
}

// Contact and damping laws with what they take, as the program states them.
async function lawTables() {
    const module = await require(path.resolve(`${program}.js`))({ wasmBinary: fs.readFileSync(`${program}.wasm`) });
    const { laws, damping_laws } = JSON.parse(module.UTF8ToString(module.ccall('ashimpact_laws', 'number', [], [])));
    return { laws, damping_laws };
}

(async () => {
    const literature = JSON.parse(data('phases/literature.json'));
    const embedded = {
        example: { 'case.json': data('cases/example/case.json'), 'ash.csv': data('cases/example/ash.csv'), 'impacts.csv': data('cases/example/impacts.csv') },
        paper: { 'case.json': data('cases/dong2013/case.json') },
        phases: [...new Set(literature.phases.map((phase) => phase.name))].sort(),
        ...await lawTables(),
    };
    const script = `(() => {\n'use strict';\nconst embedded = ${JSON.stringify(embedded).replaceAll('<', '\\u003c')};\n` +
        `${readouts()}${parts.map((part) => own(`${part}.js`)).join('\n')}\n})();`;
    const style = report('page.css') + own('style.css');
    const policy = `default-src 'none'; script-src ${hash(script)} 'wasm-unsafe-eval' blob:; worker-src blob:; style-src ${hash(style)}; ` +
        "img-src data:; base-uri 'none'; form-action 'none'";
    const worker = `${fs.readFileSync(`${program}.js`, 'utf8')}\n${own('worker.js')}`;
    const filled = {
        POLICY: policy, STYLE: style, VERSION: version, SCRIPT: script,
        PROGRAM: packed(fs.readFileSync(`${program}.wasm`)), WORKER: packed(worker),
    };
    fs.writeFileSync(output, own('index.html').replace(/@([A-Z]+)@/g, (whole, name) => filled[name] ?? whole));
})();
