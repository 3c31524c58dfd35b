// Quantities in a case: "44 um", {"value": 44, "unit": "um"}, or a bare number in SI.
const units = {
    length: ['um', 'mm', 'nm', 'm'],
    density: ['kg/m3', 'g/cm3'],
    pressure: ['GPa', 'MPa', 'Pa'],
    adhesion: ['J/m2', 'mJ/m2', 'N/m'],
    velocity: ['m/s', 'mm/s', 'cm/s'],
    fraction: ['%', '1'],
    ratio: ['1'],
    rate: ['1'],
};
const inSi = { length: 'm', density: 'kg/m3', pressure: 'Pa', adhesion: 'J/m2', velocity: 'm/s', fraction: '1', ratio: '1', rate: '1' };

// A number as JSON has it. Everything else is a text in the case, for the program to read or to refuse.
const isNumber = (text) => /^\s*[+-]?(\d+\.?\d*|\.\d+)(e[+-]?\d+)?\s*$/i.test(text) && Number.isFinite(Number(text));

// {number, unit} of a text such as "44.5 µm", both as typed; `otherwise` is the unit of a text that names none. What does not
// begin with a number is taken for one, so that the unit beside it stays.
function partsOf(text, kind, otherwise) {
    const own = units[kind].find((unit) => unit !== '1' && text.endsWith(` ${unit}`));
    const [, number, unit] = /^([\s\d.,eE+\-()\u00b1]*)([^]*)$/.exec(text);
    if (/\d/.test(number)) return { number: number.trim(), unit: unit.trim() || otherwise };
    return own ? { number: text.slice(0, -own.length - 1), unit: own } : { number: text, unit: otherwise };
}

// {number, unit} as the fields show them; both are texts. `empty` is the unit of a field without a value.
function shownQuantity(value, kind, empty = units[kind][0]) {
    if (typeof value === 'number') return { number: String(value), unit: inSi[kind] };
    if (isObject(value)) return { number: String(value.value ?? ''), unit: String(value.unit ?? inSi[kind]) };
    if (typeof value !== 'string') return { number: '', unit: empty };
    return partsOf(value, kind, /\d/.test(value) ? inSi[kind] : empty);
}

// What the case holds for a number and its unit. An object keeps its uncertainty in the same unit; origin and source were
// those of the number before.
function writtenQuantity(before, number, unit) {
    if (number.trim() === '') return undefined;
    if (isObject(before) && 'value' in before && isNumber(number)) {
        const same = before.unit === unit;
        const after = { value: Number(number), unit };
        if (same && 'standard_uncertainty' in before) after.standard_uncertainty = before.standard_uncertainty;
        return after;
    }
    return unit === '1' ? (isNumber(number) ? Number(number) : number) : `${number.trim()} ${unit}`;
}

// Three or four significant digits, as a reader wants them.
function readable(value, digits = 4) {
    if (!Number.isFinite(value)) return '';
    const size = Math.abs(value);
    return size !== 0 && (size < 1e-3 || size >= 1e5) ? value.toExponential(digits - 1) : String(Number(value.toPrecision(digits)));
}
