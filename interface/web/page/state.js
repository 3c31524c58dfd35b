// What the page knows: the case as the JSON document that is saved, the files it names, and by path the units chosen for
// fields.
const state = { document: null, files: new Map(), sample: 0, units: new Map() };

// JSON with comments, as the program reads it.
const parseJson = (text) => JSON.parse(text.replace(/"(?:[^"\\]|\\.)*"|\/\/[^\n]*|\/\*[^]*?\*\//g, (part) => (part[0] === '"' ? part : '')));

const isObject = (value) => typeof value === 'object' && value !== null && !Array.isArray(value);

// The laws of a case that names none.
const lawsByDefault = () => Object.keys(embedded.laws).filter((law) => embedded.laws[law].by_default);

// A case to begin with: a wall of stainless steel, a work of adhesion and the range of the cohesion, all stated as assumed,
// and nothing of the ash.
const assumedSteel = () => ({ young_modulus: { value: 193, unit: 'GPa', origin: 'assumed' }, poisson_ratio: { value: 0.29, unit: '1', origin: 'assumed' } });
function emptyCase() {
    return {
        name: 'Fly ash on a wall',
        wall: assumedSteel(),
        work_of_adhesion: { value: 0.3, unit: 'J/m2', origin: 'assumed' },
        particle: { cohesion_range: { value: 0.4, unit: 'nm', origin: 'assumed' } },
        laws: lawsByDefault(),
        samples: [emptySample('sample 1')],
    };
}
function emptySample(name) {
    return { name, composition: { weight_fractions: {} } };
}

// Whether a document has the outline that the form can show; what is wrong inside is told at its field.
function isCase(document) {
    return isObject(document) && Array.isArray(document.samples) && document.samples.length > 0 && document.samples.every(isObject);
}

function hasAsh({ composition }) {
    const { weight_fractions: fractions, ...other } = isObject(composition) ? composition : {};
    return !isObject(composition) || Object.keys(other).some((key) => key !== 'amorphous') || (isObject(fractions) && Object.keys(fractions).length > 0);
}

const hasLaws = () => !Array.isArray(state.document.laws) || state.document.laws.length > 0;

// What the case lacks before it can be computed at all, in words; nothing wrong, as long as nobody has typed it.
function missingInputs() {
    const ofSamples = state.document.samples.flatMap((sample) => {
        const parts = [sample.diameter === undefined && 'the particle diameter', !hasAsh(sample) && 'an XRD result or typed phases'].filter(Boolean);
        return parts.length ? [`${sample.name ?? 'sample'}: ${parts.join(' and ')}`] : [];
    });
    return hasLaws() ? ofSamples : [...ofSamples, 'a contact law'];
}

// The case with something in the place of what is missing, so that all the rest of it can be read and judged already.
function completedCase() {
    const samples = state.document.samples.map((sample) => (
        { ...sample, diameter: sample.diameter ?? '1 um', ...(hasAsh(sample) ? {} : { composition: { weight_fractions: { quartz: 1 }, amorphous: 'none' } }) }));
    return JSON.stringify({ ...state.document, samples, ...(hasLaws() ? {} : { laws: lawsByDefault().slice(0, 1) }) });
}

const sampleNow = () => state.document.samples[state.sample];

// A path is written as in the program's messages, "/samples/#/diameter"; "#" is the sample that is shown.
const pathNow = (path) => path.replace('#', state.sample);
const pointerPart = (key) => key.replaceAll('~', '~0').replaceAll('/', '~1');
const keysOf = (path) => pathNow(path).split('/').slice(1);

function valueAt(path) {
    return keysOf(path).reduce((inner, key) => (inner === null || inner === undefined ? undefined : inner[key]), state.document);
}

// Sets what stands at a path; undefined takes it away, and with it the objects that are left empty.
function setAt(path, value) {
    const keys = keysOf(path);
    const last = keys.pop();
    let inner = state.document;
    for (const key of keys) {
        if (typeof inner[key] !== 'object' || inner[key] === null) {
            if (value === undefined) return;
            inner[key] = {};
        }
        inner = inner[key];
    }
    if (value === undefined) delete inner[last];
    else inner[last] = value;
    if (value === undefined && keys.length > 0 && isObject(inner) && Object.keys(inner).length === 0) setAt('/' + keys.join('/'), undefined);
}

// Calls every function that was told to watch the case. How often it changed stands at the root of the page, as does how
// many of the changes are answered.
const watchers = [];
function changed() {
    document.documentElement.dataset.changes = String(Number(document.documentElement.dataset.changes ?? 0) + 1);
    watchers.forEach((watcher) => watcher());
}

const textOfCase = () => JSON.stringify(state.document, null, 2) + '\n';

// Another case in the place of this one, which can be undone by the name of what was done.
function openCase(what, document, files) {
    if (state.document) remember(what);
    state.document = document;
    state.files = files;
    state.sample = 0;
    state.units = new Map();
    keepCase();
    changedForm();
}
