// Files that come in by drop or choice. What a file is, its place or its content tells.
const mostBytes = 200e6;

function tell(text, bad) {
    byId('app-told').textContent = text;
    byId('app-told').classList.toggle('bad', Boolean(bad));
}

const startOf = (bytes) => new TextDecoder().decode(bytes.subarray(0, 20000));

// Whether JSON is a case; else it is taken as an XRD result.
function isCaseFile(name, bytes) {
    const start = startOf(bytes);
    return /\.json$/i.test(name) && (/"samples"/.test(start) || !/"(weight_fractions|phases)"/.test(start));
}

// 'xrd', 'impacts' or 'none' of a file that was not put at a field: what the program reads it as, else what it looks like.
async function kindOfTable(name, bytes) {
    const { answer } = await quick.ask({ name: 'kind', files: [['dropped', bytes]], words: ['dropped'] });
    if (answer.kind === 'xrd' || answer.kind === 'impacts') return answer.kind;
    if (/\.(png|jpe?g|gif|tiff?|bmp|pdf|docx?|mp4|avi)$/i.test(name)) return 'none';
    if (/impact|veloc|rebound|bounce/i.test(name)) return 'impacts';
    const heading = startOf(bytes).split('\n', 40).filter((line) => !line.startsWith('#')).slice(0, 3).join('\n');
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
async function takeFile(file, kind, toldBefore = '') {
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
    tell(`${toldBefore} ${name} is taken as ${kind === 'xrd' ? 'the XRD result' : 'the measured impacts'} of ${sampleNow().name ?? 'the sample'}.`.trim());
    if (kind === 'xrd') takeXrd(name, bytes);
    else takeImpacts(name, bytes);
}

// A table goes where the program reads it; a picture or the like goes nowhere.
async function takeTable(name, bytes, file) {
    const kind = await kindOfTable(name, bytes);
    if (kind === 'none') tell(`${byId('app-told').textContent} ${name} is neither an XRD result nor a table of impacts; it is left out.`.trim(), true);
    else await takeFile(file, kind, byId('app-told').textContent);
}

// A table with its heading from the clipboard is a file like any other.
function takePasted(text, kind) {
    const name = `${kind === 'xrd' ? 'ash' : 'impacts'}-pasted-${state.sample + 1}.csv`;
    return takeFile(new File([text], name), kind);
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
    const found = files.find(([name, bytes]) => isCaseFile(name, bytes));
    if (found) await takeCase(found[0], found[1], files.filter((each) => each !== found).map(([name, bytes]) => [name, bytes]));
    else for (const [name, bytes, file] of files) await takeTable(name, bytes, file);
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
