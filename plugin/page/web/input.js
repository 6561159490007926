'use strict';
// Mouse, touch and keys of the viewer.
(function () {
  Octacut.connectPointer = function (canvas, camera) {
    const pointers = new Map();
    const middle = () => {
      const all = [...pointers.values()];
      return {
        x: all.reduce((sum, p) => sum + p.x, 0) / all.length,
        y: all.reduce((sum, p) => sum + p.y, 0) / all.length,
        spread: all.length < 2 ? 0 : Math.hypot(all[0].x - all[1].x, all[0].y - all[1].y),
      };
    };
    canvas.addEventListener('pointerdown', event => {
      canvas.focus({ preventScroll: true });
      canvas.setPointerCapture(event.pointerId);
      pointers.set(event.pointerId, { x: event.clientX, y: event.clientY });
      event.preventDefault();
    });
    canvas.addEventListener('pointermove', event => {
      if (!pointers.has(event.pointerId)) {
        return;
      }
      const before = middle();
      pointers.set(event.pointerId, { x: event.clientX, y: event.clientY });
      const after = middle();
      const height = canvas.clientHeight;
      const dx = (after.x - before.x) / height;
      const dy = (after.y - before.y) / height;
      if (pointers.size > 1) {
        camera.shift(dx, dy);
        if (before.spread > 0 && after.spread > 0) {
          camera.zoom(after.spread / before.spread);
        }
      } else if (event.buttons & 6 || event.shiftKey || event.ctrlKey) {
        camera.shift(dx, dy);
      } else {
        camera.turn(4 * dx, 4 * dy);
      }
    });
    const release = event => pointers.delete(event.pointerId);
    canvas.addEventListener('pointerup', release);
    canvas.addEventListener('pointercancel', release);
    canvas.addEventListener('contextmenu', event => event.preventDefault());
    canvas.addEventListener('wheel', event => {
      event.preventDefault();
      const pixels = event.deltaMode === 0 ? event.deltaY : 30 * event.deltaY;
      camera.zoom(Math.exp(-0.0015 * pixels));
    }, { passive: false });
  };

  // `actions` are functions by key.
  Octacut.connectKeys = function (canvas, camera, actions) {
    const step = 0.12;
    const moves = {
      ArrowLeft: [-step, 0], ArrowRight: [step, 0],
      ArrowUp: [0, -step], ArrowDown: [0, step],
    };
    canvas.addEventListener('keydown', event => {
      if (event.ctrlKey || event.metaKey || event.altKey) {
        return;
      }
      const move = moves[event.key];
      const action = actions[event.key];
      if (move && event.shiftKey) {
        camera.shift(move[0] / 3, move[1] / 3);
      } else if (move) {
        camera.turn(move[0], move[1]);
      } else if (event.key === '+' || event.key === '=') {
        camera.zoom(1.15);
      } else if (event.key === '-') {
        camera.zoom(1 / 1.15);
      } else if (event.key === 'Home' || event.key === '0') {
        camera.reset(true);
      } else if (action) {
        action();
      } else {
        return;
      }
      event.preventDefault();
    });
  };
})();
