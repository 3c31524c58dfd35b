// Step 1: which sample, and what it is made of.
const amorphousChoices = (hasFile) => [
    ['', hasFile ? 'as the file says' : 'not stated yet'], ['remainder', 'all that is missing to 100 %'], ['none', 'none'], ['fraction', 'a fraction, typed below'],
];

function amorphousChosen(amorphous) {
    if (amorphous === undefined) return '';
    return amorphous === 'remainder' || amorphous === 'none' ? amorphous : 'fraction';
}

function weightRows() {
    const fractions = valueAt('/samples/#/composition/weight_fractions');
    return Object.entries(isObject(fractions) ? fractions : {}).filter(([name]) => !name.startsWith('//')).map(([name, fraction]) => {
        const { number, unit } = shownQuantity(fraction, 'fraction');
        if (unit === '1' && isNumber(number)) return [name, String(Number((Number(number) * 100).toPrecision(12)))];
        return [name, unit === '%' || number === '' ? number : `${number} ${unit === '1' ? 'of 1' : unit}`];
    });
}

// A fraction to begin with: what typed phases leave; empty where none are typed.
function likelyAmorphous() {
    const left = 100 - weightRows().reduce((sum, [, percent]) => sum + (Number(percent) || 0), 0);
    return left > 0 && left < 100 ? `${readable(left)} %` : '';
}

// A fraction that is not typed anew stays as the case has it. The program refuses a second row of a phase.
function typedWeights(rows) {
    const fractions = {};
    const shown = Object.fromEntries(weightRows());
    const stated = valueAt('/samples/#/composition/weight_fractions');
    for (const [name, fraction] of rows.filter((row) => row.some((text) => text !== ''))) {
        const typed = fraction === '' ? '' : `${fraction} %`;
        if (Object.hasOwn(fractions, name)) fractions[name] = `${typed} (a second row of ${name})`;
        else fractions[name] = shown[name] === fraction ? stated[name] : typed;
    }
    setAt('/samples/#/composition/weight_fractions', fractions);
    changed();
}

// What is missing to 100 % of a typed table is not the glass of a file: there the program asks for it.
function takeXrd(name, bytes) {
    state.files.set(name, bytes);
    const { amorphous, xrd } = valueAt('/samples/#/composition') ?? {};
    const stays = amorphous !== undefined && (xrd !== undefined || amorphous !== 'remainder');
    setAt('/samples/#/composition', { xrd: name, ...(stays ? { amorphous } : {}) });
}

function exampleAsh() {
    state.files.set('ash.csv', new TextEncoder().encode(embedded.example['ash.csv']));
    setAt('/samples/#/diameter', '88 um');
    setAt('/samples/#/density', '2300 kg/m3');
    setAt('/samples/#/composition', { xrd: 'ash.csv', xrd_sample: 'fine', amorphous: '47 %' });
}

function compositionFields() {
    const composition = valueAt('/samples/#/composition');
    const amorphous = composition?.amorphous;
    const file = composition?.xrd;
    const parts = [
        fileField('XRD result', '/samples/#/composition/xrd', file, (chosen) => chooseFile(chosen, 'xrd')),
        file === undefined ? null : textField('Sample in the file', '/samples/#/composition/xrd_sample', 'Needed only where the file has several.'),
        choiceField('Amorphous (glass)', '/samples/#/composition/amorphous', amorphousChoices(file !== undefined), amorphousChosen(amorphous), (choice) => {
            setAt('/samples/#/composition/amorphous', choice === 'fraction' ? likelyAmorphous() : choice || undefined);
            changedForm();
        }, 'Diffraction does not see glass: say how much there is.'),
    ];
    if (amorphousChosen(amorphous) === 'fraction') parts.push(quantityField('Amorphous fraction', '/samples/#/composition/amorphous', 'fraction'));
    return parts;
}

function weightTable() {
    const path = '/samples/#/composition/weight_fractions';
    const file = valueAt('/samples/#/composition/xrd');
    const table = typingGrid({
        caption: 'Weight fractions', columns: [{ title: 'Phase', heading: () => 'Phase', name: 'name', list: 'app-phases' }, { title: 'Weight [%]', heading: () => 'Weight [%]' }],
        rows: weightRows(), typed: typedWeights, takeTable: (text) => takePasted(text, 'xrd'),
        places: (rows) => rows.map(([name]) => [name, name].map((key) => `${path}/${pointerPart(key)}`)),
    });
    const wrong = wrongAt(path);
    if (file === undefined) return make('div', {}, make('p', { class: 'hint' }, 'Or type or paste the phases and their weight fractions:'), table, wrong);
    return make('p', { class: 'buttons' }, stepButton('Type the phases instead', () => {
        const kept = valueAt('/samples/#/composition/amorphous');
        setAt('/samples/#/composition', { weight_fractions: {}, ...(kept === undefined ? {} : { amorphous: kept }) });
    }), wrong);
}

function showAsh() {
    byId('app-ash').replaceChildren(
        make('div', { class: 'fields' },
            textField('Name of the study', '/name'),
            textField('Name of the sample', '/samples/#/name'),
            quantityField('Particle diameter', '/samples/#/diameter', 'length'),
            quantityField('Particle density', '/samples/#/density', 'density', 'With its pores. Left empty: that of the phases.'),
            ...compositionFields()),
        weightTable(), exampleButton('an ash', exampleAsh));
}

// The choice among samples, and their number.
function showSamples() {
    const choose = (event) => {
        state.sample = Number(event.target.value);
        changedForm();
    };
    const names = state.document.samples.map((sample, i) => [i, String(sample.name ?? `sample ${i + 1}`)]);
    const select = makeSelect({ id: 'app-sample', change: choose }, names, state.sample);
    const add = () => {
        state.document.samples.push(emptySample(`sample ${state.document.samples.length + 1}`));
        state.sample = state.document.samples.length - 1;
    };
    const remove = () => {
        state.document.samples.splice(state.sample, 1);
        state.sample = 0;
        state.units = new Map();
    };
    byId('app-samples').replaceChildren(make('label', { for: 'app-sample' }, 'Sample'), select,
        stepButton('Add a sample', add), stepButton('Remove this sample', remove, { disabled: state.document.samples.length < 2 }));
}
