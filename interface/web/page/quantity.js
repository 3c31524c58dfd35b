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

// {number, unit} as the fields show them; both are texts.
function shownQuantity(value, kind) {
    if (typeof value === 'number') return { number: String(value), unit: inSi[kind] };
    if (isObject(value)) return { number: String(value.value ?? ''), unit: String(value.unit ?? inSi[kind]) };
    if (typeof value !== 'string') return { number: '', unit: units[kind][0] };
    const [, number, unit] = /^([\s\d.,eE+\-()\u00b1]*)([^]*)$/.exec(value);
    if (number.trim() === '') return { number: value, unit: inSi[kind] };
    return { number: number.trim(), unit: unit.trim() || inSi[kind] };
}

// A typed number with a decimal comma has a point in the case.
const withPoint = (text) => (/^\s*[+-]?\d*,\d+(e[+-]?\d+)?\s*$/i.test(text) ? text.replace(',', '.') : text);

const isNumber = (text) => text.trim() !== '' && Number.isFinite(Number(text));

// What the case holds for it. An object keeps its uncertainty in the same unit; origin and source were those of the
// number before.
function writtenQuantity(before, typed, unit) {
    const number = withPoint(typed);
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
