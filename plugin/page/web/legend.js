'use strict';
// The legend of the colours, with a range that can be moved.
(function () {
  const { make } = Octacut;

  class Legend {
    constructor(viewer, kinds) {
      this.viewer = viewer;
      this.bar = make('canvas', { width: 256, height: 1, class: 'legend-bar' });
      this.low = make('span', {});
      this.middle = make('span', {});
      this.high = make('span', {});
      this.title = make('span', { class: 'legend-title' });
      this.slider = make('input', {
        type: 'range', min: 0, max: 200, step: 1, id: 'range',
        'aria-label': 'range of the colours',
        oninput: () => this.slide(),
      });
      this.element = make('div', { class: 'legend', id: 'legend' }, this.title, this.bar,
        make('div', { class: 'legend-ticks' }, this.low, this.middle, this.high), this.slider);
      this.limits = {};
      for (const kind of kinds) {
        this.limits[kind] = this.findLimits(kind);
      }
    }

    // The slider is logarithmic, from a three-hundredth of what nearly all values
    // reach; it begins at a third of it.
    findLimits(kind) {
      if (kind === 'support') {
        this.viewer.state.range.support = 1;
        return { low: 0.05, high: 1 };
      }
      let most = 0;
      for (const surface of this.viewer.surfaces) {
        for (const values of surface.mesh.values.filter(v => v.kind === kind)) {
          most = Math.max(most, surface.usualExtent(values));
        }
      }
      most = Math.max(most, 1e-6);
      this.viewer.state.range[kind] = most / 3;
      return { low: most / 300, high: most * 1.5 };
    }

    slide() {
      const { low, high } = this.limits[this.kind];
      this.setExtent(low * Math.pow(high / low, this.slider.value / 200));
    }

    setExtent(extent) {
      const { low, high } = this.limits[this.kind];
      this.viewer.state.range[this.kind] = Math.min(high, Math.max(low, extent));
      this.viewer.requestDraw();
      this.update();
    }

    scaleBy(factor) {
      if (this.kind) {
        this.setExtent(this.viewer.state.range[this.kind] * factor);
      }
    }

    show(kind) {
      this.kind = this.limits[kind] ? kind : null;
      this.element.hidden = this.kind === null;
      if (this.kind) {
        const context = this.bar.getContext('2d');
        for (let i = 0; i < 256; ++i) {
          context.fillStyle = Octacut.css(Octacut.scales[kind](i / 255));
          context.fillRect(i, 0, 1, 1);
        }
        this.update();
      }
    }

    update() {
      const extent = this.viewer.state.range[this.kind];
      const { low, high } = this.limits[this.kind];
      this.slider.value = Math.round((200 * Math.log(extent / low)) / Math.log(high / low));
      if (this.kind === 'distance') {
        const page = Octacut.page;
        this.title.textContent = (page.has_truth ? 'Signed error' : 'Signed distance')
          + ', % of the diagonal';
        this.low.textContent = Octacut.tick(-extent) + ' inside';
        this.middle.textContent = '0';
        this.high.textContent = 'outside ' + Octacut.tick(extent);
      } else {
        this.title.textContent = 'Support by the photographs (correlation)';
        this.low.textContent = '0';
        this.middle.textContent = '';
        this.high.textContent = extent.toFixed(2);
      }
      this.slider.setAttribute('aria-valuetext', this.high.textContent);
    }
  }

  Octacut.Legend = Legend;
})();
