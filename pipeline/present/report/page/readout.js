// Reads numbers off a figure: by mouse, by touch, and with the arrow keys once it has the focus (left and right along a
// curve, up and down from curve to curve). The page is complete without it.
'use strict';
(() => {
  const svgName = document.querySelector('svg')?.namespaceURI;

  // One axis of a panel: from, to, first pixel, last pixel, spacing; value() turns a pixel back into its number.
  const axisOf = (panel, which) => {
    const text = panel.getAttribute('data-' + which);
    if (!text) return null;
    const parts = text.split(' ');
    const [from, to, start, end] = parts.slice(0, 4).map(Number);
    const logarithmic = parts[4] === 'log';
    const name = panel.getAttribute('data-' + which + '-name');
    const unit = panel.getAttribute('data-' + which + '-unit');
    return {
      start, end, name, unit,
      value(pixel) {
        const share = (pixel - start) / (end - start);
        return logarithmic ? from * Math.pow(to / from, share) : from + share * (to - from);
      },
      step: (pixel) => Math.abs(to - from) / Math.abs(end - start),
    };
  };

  const written = (value) => {
    const text = Math.abs(value) < 1e-12 ? '0' : Number(value.toPrecision(3)).toString();
    return text.replace('e-', '·10^-').replace('e+', '·10^');
  };

  const spots = (series) => {
    const found = [];
    const line = series.querySelector('path.line');
    if (line)
      for (const match of line.getAttribute('d').matchAll(/[ML]([-\d.]+) ([-\d.]+)/g)) found.push([+match[1], +match[2]]);
    for (const mark of series.querySelectorAll('use')) found.push([+mark.getAttribute('x'), +mark.getAttribute('y')]);
    const bar = series.querySelector('rect');
    if (bar) found.push([+bar.getAttribute('x') + +bar.getAttribute('width') / 2, +bar.getAttribute('y') + +bar.getAttribute('height') / 2]);
    const interval = !line && found.length === 0 && series.querySelector('path.bar');
    if (interval) {
      const match = /M([-\d.]+) ([-\d.]+)H([-\d.]+)/.exec(interval.getAttribute('d'));
      if (match) found.push([(+match[1] + +match[3]) / 2, +match[2]]);
    }
    return found.sort((a, b) => a[0] - b[0]);
  };

  const readable = (panel, series, spot) => {
    const name = series.getAttribute('data-name');
    const y = axisOf(panel, 'y');
    if (!y) return name;
    const x = axisOf(panel, 'x');
    const number = (axis, pixel) => axis.name.replace('_', ' ') + ' = ' + written(axis.value(pixel)) + (axis.unit ? ' ' + axis.unit : '');
    return name + ': ' + number(x, spot[0]) + ', ' + number(y, spot[1]);
  };

  for (const plot of document.querySelectorAll('.plot')) {
    if (plot.tabIndex === 0) continue;  // read before
    const output = plot.parentElement.querySelector('.readout');
    const known = [];
    for (const svg of plot.querySelectorAll('svg'))
      for (const panel of svg.querySelectorAll('.panel'))
        for (const series of panel.querySelectorAll('.series')) {
          const points = spots(series);
          if (points.length) known.push({ svg, panel, series, points });
        }
    if (!known.length) continue;
    plot.tabIndex = 0;
    let at = null;

    const show = (entry, index) => {
      at = { entry, index };
      for (const old of plot.querySelectorAll('.cursor')) old.remove();
      const ring = document.createElementNS(svgName, 'circle');
      ring.setAttribute('class', 'cursor');
      ring.setAttribute('cx', entry.points[index][0]);
      ring.setAttribute('cy', entry.points[index][1]);
      ring.setAttribute('r', '6');
      entry.panel.append(ring);
      output.textContent = readable(entry.panel, entry.series, entry.points[index]);
    };
    const visible = () => known.filter((entry) => entry.svg.getBoundingClientRect().width > 0);

    const pointed = (event) => {
      const svg = event.target.closest('svg');
      if (!svg) return;
      const box = svg.getBoundingClientRect();
      const scale = svg.viewBox.baseVal.width / box.width;
      const x = (event.clientX - box.left) * scale;
      const y = (event.clientY - box.top) * scale;
      let best = null;
      for (const entry of known) {
        if (entry.svg !== svg) continue;
        entry.points.forEach((point, index) => {
          const distance = Math.hypot(point[0] - x, point[1] - y);
          if (distance < 40 && (!best || distance < best.distance)) best = { distance, entry, index };
        });
      }
      if (best) show(best.entry, best.index);
    };
    for (const kind of ['pointermove', 'pointerdown']) plot.addEventListener(kind, pointed);  // a tap moves nothing
    plot.addEventListener('keydown', (event) => {
      const moves = { ArrowLeft: [0, -1], ArrowRight: [0, 1], ArrowUp: [-1, 0], ArrowDown: [1, 0] };
      const move = moves[event.key];
      if (!move) return;
      event.preventDefault();
      const entries = visible();
      let place = at ? entries.indexOf(at.entry) : -1;
      let index = at ? at.index : 0;
      if (place < 0) [place, index] = [0, 0];
      else if (move[0]) {
        place = (place + move[0] + entries.length) % entries.length;
        index = Math.min(index, entries[place].points.length - 1);
      } else index = Math.min(Math.max(index + move[1], 0), entries[place].points.length - 1);
      show(entries[place], index);
    });
  }
})();
