// On a tube: what stays of the ash of the last run, as `ashimpact deposit` estimates it from the same files.
const tube = { program: new Program(), sieve: null, files: null, nodes: null };

// Fields by the option of the command line that they are.
const tubeQuantities = [
    ['--tube-diameter', 'Outer diameter of the tube', '38 mm'],
    ['--gas-velocity', 'Velocity of the gas, far upstream', '12 m/s'],
    ['--gas-temperature', 'Temperature of the gas', '900 C'],
    ['--ash-load', 'Ash in the gas', '10 g/m3', 'Without it there are shares alone. At the temperature of the gas; at 0 C: 35 g/Nm3.'],
    ['--gas-viscosity', 'Viscosity of the gas', '46 uPa s', 'Without it that of air.'],
];
const tubeOptional = ['--ash-load', '--gas-viscosity'];

// Distributions of mass: what the program calls them, and the labels and examples of their numbers.
const tubeSizes = {
    'rosin-rammler': ['Rosin-Rammler', ['63.2 % is finer than', '20 um'], ['Exponent', '1.2']],
    'log-normal': ['log-normal, by mass', ['Half is finer than', '20 um'], ['Geometric standard deviation', '1.8']],
    'log-normal, number': ['log-normal, by number', ['Half is finer than', '8 um'], ['Geometric standard deviation', '1.8']],
    one: ['one size', ['Diameter', '20 um']],
    table: ['a sieve table'],
};

function tubeField(option, label, example, hint) {
    const input = make('input', { type: 'text', autocomplete: 'off', 'data-tube': option });
    return fieldAround(label + (tubeOptional.includes(option) ? ' (optional)' : ''), option, [`For example ${example}.`, hint].filter(Boolean).join(' '), input);
}

const tubeText = (option) => document.querySelector(`[data-tube="${option}"]`)?.value.trim() ?? '';

// The fields of a distribution; a table is a file.
function showTubeSizes(kind) {
    const [, ...numbers] = tubeSizes[kind];
    tube.nodes.sizes.replaceChildren(...kind === 'table'
        ? [fileField('Sieve table', '--sizes', tube.sieve?.name, async (file) => {
            tube.sieve = { name: file.name, bytes: new Uint8Array(await file.arrayBuffer()) };
            showTubeSizes(kind);
        })]
        : numbers.map(([label, example], i) => tubeField(`size ${i}`, label, example)));
}

function sizesOfTube() {
    const kind = tube.nodes.kind.value;
    if (kind === 'table') return tube.sieve?.name ?? '';
    const numbers = tubeSizes[kind].slice(1).map((_, i) => tubeText(`size ${i}`));
    if (numbers.includes('')) return '';
    const [name, basis] = kind.split(', ');
    return kind === 'one' ? numbers[0] : `${name}: ${[...numbers, ...(basis ? [basis] : [])].join(', ')}`;
}

// The options of the command; texts, as they were typed.
function tubeOptions() {
    const typed = { '--sizes': sizesOfTube(), '--assumption': tube.nodes.assumption.value };
    for (const [option] of tubeQuantities) typed[option] = tubeText(option);
    return Object.fromEntries(Object.entries(typed).filter(([, text]) => text !== ''));
}

function buildTube() {
    const kind = makeSelect({ id: 'app-tube-kind', change: () => showTubeSizes(kind.value) }, Object.entries(tubeSizes).map(([name, [title]]) => [name, title]), 'rosin-rammler');
    const assumption = make('select', { id: 'app-tube-assumption' });
    const sizes = make('div', { class: 'fields' });
    const answer = make('div', { id: 'app-tube-answer' });
    const save = [['Download deposit.html', () => saveOfTube('deposit.html', 'text/html')], ['Download deposit.json', () => saveOfTube('deposit.json', 'application/json')]]
        .map(([words, click]) => make('button', { type: 'button', click }, words));
    tube.nodes = { kind, assumption, sizes, answer, told: make('p', { class: 'told', role: 'status' }), problem: make('p', { class: 'problem', role: 'alert' }), saved: make('p', { class: 'buttons', hidden: true }, ...save) };
    const example = () => {
        for (const input of document.querySelectorAll('[data-tube]')) input.value = /^For example (.*?)\.(?: |$)/.exec(input.closest('.field').querySelector('.hint').textContent)[1];
        for (const option of tubeOptional.slice(1)) document.querySelector(`[data-tube="${option}"]`).value = '';
    };
    byId('app-tube-body').append(
        make('div', { class: 'fields' }, ...tubeQuantities.map((each) => tubeField(...each))),
        make('div', { class: 'fields' }, fieldAround('Sizes of the ash', '--sizes', 'A distribution of mass.', kind),
            fieldAround('Critical velocity of sizes that were not measured', '--assumption', 'The answer states how much the assumption matters.', assumption)),
        sizes,
        make('p', { class: 'buttons' }, make('button', { type: 'button', id: 'app-tube-run', class: 'first', click: computeTube }, 'Estimate what stays on the tube'),
            make('button', { type: 'button', class: 'small', click: example }, 'Fill in an example of a tube')),
        tube.nodes.problem, tube.nodes.told, tube.nodes.saved, answer);
    showTubeSizes(kind.value);
}

// Offers a tube for the artifacts of a run; none takes it away. What was estimated was of another run.
function offerTube(artifacts) {
    if (!tube.nodes) buildTube();
    tube.files = null;
    tube.program.stop();
    byId('app-tube').hidden = !artifacts;
    tube.nodes.saved.hidden = true;
    tube.nodes.answer.replaceChildren();
    for (const name of ['told', 'problem']) tube.nodes[name].textContent = '';
    const rows = artifacts && resultOf(artifacts, 'comparison.json')?.by_size;
    const named = [...new Set((rows ?? []).map((row) => row.assumption))].filter((name) => !['measured', 'adhesion-alone'].includes(name));
    fillSelect(tube.nodes.assumption, [['', 'by the first that the impacts admit'], ...named.map((name) => [name, `by ${name.replaceAll('-', ' ')}`])], '');
}

function missingOfTube(options) {
    const needed = [...tubeQuantities.filter(([option]) => !tubeOptional.includes(option)), ['--sizes', 'Sizes of the ash']];
    return needed.filter(([option]) => options[option] === undefined).map(([, label]) => label.toLowerCase());
}

function showTube(text) {
    const [page] = parsedPage(text);
    tube.nodes.answer.replaceChildren(...page.querySelectorAll('header .answers, header > p:not(.kind), figure, #warnings ul'));
    readFigures();
}

async function computeTube() {
    const { nodes } = tube;
    const options = tubeOptions();
    const missing = missingOfTube(options);
    tellAtField(null);
    nodes.problem.textContent = missing.length ? `Still missing: ${missing.join('; ')}.` : '';
    if (missing.length) return;
    const artifacts = run.artifacts;
    const files = Object.entries(artifacts).filter(([name]) => name.endsWith('.json')).map(([name, text]) => [`results/${name}`, text]);
    if (options['--sizes'] === tube.sieve?.name) files.push([tube.sieve.name, tube.sieve.bytes]);
    nodes.told.textContent = 'Estimating. This takes some seconds.';
    byId('app-tube-run').disabled = true;
    try {
        const { answer, artifacts: written } = await tube.program.ask({ name: 'deposit', files, words: [JSON.stringify({ run: 'results', ...options }), 'tube'], read: 'all' });
        if (run.artifacts !== artifacts) return;
        if (answer.status !== 0) {
            if (!tellAtField(answer.error.place, answer.error.message.replace(`${answer.error.place}: `, ''))) nodes.problem.textContent = answer.error.message;
            return;
        }
        tube.files = written;
        nodes.saved.hidden = false;
        showTube(written['deposit.html']);
    } catch (error) {
        nodes.problem.textContent = `The program cannot go on: ${error.message}`;
    } finally {
        nodes.told.textContent = '';
        byId('app-tube-run').disabled = false;
    }
}

const saveOfTube = (name, type) => save(name, tube.files[name], type);
