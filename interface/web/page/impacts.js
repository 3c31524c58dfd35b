// Step 3: impacts measured with this sample, as a file or typed.
const columnOfTable = (name) => valueAt(`/samples/#/restitution/${name}`);

function takeImpacts(name, bytes) {
    state.files.set(name, bytes);
    setAt('/samples/#/restitution', { file: name });
}

const mostRows = 2000;

// The impacts of a file as what is typed; nothing where they cannot be read or are too many to be typed. Their uncertainties
// stay in the file.
async function rowsOf(file) {
    if (file === undefined) return undefined;
    const { answer } = await quick.ask({ name: 'impacts', files: [['dropped', state.files.get(file)]], words: ['dropped'] });
    if (answer.status !== 0 || answer.velocity.values.length > mostRows) return undefined;
    if (answer.velocity_uncertainty) tell(`The uncertainties that ${file} states do not come along.`, true);
    return { velocity: answer.velocity, rebound_velocity: answer.rebound_velocity };
}

function exampleImpacts() {
    takeImpacts('impacts.csv', new TextEncoder().encode(embedded.example['impacts.csv']));
}

// Words for a particle that stayed, typed in the place of its rebound; files are read with more of them.
const stayed = /^(stuck|sticks?|sticking|captured?|deposit(ed)?|adhere[sd]|no rebound|(ge)?haftet|klebt(e)?|bleibt|collé|reste)$/i;

const listOf = (column) => (Array.isArray(column) ? column : Array.isArray(column?.values) ? column.values : []);
const unitOf = (column, otherwise) => (typeof column?.unit === 'string' ? column.unit : otherwise);

// Rows [v_in, v_r or e] of the case; which of the two stands in the second column is that of the case.
function typedColumns() {
    const second = columnOfTable('restitution') !== undefined ? 'restitution' : 'rebound_velocity';
    const [first, other] = [columnOfTable('velocity'), columnOfTable(second)];
    const values = listOf(other);
    return { second, unit: unitOf(first, 'm/s'), otherUnit: unitOf(other, 'm/s'), rows: listOf(first).map((value, i) => [String(value), String(values[i] ?? '')]) };
}

function impactTable() {
    const { second, unit, otherUnit, rows } = typedColumns();
    const chosen = { unit, otherUnit };
    const number = (text) => (isNumber(text) ? Number(text) : stayed.test(text) ? 0 : text);
    const places = (all) => {
        let at = -1;
        return all.map((row) => (isFilled(row) ? (++at, ['velocity', second].map((name) => `/samples/#/restitution/${name}/values/${at}`)) : []));
    };
    let last = rows;
    const isFilled = (row) => row.some((text) => text !== '');
    const typed = (all) => {
        last = all.filter(isFilled);
        const column = (i, of) => ({ values: last.map((row) => number(row[i])), unit: of });
        const before = valueAt('/samples/#/restitution');
        const kept = isObject(before) && !before.file && !before.reconstruct ? before : {};
        setAt('/samples/#/restitution', last.length === 0 ? undefined
            : { ...kept, velocity: column(0, chosen.unit), [second]: column(1, second === 'restitution' ? '1' : chosen.otherUnit) });
        changed();
    };
    const takeUnit = (keys) => (choice) => {
        for (const key of keys) chosen[key] = choice;
        typed(last);
    };
    // One unit for both, unless the case that was opened has two.
    const alike = unit === otherUnit;
    const other = second === 'restitution' ? 'Restitution e' : 'Rebound velocity';
    return typingGrid({
        caption: 'Measured impacts', columns: [{ title: 'Velocity', heading: () => `v_in [${chosen.unit}]` }, { title: other, heading: () => (second === 'restitution' ? 'e_n' : `v_r [${chosen.otherUnit}]`) }], rows, typed, places, takeTable: (text) => takePasted(text, 'impacts'),
        heads: [unitChoice('velocity', chosen.unit, 'Unit of the velocities', takeUnit(alike ? ['unit', 'otherUnit'] : ['unit'])),
            second === 'restitution' || alike ? null : unitChoice('velocity', chosen.otherUnit, 'Unit of the rebound velocities', takeUnit(['otherUnit']))],
    });
}

function cameraFields() {
    return make('details', { open: valueAt('/camera') !== undefined }, make('summary', {}, 'Camera: frame rate and pixel size give the uncertainty of velocities that state none'),
        make('div', { class: 'fields' },
            quantityField('Frames per second', '/camera/frame_rate', 'rate'),
            quantityField('Size of a pixel', '/camera/pixel_size', 'length', 'In the plane of the particle.'),
            quantityField('Frames for each velocity', '/camera/frames', 'rate')));
}

function fitFields() {
    const robust = makeBox('A few wrong impacts are given little weight', valueAt('/fit/robust') === true, (checked) => {
        setAt('/fit/robust', checked || undefined);
        changed();
    });
    return make('details', { open: valueAt('/fit') !== undefined }, make('summary', {}, 'Fit: outliers, and sizes that differ'),
        make('fieldset', { class: 'choices' }, make('legend', {}, 'Outliers'), robust, wrongAt('/fit/robust')),
        make('div', { class: 'fields' }, quantityField('Scatter of the diameters', '/fit/size_scatter', 'ratio',
            'Standard deviation of single particles over their mean, e.g. 0.05. Left empty: found from the impacts.')));
}

function showImpacts() {
    const impacts = valueAt('/samples/#/restitution');
    const file = impacts?.file;
    const reconstructed = isObject(impacts?.reconstruct);
    const typeInstead = stepButton('Type the impacts instead', async () => setAt('/samples/#/restitution', await rowsOf(file)));
    byId('app-impacts').replaceChildren(...[
        make('p', {}, 'Velocities before and after single impacts, typed or pasted. A rebound of 0, or the word “stuck”, is a particle that stayed. Without impacts there is no damping, and no dynamic critical velocity.'),
        make('div', { class: 'fields' }, fileField('Measured impacts', '/samples/#/restitution', file, (chosen) => chooseFile(chosen, 'impacts'))),
        reconstructed ? make('p', { class: 'hint' }, 'The impacts of this sample are reconstructed from published fits.') : null,
        file === undefined && !reconstructed ? impactTable() : make('p', { class: 'buttons' }, typeInstead),
        cameraFields(), fitFields(), exampleButton('measured impacts', exampleImpacts)].filter(Boolean));
}

// What a reader knows a control by; the same after the form is made anew.
const nameOfControl = (control) => `${control.tagName} ${control.labels?.[0]?.textContent ?? control.getAttribute('aria-label') ?? control.textContent}`;

// Makes a part of the form anew, and leaves the focus where it was.
function keepFocus(work) {
    const control = document.activeElement;
    const section = control?.closest('#app-form > *');
    const name = section && nameOfControl(control);
    work();
    if (!section || control.isConnected) return;
    const controls = [...section.querySelectorAll('input, select, button')];
    (controls.find((each) => nameOfControl(each) === name) ?? controls[0])?.focus();
}

// After a change that makes other fields.
function changedForm() {
    showForm();
    changed();
}

function showForm() {
    keepFocus(() => {
        showSamples();
        showAsh();
        showWall();
        showImpacts();
    });
}
