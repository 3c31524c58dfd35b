// How far two results of the same case are apart.
'use strict';

// What stands at a place of an artifact: the interval or uncertainty of something or a number of uncertainties, a fitted
// value or what follows from one, or a value computed directly from the case.
function kindOf(file, place) {
    if (/interval|uncertainty|covariance|lower|upper|quantile|probability|deviation|scatter|residuals|prediction_error/.test(place)) return 'interval';
    // The contact radius is the root of the overlap: at the end of a contact a rounding of 1e-16 becomes 1e-8 of the greatest.
    // Brach & Dunn's attraction goes with that radius.
    if (/(curves|trajectory).*contact_radius|brach-dunn.*attractive_force/.test(place)) return 'root';
    return /^(6-fit|7-critical-velocity|8-histories|comparison)/.test(file) ? 'fitted' : 'direct';
}

const isNumbers = value => Array.isArray(value) && value.length > 0 && value.every(each => typeof each === 'number');
const largest = numbers => Math.max(...numbers.map(Math.abs));

// All numbers below a value.
function numbersIn(value) {
    if (typeof value === 'number') return [value];
    return value && typeof value === 'object' ? Object.values(value).flatMap(numbersIn) : [];
}

// The size against which rounding in a member is to be seen, where the member is a small difference of large numbers: a
// residual beside the terms it is of, a relative difference beside one. An exact fit leaves nothing but rounding as the
// uncertainty of its coefficients: below a millionth of them it is none.
function sizeBeside(parent, key) {
    const none = 1e-6;
    if (parent.at_touch) return Math.abs(parent.incident.value);  // the ledger of an impact's energy
    if (key === 'equation_41') return Math.abs(parent.rebound.static_impulse.value);  // a difference of impulses
    if (key === 'residual') return largest(numbersIn(parent).filter(Number.isFinite));
    if (['relative_difference', 'first', 'total', 'first_error', 'total_error'].includes(key)) return 1;
    if (parent.lower_velocity && ['dissipated', 'adhesion', 'plastic'].includes(key)) return 1;  // shares on a curve
    if (key === 'standard_uncertainty' && typeof parent.value === 'number') return none * Math.abs(parent.value);
    const coefficients = ['a', 'b', 'c'].map(name => parent[name]?.value).filter(value => typeof value === 'number');
    if (coefficients.length < 3) return 0;
    if (['a', 'b', 'c'].includes(key)) return largest(coefficients);  // of a polynomial in e, which is at most one
    if (key === 'covariance') return (none * largest(coefficients)) ** 2;
    return key === 'residual_deviation' ? none * largest(coefficients) : 0;
}

// Calls tell(place, one, other, distance) for each leaf. A column is measured by its largest number.
function walk(one, other, place, size, tell) {
    const relative = (a, b, scale) => (a === b ? 0 : Math.abs(a - b) / Math.max(scale, size));
    if (typeof one === 'number' && typeof other === 'number') {
        tell(place, one, other, relative(one, other, largest([one, other])));
    } else if (isNumbers(one) && isNumbers(other) && one.length === other.length) {
        const scale = largest([...one, ...other]);
        one.forEach((each, i) => tell(`${place}/${i}`, each, other[i], relative(each, other[i], scale)));
    } else if (one && other && typeof one === 'object' && typeof other === 'object' && Array.isArray(one) === Array.isArray(other)) {
        for (const key of new Set([...Object.keys(one), ...Object.keys(other)]))
            walk(one[key], other[key], `${place}/${key}`, Math.max(size, sizeBeside(one, key)), tell);
    } else if (one !== other) {
        tell(place, one, other, Infinity);
    }
}

// The largest distance of each kind between two results of an artifact, and how many leaves there are of it.
// taken(place): whether a leaf is to be compared.
function distances(file, one, other, taken) {
    const worst = {};
    walk(one, other, '', 0, (place, a, b, distance) => {
        if (!taken(place)) return;
        const kind = kindOf(file, place);
        const before = worst[kind] ?? { distance: -1, count: 0 };
        worst[kind] = distance > before.distance ? { distance, place, one: a, other: b, count: before.count + 1 } : { ...before, count: before.count + 1 };
    });
    return worst;
}

module.exports = { distances, walk };
