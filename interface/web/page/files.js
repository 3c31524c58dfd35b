// Files that come in by drop or choice. What a file is, its place or its content tells.
const mostBytes = 200e6;

function tell(text, bad) {
    byId('app-told').textContent = text;
    byId('app-told').classList.toggle('bad', Boolean(bad));
}

const startOf = (bytes) => new TextDecoder().decode(bytes.subarray(0, 20000));

// 'case', 'xrd' or 'impacts' of a file that was not put at a field.
function kindOfFile(name, bytes) {
    const start = startOf(bytes);
    if (/\.json$/i.test(name)) return /"(weight_fractions|phases)"/.test(start) && !/"samples"/.test(start) ? 'xrd' : 'case';
    if (/impact|veloc|rebound|bounce/i.test(name)) return 'impacts';
    const heading = start.split('\n', 40).filter((line) => !line.startsWith('#')).slice(0, 3).join('\n');
    return /veloc|v_in|v_r|rebound|restitution/i.test(heading) ? 'impacts' : 'xrd';
}

// A case replaces the one in the page, with the files that came along.
async function takeCase(name, bytes, others) {
    const files = new Map([...state.files, ...others]);
    const { answer } = await quick.ask({ name: 'validate', files: [...others, [name, bytes]], words: [name] });
    let document = null;
    try {
        document = JSON.parse(new TextDecoder('utf-8', { fatal: true }).decode(bytes));
    } catch { /* the program has said so */ }
    if (!isCase(document)) {
        tell(answer.status === 0 ? `${name}: is no case that this page can show` : answer.error.message, true);
        return;
    }
    openCase(document, files);
    showForm();
    tell(`${name} is open.`);
}

// One file for a field of the sample that is shown.
async function takeFile(file, kind) {
    if (file.size > mostBytes) {
        tell(`${file.name}: is larger than ${mostBytes / 1e6} MB`, true);
        return;
    }
    let bytes;
    try {
        bytes = new Uint8Array(await file.arrayBuffer());
    } catch {
        tell(`${file.name}: cannot be read; is it a folder?`, true);
        return;
    }
    const name = file.name.replaceAll(/[/\\]/g, '_');
    tell(`${name} is taken as ${kind === 'xrd' ? 'the XRD result' : 'the measured impacts'} of the sample ${sampleNow().name ?? ''}.`);
    if (kind === 'xrd') takeXrd(name, bytes);
    else takeImpacts(name, bytes);
}

// Any number of files at once: with a case among them the others are what it names.
async function takeFiles(list) {
    tell('');
    const files = [];
    for (const file of list) {
        if (file.size > mostBytes) {
            tell(`${file.name}: is larger than ${mostBytes / 1e6} MB`, true);
            return;
        }
        try {
            files.push([file.name, new Uint8Array(await file.arrayBuffer()), file]);
        } catch {
            tell(`${file.name}: cannot be read; is it a folder?`, true);
            return;
        }
    }
    const found = files.find(([name, bytes]) => kindOfFile(name, bytes) === 'case');
    if (found) await takeCase(found[0], found[1], files.filter((each) => each !== found).map(([name, bytes]) => [name, bytes]));
    else for (const [name, bytes, file] of files) await takeFile(file, kindOfFile(name, bytes));
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
