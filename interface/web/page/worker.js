// The program beside the page. It answers {id, name, files, arguments, read}: writes the files, calls the function of
// binding.cpp, and reads back what is asked for: a list of files, or 'all' that a run has written.
'use strict';
let program;

async function start(wasmBinary) {
    const onProgress = (line) => self.postMessage({ progress: line });
    program = await createAshimpact({ wasmBinary, onProgress, print: () => {}, printErr: () => {} });
    program.FS.mkdir('/case');
    program.FS.chdir('/case');
}

function written(answer, folder, wanted) {
    const names = wanted === 'all' ? answer.files ?? [] : wanted ?? [];
    const found = {};
    for (const name of names)
        if (program.FS.analyzePath(`${folder}/${name}`).exists)
            found[name] = program.FS.readFile(`${folder}/${name}`, { encoding: 'utf8' });
    return found;
}

function answerTo({ name, files, remove, words, read }) {
    for (const old of remove ?? []) if (program.FS.analyzePath(old).exists) program.FS.unlink(old);
    for (const [file, bytes] of files ?? []) {
        if (file.includes('/')) program.FS.mkdirTree(`${program.FS.cwd()}/${file.slice(0, file.lastIndexOf('/'))}`);
        program.FS.writeFile(file, bytes);
    }
    const text = program.ccall(`ashimpact_${name}`, 'number', words.map(() => 'string'), words);
    const answer = JSON.parse(program.UTF8ToString(text));
    return { answer, artifacts: written(answer, words[1], read) };
}

let queue = null;
self.onmessage = ({ data }) => {
    if (data.wasmBinary) {
        queue = start(data.wasmBinary);
        return;
    }
    queue = queue.then(() => {
        try {
            self.postMessage({ id: data.id, ...answerTo(data) });
        } catch (error) {  // out of memory, or a defect: this worker is not used again
            self.postMessage({ id: data.id, broken: String(error) });
        }
    }, (error) => self.postMessage({ id: data.id, broken: String(error) }));
};
