// What follows at once, while one types: the program's own messages at their fields, modulus and contact of each sample.
const live = { busy: false, again: false };

// The field of a key that an object lacks: what is allowed there begins with the key's name.
function fieldOfMissing(pointer, allowed) {
    const key = /^"(\w+)"/.exec(allowed ?? '');
    const path = key && `${pointer}/${key[1]}`;
    const isField = path && [...document.querySelectorAll('.wrong[data-path]')].some((wrong) => pathNow(wrong.dataset.path) === path);
    return isField ? path : null;
}

// The place in the case that a message begins with; names in it may hold blanks and colons.
const pointerOf = (error) => /(?:^|: )(\/.*?)(?=: |$)/.exec(error.place ?? '')?.[1];

// Where a message of the program belongs: "case.json: /samples/0/diameter: ..." or "impacts.csv:3: ...".
function placeOf(error) {
    const pointer = pointerOf(error);
    const point = /: point (\d+)$/.exec(error.place);
    if (pointer && point) return `${pointer}/${typedColumns().second}/values/${point[1] - 1}`;
    if (pointer) return fieldOfMissing(pointer, error.allowed) ?? pointer;
    for (const [i, sample] of state.document.samples.entries()) {
        if (sample.composition?.xrd && error.message.startsWith(sample.composition.xrd)) return `/samples/${i}/composition/xrd`;
        if (sample.restitution?.file && error.message.startsWith(sample.restitution.file)) return `/samples/${i}/restitution`;
    }
    return null;
}

// A message for a sample that is not shown is told above, with its name.
function tellError(error) {
    const place = placeOf(error);
    const other = /^\/samples\/(\d+)/.exec(place ?? '');
    const elsewhere = other && Number(other[1]) !== state.sample;
    const found = !elsewhere && tellAtField(place, wordsAtField(error));
    if (!found) tellAtField(null);
    const name = elsewhere ? `Sample ${state.document.samples[Number(other[1])]?.name ?? Number(other[1]) + 1}: ` : '';
    byId('app-problem').textContent = found ? 'Something has to be mended first; it stands in red above.' : name + inThePage(error.message);
    showOld(true);
}

// What a message advises that only the command line has, in words of this page; numbers without the noise of rounding.
const inThePage = (message) => message.replace(/a phase that `ashimpact phases` lists.*$/,
    'a name that the field “Phase” lists: change it in the file, or press “Type the phases instead”. For a phase of your own download case.json, add it there with its modulus under "phases" (docs/case.md), and drop that file here')
    .replace(' without quotes', '').replace(/\d+\.\d{7,}/g, (number) => readable(Number(number), 6));

// At its field a message needs no place within the case; one within a file stays.
function wordsAtField(error) {
    const place = `case.json: ${pointerOf(error)}: `;
    const message = error.message.startsWith(place) ? error.message.slice(place.length) : error.message;
    return inThePage(message.replace(/^point \d+: /, ''));
}

// What was computed before is no answer to what stands there now.
function showOld(old) {
    for (const id of ['app-live', 'app-what-if']) byId(id).classList.toggle('old', old);
}

// Beside each file what was read of it.
function tellRead({ impacts }, artifacts) {
    const tellAt = (path, text) => document.querySelectorAll(`[data-read="${path}"]`).forEach((node) => { node.textContent = text; });
    const modulus = samplesOf(artifacts, '1-modulus.json')[state.sample];
    tellAt('/samples/#/composition/xrd', valueAt('/samples/#/composition/xrd') === undefined ? '' : `Read: ${phasesOf(modulus)}.`);
    const read = impacts?.[state.sample];
    tellAt('/samples/#/restitution', !read ? '' : `Read: ${read.rebounds} ${read.rebounds === 1 ? 'rebound' : 'rebounds'}, ${read.captures} that stayed${read.unknown ? `, ${read.unknown} of unknown outcome left out` : ''}; `
        + `${readable(read.from, 3)} to ${readable(read.to, 3)} m/s.${read.to > 50 ? ' That is fast: is the unit right?' : ''}`);
}

function phasesOf(modulus) {
    const phases = modulus.phases ?? [];
    return phases.map((phase) => `${phase.name} ${readable(100 * (phase.weight_fraction?.value ?? phase.weight_fraction), 3)} %`).join(', ') + ' by weight';
}

function liveTable(artifacts) {
    const [moduli, contacts, analytic] = ['1-modulus.json', '2-contact.json', '3-analytic.json'].map((file) => samplesOf(artifacts, file));
    const cell = (quantity, scale) => make('td', {}, quantity ? readable(quantity.value * scale) : '');
    const body = moduli.map((modulus, i) => make('tr', {}, make('th', { scope: 'row' }, modulus.name), cell(modulus.young_modulus, 1e-9),
        cell(contacts[i].density, 1), cell(contacts[i].contact_modulus, 1e-9), cell(contacts[i].mass, 1e9), cell(analytic[i]?.critical_velocity, 1e3)));
    const heads = ['Sample', 'Young’s modulus [GPa]', 'Density [kg/m3]', 'E* [GPa]', 'Mass [µg]', 'v_c of adhesion alone [mm/s]'];
    return [make('div', { class: 'scroll', role: 'region', tabindex: '0', 'aria-label': 'Modulus and contact of each sample' },
        make('table', {}, make('thead', {}, make('tr', {}, ...heads.map((text) => make('th', { scope: 'col' }, text)))), make('tbody', {}, ...body))),
    make('p', { class: 'hint' }, 'The v_c of adhesion alone is not the answer: it leaves out damping, with which faster particles stick as well, often many times as fast. The answer needs impacts, and comes with “Compute the critical velocity”.')];
}

// Asks for what is not there yet, and whether it had to.
function askForMissing() {
    const missing = missingInputs();
    byId('app-missing').textContent = missing.length ? `Still missing: ${missing.join('; ')}.` : '';
    if (!missing.length) return false;
    byId('app-live').replaceChildren();
    byId('app-what-if').hidden = true;
    byId('app-run').disabled = true;
    return true;
}

async function answerOnce() {
    const { changes } = document.documentElement.dataset;
    const incomplete = askForMissing();
    const { answer, artifacts } = await quick.askOfCase('evaluate', '/at-once', ['0-case.json', '1-modulus.json', '2-contact.json', '3-analytic.json', '4-restitution.json'],
        incomplete ? completedCase() : undefined);
    await showAnswer(answer, artifacts, incomplete);
    document.documentElement.dataset.answered = changes;
}

async function showAnswer(answer, artifacts, incomplete) {
    byId('app-run').disabled = answer.status !== 0 || incomplete || run.going;
    if (answer.status !== 0) {
        tellError(answer.error);
        return;
    }
    tellAtField(null);
    byId('app-problem').textContent = '';
    showOld(false);
    tellRead(answer, artifacts);
    if (incomplete) return;
    byId('app-live').replaceChildren(...liveTable(artifacts));
    await offerWhatIf(run.artifacts && !isStale() ? { ...run.artifacts, ...artifacts, '4-restitution.json': run.artifacts['4-restitution.json'] } : artifacts);
}

// Asks for the newest case; what changed meanwhile is asked for after the answer.
async function answerAtOnce() {
    if (live.busy) {
        live.again = true;
        return;
    }
    live.busy = true;
    do {
        live.again = false;
        try {
            await answerOnce();
        } catch (error) {
            byId('app-problem').textContent = `The program cannot go on: ${error.message}`;
        }
    } while (live.again);
    live.busy = false;
}
