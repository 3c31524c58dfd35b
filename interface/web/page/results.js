// The whole computation in a worker of its own, which can be stopped, and its report.
const run = { going: false, worker: null, artifacts: null };

function showRunning(going) {
    run.going = going;
    byId('app-run').disabled = going;
    byId('app-stop').hidden = !going;
    byId('app-bar').hidden = !going;
    byId('app-bar').value = 0;
    if (going) byId('app-progress').textContent = 'Computing. Fits of measured impacts take up to a minute.';
}

// The program says "damping: done" after each stage.
function showStage(line) {
    const stage = /^(.*): done$/.exec(line);
    if (!stage || !run.going) return;
    byId('app-bar').value += 1;
    byId('app-progress').textContent = `Computing. Done: ${stage[1].replaceAll('-', ' ')}.`;
}

function stopRun() {
    run.worker?.stop();
    showRunning(false);
    byId('app-progress').textContent = 'Stopped.';
}

// A page as the program writes it, and the text of its style, which the policy of this page admits as a sheet alone.
function parsedPage(text) {
    const [element, style] = /<style>([^]*?)<\/style>/.exec(text);
    return [new DOMParser().parseFromString(text.replace(element, ''), 'text/html'), style];
}

// The report, its head and its provenance at the end left to the downloaded file.
function showReport(text) {
    const [report, style] = parsedPage(text);
    const sheet = new CSSStyleSheet();
    sheet.replaceSync(style);
    document.adoptedStyleSheets = [sheet];
    byId('app-markers').replaceChildren(...(report.querySelector('svg.defs')?.childNodes ?? []));
    byId('app-answers').replaceChildren(...report.querySelectorAll('header .answers, header > .sizes, header > .where'));
    byId('app-report').replaceChildren(...(report.querySelector('main')?.children ?? []));
    readFigures();
}

async function compute() {
    showRunning(true);
    run.worker = new Program(showStage);
    const asked = { document: state.document, files: new Map([...state.files, ['case.json', textOfCase()]]) };
    try {
        const { answer, artifacts } = await run.worker.askOfCase('run', '/results', 'all');
        if (answer.status !== 0) {
            tellError(answer.error);
            byId('app-progress').textContent = '';
            return;
        }
        run.artifacts = artifacts;
        run.document = asked.document;
        run.files = asked.files;
        showStale();
        showReport(artifacts['report.html']);
        hideResults(false);
        byId('app-progress').textContent = 'Done; the results are below.';
        offerWhatIf(artifacts);
        offerTube(artifacts);
        byId('app-results').focus({ preventScroll: true });
        byId('app-results').scrollIntoView({ block: 'start', behavior: 'instant' });
    } catch (error) {
        byId('app-progress').textContent = `The program cannot go on: ${error.message}`;
    } finally {
        run.worker.stop();
        showRunning(false);
    }
}

// Whether the case was changed after its results were computed.
const isStale = () => Boolean(run.artifacts) && state.document === run.document && textOfCase() !== run.files.get('case.json');

function hideResults(hidden) {
    for (const id of ['app-results', 'app-report']) byId(id).hidden = hidden;
}

// After a change the results are those of the case before it.
function showStale() {
    byId('app-stale').hidden = !isStale();
    if (!run.artifacts || state.document === run.document) return;
    run.artifacts = null;
    offerTube(null);
    hideResults(true);
    byId('app-progress').textContent = '';
}

function saveAll() {
    const files = [...(run.files ?? []), ...Object.entries(run.artifacts ?? {}).map(([name, text]) => [`results/${name}`, text]),
        ...Object.entries(tube.files ?? {}).map(([name, text]) => [`tube/${name}`, text])];
    save('ashimpact.zip', zipOf(files), 'application/zip');
    if (!isStale()) keepCase();
}
