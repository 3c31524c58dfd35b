// Step 2: the wall, what holds the surfaces together, and the laws to compute with.
const { laws } = embedded;
const lawName = (id) => laws[id]?.title ?? id;

function chosenLaws() {
    const chosen = valueAt('/laws');
    return Array.isArray(chosen) ? chosen : lawsByDefault();
}

function lawChoices() {
    const boxes = Object.entries(laws).map(([id, { title, parameters }]) => makeBox(title, chosenLaws().includes(id), (checked) => {
        const others = chosenLaws().filter((each) => each !== id);
        setAt('/laws', checked ? Object.keys(laws).filter((each) => each === id || others.includes(each)) : others);
        if (parameters.length) keepFocus(showWall);
        changed();
    }));
    return make('fieldset', { class: 'choices' }, make('legend', {}, 'Contact laws'), ...boxes, wrongAt('/laws'));
}

// The kind of a law's parameter: its units are that of the example and those of quantities alike.
function kindOfParameter({ name, unit, example }) {
    const alike = Object.keys(inSi).find((kind) => inSi[kind] === unit);
    units[name] ??= unit === '1' ? ['1'] : [...new Set([example.replace(/^\S+ /, ''), ...(units[alike] ?? [unit])])];
    inSi[name] = unit;
    return name;
}

// The field of a parameter. Of alternatives it is the one that the case states, else the last; another one begins with its
// example.
function parameterFields(alternatives, titles) {
    const pathOf = ({ name }) => `/particle/${name}`;
    const shown = alternatives.find((each) => valueAt(pathOf(each)) !== undefined) ?? alternatives.at(-1);
    const choose = (name) => {
        for (const each of alternatives) setAt(pathOf(each), undefined);
        const chosen = alternatives.find((each) => each.name === name);
        const { number, unit } = partsOf(chosen.example, kindOfParameter(chosen), '1');
        setAt(pathOf(chosen), writtenQuantity(undefined, number, unit));
        changedForm();
    };
    const field = quantityField(shown.description, pathOf(shown), kindOfParameter(shown), `For ${titles}, e.g. ${shown.example}.`);
    if (alternatives.length === 1) return [field];
    return [choiceField(`Known for ${titles}`, '/particle', alternatives.map(({ name, description }) => [name, description]), shown.name, choose), field];
}

// What the chosen laws take besides, each parameter once.
function lawParameters() {
    const groups = new Map();
    for (const { title, parameters } of chosenLaws().map((id) => laws[id]).filter((law) => law?.parameters))
        for (const { name, choice } of parameters) {
            const alternatives = parameters.filter((each) => each.name === name || (choice && each.choice === choice));
            const { titles } = groups.get(alternatives[0].name) ?? { titles: new Set() };
            groups.set(alternatives[0].name, { alternatives, titles: titles.add(title) });
        }
    return [...groups.values()].flatMap(({ alternatives, titles }) => parameterFields(alternatives, [...titles].join(' and ')));
}

function exampleWall() {
    const { wall, work_of_adhesion: adhesion } = parseJson(embedded.example['case.json']);
    setAt('/wall', wall);
    setAt('/work_of_adhesion', adhesion);
}

// What a particle may meet. Two spheres meet without a wall.
const bodies = [['elastic', 'an elastic wall'], ['rigid', 'a rigid wall'], ['sphere', 'a second sphere']];

function chooseBody(kind) {
    setAt('/partner', kind === 'sphere' ? { diameter: '88 um', density: '2600 kg/m3', young_modulus: '100 GPa', poisson_ratio: 0.2 } : undefined);
    setAt('/wall', kind === 'sphere' ? undefined : kind === 'rigid' ? { rigid: true } : assumedSteel());
    changedForm();
}

function partnerFields() {
    return [quantityField('Diameter of the second sphere', '/partner/diameter', 'length'),
        quantityField('Density of the second sphere', '/partner/density', 'density'),
        quantityField('Young’s modulus of the second sphere', '/partner/young_modulus', 'pressure'),
        quantityField('Poisson ratio of the second sphere', '/partner/poisson_ratio', 'ratio')];
}

function wallFields() {
    const wall = valueAt('/wall');
    const rigid = wall?.rigid === true;
    const sphere = valueAt('/partner') !== undefined;
    const choice = choiceField('The particle meets', '/wall', bodies, sphere ? 'sphere' : rigid ? 'rigid' : 'elastic', chooseBody);
    if (sphere) return [choice, ...partnerFields()];
    if (wall?.contact_modulus !== undefined) return [quantityField('Contact modulus E*', '/wall/contact_modulus', 'pressure')];
    return rigid ? [choice] : [choice,
        quantityField('Young’s modulus of the wall', '/wall/young_modulus', 'pressure', 'Stainless steel 193 GPa, glass 70 GPa, copper 120 GPa.'),
        quantityField('Poisson ratio of the wall', '/wall/poisson_ratio', 'ratio', 'Stainless steel 0.29, glass 0.22, copper 0.34.')];
}

function adhesionField() {
    const adhesion = valueAt('/work_of_adhesion');
    const other = valueAt('/partner') === undefined ? 'wall' : 'partner';
    if (isObject(adhesion) && adhesion.surface_energies)
        return [quantityField('Surface energy of the particle', '/work_of_adhesion/surface_energies/particle', 'adhesion'),
            quantityField(`Surface energy of the ${other === 'wall' ? 'wall' : 'second sphere'}`, `/work_of_adhesion/surface_energies/${other}`, 'adhesion')];
    return [quantityField('Work of adhesion w', '/work_of_adhesion', 'adhesion', 'The energy to part unit area of particle and wall.')];
}

function showWall() {
    byId('app-wall').replaceChildren(
        make('div', { class: 'fields' }, ...wallFields(), ...adhesionField(), ...lawParameters()),
        lawChoices(), exampleButton('a steel wall', exampleWall));
}
