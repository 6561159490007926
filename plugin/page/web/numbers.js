'use strict';
// Numbers as text, and colour scales.
(function () {
  // A distance in per cent of the diagonal.
  Octacut.percent = function (fraction) {
    if (fraction === null || fraction === undefined) {
      return '–';
    }
    return (100 * fraction).toPrecision(4);
  };
  // A fraction such as precision, in per cent.
  Octacut.share = fraction =>
    fraction === null || fraction === undefined ? '–' : (100 * fraction).toFixed(2);
  Octacut.count = number =>
    number === null || number === undefined
      ? '–'
      : String(number).replace(/\B(?=(\d{3})+(?!\d))/g, '\u202f');
  // Short, for axes and legends.
  Octacut.tick = function (fraction) {
    const value = 100 * fraction;
    if (value === 0) {
      return '0';
    }
    return String(Number(value.toPrecision(2))).replace('-', '−') + ' %';
  };

  function lerpStops(stops, t) {
    const x = Math.min(0.999999, Math.max(0, t)) * (stops.length - 1);
    const i = Math.floor(x);
    const f = x - i;
    return stops[i].map((v, k) => v + f * (stops[i + 1][k] - v));
  }

  // From inside (blue) over none (light) to outside (red).
  const diverging = [
    [12, 50, 110], [33, 102, 172], [67, 147, 195], [146, 197, 222], [209, 229, 240],
    [246, 246, 244],
    [253, 219, 199], [244, 165, 130], [214, 96, 77], [178, 24, 43], [110, 10, 35],
  ];
  // From contradicted (dark violet) to supported (yellow).
  const sequential = [
    [68, 1, 84], [70, 50, 127], [54, 92, 141], [39, 127, 142], [31, 161, 135],
    [74, 194, 109], [159, 218, 58], [253, 231, 37],
  ];
  Octacut.scales = {
    distance: t => lerpStops(diverging, t),
    support: t => lerpStops(sequential, t),
  };
  Octacut.css = rgb => 'rgb(' + rgb.map(v => Math.round(v)).join(',') + ')';
})();
