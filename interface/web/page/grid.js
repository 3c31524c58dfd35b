// Whether the first line of a pasted table has no number, and the second one has.
function hasHeading(text) {
    const [first, second] = text.trim().split(/\r?\n/, 2).map((line) => line.split(/[\t;]/).some((cell) => /^[\s\d.,'+-]*\d[\s\d.,'e+-]*$/i.test(cell)));
    return first === false && second === true;
}

// A table to type into. columns: {title, heading (in a file), name (class), list}; rows: lists of texts. Calls typed(rows) on
// every change. A paste of several cells, as from a spreadsheet, fills the cells from there on. One that begins with a heading
// or has commas, which only the program can read, goes to takeTable(text), as a file would. places(rows) gives the path in the
// case of each cell, by which a message finds it.
function typingGrid({ caption, columns, rows, typed, places, takeTable, heads = [] }) {
    const body = make('tbody');
    const cells = () => [...body.rows].map((row) => [...row.querySelectorAll('input')]);
    const texts = () => cells().map((row) => row.map((input) => input.value.trim()));
    const tell = () => {
        const last = texts().at(-1);
        if (!last || last.some((text) => text !== '')) addRow([]);
        placeCells();
        typed(texts());
    };
    const placeCells = () => {
        const paths = places(texts());
        cells().forEach((row, i) => row.forEach((input, j) => { input.dataset.cell = paths[i][j] ?? ''; }));
    };
    const addRow = (values) => {
        const place = body.rows.length;
        const row = make('tr');
        columns.forEach((column, i) => {
            const input = make('input', {
                type: 'text', autocomplete: 'off', value: values[i] ?? '', inputmode: column.name === 'name' ? 'text' : 'decimal',
                list: column.list, 'aria-label': `${column.title}, row ${place + 1}`, input: tell, paste,
            });
            row.append(make('td', { class: column.name ?? '' }, input));
        });
        body.append(row);
    };
    const paste = (event) => {
        const text = event.clipboardData?.getData('text') ?? '';
        if (!/[\t\n;]/.test(text.trim())) return;
        event.preventDefault();
        const heading = hasHeading(text) ? '' : `${columns.map((column) => column.heading()).join(text.includes('\t') ? '\t' : ';')}\n`;
        if (!heading || text.includes(',')) {
            takeTable(heading + text);
            return;
        }
        const all = cells();
        const first = all.findIndex((row) => row.includes(event.target));
        const left = all[first].indexOf(event.target);
        text.trim().split(/\r?\n/).slice(0, 2000).forEach((line, i) => {
            while (body.rows.length <= first + i) addRow([]);
            const inputs = [...body.rows[first + i].querySelectorAll('input')];
            line.split(/[\t;]/).forEach((cell, j) => inputs[left + j] && (inputs[left + j].value = cell.trim()));
        });
        tell();
    };
    rows.forEach(addRow);
    addRow([]);
    placeCells();
    const head = make('tr', {}, ...columns.map((column, i) => make('th', { scope: 'col' }, column.title, heads[i])));
    return make('div', { class: 'scroll tall', role: 'region', tabindex: '0', 'aria-label': caption },
        make('table', { class: 'grid' }, make('thead', {}, head), body));
}
