'use strict';
// The controls above the viewer.
(function () {
  const { make } = Octacut;
  const page = Octacut.page;

  function toggle(id, text, pressed, onChange) {
    const button = make('button', { type: 'button', id: id, 'aria-pressed': String(pressed) }, text);
    button.addEventListener('click', () => {
      const now = button.getAttribute('aria-pressed') !== 'true';
      button.setAttribute('aria-pressed', String(now));
      onChange(now);
    });
    return button;
  }

  function select(id, label, options, onChange) {
    const element = make('select', { id: id, 'aria-label': label },
      ...options.map(([value, text]) => make('option', { value: value }, text)));
    element.addEventListener('change', () => onChange(element.value));
    return element;
  }

  const labelled = (text, element) => make('label', { class: 'field' }, make('span', {}, text), element);

  function meshToggles(viewer) {
    return make('div', { class: 'group', role: 'group', 'aria-label': 'Meshes shown' },
      ...viewer.surfaces.map((surface, i) => {
        const button = toggle('mesh-' + i, '', surface.visible, on => {
          surface.visible = on;
          viewer.requestDraw();
        });
        button.append(Octacut.nameTag(surface.mesh));
        const { full_triangles, full_points, simplified, triangles } = surface.mesh;
        button.title = full_triangles > 0
          ? Octacut.count(full_triangles) + ' triangles, '
            + (simplified ? 'shown with ' + Octacut.count(triangles) : 'all shown')
          : Octacut.count(full_points) + ' points';
        return button;
      }));
  }

  function colourSelect(viewer, legend) {
    const kinds = new Set(page.meshes.flatMap(mesh => mesh.values.map(v => v.kind)));
    const options = [];
    if (kinds.has('distance')) {
      options.push(['distance', page.has_truth ? 'Signed error' : 'Signed distance']);
    }
    if (kinds.has('support')) {
      options.push(['support', 'Support by photographs']);
    }
    if (page.meshes.some(mesh => mesh.colors !== undefined)) {
      options.push(['photographs', 'Colours of the photographs']);
    }
    options.push(['plain', 'Plain']);
    const choose = value => {
      viewer.set({ colourBy: value });
      legend.show(value);
    };
    const element = select('colour', 'colour', options, choose);
    choose(options[0][0]);
    return labelled('Colour', element);
  }

  function sectionGroup(viewer) {
    const section = viewer.state.section;
    const apply = changes => {
      Object.assign(section, changes);
      viewer.requestDraw();
    };
    const slider = make('input', {
      type: 'range', id: 'section-position', min: 0, max: 1, step: 0.002, value: 0.5,
      'aria-label': 'position of the cross-section',
      oninput: event => {
        on.setAttribute('aria-pressed', 'true');
        apply({ on: true, position: Number(event.target.value) });
      },
    });
    const on = toggle('section', 'Section', false, pressed => apply({ on: pressed }));
    return make('div', { class: 'group' }, on,
      select('section-axis', 'axis of the cross-section',
        [['0', 'x'], ['1', 'y'], ['2', 'z']], axis => apply({ axis: Number(axis) })),
      slider,
      toggle('section-flip', 'Flip', false, pressed => apply({ flipped: pressed })));
  }

  function photographGroup(viewer) {
    if (!page.photographs.length) {
      return '';
    }
    const picker = select('photograph', 'photograph',
      [['', 'none']].concat(page.photographs.map((p, i) => [String(i), p.name])),
      value => viewer.showPhotograph(value === '' ? null : page.photographs[Number(value)]));
    const step = by => {
      const now = picker.value === '' ? (by > 0 ? -1 : 0) : Number(picker.value);
      const count = page.photographs.length;
      viewer.showPhotograph(page.photographs[(now + by + count) % count]);
    };
    const blend = make('input', {
      type: 'range', id: 'blend', min: 0, max: 1, step: 0.01, value: 0.5,
      'aria-label': 'blend from photograph to mesh',
      oninput: event => {
        difference.setAttribute('aria-pressed', 'false');
        Object.assign(viewer.state.mix, { amount: Number(event.target.value), difference: false });
        viewer.requestDraw();
      },
    });
    const difference = toggle('difference', 'Difference', false, on => {
      viewer.state.mix.difference = on;
      viewer.requestDraw();
    });
    const mixing = make('span', { class: 'group', id: 'mixing', hidden: true },
      make('span', { class: 'hint' }, 'photo'), blend,
      make('span', { class: 'hint' }, 'mesh'), difference);
    viewer.showPhotograph = photograph => {
      picker.value = photograph ? String(page.photographs.indexOf(photograph)) : '';
      mixing.hidden = !photograph;
      if (photograph) {
        viewer.camera.flyToPhotograph(photograph);
      } else {
        viewer.camera.leavePhotograph();
        viewer.requestDraw();
      }
    };
    // Turning leaves the photograph.
    viewer.onFrame = () => {
      const photograph = viewer.camera.photograph;
      if (!photograph && !viewer.camera.flight && picker.value !== '') {
        picker.value = '';
        mixing.hidden = true;
      }
    };
    viewer.stepPhotograph = step;
    return make('div', { class: 'group' }, labelled('Photograph', picker),
      make('button', { type: 'button', 'aria-label': 'previous photograph', onclick: () => step(-1) }, '‹'),
      make('button', { type: 'button', id: 'next-photograph', 'aria-label': 'next photograph',
        onclick: () => step(1) }, '›'),
      mixing);
  }

  Octacut.toolbar = function (viewer, legend) {
    const several = page.meshes.length > 1;
    const together = several ? toggle('together', 'Overlay', false,
      on => viewer.set({ together: on })) : '';
    const wireframe = toggle('wireframe', 'Wireframe', false, on => viewer.set({ wireframe: on }));
    const reset = make('button', {
      type: 'button', id: 'reset', onclick: () => viewer.camera.reset(true) }, 'Reset view');
    return make('div', { class: 'toolbar', role: 'toolbar', 'aria-label': 'Viewer' },
      several ? meshToggles(viewer) : '',
      make('div', { class: 'group' }, colourSelect(viewer, legend), together, wireframe, reset),
      sectionGroup(viewer), photographGroup(viewer));
  };
})();
