// Small helpers for the elements of the page.
const byId = (id) => document.getElementById(id);

// listen({id: work, ...}): calls work() on a click on the element of that id.
function listen(clicks) {
    for (const [id, work] of Object.entries(clicks)) byId(id).addEventListener('click', work);
}

// make('p', {class: 'hint'}, 'text', child): attributes that are functions listen to the event of their name.
function make(name, attributes = {}, ...children) {
    const element = document.createElement(name);
    for (const [key, value] of Object.entries(attributes)) {
        if (typeof value === 'function') element.addEventListener(key, value);
        else if (value === true) element.setAttribute(key, '');
        else if (value !== false && value !== undefined) element.setAttribute(key, value);
    }
    element.append(...children.filter((child) => child !== undefined && child !== null));
    return element;
}

// options: [value, text] each. Options that were those of another select would not keep which one is chosen.
function fillSelect(select, options, chosen) {
    select.replaceChildren(...options.map(([value, text]) => make('option', { value, selected: value === chosen }, text)));
    return select;
}

const makeSelect = (attributes, options, chosen) => fillSelect(make('select', attributes), options, chosen);

// A checkbox with its label; calls changed(checked) on a change.
function makeBox(label, checked, changed) {
    const box = make('input', { type: 'checkbox', checked, change: () => changed(box.checked) });
    return make('label', {}, box, label);
}

const svgName = 'http://www.w3.org/2000/svg';
function draw(name, attributes = {}, ...children) {
    const element = document.createElementNS(svgName, name);
    for (const [key, value] of Object.entries(attributes)) element.setAttribute(key, value);
    element.append(...children);
    return element;
}

let lastId = 0;
const newId = () => `app-${++lastId}`;

function save(name, content, type) {
    const link = make('a', { href: URL.createObjectURL(new Blob([content], { type })), download: name });
    document.body.append(link);
    link.click();
    link.remove();
    setTimeout(() => URL.revokeObjectURL(link.href), 60000);
}

// Calls a function when nothing new has come for a while.
function afterPause(milliseconds, work) {
    let timer = 0;
    return () => {
        clearTimeout(timer);
        timer = setTimeout(work, milliseconds);
    };
}
