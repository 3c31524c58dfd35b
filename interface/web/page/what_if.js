// Sliders for one sample and law: what would be beside what is.
const sliders = [
    { key: 'work_of_adhesion', label: 'Work of adhesion w', unit: 'J/m2', scale: 1 },
    { key: 'density', label: 'Density', unit: 'kg/m3', scale: 1 },
    { key: 'damping', label: 'Damping' },
    { key: 'contact_modulus', label: 'Contact modulus E*', unit: 'GPa', scale: 1e-9 },
];
const whatIf = { factors: {}, law: null, contact: null, points: [], measured: false, nodes: null };

// The unit of a damping on the page, and the number of these in the SI unit of its law.
const dampingUnit = (si) => (si === 'kg/s' ? { unit: 'g/s', scale: 1e3 } : { unit: si === '1' ? '' : si, scale: 1 });

// The result of an artifact, and what it holds of each sample; undefined where there is none.
const resultOf = (artifacts, file) => artifacts[file] && JSON.parse(artifacts[file]).result;
const samplesOf = (artifacts, file) => resultOf(artifacts, file)?.samples;

// The contact of the sample that is shown, from artifacts of a run or of the answer at once; null where there is none. Its
// damping is that of the law of the case, as measured; before any was measured the program guesses it.
async function contactOf(artifacts, law) {
    const { laws, damping_laws: dampings } = embedded;
    const inArtifact = (file) => samplesOf(artifacts, file)?.[state.sample];
    const contact = inArtifact('2-contact.json');
    const modulus = inArtifact('1-modulus.json');
    if (!contact || !modulus || !contact.density) return null;
    const critical = inArtifact('7-critical-velocity.json')?.[law];
    const measured = critical?.damping?.value;
    const course = measured === undefined ? null : dampingCourse(critical, inArtifact('5-damping.json')?.[law]);
    const { partner } = contact;
    const asStated = resultOf(artifacts, '0-case.json') ?? {};
    const dampingLaw = critical?.damping_law ?? asStated.damping_law ?? Object.keys(dampings)[0];
    const detachment = critical?.detachment ?? asStated.detachments?.[law];
    const parameters = {};
    for (const { name } of laws[law].parameters)
        if (contact[name]) parameters[name] = contact[name].value ?? contact[name];
    const found = {
        ...parameters, law, ...(detachment ? { detachment } : {}), damping_law: dampingLaw, diameter: modulus.diameter.value, density: contact.density.value,
        ...(partner && { partner_radius: partner.radius.value, partner_mass: partner.mass.value }),
        contact_modulus: contact.contact_modulus.value, work_of_adhesion: contact.work_of_adhesion?.value ?? null,
        course,
    };
    found.damping = measured ?? (await curveOf(found, [1])).damping;
    found.dampingUnit = dampingUnit(dampings[dampingLaw].unit);
    return found;
}

// Damping over velocity: where it begins, the critical velocity and its damping, and [v, damping] as measured above it.
function dampingCourse(critical, measured) {
    const begin = critical.critical_velocity && [critical.critical_velocity.value, critical.damping.value];
    const all = (measured?.velocity.values ?? []).map((v, i) => [v, measured.damping.values[i]])
        .filter(([v, damping]) => damping !== null && (!begin || v > begin[0])).sort((a, b) => a[0] - b[0]);
    const points = all.filter((_, i) => i % Math.ceil(all.length / 400) === 0);
    return { begin, points: begin ? [begin, ...points] : points };
}

// The damping at a velocity is the mean of those measured nearby, by local lines over log v, so that curves have no corners.
// At the critical velocity it is that of the critical velocity.
function dampingAt({ begin, points }, v) {
    const places = points.map(([at]) => Math.log(at));
    const spread = Math.min(0.3, Math.max(0.1, (Math.max(...places) - Math.min(...places)) / 8));  // of weights, in log v
    const meanAt = (at) => {
        let [sum, first, second, mean, slope] = [0, 0, 0, 0, 0];
        places.forEach((place, i) => {
            const from = place - at;
            const weight = Math.exp(-0.5 * (from / spread) ** 2) + 1e-12 / (1 + from ** 2);
            sum += weight;
            first += weight * from;
            second += weight * from ** 2;
            mean += weight * points[i][1];
            slope += weight * from * points[i][1];
        });
        const rise = (sum * slope - first * mean) / (sum * second - first ** 2 + 1e-3 * (sum * spread) ** 2);
        return Math.max(0, (mean - first * rise) / sum);
    };
    const place = Math.log(v);
    if (!begin) return meanAt(place);
    const [start, from] = [Math.log(begin[0]), Math.max(0, place - Math.log(begin[0]))];
    return meanAt(start + from) + (begin[1] - meanAt(start)) * Math.exp(-0.5 * (from / spread) ** 2);
}

function measuredPoints(artifacts, law) {
    const sample = samplesOf(artifacts, '4-restitution.json')?.[state.sample];
    return (sample?.series ?? []).filter((series) => series.laws.includes(law)).flatMap((series) => series.velocity.values.map((v, i) => [v, series.restitution.values[i]]));
}

const withFactors = (contact) => Object.fromEntries(Object.entries(contact).map(([key, value]) => [key, typeof value === 'number' ? value * (whatIf.factors[key] ?? 1) : value]));

// Restitutions and critical velocity of a contact; `dampings`, one for each velocity, replace its own.
async function curveOf({ course: _, dampingUnit: __, ...asked }, velocities, dampings) {
    if (asked.work_of_adhesion === null) delete asked.work_of_adhesion;
    const { answer } = await quick.ask({ name: 'curve', words: [JSON.stringify({ ...asked, velocities, dampings })] });
    return answer;
}

// The critical velocity of a contact: where a velocity is that of the damping there, which is times a factor. Below the measured
// critical velocity the damping is that of it.
async function criticalOf(contact, most, factor) {
    const { course } = contact;
    const valueOf = ({ critical_velocity: value, always_captured: always }) => value ?? (always ? Infinity : 0);
    const constant = await curveOf(contact, [most]);
    const begin = course?.begin?.[0] ?? 0;
    if (constant.status !== 0 || !course?.points.length || valueOf(constant) <= begin * (1 + 1e-9)) return constant;
    const at = (v) => curveOf({ ...contact, damping: dampingAt(course, v) * factor }, [v]);
    const fastest = await at(most);
    if (!(valueOf(fastest) < most)) return fastest;
    let [captured, rebounds] = [begin || most / 1000, most];
    for (let i = 0; i < 24; ++i) {
        const middle = Math.sqrt(captured * rebounds);
        if (valueOf(await at(middle)) < middle) rebounds = middle;
        else captured = middle;
    }
    return { ...fastest, critical_velocity: rebounds };
}

// The curve of a contact up to a velocity, and its critical velocity. Where that is less than the measured one, the damping
// measured above it is stretched, by log v, to begin there.
async function curveUpTo(most, contact, factor = 1) {
    const { course } = contact;
    const answer = await criticalOf(contact, most, factor);
    if (answer.status !== 0) return answer;
    const from = answer.critical_velocity ?? 0;
    const begin = from < most ? from : 0;
    const steps = Array.from({ length: 200 }, (_, i) => begin + (most - begin) * ((i + 1) / 200) ** 2);
    const velocities = begin > 0 ? [begin / 1000, begin, ...steps] : steps;
    const stretch = begin > 0 && begin < course?.begin?.[0] ? Math.log(most / course.begin[0]) / Math.log(most / begin) : 1;
    const dampings = course?.points.length ? velocities.map((v) => dampingAt(course, most * (v / most) ** stretch) * factor) : undefined;
    const curve = await curveOf(contact, velocities, dampings);
    return { ...curve, critical_velocity: answer.critical_velocity, always_captured: answer.always_captured, velocities };
}

// Without measured impacts the damping is a guess, and a velocity would be taken for a result.
function guessed(was, would) {
    const change = was && would ? ` The sliders change the critical velocity by a factor of ${readable(would / was, 3)}.` : '';
    return `The damping is a guess until impacts are computed: curves and marks show which way things go, not the critical velocity of your ash.${change}`;
}

let drawn = 0;
async function drawWhatIf() {
    const turn = ++drawn;
    const contact = whatIf.contact;
    if (!contact) return;
    const fastest = Math.max(0, ...whatIf.points.map(([v]) => v));
    const base = await curveOf(contact, [1]);
    const most = fastest > 0 ? fastest * 1.05 : Math.min(100, 4 * (base.critical_velocity || 1));
    const answers = await Promise.all([curveUpTo(most, contact), curveUpTo(most, withFactors(contact), whatIf.factors.damping)]);
    if (turn !== drawn) return;
    const wrong = answers.find((answer) => answer.status !== 0);
    if (wrong) {
        whatIf.nodes.text.textContent = wrong.error.message;
        return;
    }
    const [was, would] = answers;
    const said = (answer) => (answer.critical_velocity === null ? (answer.always_captured ? 'every particle stays' : 'none') : answer.outside_model ?? `${readable(answer.critical_velocity, 3)} m/s`);
    whatIf.nodes.text.textContent = contact.course
        ? `Critical velocity by ${lawName(contact.law)} with the measured damping: ${said(was)}. What if: ${said(would)}.`
        : guessed(was.critical_velocity, would.critical_velocity);
    const mostY = Math.max(0.5, ...whatIf.points.map(([, e]) => e), ...was.restitution, ...would.restitution) > 0.8 ? 1 : 0.8;
    const markers = [[was, 'base'], [would, 'new']].filter(([answer]) => answer.critical_velocity !== null).map(([answer, kind]) => ({ x: answer.critical_velocity, class: kind }));
    whatIf.nodes.plot.replaceChildren(curvePlot(byId('app-what-if').clientWidth > 560, 'Restitution over velocity, as it is and what if', most, mostY,
        [{ class: 'base', x: was.velocities, y: was.restitution }, { class: 'new', x: would.velocities, y: would.restitution }], whatIf.points, markers));
}

function sliderFor({ key, label, ...fixed }) {
    const output = make('output', {});
    const tell = () => {
        const { unit, scale } = fixed.unit ? fixed : whatIf.contact?.dampingUnit ?? dampingUnit('1');
        output.textContent = whatIf.contact?.[key] === null ? 'not used' : `${readable((whatIf.contact?.[key] ?? 0) * scale * (whatIf.factors[key] ?? 1), 3)} ${unit}`;
        input.setAttribute('aria-valuetext', output.textContent);
    };
    const input = make('input', {
        type: 'range', id: `app-slider-${key}`, min: '-1', max: '1', step: '0.02', value: '0', input: () => {
            whatIf.factors[key] = 5 ** Number(input.value);
            tell();
            drawWhatIf();
        },
    });
    tell();
    return { key, input, tell, node: make('div', {}, make('label', { for: input.id }, label), input, output) };
}

function buildWhatIf() {
    const law = make('select', { id: 'app-what-if-law', change: () => offerWhatIf(whatIf.artifacts, law.value) });
    const parts = sliders.map(sliderFor);
    const reset = make('button', {
        type: 'button', class: 'small', click: () => {
            whatIf.factors = {};
            for (const part of parts) part.input.value = '0';
            parts.forEach((part) => part.tell());
            drawWhatIf();
        },
    }, 'Reset the sliders');
    const plot = make('div', {});
    const text = make('p', { class: 'answer', role: 'status' });
    whatIf.nodes = { law, parts, plot, text };
    byId('app-what-if-body').append(make('p', { class: 'buttons' }, make('label', { for: 'app-what-if-law' }, 'Contact law'), law, reset),
        make('div', { class: 'sliders' }, ...parts.map((part) => part.node)), text, plot);
}

// Shows the sliders for what the artifacts hold.
async function offerWhatIf(artifacts, chosen) {
    if (!whatIf.nodes) buildWhatIf();
    const names = chosenLaws().filter((law) => typeof law === 'string');
    const law = names.includes(chosen ?? whatIf.law) ? chosen ?? whatIf.law : names.at(-1);
    whatIf.artifacts = artifacts;
    whatIf.law = law;
    const contact = law ? await contactOf(artifacts, law) : null;
    if (whatIf.artifacts !== artifacts || whatIf.law !== law) return;  // another one was chosen meanwhile
    whatIf.contact = contact;
    whatIf.points = law ? measuredPoints(artifacts, law) : [];
    byId('app-what-if').hidden = !whatIf.contact;
    if (!whatIf.contact) return;
    fillSelect(whatIf.nodes.law, names.map((name) => [name, lawName(name)]), law);
    whatIf.nodes.parts.forEach((part) => part.tell());
    drawWhatIf();
}
