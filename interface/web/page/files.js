// Files that come in by drop or choice. What a file is, its place or its content tells.
const mostBytes = 200e6;
const mostInArchive = 20;
const mostUnpacked = 50e6;  // bytes of an archive

function tell(text, bad, choices = []) {
    byId('app-told').textContent = text;
    byId('app-told').classList.toggle('bad', Boolean(bad));
    byId('app-choice').replaceChildren(...choices);
}

// Notes on several files, each {text, bad, choices}.
function tellAll(notes) {
    tell(notes.map(({ text }) => text).join(' '), notes.some(({ bad }) => bad), notes.flatMap(({ choices }) => choices ?? []));
}

const startOf = (bytes) => new TextDecoder().decode(bytes.subarray(0, 20000));

// Whether JSON is a case; else it is taken as an XRD result.
function isCaseFile(name, bytes) {
    const start = startOf(bytes);
    return /\.json$/i.test(name) && (/"samples"/.test(start) || !/"(weight_fractions|phases)"/.test(start));
}

// A case replaces the one in the page, with the files that came along; gives what to tell.
async function takeCase(name, bytes, others) {
    const files = new Map([...state.files, ...others]);
    const { answer } = await quick.ask({ name: 'validate', files: [...others, [name, bytes]], words: [name] });
    let document = null;
    try {
        document = parseJson(new TextDecoder('utf-8', { fatal: true }).decode(bytes));
    } catch { /* the program has said so */ }
    if (!isCase(document)) {
        return { text: answer.status === 0 ? `${name}: is no case that this page can show` : answer.error.message, bad: true };
    }
    openCase(`open ${name}`, document, files);
    return answer.status === 0 ? { text: `${name} is open.` } : { text: `${name} is open. In the file: ${answer.error.message}`, bad: true };
}

const kindNames = { xrd: 'the XRD result', impacts: 'the measured impacts' };

// What a table of a kind would replace in the sample that is shown, in words.
function replacedBy(kind, name) {
    const before = valueAt(kind === 'xrd' ? '/samples/#/composition' : '/samples/#/restitution');
    const file = kind === 'xrd' ? before?.xrd : before?.file;
    if (file !== undefined) return `, in place of ${file === name ? 'the file of that name before' : file}`;
    const typed = kind === 'xrd' ? before?.weight_fractions : before?.velocity;
    return isObject(typed) && Object.keys(typed).length > 0 ? ', in place of what was typed' : '';
}

// The name by which the case knows a file: another one where a second sample has a different file of that name.
function nameInCase(name, bytes) {
    const old = state.files.get(name);
    const others = state.document.samples.filter((sample) => sample !== sampleNow() && (sample.composition?.xrd === name || sample.restitution?.file === name));
    const same = !old || (old.length === bytes.length && old.every((byte, i) => byte === bytes[i]));
    return others.length === 0 || same ? name : nameInCase(`${state.sample + 1}-${name}`, bytes);
}

// One table becomes that of a kind for the sample that is shown; says so.
function takeTable([file, bytes], kind) {
    const name = nameInCase(file.replaceAll(/[/\\]/g, '_'), bytes);
    const told = `${name} is taken as ${kindNames[kind]} of ${sampleNow().name ?? 'the sample'}${replacedBy(kind, name)}.`;
    remember(`take ${name}`);
    if (kind === 'xrd') takeXrd(name, bytes);
    else takeImpacts(name, bytes);
    changedForm();
    return told;
}

// A table goes where the program reads it. One that no reader takes goes nowhere; the user may say what it is.
async function placeTable(table) {
    const [name, bytes] = table;
    const { answer } = await quick.ask({ name: 'kind', files: [['dropped', bytes]], words: ['dropped'] });
    if (answer.kind === 'xrd' || answer.kind === 'impacts') {
        return { text: `${takeTable(table, answer.kind)} Read as ${answer.read_as}.` };
    }
    const because = (message) => (message ?? '').replace(/^dropped: /, '');
    const choices = Object.entries(kindNames).map(([kind, words]) => make('button', {
        type: 'button', class: 'small', click: () => tell(takeTable(table, kind)),
    }, `Take ${name} as ${words}`));
    return { text: `${name} is neither an XRD result nor a table of impacts; it is left out. As impacts: ${because(answer.impacts)}. As an XRD result: ${because(answer.xrd)}.`, bad: true, choices };
}

// [name, bytes] of each file, those of an archive in its place; notes tell what cannot be read.
async function readFiles(list) {
    const [files, notes] = [[], []];
    for (const file of list) {
        try {
            if (file.size > mostBytes) notes.push({ text: `${file.name}: is larger than ${mostBytes / 1e6} MB.`, bad: true });
            else files.push(...await unpackedFiles(file.name, new Uint8Array(await file.arrayBuffer()), notes));
        } catch {
            notes.push({ text: `${file.name}: cannot be read; is it a folder?`, bad: true });
        }
    }
    return { files, notes };
}

// The files of a .zip beside its case, or all of them where it has none; any other file is itself.
async function unpackedFiles(name, bytes, notes) {
    if (!/\.zip$/i.test(name)) return [[name, bytes]];
    let [held, fault] = [[], 'cannot be unpacked here'];
    try {
        held = (await unzipped(bytes)).filter(([path]) => !/(^|\/)(\.|__MACOSX)/.test(path));
    } catch (error) {
        if (error.message === 'too large') fault = `is more than ${mostUnpacked / 1e6} MB when unpacked`;
    }
    const cases = held.map(([path]) => path).filter((path) => /(^|\/)case\.json$/.test(path)).sort((a, b) => a.length - b.length);
    const folder = cases.length ? cases[0].slice(0, -'case.json'.length) : null;
    const chosen = folder === null ? held : held.filter(([path]) => path.startsWith(folder) && !path.slice(folder.length).includes('/'));
    if (chosen.length > 0 && chosen.length <= mostInArchive) return chosen.map(([path, content]) => [path.split('/').at(-1), content]);
    notes.push({ text: `${name}: ${chosen.length ? `holds ${chosen.length} files` : fault}; unpack it, and drop the files themselves.`, bad: true });
    return [];
}

// A file for one field.
async function chooseFile(file, kind) {
    const { files, notes } = await readFiles([file]);
    tellAll([...notes, ...files.slice(0, 1).map((table) => ({ text: takeTable(table, kind) }))]);
}

// A table with its heading from the clipboard is a file like any other.
function takePasted(text, kind) {
    return chooseFile(new File([text], `${kind === 'xrd' ? 'ash' : 'impacts'}-pasted-${state.sample + 1}.csv`), kind);
}

// Any number of files at once: with a case among them the others are what it names.
async function takeFiles(list) {
    tell('');
    const { files, notes } = await readFiles(list);
    const found = files.find(([name, bytes]) => isCaseFile(name, bytes));
    if (found) notes.push(await takeCase(found[0], found[1], files.filter((each) => each !== found)));
    else for (const table of files) notes.push(await placeTable(table));
    tellAll(notes);
}

function listenForDrops() {
    const body = document.body;
    document.addEventListener('dragover', (event) => {
        event.preventDefault();
        body.classList.add('dropping');
    });
    document.addEventListener('dragleave', (event) => event.relatedTarget === null && body.classList.remove('dropping'));
    document.addEventListener('drop', (event) => {
        event.preventDefault();
        body.classList.remove('dropping');
        takeFiles([...event.dataTransfer.files]);
    });
}
