'use strict';
// Draws the meshes, side by side or together, and mixes them with photographs.
(function () {
  // Antialiasing takes four times as long where the processor draws: browsers
  // refuse a context without a caveat then, or name the renderer.
  function hasHardware() {
    const canvas = document.createElement('canvas');
    const context = canvas.getContext('webgl', { failIfMajorPerformanceCaveat: true });
    if (!context) {
      return false;
    }
    const names = context.getExtension('WEBGL_debug_renderer_info');
    const renderer = names ? context.getParameter(names.UNMASKED_RENDERER_WEBGL) : '';
    const extension = context.getExtension('WEBGL_lose_context');
    if (extension) {
      extension.loseContext();
    }
    return !/swiftshader|llvmpipe|softpipe|software|basic render/i.test(renderer);
  }

  class Viewer {
    constructor(canvas, labels) {
      this.canvas = canvas;
      this.labels = labels;
      this.renderer = new THREE.WebGLRenderer({
        canvas: canvas, antialias: hasHardware() });
      this.renderer.autoClear = false;
      this.renderer.setScissorTest(true);
      this.surfaces = Octacut.page.meshes.map(mesh => new Octacut.Surface(mesh));
      this.scene = new THREE.Scene();
      for (const surface of this.surfaces) {
        this.scene.add(surface.object);
      }
      this.state = {
        together: false,
        colourBy: 'plain',
        range: { distance: 0.01, support: 1 },
        wireframe: false,
        section: { on: false, axis: 0, position: 0.5, flipped: false },
        mix: { amount: 0.5, difference: false },
      };
      this.camera = new Octacut.SharedCamera(() => this.requestDraw());
      this.screen = new THREE.Mesh(
        new THREE.PlaneBufferGeometry(2, 2), Octacut.makeMixMaterial());
      this.screen.frustumCulled = false;
      this.screenScene = new THREE.Scene();
      this.screenScene.add(this.screen);
      this.target = null;
      this.textures = new Map();
      this.waiting = false;
      new ResizeObserver(() => this.requestDraw()).observe(canvas.parentElement);
    }

    requestDraw() {
      if (!this.waiting && this.camera) {
        this.waiting = true;
        requestAnimationFrame(now => {
          this.waiting = false;
          const goesOn = this.camera.advance(now);
          this.draw();
          if (goesOn) {
            this.requestDraw();
          }
        });
      }
    }

    set(changes) {
      Object.assign(this.state, changes);
      this.requestDraw();
    }

    // The parts of the canvas, each with the surfaces that it shows.
    viewports(width, height) {
      const shown = this.surfaces.filter(surface => surface.visible);
      if (this.state.together || shown.length <= 1) {
        return [{ x: 0, y: 0, width: width, height: height, surfaces: shown }];
      }
      let columns = 1;
      let best = 0;
      for (let n = 1; n <= shown.length; ++n) {
        const side = Math.min(width / n, height / Math.ceil(shown.length / n));
        if (side > best * 1.02) {
          best = side;
          columns = n;
        }
      }
      const rows = Math.ceil(shown.length / columns);
      return shown.map((surface, i) => ({
        x: ((i % columns) * width) / columns,
        y: (Math.floor(i / columns) * height) / rows,
        width: width / columns,
        height: height / rows,
        surfaces: [surface],
      }));
    }

    draw() {
      const box = this.canvas.parentElement.getBoundingClientRect();
      const width = Math.max(1, Math.round(box.width));
      const height = Math.max(1, Math.round(box.height));
      const ratio = Math.min(2, window.devicePixelRatio || 1);
      if (this.width !== width || this.height !== height || this.ratio !== ratio) {
        Object.assign(this, { width: width, height: height, ratio: ratio });
        this.renderer.setPixelRatio(ratio);
        this.renderer.setSize(width, height);
      }
      const background = new THREE.Color(
        getComputedStyle(document.documentElement)
          .getPropertyValue('--viewer').trim());
      this.renderer.setRenderTarget(null);
      this.renderer.setClearColor(background, 1);
      this.renderer.setScissor(0, 0, width, height);
      this.renderer.setViewport(0, 0, width, height);
      this.renderer.clear();
      const viewports = this.viewports(width, height);
      for (const viewport of viewports) {
        this.drawViewport(viewport, background);
      }
      this.placeLabels(viewports);
      if (this.onFrame) {
        this.onFrame();
      }
    }

    // Waits until what was drawn is there.
    finish() {
      const gl = this.renderer.getContext();
      gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, new Uint8Array(4));
    }

    drawViewport(viewport, background) {
      this.prepare(viewport.surfaces);
      const camera = this.camera.forViewport(viewport.width, viewport.height);
      const bottom = this.height - viewport.y - viewport.height;
      const texture = this.camera.photograph &&
        this.texture(this.camera.photograph);
      if (texture) {
        this.renderToTarget(viewport, camera);
      }
      this.renderer.setViewport(viewport.x, bottom, viewport.width, viewport.height);
      this.renderer.setScissor(viewport.x, bottom, viewport.width, viewport.height);
      if (texture) {
        this.drawMix(viewport, texture, background, camera);
      } else {
        this.renderer.render(this.scene, camera);
      }
    }

    prepare(shown) {
      const { section, wireframe, together, mix } = this.state;
      const comparing = this.camera.photograph !== null && mix.difference;
      for (const surface of this.surfaces) {
        const uniforms = surface.material.uniforms;
        surface.object.visible = shown.includes(surface);
        uniforms.lit.value = !comparing && !surface.isCloud;
        uniforms.pointSize.value = 3 * this.ratio;
        this.paint(surface, comparing);
        if (together && shown.length > 1) {
          uniforms.tint.value.set(surface.mesh.tint);
        } else {
          uniforms.tint.value.set('#cfc6b8');
        }
        this.setCut(uniforms.cut.value, section);
        if (surface.lines) {
          this.scene.remove(surface.lines);
        }
        if (wireframe && surface.object.visible && !comparing && !surface.isCloud) {
          this.scene.add(surface.wireframe());
        }
      }
    }

    paint(surface, comparing) {
      const uniforms = surface.material.uniforms;
      const by = comparing ? 'photographs' : this.state.colourBy;
      if (by === 'photographs') {
        uniforms.paint.value = surface.hasColors() ? 1 : 0;
      } else if (by === 'plain') {
        uniforms.paint.value = 0;
      } else {
        const values = surface.mesh.values.find(v => v.kind === by) || null;
        if (surface.values !== values &&
            !(surface.values && surface.values.kind === by)) {
          surface.showValues(values);
        }
        uniforms.paint.value = values ? 2 : 0;
        uniforms.scale.value = Octacut.scaleTextures[by];
        const extent = this.state.range[by];
        uniforms.range.value.set(by === 'distance' ? -extent : 0, extent);
      }
    }

    setCut(cut, section) {
      if (!section.on) {
        cut.set(0, 0, 0, 1);
        return;
      }
      const normal = [0, 0, 0];
      const sign = section.flipped ? -1 : 1;
      normal[section.axis] = sign;
      const low = Octacut.box.low[section.axis];
      const high = Octacut.box.high[section.axis];
      cut.set(...normal, sign * (low + section.position * (high - low)));
    }

    renderToTarget(viewport, camera) {
      const width = Math.max(1, Math.round(viewport.width * this.ratio));
      const height = Math.max(1, Math.round(viewport.height * this.ratio));
      if (!this.target) {
        this.target = new THREE.WebGLRenderTarget(width, height);
      }
      if (this.target.width !== width || this.target.height !== height) {
        this.target.setSize(width, height);
      }
      this.renderer.setRenderTarget(this.target);
      this.renderer.setClearColor(0x000000, 0);
      this.renderer.clear();
      this.renderer.render(this.scene, camera);
      this.renderer.setRenderTarget(null);
    }

    drawMix(viewport, texture, background, camera) {
      const uniforms = this.screen.material.uniforms;
      const rect = this.camera.photographRectangle(viewport.width, viewport.height);
      uniforms.photograph.value = texture;
      uniforms.mesh.value = this.target.texture;
      uniforms.rectangle.value.set(rect.x, rect.y, rect.width, rect.height);
      uniforms.size.value.set(viewport.width, viewport.height);
      uniforms.amount.value = this.state.mix.amount;
      uniforms.difference.value = this.state.mix.difference;
      uniforms.background.value.copy(background);
      this.renderer.render(this.screenScene, camera);
    }

    // Null until the photograph is decoded; then draws again.
    texture(photograph) {
      if (!this.textures.has(photograph)) {
        this.textures.set(photograph, null);
        const image = new Image();
        image.onload = () => {
          const texture = new THREE.Texture(image);
          texture.minFilter = THREE.LinearFilter;
          texture.wrapS = THREE.ClampToEdgeWrapping;
          texture.wrapT = THREE.ClampToEdgeWrapping;
          texture.generateMipmaps = false;
          texture.needsUpdate = true;
          this.textures.set(photograph, texture);
          this.requestDraw();
        };
        image.src = Octacut.photographUrl(photograph);
      }
      return this.textures.get(photograph);
    }

    placeLabels(viewports) {
      const texts = viewports.map(viewport => viewport.surfaces);
      const key = JSON.stringify([
        texts.map(list => list.map(s => s.mesh.name)), this.state.together,
        viewports.map(v => [v.x, v.y]), this.camera.photograph !== null]);
      if (key === this.labelKey) {
        return;
      }
      this.labelKey = key;
      this.labels.textContent = '';
      for (const viewport of viewports) {
        const label = document.createElement('div');
        label.className = 'viewport-label';
        label.style.left = (100 * viewport.x) / this.width + '%';
        label.style.top = (100 * viewport.y) / this.height + '%';
        label.style.width = (100 * viewport.width) / this.width + '%';
        for (const surface of viewport.surfaces) {
          label.appendChild(Octacut.nameTag(surface.mesh));
        }
        this.labels.appendChild(label);
      }
    }
  }

  Octacut.Viewer = Viewer;
})();
