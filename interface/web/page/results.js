// The whole computation in a worker of its own, which can be stopped, and its report.
const run = { going: false, worker: null, artifacts: null, clock: 0 };

function showRunning(going) {
    run.going = going;
    byId('app-run').disabled = going;
    byId('app-stop').hidden = !going;
    clearInterval(run.clock);
    const begin = Date.now();
    const tell = () => {
        byId('app-progress').textContent = `Computing for ${Math.round((Date.now() - begin) / 1000)} s. Fits of measured impacts take up to a minute.`;
    };
    if (going) {
        tell();
        run.clock = setInterval(tell, 5000);
    }
}

function stopRun() {
    run.worker?.stop();
    showRunning(false);
    byId('app-progress').textContent = 'Stopped.';
}

// The report as the program writes it, its head and its provenance at the end left to the downloaded file.
function showReport(text) {
    const [element, style] = /<style>([^]*?)<\/style>/.exec(text);
    const report = new DOMParser().parseFromString(text.replace(element, ''), 'text/html');
    const sheet = new CSSStyleSheet();  // which the policy of the page admits, as it does not a style element
    sheet.replaceSync(style);
    document.adoptedStyleSheets = [sheet];
    byId('app-markers').replaceChildren(...(report.querySelector('svg.defs')?.childNodes ?? []));
    const answers = report.querySelector('header .answers');
    byId('app-report').replaceChildren(...[answers, ...(report.querySelector('main')?.children ?? [])].filter(Boolean));
    readFigures();
}

async function compute() {
    showRunning(true);
    run.worker = new Program();
    try {
        const { answer, artifacts } = await run.worker.askOfCase('run', '/results', 'all');
        if (answer.status !== 0) {
            tellError(answer.error);
            byId('app-progress').textContent = '';
            return;
        }
        run.artifacts = artifacts;
        run.files = new Map([...state.files, ['case.json', textOfCase()]]);
        showReport(artifacts['report.html']);
        byId('app-results').hidden = false;
        byId('app-progress').textContent = 'Done; the results are below.';
        byId('app-results').focus();
        offerWhatIf(artifacts);
    } catch (error) {
        byId('app-progress').textContent = `The program cannot go on: ${error.message}`;
    } finally {
        run.worker.stop();
        showRunning(false);
    }
}

function saveAll() {
    const files = [...(run.files ?? []), ...Object.entries(run.artifacts ?? {}).map(([name, text]) => [`results/${name}`, text])];
    save('ashimpact.zip', zipOf(files), 'application/zip');
}
