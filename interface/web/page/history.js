// What was there before a step that replaces much at once, so that the step can be taken back: lists of
// {what, document, text, files, sample}. The document keeps its identity, as results belong to it.
const past = { done: [], undone: [] };
const mostSteps = 30;

function placeNow(what) {
    return { what, document: state.document, text: textOfCase(), files: new Map(state.files), sample: state.sample };
}

// Before such a step: `what` names it as its button does.
function remember(what) {
    past.done.push(placeNow(what));
    if (past.done.length > mostSteps) past.done.shift();
    past.undone.length = 0;
    showHistory();
}

function step(from, to, told) {
    const { what, document, text, files, sample } = from.pop();
    to.push(placeNow(what));
    for (const key of Object.keys(document)) delete document[key];
    Object.assign(document, JSON.parse(text));
    Object.assign(state, { document, files, sample });
    showHistory();
    changedForm();
    tell(`${told}: ${what}.`);
}

function showHistory() {
    for (const [id, list, word] of [['app-undo', past.done, 'Undo'], ['app-redo', past.undone, 'Redo']]) {
        byId(id).hidden = list.length === 0;
        byId(id).textContent = list.length ? `${word}: ${list.at(-1).what}` : word;
    }
}

// The case as it was opened or saved last: what differs from it would be lost with the page.
let keptCase = '';
function keepCase() {
    keptCase = textOfCase();
}

function listenToHistory() {
    listen({ 'app-undo': () => step(past.done, past.undone, 'Undone'), 'app-redo': () => step(past.undone, past.done, 'Done again') });
    window.addEventListener('beforeunload', (event) => {
        if (textOfCase() !== keptCase) event.preventDefault();
    });
}
