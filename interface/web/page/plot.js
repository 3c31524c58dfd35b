// Curves over velocity: restitution between 0 and 1.
// Drawn for the width at hand, so that its text has the same size on a telephone.
const plotSize = (wide) => ({ width: wide ? 720 : 340, height: wide ? 340 : 280, left: 56, right: 14, top: 12, bottom: 46 });

function niceStep(most) {
    const power = 10 ** Math.floor(Math.log10(most));
    return [0.2, 0.5, 1, 2, 5].map((each) => each * power).find((step) => most / step <= 7) ?? power;
}

// curves: {name, class, x, y}; points: [[x, y], ...]; markers: {x, class}.
function curvePlot(wide, title, mostX, mostY, curves, points, markers) {
    const { width, height, left, right, top, bottom } = plotSize(wide);
    const atX = (x) => left + (x / mostX) * (width - left - right);
    const atY = (y) => height - bottom - (y / mostY) * (height - top - bottom);
    const svg = draw('svg', { class: 'curve', viewBox: `0 0 ${width} ${height}`, role: 'img', 'aria-label': title });
    for (let x = 0, step = niceStep(mostX); x <= mostX * 1.0001; x += step) {
        svg.append(draw('path', { class: 'tick', d: `M${atX(x)} ${top}V${height - bottom}` }));
        svg.append(draw('text', { x: atX(x), y: height - bottom + 20, 'text-anchor': 'middle' }, readable(x, 3)));
    }
    for (let y = 0, step = niceStep(mostY); y <= mostY * 1.0001; y += step) {
        svg.append(draw('path', { class: 'tick', d: `M${left} ${atY(y)}H${width - right}` }));
        svg.append(draw('text', { x: left - 8, y: atY(y) + 5, 'text-anchor': 'end' }, readable(y, 2)));
    }
    svg.append(draw('rect', { class: 'frame', x: left, y: top, width: width - left - right, height: height - top - bottom }));
    for (const [x, y] of points) if (x <= mostX && y <= mostY) svg.append(draw('circle', { class: 'point', cx: atX(x), cy: atY(y), r: 4 }));
    for (const curve of curves)
        svg.append(draw('path', { class: curve.class, d: curve.x.map((x, i) => `${i ? 'L' : 'M'}${atX(x).toFixed(2)} ${atY(Math.min(curve.y[i], mostY)).toFixed(2)}`).join('') }));
    for (const marker of markers) if (marker.x <= mostX) svg.append(draw('path', { class: marker.class, d: `M${atX(marker.x)} ${height - bottom}v-26` }));
    svg.append(draw('text', { x: (left + width - right) / 2, y: height - 6, 'text-anchor': 'middle' }, 'incident velocity [m/s]'));
    svg.append(draw('text', { x: 14, y: (top + height - bottom) / 2, 'text-anchor': 'middle', transform: `rotate(-90 14 ${(top + height - bottom) / 2})` }, 'restitution'));
    return svg;
}
