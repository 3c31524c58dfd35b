// Fields of the form. Each knows its path in the case, so that a message of the program finds it.
function unitChoice(kind, chosen, label, changedUnit) {
    const known = units[kind].includes(chosen) ? units[kind] : [...units[kind], chosen];
    const options = known.map((unit) => [unit, unit === '1' ? 'fraction' : unit]);
    return makeSelect({ 'aria-label': label, change: (event) => changedUnit(event.target.value) }, options, chosen);
}

// The message below a field, empty while nothing is wrong.
function wrongAt(path) {
    return make('p', { class: 'wrong', id: newId(), 'data-path': path });
}

function fieldAround(label, path, hint, ...inside) {
    const wrong = wrongAt(path);
    const input = inside[0];
    input.id ||= newId();
    const told = hint ? make('p', { class: 'hint', id: newId() }, hint) : null;
    input.setAttribute('aria-describedby', [told?.id, wrong.id].filter(Boolean).join(' '));
    return make('div', { class: 'field' }, make('label', { for: input.id }, label), make('div', { class: 'row' }, ...inside), told, wrong);
}

// A number with its unit beside it. A unit that is typed after the number is taken over into the choice beside it; that of
// an empty field is kept in the state.
function quantityField(label, path, kind, hint) {
    const shown = shownQuantity(valueAt(path), kind, state.units.get(pathNow(path)));
    const typed = () => partsOf(input.value, kind, select.value);
    const write = () => {
        const { number, unit } = typed();
        setAt(path, writtenQuantity(valueAt(path), number, unit));
        changed();
    };
    const takeUnit = () => {
        const { number, unit } = typed();
        if (!select.isConnected || number === input.value.trim()) return;
        if (![...select.options].some((option) => option.value === unit)) select.append(make('option', { value: unit }, unit));
        select.value = unit;
        input.value = number;
        state.units.set(pathNow(path), unit);
    };
    const input = make('input', { type: 'text', inputmode: 'decimal', autocomplete: 'off', value: shown.number, input: write, change: takeUnit });
    const select = unitChoice(kind, shown.unit, `Unit of: ${label}`, (unit) => {
        state.units.set(pathNow(path), unit);
        write();
    });
    return select.options.length === 1 ? fieldAround(label, path, hint, input) : fieldAround(label, path, hint, input, select);
}

function textField(label, path, hint) {
    const write = () => {
        setAt(path, input.value === '' ? undefined : input.value);
        changed();
    };
    const input = make('input', { type: 'text', autocomplete: 'off', value: String(valueAt(path) ?? ''), input: write });
    return fieldAround(label, path, hint, input);
}

// One of several; options: [value, text].
function choiceField(label, path, options, chosen, choose, hint) {
    return fieldAround(label, path, hint, makeSelect({ change: (event) => choose(event.target.value) }, options, chosen));
}

// A file by choice, or by a drop on the page.
function fileField(label, path, name, take) {
    const input = make('input', { type: 'file', class: 'file', id: newId(), change: () => input.files[0] && take(input.files[0]) });
    const wrong = wrongAt(path);
    input.setAttribute('aria-describedby', wrong.id);
    return make('div', { class: 'field' },
        make('p', { class: 'hint' }, name ? `${label}: ${name}` : `${label}: none yet`),
        make('p', { class: 'hint', 'data-read': path }),
        make('label', { class: 'button', for: input.id }, name ? 'Choose another file' : 'Choose a file', make('span', { class: 'visually-hidden' }, ` for: ${label}`)),
        input, wrong);
}

// A button that changes several fields at once, or makes others of them; it can be undone.
function stepButton(what, work, attributes = {}) {
    return make('button', {
        type: 'button', class: 'small', ...attributes, click: async () => {
            remember(what);
            await work();
            changedForm();
        },
    }, what);
}

const exampleButton = (what, fill) => make('p', { class: 'buttons' }, stepButton(`Fill in an example of ${what}`, fill));

// Takes every message away, and shows one at the field whose path is nearest; false if there is none.
function tellAtField(path, text) {
    for (const old of document.querySelectorAll('.wrong')) old.textContent = '';
    for (const old of document.querySelectorAll('[aria-invalid]')) old.removeAttribute('aria-invalid');
    if (!path) return false;
    let nearest = null;
    for (const wrong of document.querySelectorAll('.wrong[data-path]')) {
        const own = pathNow(wrong.dataset.path);
        const fits = path === own || path.startsWith(own + '/') || own.startsWith(path + '/');
        if (fits && (!nearest || own.length > pathNow(nearest.dataset.path).length)) nearest = wrong;
    }
    if (!nearest) return false;
    const cells = [...document.querySelectorAll('[data-cell]')].filter((cell) => pathNow(cell.dataset.cell) === path);
    for (const cell of cells) cell.setAttribute('aria-invalid', 'true');
    const row = cells.length ? `${cells.at(-1).getAttribute('aria-label')}: ` : '';
    nearest.textContent = row + text;
    if (!cells.length) document.querySelector(`[aria-describedby~="${nearest.id}"]`)?.setAttribute('aria-invalid', 'true');
    return true;
}
