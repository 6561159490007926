'use strict';
// Puts the page together.
(function () {
  const { make } = Octacut;
  const page = Octacut.page;

  function subtitle() {
    const sum = size => page.meshes.reduce((total, mesh) => total + size(mesh), 0);
    const parts = [];
    if (page.meshes.some(mesh => mesh.triangles)) {
      parts.push('from ' + Octacut.count(sum(mesh => mesh.full_triangles)) + ' to '
        + Octacut.count(sum(mesh => mesh.triangles)) + ' triangles');
    }
    const clouds = mesh => mesh.full_points;
    if (page.meshes.some(clouds)) {
      parts.push('from ' + Octacut.count(sum(clouds)) + ' to '
        + Octacut.count(sum(mesh => clouds(mesh) ? mesh.vertices : 0)) + ' points');
    }
    const simplified = page.meshes.some(mesh => mesh.simplified);
    const views = page.num_views
      ? ' Photographs: ' + page.photographs.length
        + (page.photographs.length < page.num_views ? ' of ' + page.num_views : '') + ', reduced.'
      : '';
    return (simplified
      ? 'For display, the meshes are simplified ' + parts.join(' and ')
        + ', and quantised to 16 bits. '
      : 'For display, coordinates are quantised to 16 bits. ')
      + 'All figures are measured on the full meshes.' + views;
  }

  function setTheme(button) {
    const root = document.documentElement;
    const dark = root.dataset.theme
      ? root.dataset.theme === 'dark'
      : window.matchMedia('(prefers-color-scheme: dark)').matches;
    root.dataset.theme = dark ? 'light' : 'dark';
    button.textContent = dark ? 'Dark' : 'Light';
  }

  function start() {
    document.title = page.title;
    document.getElementById('title').textContent = page.title;
    document.getElementById('subtitle').textContent = subtitle();
    const canvas = document.getElementById('viewer');
    let viewer;
    try {
      viewer = new Octacut.Viewer(canvas, document.getElementById('labels'));
    } catch (error) {
      document.getElementById('stage').replaceWith(make('p', { class: 'note', role: 'alert' },
        'This browser cannot show the meshes, because it lacks WebGL. The figures are below.'));
    }
    if (viewer) {
      const kinds = new Set(page.meshes.flatMap(mesh => mesh.values.map(v => v.kind)));
      const legend = new Octacut.Legend(viewer, kinds);
      document.getElementById('stage').after(legend.element);
      viewer.showPhotograph = () => {};
      viewer.stepPhotograph = () => {};
      document.getElementById('stage').before(Octacut.toolbar(viewer, legend));
      Octacut.connectPointer(canvas, viewer.camera);
      const click = id => () => document.getElementById(id).click();
      Octacut.connectKeys(canvas, viewer.camera, {
        w: click('wireframe'), s: click('section'),
        o: page.meshes.length > 1 ? click('together') : () => {},
        n: () => viewer.stepPhotograph(1), p: () => viewer.stepPhotograph(-1),
        '[': () => legend.scaleBy(1 / 1.25), ']': () => legend.scaleBy(1.25),
      });
      viewer.draw();
      viewer.finish();
      document.documentElement.dataset.firstFrame = String(Math.round(performance.now()));
    }
    const theme = document.getElementById('theme');
    theme.addEventListener('click', () => {
      setTheme(theme);
      if (viewer) {
        viewer.requestDraw();
      }
    });
    const cards = document.getElementById('cards');
    for (const build of [Octacut.benchmarkCard, Octacut.photographCard, Octacut.distanceCard, Octacut.placesCard,
      Octacut.viewsCard, Octacut.auditCard, Octacut.procedureCard]) {
      const element = build(viewer);
      if (element) {
        cards.append(element);
      }
    }
    Octacut.viewer = viewer;
    document.documentElement.dataset.ready = String(Math.round(performance.now()));
  }

  start();
})();
