'use strict';
// The camera that all viewports share: it turns about a target, or stands where a
// photograph was taken.
(function () {
  const fieldOfView = (32 * Math.PI) / 180;
  const flightMilliseconds = 700;

  class SharedCamera {
    constructor(onChange) {
      this.onChange = onChange;
      this.target = new THREE.Vector3();
      this.orientation = new THREE.Quaternion();
      this.distance = 1;
      this.photograph = null;
      this.photoZoom = 1;
      this.photoShift = { x: 0, y: 0 };
      this.flight = null;
      this.camera = new THREE.PerspectiveCamera();
      this.camera.matrixAutoUpdate = true;
      this.up = this.upDirection();
      this.reset(false);
    }

    // Cameras tell what is up: the mean of their upward directions.
    upDirection() {
      const up = new THREE.Vector3(...(Octacut.page.up || [0, 1, 0]));
      return up.length() > 0.1 ? up.normalize() : new THREE.Vector3(0, 1, 0);
    }

    // Where the first camera stands, a little above; without cameras, obliquely.
    homeDirection() {
      if (!Octacut.page.front) {
        const turn = new THREE.Quaternion().setFromUnitVectors(
          new THREE.Vector3(0, 1, 0), this.up);
        return new THREE.Vector3(0.55, 0.28, 0.8).applyQuaternion(turn).normalize();
      }
      const front = new THREE.Vector3(...Octacut.toViewer(Octacut.page.front));
      front.normalize();
      const level = front.clone().addScaledVector(this.up, -front.dot(this.up));
      return level.length() > 0.3
        ? level.normalize().addScaledVector(this.up, 0.2).normalize() : front;
    }

    homePose() {
      const sizes = Octacut.box.high.map((v, k) => v - Octacut.box.low[k]);
      const radius = Math.hypot(sizes[0], sizes[1], sizes[2]) / 2;
      const orientation = new THREE.Quaternion().setFromRotationMatrix(
        new THREE.Matrix4().lookAt(this.homeDirection(), new THREE.Vector3(), this.up));
      return {
        target: new THREE.Vector3(),
        orientation: orientation,
        distance: (0.9 * radius) / Math.sin(fieldOfView / 2),
        photograph: null,
      };
    }

    reset(animated) {
      this.flyTo(this.homePose(), animated);
    }

    position(pose) {
      return new THREE.Vector3(0, 0, pose.distance)
        .applyQuaternion(pose.orientation)
        .add(pose.target);
    }

    pose() {
      return {
        target: this.target.clone(),
        orientation: this.orientation.clone(),
        distance: this.distance,
        photograph: this.photograph,
      };
    }

    take(pose) {
      this.target.copy(pose.target);
      this.orientation.copy(pose.orientation);
      this.distance = pose.distance;
      this.photograph = pose.photograph;
    }

    flyTo(pose, animated) {
      const calm = window.matchMedia('(prefers-reduced-motion: reduce)').matches;
      this.photoZoom = 1;
      this.photoShift = { x: 0, y: 0 };
      if (!animated || calm) {
        this.flight = null;
        this.take(pose);
      } else {
        this.flight = { from: this.pose(), to: pose, begin: performance.now() };
      }
      this.onChange();
    }

    // Looks at a place from where its surface faces.
    flyToPlace(position, normal) {
      const target = new THREE.Vector3(...Octacut.toViewer(position));
      let out = new THREE.Vector3(...normal);
      if (out.length() < 0.5) {
        out = target.clone().normalize();
      }
      const up = Math.abs(out.dot(this.up)) > 0.95
        ? new THREE.Vector3(1, 0, 0) : this.up;
      const matrix = new THREE.Matrix4().lookAt(out, new THREE.Vector3(), up);
      this.flyTo({
        target: target,
        orientation: new THREE.Quaternion().setFromRotationMatrix(matrix),
        distance: 0.9,
        photograph: null,
      }, true);
    }

    flyToPhotograph(photograph) {
      const r = photograph.rotation;
      const t = photograph.translation;
      const center = [0, 1, 2].map(
        k => -(r[k] * t[0] + r[3 + k] * t[1] + r[6 + k] * t[2]));
      const eye = new THREE.Vector3(...Octacut.toViewer(center));
      // World from camera, whose y and z point the other way than a photograph's.
      const matrix = new THREE.Matrix4().set(
        r[0], -r[3], -r[6], 0,
        r[1], -r[4], -r[7], 0,
        r[2], -r[5], -r[8], 0,
        0, 0, 0, 1);
      const orientation = new THREE.Quaternion().setFromRotationMatrix(matrix);
      const forward = new THREE.Vector3(0, 0, -1).applyQuaternion(orientation);
      const distance = Math.max(0.1, -eye.dot(forward));
      this.flyTo({
        target: eye.clone().addScaledVector(forward, distance),
        orientation: orientation,
        distance: distance,
        photograph: photograph,
      }, true);
    }

    leavePhotograph() {
      this.flight = null;
      this.photograph = null;
      this.photoZoom = 1;
      this.photoShift = { x: 0, y: 0 };
    }

    turn(dx, dy) {
      this.leavePhotograph();
      const rotation = new THREE.Quaternion().setFromEuler(
        new THREE.Euler(-dy, -dx, 0, 'YXZ'));
      this.orientation.multiply(rotation).normalize();
      this.onChange();
    }

    // By fractions of the viewport's height.
    shift(dx, dy) {
      this.flight = null;
      if (this.photograph) {
        this.photoShift.x += dx;
        this.photoShift.y += dy;
      } else {
        const height = 2 * this.distance * Math.tan(fieldOfView / 2);
        this.target.add(new THREE.Vector3(-dx * height, dy * height, 0)
          .applyQuaternion(this.orientation));
      }
      this.onChange();
    }

    zoom(factor) {
      this.flight = null;
      if (this.photograph) {
        this.photoZoom = Math.min(30, Math.max(0.5, this.photoZoom * factor));
      } else {
        this.distance = Math.min(60, Math.max(0.02, this.distance / factor));
      }
      this.onChange();
    }

    // One step of a flight; returns whether it goes on.
    advance(now) {
      if (!this.flight) {
        return false;
      }
      const { from, to, begin } = this.flight;
      const linear = Math.min(1, (now - begin) / flightMilliseconds);
      const t = linear * linear * (3 - 2 * linear);
      this.take({
        target: from.target.clone().lerp(to.target, t),
        orientation: from.orientation.clone().slerp(to.orientation, t),
        distance: from.distance * Math.pow(to.distance / from.distance, t),
        photograph: linear === 1 ? to.photograph : null,
      });
      if (linear === 1) {
        this.flight = null;
      }
      return this.flight !== null;
    }

    // Where the photograph lies in a viewport, in its pixels from the top left.
    photographRectangle(width, height) {
      const { width: w, height: h } = this.photograph;
      const scale = Math.min(width / w, height / h) * this.photoZoom;
      return {
        scale: scale,
        x: width / 2 - (scale * w) / 2 + this.photoShift.x * height,
        y: height / 2 - (scale * h) / 2 + this.photoShift.y * height,
        width: scale * w,
        height: scale * h,
      };
    }

    // The three.js camera for a viewport of this size.
    forViewport(width, height) {
      const camera = this.camera;
      camera.position.copy(this.position(this));
      camera.quaternion.copy(this.orientation);
      camera.updateMatrixWorld(true);
      const reach = camera.position.length();
      const near = Math.max(0.003, reach - 3, 0.002 * reach);
      const far = reach + 3;
      const m = camera.projectionMatrix;
      if (this.photograph) {
        this.photographProjection(m, width, height, near, far);
      } else {
        // The narrower side sees the whole field.
        const half = near * Math.tan(fieldOfView / 2) *
          (width < height ? height / width : 1);
        const side = (half * width) / height;
        m.makePerspective(-side, side, half, -half, near, far);
      }
      camera.projectionMatrixInverse.getInverse(m);
      return camera;
    }

    photographProjection(m, width, height, near, far) {
      const p = this.photograph;
      const rect = this.photographRectangle(width, height);
      const s = rect.scale;
      m.set(
        (2 * s * p.fx) / width, 0, 1 - (2 * (rect.x + s * p.cx)) / width, 0,
        0, (2 * s * p.fy) / height, (2 * (rect.y + s * p.cy)) / height - 1, 0,
        0, 0, -(far + near) / (far - near), (-2 * far * near) / (far - near),
        0, 0, -1, 0);
    }
  }

  Octacut.SharedCamera = SharedCamera;
})();
