'use strict';
// A mesh or a cloud of the page as an object of three.js.
(function () {
  const none = 1e30;

  class Surface {
    constructor(mesh) {
      this.mesh = mesh;
      this.visible = true;
      const geometry = new THREE.BufferGeometry();
      geometry.setAttribute('position',
        new THREE.BufferAttribute(Octacut.decodePositions(mesh), 3));
      this.isCloud = mesh.triangles === 0;
      if (this.isCloud) {
        geometry.setAttribute('normal',
          new THREE.BufferAttribute(new Float32Array(3 * mesh.vertices), 3));
      } else {
        geometry.setIndex(new THREE.BufferAttribute(Octacut.decodeIndices(mesh), 1));
        geometry.computeVertexNormals();
      }
      geometry.setAttribute('color3', this.colors());
      this.geometry = geometry;
      this.material = Octacut.makeMeshMaterial('#cfc6b8');
      this.material.uniforms.lit.value = !this.isCloud;
      this.object = this.isCloud
        ? new THREE.Points(geometry, this.material)
        : new THREE.Mesh(geometry, this.material);
      this.object.frustumCulled = false;
      this.lines = null;
      this.decoded = new Map();
      this.showValues(null);
    }

    colors() {
      if (this.mesh.colors === undefined) {
        return new THREE.BufferAttribute(
          new Uint8Array(3 * this.mesh.vertices).fill(170), 3, true);
      }
      return new THREE.BufferAttribute(Octacut.blobBytes(this.mesh.colors), 3, true);
    }

    hasColors() {
      return this.mesh.colors !== undefined;
    }

    // Null, or one of mesh.values: distances as fractions of the diagonal.
    showValues(values) {
      this.values = values;
      if (!this.decoded.has(values)) {
        this.decoded.set(values, new THREE.BufferAttribute(this.decode(values), 1));
      }
      this.geometry.setAttribute('value', this.decoded.get(values));
      if (this.lines) {
        this.lines.geometry.setAttribute('value', this.decoded.get(values));
      }
    }

    decode(values) {
      const decoded = values === null
        ? new Float32Array(this.mesh.vertices).fill(none)
        : Octacut.decodeValues(values);
      const unit = values && values.kind === 'distance' ? Octacut.page.diagonal : 1;
      for (let i = 0; i < decoded.length; ++i) {
        decoded[i] = Number.isFinite(decoded[i]) ? decoded[i] / unit : none;
      }
      return decoded;
    }

    // The largest |value| but for a thousandth.
    usualExtent(values) {
      const attribute = this.decoded.get(values) ||
        new THREE.BufferAttribute(this.decode(values), 1);
      this.decoded.set(values, attribute);
      const sizes = Float32Array.from(attribute.array)
        .filter(v => v < none / 2).map(Math.abs).sort();
      return sizes.length ? sizes[Math.floor(0.999 * (sizes.length - 1))] : 0;
    }

    // Made when first asked for; clouds have none.
    wireframe() {
      if (!this.lines) {
        const triangles = this.geometry.index.array;
        const ends = new Uint32Array(2 * triangles.length);
        for (let i = 0, j = 0; i < triangles.length; i += 3) {
          for (let k = 0; k < 3; ++k) {
            ends[j++] = triangles[i + k];
            ends[j++] = triangles[i + (k + 1) % 3];
          }
        }
        const geometry = new THREE.BufferGeometry();
        for (const name of ['position', 'normal', 'color3', 'value']) {
          geometry.setAttribute(name, this.geometry.getAttribute(name));
        }
        geometry.setIndex(new THREE.BufferAttribute(ends, 1));
        this.lines = new THREE.LineSegments(
          geometry, Octacut.makeLineMaterial(this.material.uniforms.cut));
        this.lines.frustumCulled = false;
      }
      return this.lines;
    }
  }

  Octacut.Surface = Surface;
})();
