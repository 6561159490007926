'use strict';
// All scripts of the page share this one object.
const Octacut = {};

// The report, the page's description and the binary parts, decoded.
(function () {
  function parse(id) {
    return JSON.parse(document.getElementById(id).textContent);
  }

  function blobBytes(number) {
    const text = atob(document.getElementById('blob-' + number).textContent);
    const bytes = new Uint8Array(text.length);
    for (let i = 0; i < text.length; ++i) {
      bytes[i] = text.charCodeAt(i);
    }
    return bytes;
  }

  Octacut.report = parse('report');
  Octacut.page = parse('page');
  Octacut.blobBytes = blobBytes;

  // Okabe and Ito's colours, which colour-blind people can tell apart.
  const tints = ['#0072b2', '#e69f00', '#009e73', '#cc79a7', '#d55e00', '#56b4e9'];
  let next = 0;
  for (const mesh of Octacut.page.meshes) {
    mesh.tint = mesh.reference ? '#8c8c8c' : tints[next++ % tints.length];
  }

  // The frame of the viewer: the meshes' common centre is the origin, half the
  // diagonal is the unit.
  const low = [Infinity, Infinity, Infinity];
  const high = [-Infinity, -Infinity, -Infinity];
  for (const mesh of Octacut.page.meshes) {
    for (let k = 0; k < 3; ++k) {
      low[k] = Math.min(low[k], mesh.box_min[k]);
      high[k] = Math.max(high[k], mesh.box_max[k]);
    }
  }
  Octacut.center = low.map((v, k) => (v + high[k]) / 2);
  Octacut.unit = Octacut.page.diagonal / 2;
  Octacut.box = {
    low: low.map((v, k) => (v - Octacut.center[k]) / Octacut.unit),
    high: high.map((v, k) => (v - Octacut.center[k]) / Octacut.unit),
  };
  Octacut.toViewer = point =>
    point.map((v, k) => (v - Octacut.center[k]) / Octacut.unit);

  Octacut.decodePositions = function (mesh) {
    const quantised = new Uint16Array(blobBytes(mesh.positions).buffer);
    const positions = new Float32Array(quantised.length);
    for (let k = 0; k < 3; ++k) {
      const offset = (mesh.box_min[k] - Octacut.center[k]) / Octacut.unit;
      const step = (mesh.box_max[k] - mesh.box_min[k]) / 65535 / Octacut.unit;
      for (let i = k; i < quantised.length; i += 3) {
        positions[i] = offset + step * quantised[i];
      }
    }
    return positions;
  };

  Octacut.decodeIndices = function (mesh) {
    const bytes = blobBytes(mesh.indices);
    const indices = new Uint32Array(bytes.length / 3);
    for (let i = 0, j = 0; i < indices.length; ++i, j += 3) {
      indices[i] = bytes[j] | (bytes[j + 1] << 8) | (bytes[j + 2] << 16);
    }
    return indices;
  };

  Octacut.decodeValues = values => new Float32Array(blobBytes(values.blob).buffer);

  Octacut.photographUrl = function (photograph) {
    const text = document.getElementById('blob-' + photograph.blob).textContent;
    return 'data:image/jpeg;base64,' + text;
  };
})();
