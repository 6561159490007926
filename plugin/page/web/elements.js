'use strict';
// Small helpers that make elements of the document.
(function () {
  // make('td', {class: 'number'}, 'text', child, ...)
  Octacut.make = function (name, attributes, ...children) {
    const element = document.createElement(name);
    for (const [key, value] of Object.entries(attributes || {})) {
      if (key.startsWith('on')) {
        element.addEventListener(key.slice(2), value);
      } else if (value === true) {
        element.setAttribute(key, '');
      } else if (value !== false && value !== null && value !== undefined) {
        element.setAttribute(key, value);
      }
    }
    element.append(...children);
    return element;
  };

  Octacut.makeSvg = function (name, attributes, ...children) {
    const element = document.createElementNS('http://www.w3.org/2000/svg', name);
    for (const [key, value] of Object.entries(attributes || {})) {
      element.setAttribute(key, value);
    }
    element.append(...children);
    return element;
  };

  // A mesh's name with its colour.
  Octacut.nameTag = function (mesh) {
    const text = mesh.name + (mesh.reference
      ? Octacut.page.has_truth ? ' (truth)' : ' (reference)' : '');
    return Octacut.make('span', { class: 'name-tag' },
      Octacut.make('i', { class: 'dot', style: 'background:' + mesh.tint }), text);
  };

  // Columns: {head, cell: item => text or node, number: bool, title}.
  Octacut.table = function (columns, items, attributes) {
    const head = Octacut.make('tr', {}, ...columns.map(column =>
      Octacut.make('th', {
        scope: 'col', class: column.number ? 'number' : null, title: column.title,
      }, column.head)));
    const rows = items.map(item => Octacut.make('tr', {}, ...columns.map(column =>
      Octacut.make('td', {
        class: column.number ? 'number' : null,
        'data-column': column.id,
      }, column.cell(item)))));
    return Octacut.make('div', { class: 'table-frame' },
      Octacut.make('table', attributes || {},
        Octacut.make('thead', {}, head), Octacut.make('tbody', {}, ...rows)));
  };

  // A card of the page. `id` names it for tests and links.
  Octacut.card = function (id, title, ...children) {
    return Octacut.make('section', { class: 'card', id: id, 'aria-labelledby': id + '-title' },
      Octacut.make('h2', { id: id + '-title' }, title), ...children);
  };
})();
