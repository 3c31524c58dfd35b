// Step 2: the wall, what holds the surfaces together, and the laws to compute with.
const laws = [['hertz', 'Hertz'], ['dmt', 'DMT'], ['brach-dunn', 'Brach-Dunn'], ['jkr', 'JKR'], ['maugis-dugdale', 'Maugis-Dugdale'], ['thornton-ning', 'Thornton-Ning'], ['sjkr', 'SJKR']];
const defaultLaws = ['hertz', 'dmt', 'brach-dunn', 'jkr'];
const lawName = (id) => laws.find(([name]) => name === id)?.[1] ?? id;

function chosenLaws() {
    const chosen = valueAt('/laws');
    return Array.isArray(chosen) ? chosen : defaultLaws;
}

function lawChoices() {
    const boxes = laws.map(([id, name]) => {
        const box = make('input', {
            type: 'checkbox', checked: chosenLaws().includes(id), change: () => {
                const others = chosenLaws().filter((each) => each !== id);
                setAt('/laws', box.checked ? laws.map(([each]) => each).filter((each) => each === id || others.includes(each)) : others);
                if (id === 'maugis-dugdale' || id === 'thornton-ning' || id === 'sjkr') keepFocus(showWall);
                changed();
            },
        });
        return make('label', {}, box, name);
    });
    return make('fieldset', { class: 'choices' }, make('legend', {}, 'Contact laws'), ...boxes, wrongAt('/laws'));
}

// What single laws need besides.
function lawParameters() {
    const chosen = chosenLaws();
    return [
        chosen.includes('maugis-dugdale') ? quantityField('Range of cohesion', '/particle/cohesion_range', 'range', 'For Maugis-Dugdale, e.g. 0.4 nm.') : null,
        chosen.includes('thornton-ning') ? quantityField('Yield pressure', '/particle/yield_pressure', 'pressure', 'For Thornton-Ning.') : null,
        chosen.includes('sjkr') ? textField('Cohesion energy density', '/particle/cohesion_energy_density', 'For SJKR, e.g. 20 MJ/m3.') : null,
    ].filter(Boolean);
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
    showForm();
    changed();
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
