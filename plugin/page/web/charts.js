'use strict';
// Distributions of distances over a logarithmic axis.
(function () {
  const { makeSvg } = Octacut;
  const size = { width: 460, height: 190, left: 44, right: 10, top: 10, bottom: 34 };

  // The i-th threshold of a curve of the report, as a fraction of the diagonal.
  Octacut.curveThreshold = function (curve, i) {
    return Math.pow(10, i / curve.steps_per_decade - curve.decades);
  };

  // The part of the axis that holds anything: from where one curve exceeds a
  // thousandth to where all have reached all but a ten thousandth.
  Octacut.usedRange = function (curves) {
    let first = Infinity;
    let last = 0;
    for (const fractions of curves) {
      first = Math.min(first, fractions.findIndex(f => f > 0.001));
      last = Math.max(last, fractions.findIndex(f => f >= 0.9999));
    }
    first = Math.max(0, first);
    if (last <= first) {
      last = Math.min(curves[0].length - 1, first + 40);
    }
    return { first: first, last: last };
  };

  // lines: [{points: [value at index], colour, dashed}], `range` of indices.
  Octacut.chart = function ({ lines, range, curve, top, yLabel, label, id }) {
    const inner = {
      width: size.width - size.left - size.right,
      height: size.height - size.top - size.bottom,
    };
    const x = i => size.left + (inner.width * (i - range.first)) / (range.last - range.first);
    const y = v => size.top + inner.height * (1 - v / top);
    const svg = makeSvg('svg', {
      viewBox: '0 0 ' + size.width + ' ' + size.height, role: 'img',
      'aria-label': label, id: id, class: 'chart',
    });
    for (let k = 0; k <= 4; ++k) {
      const value = (top * k) / 4;
      svg.append(makeSvg('line', {
        class: 'grid', x1: size.left, x2: size.width - size.right, y1: y(value), y2: y(value) }));
      if (k % 2 === 0) {
        svg.append(makeSvg('text', {
          class: 'axis', x: size.left - 6, y: y(value) + 4, 'text-anchor': 'end',
        }, yLabel(value)));
      }
    }
    const perDecade = curve.steps_per_decade;
    for (let i = range.first; i <= range.last; ++i) {
      const within = i % perDecade;
      const isDecade = within === 0;
      const third = within === Math.round(perDecade * Math.log10(3));
      if (isDecade || (third && range.last - range.first < 3 * perDecade)) {
        svg.append(makeSvg('line', {
          class: 'grid', x1: x(i), x2: x(i), y1: size.top, y2: size.top + inner.height }));
        svg.append(makeSvg('text', {
          class: 'axis', x: x(i), y: size.top + inner.height + 15, 'text-anchor': 'middle',
        }, Octacut.tick(Number(Octacut.curveThreshold(curve, i).toPrecision(1)))));
      }
    }
    svg.append(makeSvg('text', {
      class: 'axis', x: size.left + inner.width / 2, y: size.height - 4, 'text-anchor': 'middle',
    }, 'distance, % of the diagonal'));
    for (const line of lines) {
      const path = [];
      for (let i = range.first; i <= range.last; ++i) {
        path.push((path.length ? 'L' : 'M') + x(i).toFixed(1) + ' ' + y(line.points[i]).toFixed(1));
      }
      svg.append(makeSvg('path', {
        class: 'curve', d: path.join(''), stroke: line.colour,
        'stroke-dasharray': line.dashed ? '5 4' : 'none' }));
    }
    const mark = makeSvg('line', {
      class: 'mark', y1: size.top, y2: size.top + inner.height, x1: 0, x2: 0 });
    svg.append(mark);
    return {
      svg: svg,
      setMark(i) {
        mark.setAttribute('x1', x(i));
        mark.setAttribute('x2', x(i));
      },
    };
  };

  // Shares of the samples between neighbouring thresholds, four steps together.
  Octacut.density = function (fractions) {
    return fractions.map((f, i) => {
      const low = Math.max(0, i - 2);
      const high = Math.min(fractions.length - 1, i + 2);
      return high > low ? ((fractions[high] - fractions[low]) * 4) / (high - low) : 0;
    });
  };
})();
