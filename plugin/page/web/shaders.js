'use strict';
// How surfaces are painted, cut, and mixed with photographs.
(function () {
  const meshVertex = `
    attribute vec3 color3;
    attribute float value;
    uniform float pointSize;
    varying vec3 vNormal;
    varying vec3 vColor;
    varying float vValue;
    varying vec3 vWorld;
    void main() {
      vNormal = normalMatrix * normal;
      vColor = color3;
      vValue = value;
      vWorld = position;
      gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
      gl_PointSize = pointSize;
    }`;

  // paint: 0 plain, 1 colours of the photographs, 2 values. Values beyond 1e29
  // stand for none.
  const meshFragment = `
    uniform int paint;
    uniform bool lit;
    uniform vec3 tint;
    uniform vec3 sectionColor;
    uniform sampler2D scale;
    uniform vec2 range;
    uniform vec4 cut;
    varying vec3 vNormal;
    varying vec3 vColor;
    varying float vValue;
    varying vec3 vWorld;
    void main() {
      if (dot(cut.xyz, vWorld) > cut.w) discard;
      vec3 base = tint;
      if (paint == 1) {
        base = vColor;
      } else if (paint == 2) {
        float t = clamp((vValue - range.x) / (range.y - range.x), 0.0, 1.0);
        base = vValue > 1e29 ? vec3(0.45)
                             : texture2D(scale, vec2(t, 0.5)).rgb;
      }
      bool isCut = dot(cut.xyz, cut.xyz) > 0.0;
      if (isCut && !gl_FrontFacing) {
        // Where the surface is cut one sees its inside, which is shown flat.
        gl_FragColor = vec4(mix(sectionColor, base, 0.15), 1.0);
        return;
      }
      vec3 n = lit ? normalize(vNormal) : vec3(0.0, 0.0, 1.0);
      float key = max(0.0, dot(n, normalize(vec3(-0.45, 0.65, 0.75))));
      float fill = max(0.0, dot(n, normalize(vec3(0.7, -0.15, 0.6))));
      float shade = lit ? 0.40 + 0.52 * key + 0.20 * fill : 1.0;
      gl_FragColor = vec4(base * min(shade, 1.08), 1.0);
    }`;

  const lineFragment = `
    uniform vec3 lineColor;
    uniform vec4 cut;
    varying vec3 vWorld;
    void main() {
      if (dot(cut.xyz, vWorld) > cut.w) discard;
      gl_FragColor = vec4(lineColor, 0.35);
    }`;

  const screenVertex = `
    varying vec2 vUv;
    void main() {
      vUv = uv;
      gl_Position = vec4(position.xy, 0.0, 1.0);
    }`;

  const mixFragment = `
    uniform sampler2D photograph;
    uniform sampler2D mesh;
    uniform vec4 rectangle;
    uniform vec2 size;
    uniform float amount;
    uniform bool difference;
    uniform vec3 background;
    varying vec2 vUv;
    void main() {
      vec2 pixel = vec2(vUv.x, 1.0 - vUv.y) * size;
      vec2 at = (pixel - rectangle.xy) / rectangle.zw;
      bool inside = all(greaterThan(at, vec2(0.0))) && all(lessThan(at, vec2(1.0)));
      vec3 photo = inside ? texture2D(photograph, vec2(at.x, 1.0 - at.y)).rgb
                          : background;
      vec4 drawn = texture2D(mesh, vUv);
      vec3 color = mix(photo, mix(background, drawn.rgb, drawn.a), amount);
      if (difference) {
        // Twice the difference, so that a tenth can be seen.
        color = inside && drawn.a > 0.5 ? abs(photo - drawn.rgb) * 2.0
                                        : mix(background, photo, 0.25);
      }
      gl_FragColor = vec4(color, 1.0);
    }`;

  function scaleTexture(scale) {
    const size = 256;
    const pixels = new Uint8Array(4 * size);
    for (let i = 0; i < size; ++i) {
      const rgb = scale(i / (size - 1));
      pixels.set([rgb[0], rgb[1], rgb[2], 255], 4 * i);
    }
    const texture = new THREE.DataTexture(pixels, size, 1, THREE.RGBAFormat);
    texture.minFilter = THREE.LinearFilter;
    texture.magFilter = THREE.LinearFilter;
    texture.needsUpdate = true;
    return texture;
  }

  Octacut.makeMeshMaterial = tint => new THREE.ShaderMaterial({
    vertexShader: meshVertex,
    fragmentShader: meshFragment,
    side: THREE.DoubleSide,
    polygonOffset: true,
    polygonOffsetFactor: 1,
    polygonOffsetUnits: 1,
    uniforms: {
      paint: { value: 0 },
      lit: { value: true },
      pointSize: { value: 2 },
      tint: { value: new THREE.Color(tint) },
      sectionColor: { value: new THREE.Color('#5b5148') },
      scale: { value: null },
      range: { value: new THREE.Vector2(-1, 1) },
      cut: { value: new THREE.Vector4(0, 0, 0, 1) },
    },
  });
  Octacut.makeLineMaterial = cut => new THREE.ShaderMaterial({
    vertexShader: meshVertex,
    fragmentShader: lineFragment,
    transparent: true,
    depthWrite: false,
    uniforms: {
      lineColor: { value: new THREE.Color('#000000') },
      cut: cut,
    },
  });
  Octacut.makeMixMaterial = () => new THREE.ShaderMaterial({
    vertexShader: screenVertex,
    fragmentShader: mixFragment,
    depthTest: false,
    uniforms: {
      photograph: { value: null },
      mesh: { value: null },
      rectangle: { value: new THREE.Vector4() },
      size: { value: new THREE.Vector2() },
      amount: { value: 0.5 },
      difference: { value: false },
      background: { value: new THREE.Color() },
    },
  });
  Octacut.scaleTextures = {
    distance: scaleTexture(Octacut.scales.distance),
    support: scaleTexture(Octacut.scales.support),
  };
})();
