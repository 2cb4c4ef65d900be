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

// With parallel rays the front of the sphere is sqrt(1 - r^2) radii before its centre.
const FRAGMENT = `
  uniform float depthPerLength;
  varying vec2 place; varying vec3 colour; varying float size; varying float mark;
  void main() {
    float r2 = dot(place, place);
    if (r2 > 1.0 || size <= 0.0) discard;
    float front = sqrt(1.0 - r2);
    vec3 normal = vec3(place, front);
    float light = 0.55 + 0.45 * max(0.0, dot(normal, normalize(vec3(-0.4, 0.6, 0.8))));
    vec3 shaded = colour * light;
    float edge = mark > 0.5 ? 0.62 : 0.90;
    vec3 rim = mark > 0.5 ? vec3(0.0) : shaded * 0.45;
    gl_FragColor = vec4(r2 > edge ? rim : shaded, 1.0);
    gl_FragDepth = gl_FragCoord.z - front * size * depthPerLength;
  }`;

/** A cloud of spheres whose places, colours, radii and rings change with `set`. */
export class Spheres {
  constructor(most) {
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
      uniforms: { depthPerLength: this.depthPerLength },
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
