// Puts the page together.
function openEmbedded(name) {
    const files = Object.entries(embedded[name]).filter(([file]) => file !== 'case.json').map(([file, text]) => [file, new TextEncoder().encode(text)]);
    openCase(name === 'paper' ? 'Open the paper’s case' : 'Open the example', parseJson(embedded[name]['case.json']), new Map(files));
    tell(name === 'paper' ? 'The three sieve sizes of Dong et al. 2013 are open.' : 'The example is open: two sieve sizes with invented numbers.');
}

function begin() {
    if (typeof DecompressionStream === 'undefined' || typeof WebAssembly === 'undefined') {
        tell('This browser is too old for this page: it needs one of 2023 or later.', true);
        return;
    }
    document.body.append(make('datalist', { id: 'app-phases' }, ...embedded.phases.map((name) => make('option', { value: name }))));
    openCase('', emptyCase(), new Map());
    watchers.push(afterPause(80, answerAtOnce), showStale, () => {
        byId('app-sample').selectedOptions[0].textContent = String(sampleNow().name ?? '');
    });
    byId('app-files').addEventListener('change', (event) => takeFiles([...event.target.files]).then(() => { event.target.value = ''; }));
    byId('app-form').addEventListener('submit', (event) => event.preventDefault());
    listen({
        'app-example': () => openEmbedded('example'),
        'app-paper': () => openEmbedded('paper'),
        'app-new': () => {
            openCase('Begin anew', emptyCase(), new Map());
            tell('A new case.');
        },
        'app-run': compute,
        'app-stop': stopRun,
        'app-save-report': () => save('report.html', run.artifacts['report.html'], 'text/html'),
        'app-save-case': () => {
            save('case.json', textOfCase(), 'application/json');
            keepCase();
        },
        'app-save-all': saveAll,
    });
    listenForDrops();
    listenToHistory();
    // For a browser's console: the functions of the program that take texts, as docs/web.md lists them.
    window.ashimpact = { ask: async (name, ...words) => (await quick.ask({ name, words })).answer };
    changed();
}
begin();
