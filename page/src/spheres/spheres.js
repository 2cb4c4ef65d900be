// Spheres as squares that face the viewer: exact at every zoom, two triangles each.
import * as THREE from "three";

const VERTEX = `
  attribute vec3 centre; attribute vec3 tint; attribute float radius; attribute float ring;
  varying vec2 place; varying vec3 colour; varying float size; varying float mark;
  void main() {
    place = position.xy; colour = tint; size = radius; mark = ring;
    vec4 seen = viewMatrix * vec4(centre, 1.0);
    seen.xy += position.xy * radius;
    gl_Position = projectionMatrix * seen;
  }`;

// With parallel rays the front of the sphere is sqrt(1 - r^2) radii before its centre. Coverage
// smooths the edge, which multisampling alone does not: it is inside a triangle.
const FRAGMENT = `
  uniform float depthPerLength, roundness;
  varying vec2 place; varying vec3 colour; varying float size; varying float mark;
  void main() {
    float r = length(place), pixel = fwidth(r);
    float cover = clamp((1.0 - r) / pixel, 0.0, 1.0);
    if (cover == 0.0 || size <= 0.0) discard;
    float front = sqrt(max(0.0, 1.0 - r * r));
    float slope = max(0.0, dot(vec3(place, front), normalize(vec3(-0.4, 0.6, 0.8))));
    vec3 shaded = colour * mix(1.0, 0.55 + 0.45 * slope, roundness);
    float edge = mark > 0.5 ? 0.79 : 0.95;
    vec3 rim = mark > 0.5 ? vec3(0.0) : shaded * 0.45;
    gl_FragColor = vec4(mix(shaded, rim, clamp((r - edge) / pixel + 0.5, 0.0, 1.0)), cover);
    gl_FragDepth = gl_FragCoord.z - front * size * depthPerLength;
  }`;

/** A cloud of spheres whose places, colours, radii and rings change with `set`. */
export class Spheres {
  /** isFlat: disks of one colour instead of shaded balls */
  constructor(most, isFlat) {
    this.geometry = new THREE.InstancedBufferGeometry();
    const square = [-1, -1, 0, 1, -1, 0, 1, 1, 0, -1, -1, 0, 1, 1, 0, -1, 1, 0];
    this.geometry.setAttribute("position", new THREE.Float32BufferAttribute(square, 3));
    this.columns = { centre: 3, tint: 3, radius: 1, ring: 1 };
    for (const [name, size] of Object.entries(this.columns)) {
      const attribute = new THREE.InstancedBufferAttribute(new Float32Array(most * size), size);
      attribute.setUsage(THREE.DynamicDrawUsage);
      this.geometry.setAttribute(name, attribute);
      this[name] = attribute.array;
    }
    this.depthPerLength = { value: 0 };
    const material = new THREE.ShaderMaterial({
      vertexShader: VERTEX,
      fragmentShader: FRAGMENT,
      uniforms: { depthPerLength: this.depthPerLength, roundness: { value: isFlat ? 0 : 1 } },
      alphaToCoverage: true,
    });
    this.mesh = new THREE.Mesh(this.geometry, material);
    this.mesh.frustumCulled = false;
  }

  /** Draws the first `count`, as the columns say now. */
  show(count) {
    this.geometry.instanceCount = count;
    for (const name of Object.keys(this.columns)) this.geometry.attributes[name].needsUpdate = true;
  }

  /** Tells how the camera turns lengths into depths. */
  follow(camera) {
    this.depthPerLength.value = Math.abs(camera.projectionMatrix.elements[10]) / 2;
  }
}
