'use strict';
// The cards beside the viewer: what was measured, in words, tables and curves.
(function () {
  const { make, table, card, percent, share, count } = Octacut;
  const page = Octacut.page;
  const report = Octacut.report;

  // The meshes of the page with their members of the report.
  function entries(withReference) {
    const all = report.meshes.map((measured, i) => ({
      measured: measured, mesh: page.meshes[i] }));
    if (withReference && report.reference) {
      all.push({ measured: report.reference, mesh: page.meshes[report.meshes.length] });
    }
    return all;
  }
  const compared = () => entries(false).filter(e => e.measured.comparison);
  const nameColumn = {
    head: 'mesh', id: 'name', cell: e => Octacut.nameTag(e.mesh) };
  const note = text => make('p', { class: 'note' }, text);

  function statisticColumns(word) {
    const side = (name, key, statistic) => ({
      head: name, number: true, id: key + '.' + statistic,
      cell: e => percent(e.measured.comparison[key][statistic + '_over_diagonal']),
    });
    return [
      nameColumn,
      side(word + ' to: mean', 'to_reference', 'mean'),
      side('median', 'to_reference', 'median'),
      side('90 %', 'to_reference', 'percentile_90'),
      side('max', 'to_reference', 'max'),
      side('from: mean', 'from_reference', 'mean'),
      side('90 %', 'from_reference', 'percentile_90'),
      side('max', 'from_reference', 'max'),
    ];
  }

  // The figures of a benchmark's protocol, by the names that it uses.
  Octacut.benchmarkCard = function () {
    const protocol = report.protocol;
    if (!protocol) {
      return null;
    }
    const items = entries(false);
    const number = figure => figure.kind === 'distance' ? figure.value.toPrecision(6)
      : figure.kind === 'fraction' ? share(figure.value) + ' %' : count(figure.value);
    const columns = [nameColumn];
    items[0].measured.protocol.scores.forEach((score, i) => {
      const at = ' at ' + score.tolerance;
      const column = (head, key) => columns.push({
        head: head + at + ', %', number: true, id: key + '.' + i,
        cell: e => share(e.measured.protocol.scores[i][key]) });
      column(protocol.name === 'eth3d' ? 'accuracy' : 'precision', 'precision');
      column(protocol.name === 'eth3d' ? 'completeness' : 'recall', 'recall');
      column('F', 'f_score');
    });
    items[0].measured.protocol.figures.forEach((figure, i) => columns.push({
      head: figure.name, number: true, id: 'figure.' + i,
      cell: e => number(e.measured.protocol.figures[i]) }));
    return card('benchmark-card', 'Protocol ' + protocol.name,
      table(columns, items, { id: 'benchmark' }), note(protocol.rules
        + ' Distances are in the units of the reference.'));
  };

  Octacut.distanceCard = function () {
    const items = compared();
    if (!items.length) {
      return null;
    }
    const other = page.compared_with;
    const title = page.has_truth ? 'Error against the truth' : 'Distance to ' + other;
    const children = [table(
      statisticColumns(page.has_truth ? 'error' : 'distance'), items, { id: 'distances' })];
    children.unshift(note(page.has_truth
      ? 'In % of the diagonal of ' + other + ', which is declared to be the truth. '
        + '“to” is from the mesh to the truth (accuracy), “from” is from the truth to '
        + 'the mesh (completeness).'
      : 'In % of the diagonal of ' + other + '. No mesh is declared to be the truth: '
        + 'distances say how far the surfaces are apart, not which one is right.'));
    children.push(...curveParts(items));
    return card('distance-card', title, ...children);
  };

  function curveParts(items) {
    const curve = items[0].measured.comparison.curves;
    const all = [];
    for (const e of items) {
      all.push(e.measured.comparison.curves.to, e.measured.comparison.curves.from);
    }
    const range = Octacut.usedRange(all);
    const lines = transform => items.flatMap(e => [
      { points: transform(e.measured.comparison.curves.to), colour: e.mesh.tint, dashed: false },
      { points: transform(e.measured.comparison.curves.from), colour: e.mesh.tint, dashed: true },
    ]);
    const densities = lines(Octacut.density);
    const top = Math.max(...densities.map(line => Math.max(...line.points))) || 1;
    const percentLabel = v => Number((100 * v).toPrecision(2)) + ' %';
    const histogram = Octacut.chart({
      lines: densities, range: range, curve: curve, top: top, yLabel: percentLabel,
      label: 'Histogram of distances', id: 'histogram' });
    const cumulative = Octacut.chart({
      lines: lines(f => f), range: range, curve: curve, top: 1, yLabel: percentLabel,
      label: 'Share of samples within a distance', id: 'cumulative' });
    return [
      make('h3', {}, 'Histogram'), histogram.svg,
      make('h3', {}, 'Share within a distance'), cumulative.svg,
      note('Solid: from the mesh to the reference. Dashed: from the reference to the mesh.'),
      thresholdPart(items, curve, range, [histogram, cumulative]),
    ];
  }

  // The slider stands on thresholds of the curve, whose values are exact.
  function thresholdPart(items, curve, range, charts) {
    const start = Math.round((Math.log10(0.001) + curve.decades) * curve.steps_per_decade);
    const output = make('output', { id: 'threshold-value', for: 'threshold' });
    const result = make('div', { id: 'scores' });
    const slider = make('input', {
      type: 'range', id: 'threshold', min: range.first, max: range.last, step: 1,
      value: Math.min(range.last, Math.max(range.first, start)),
      'aria-label': 'threshold',
    });
    const update = () => {
      const i = Number(slider.value);
      const threshold = Octacut.curveThreshold(curve, i);
      output.textContent = percent(threshold) + ' %';
      slider.setAttribute('aria-valuetext', output.textContent);
      charts.forEach(chart => chart.setMark(i));
      const to = e => e.measured.comparison.curves.to[i];
      const from = e => e.measured.comparison.curves.from[i];
      const f = e => to(e) + from(e) > 0 ? (2 * to(e) * from(e)) / (to(e) + from(e)) : 0;
      const columns = page.has_truth
        ? [nameColumn,
          { head: 'precision, %', number: true, id: 'precision', cell: e => share(to(e)) },
          { head: 'recall, %', number: true, id: 'recall', cell: e => share(from(e)) },
          { head: 'F, %', number: true, id: 'f', cell: e => share(f(e)) }]
        : [nameColumn,
          { head: 'of the mesh, %', number: true, id: 'precision', cell: e => share(to(e)) },
          { head: 'of ' + page.compared_with + ', %', number: true, id: 'recall',
            cell: e => share(from(e)) }];
      result.textContent = '';
      result.append(table(columns, items, { id: 'score-table' }));
    };
    slider.addEventListener('input', update);
    update();
    return make('div', { class: 'threshold' },
      make('label', { for: 'threshold' }, 'Threshold'), slider, output, result);
  }

  Octacut.photographCard = function () {
    const items = entries(false).filter(e => e.measured.silhouettes);
    if (!items.length) {
      return null;
    }
    const reprojection = (e, key, text) =>
      e.measured.reprojection ? text(e.measured.reprojection[key]) : '–';
    const columns = [nameColumn,
      { head: 'support', number: true, id: 'support',
        title: 'Mean correlation of the photographs over the object; parts left out count as 0',
        cell: e => e.measured.photo_support ? e.measured.photo_support.mean.toFixed(4) : '–' },
      { head: 'correlation', number: true, id: 'correlation',
        cell: e => reprojection(e, 'mean_correlation', v => v.toFixed(4)) },
      { head: 'compared, %', number: true, id: 'compared',
        cell: e => reprojection(e, 'compared_fraction', share) },
      { head: 'object covered, %', number: true, id: 'covered',
        cell: e => share(1 - e.measured.silhouettes.missed) },
      { head: 'outside, %', number: true, id: 'excess',
        cell: e => share(e.measured.silhouettes.excess) },
      { head: 'outline: mean, px', number: true, id: 'outline',
        cell: e => e.measured.silhouettes.outline_mean.toFixed(3) }];
    const parts = [rankingPart(), table(columns, items, { id: 'photographs' }), note(
      '“support” is the mean correlation between each photograph and its neighbours, '
      + 'reprojected over the mesh, over all textured pixels of the object; pixels that the '
      + 'mesh does not explain count as 0. “object covered” is the part of the masks that '
      + 'the mesh fills.')];
    return card('photograph-card', 'What the photographs say', ...parts.filter(Boolean));
  };

  function rankingPart() {
    const ranking = report.ranking;
    if (!ranking) {
      return '';
    }
    const list = make('ol', { id: 'ranking' }, ...ranking.order.map(name => {
      const mesh = page.meshes.find(m => m.name === name);
      return make('li', {}, Octacut.nameTag(mesh));
    }));
    const sentences = ranking.pairs.map(pair => {
      const interval = '95 % of resampled differences lie in ' + pair.low.toFixed(4)
        + ' … ' + pair.high.toFixed(4)
      + (pair.p_value < 0.001 ? ', p < 0.001' : ', p = ' + pair.p_value.toPrecision(2));
      return make('li', {}, pair.more_than_chance
        ? pair.better + ' is supported better than ' + pair.worse + ' by '
          + pair.mean.toFixed(4) + ' (' + interval + ').'
        : 'Between ' + pair.better + ' and ' + pair.worse
          + ' the photographs do not decide: the difference of ' + pair.mean.toFixed(4)
          + ' is not more than chance (' + interval + ').');
    });
    return make('div', {},
      make('h3', {}, 'Ranking by the photographs alone'), list,
      make('ul', { class: 'sentences' }, ...sentences));
  }

  Octacut.placesCard = function (viewer) {
    const lists = page.meshes.filter(mesh => mesh.places.length).map(mesh => {
      const items = mesh.places.map((place, i) => make('li', {},
        make('button', {
          type: 'button', class: 'place', 'data-mesh': mesh.name, 'data-place': i,
          onclick: () => viewer.camera.flyToPlace(place.position, place.normal),
        }, placeText(mesh, place))));
      return make('div', {}, make('h3', {}, Octacut.nameTag(mesh)),
        make('ol', { class: 'places' }, ...items));
    });
    if (!lists.length) {
      return null;
    }
    const kinds = new Set(page.meshes.map(mesh => mesh.place_kind));
    const text = kinds.has('support')
      ? 'Where the photographs contradict a mesh most. A click flies there.'
      : 'Where a mesh is furthest from ' + page.compared_with + '. A click flies there.';
    return card('places-card', page.has_truth ? 'Ten worst places' : 'Ten places to look at',
      note(text), make('div', { class: 'place-lists' }, ...lists));
  };

  function placeText(mesh, place) {
    return mesh.place_kind === 'support'
      ? 'support ' + place.value.toFixed(3)
      : percent(place.value / page.diagonal) + ' %';
  }

  Octacut.viewsCard = function (viewer) {
    const items = entries(false).filter(e => e.measured.photo_support);
    if (!items.length) {
      return null;
    }
    const lists = items.map(e => {
      const views = e.measured.photo_support.views
        .map((view, i) => Object.assign({ index: i }, view))
        .filter(view => view.contradicts).sort((a, b) => a.support - b.support);
      const rows = views.slice(0, 10).map(view => {
        const photograph = page.photographs.find(p => p.view === view.index);
        return make('li', {}, make('button', {
          type: 'button', class: 'place', disabled: !photograph,
          onclick: () => viewer.showPhotograph(photograph),
        }, view.name + ': support ' + view.support.toFixed(3)));
      });
      return make('div', {}, make('h3', {}, Octacut.nameTag(e.mesh)),
        views.length ? make('ol', { class: 'places' }, ...rows)
          : note('No view stands out.'));
    });
    return card('views-card', 'Views that contradict a mesh',
      note('Views whose support lies more than three robust standard deviations below the '
        + 'median of all views.'),
      make('div', { class: 'place-lists' }, ...lists));
  };

  Octacut.auditCard = function () {
    const audit = e => e.measured.audit;
    const isCloud = e => audit(e).triangles === 0;
    const yes = (e, flag, number) =>
      isCloud(e) ? '–' : flag ? 'yes' : 'no (' + count(number) + ')';
    const columns = [nameColumn,
      { head: 'vertices', number: true, id: 'vertices', cell: e => count(audit(e).vertices) },
      { head: 'triangles', number: true, id: 'triangles', cell: e => count(audit(e).triangles) },
      { head: 'closed', id: 'closed', cell: e => yes(e, audit(e).closed, audit(e).boundary_edges) },
      { head: 'manifold', id: 'manifold', cell: e => yes(e,
        audit(e).edge_manifold && audit(e).vertex_manifold,
        audit(e).nonmanifold_edges + audit(e).nonmanifold_vertices) },
      { head: 'oriented', id: 'oriented',
        cell: e => yes(e, audit(e).oriented, audit(e).misoriented_edges) },
      { head: 'genus', number: true, id: 'genus', cell: e => count(audit(e).genus) },
      { head: 'components', number: true, id: 'components', cell: e => count(audit(e).components) },
      { head: 'self-intersecting', number: true, id: 'self_intersections',
        cell: e => e.measured.self_intersections
          ? count(e.measured.self_intersections.triangles) : '–' }];
    return card('audit-card', 'Audit', table(columns, entries(true), { id: 'audit' }),
      note('Of the full meshes. In brackets: boundary edges, edges and vertices that are not '
        + 'manifold, edges whose triangles disagree about the outside.'));
  };

  Octacut.procedureCard = function () {
    const download = make('button', { type: 'button', id: 'download', onclick: () => {
      const url = URL.createObjectURL(new Blob(
        [JSON.stringify(report, null, 2) + '\n'], { type: 'application/json' }));
      const link = make('a', { href: url, download: 'octacut-report.json' });
      document.body.append(link);
      link.click();
      link.remove();
      setTimeout(() => URL.revokeObjectURL(url), 1000);
    } }, 'Download the report (JSON)');
    return card('procedure-card', 'Procedure',
      make('ul', { class: 'sentences', id: 'procedure' },
        ...page.procedure.map(line => make('li', {}, line))),
      make('h3', {}, 'Command'),
      make('pre', { tabindex: 0 }, page.command_line),
      download);
  };
})();
