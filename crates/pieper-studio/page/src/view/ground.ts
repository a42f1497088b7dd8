// The ground: a grid that fades out, and the arm's shadow.

import { Color, Group, Mesh, PlaneGeometry, ShaderMaterial, ShadowMaterial } from 'three';

const VERTEX = `
varying vec2 place;
void main() { place = position.xy; gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0); }`;

const FRAGMENT = `
varying vec2 place;
uniform vec3 ink;
uniform float strength;
uniform float span;
uniform float cell;
float lines(vec2 p, float size) {
  vec2 at = p / size;
  vec2 width = fwidth(at);
  vec2 near = abs(fract(at - 0.5) - 0.5) / max(width, vec2(1e-6));
  return (1.0 - min(min(near.x, near.y), 1.0)) * clamp(1.5 - 2.0 * max(width.x, width.y), 0.0, 1.0);
}
void main() {
  float fade = 1.0 - smoothstep(0.25 * span, span, length(place));
  float fine = 0.35 * lines(place, cell);
  float coarse = lines(place, 5.0 * cell);
  gl_FragColor = vec4(ink, max(fine, coarse) * fade * strength);
}`;

export class Ground {
  readonly object = new Group();
  private readonly grid: ShaderMaterial;
  private readonly shadow = new ShadowMaterial({ opacity: 0.2, depthWrite: false });
  private readonly planes: Mesh[];

  constructor() {
    this.grid = new ShaderMaterial({
      vertexShader: VERTEX, fragmentShader: FRAGMENT, transparent: true, depthWrite: false,
      uniforms: { ink: { value: new Color(0x3b4252) }, strength: { value: 0.34 }, span: { value: 4 }, cell: { value: 0.1 } },
    });
    const grid = new Mesh(new PlaneGeometry(2, 2), this.grid);
    const shadow = new Mesh(new PlaneGeometry(2, 2), this.shadow);
    shadow.receiveShadow = true;
    shadow.position.z = -0.0005;
    grid.renderOrder = shadow.renderOrder = -1;
    this.planes = [grid, shadow];
    this.object.add(grid, shadow);
  }

  resize(reach: number): void {
    const span = 3.2 * reach;
    for (const plane of this.planes) {
      plane.geometry.dispose();
      plane.geometry = new PlaneGeometry(2 * span, 2 * span);
      plane.position.z = -0.001 * reach;
    }
    // Cells of 1, 2 or 5 times a power of ten, about an eighth of the reach.
    const wanted = reach / 8;
    const power = 10 ** Math.floor(Math.log10(wanted));
    const cell = power * ([1, 2, 5, 10].find((step) => step * power >= wanted) ?? 10);
    this.grid.uniforms.span!.value = span;
    this.grid.uniforms.cell!.value = cell / 1;
  }

  setDark(dark: boolean): void {
    (this.grid.uniforms.ink!.value as Color).set(dark ? 0xaab4c8 : 0x3b4252);
    this.grid.uniforms.strength!.value = dark ? 0.22 : 0.3;
    this.shadow.opacity = dark ? 0.42 : 0.2;
  }
}
