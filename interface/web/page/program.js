// The program in workers: one that answers while the user types, one for each long computation.
const unpacked = (id) => decompressed(Uint8Array.from(atob(byId(id).textContent), (letter) => letter.charCodeAt(0)), 'gzip');

let programParts = null;
async function newWorker() {
    programParts ??= Promise.all([unpacked('app-program'), unpacked('app-worker')]).then(([wasm, source]) => (
        { wasm, url: URL.createObjectURL(new Blob([source], { type: 'text/javascript' })) }));
    const { wasm, url } = await programParts;
    const worker = new Worker(url);
    worker.postMessage({ wasmBinary: wasm });
    return worker;
}

// One worker and the questions it has not answered yet.
class Program {
    // progress(line): what the program says while it computes.
    constructor(progress = () => {}) {
        this.progress = progress;
        this.waiting = new Map();
        this.last = 0;
        this.had = new Map();
        this.worker = null;
    }

    async ask(question) {
        this.worker ??= newWorker().then((worker) => {
            worker.onmessage = ({ data }) => this.answered(data);
            worker.onerror = (event) => {
                event.preventDefault();
                this.fail(event.message);
            };
            return worker;
        });
        const worker = await this.worker;
        const id = ++this.last;
        return new Promise((resolve, reject) => {
            this.waiting.set(id, { resolve, reject });
            worker.postMessage({ id, ...question });
        });
    }

    // Asks about the case: its files go along where the worker does not have them yet.
    askOfCase(name, folder, read, text = textOfCase()) {
        const files = [...state.files].filter(([file, bytes]) => this.had.get(file) !== bytes);
        const remove = [...this.had.keys()].filter((file) => !state.files.has(file));
        this.had = new Map(state.files);
        files.push(['case.json', new TextEncoder().encode(text)]);
        return this.ask({ name, files, remove, words: folder === undefined ? ['case.json'] : ['case.json', folder], read });
    }

    answered({ id, answer, artifacts, broken, progress }) {
        if (progress !== undefined) {
            this.progress(progress);
            return;
        }
        const waiting = this.waiting.get(id);
        this.waiting.delete(id);
        if (broken !== undefined) {
            waiting?.reject(new Error(broken));
            this.stop();
        } else waiting?.resolve({ answer, artifacts });
    }

    fail(message) {
        const waiting = [...this.waiting.values()];
        this.stop();
        for (const each of waiting) each.reject(new Error(message));
    }

    // Ends the worker; the next question starts another.
    stop() {
        this.worker?.then((worker) => worker.terminate(), () => {});
        this.worker = null;
        this.waiting.clear();
        this.had.clear();
    }
}

const quick = new Program();
