// The line round the link under the pointer: the link's shape as a mask, and its edge drawn over the picture.

import {
  Camera, DoubleSide, Group, Mesh, MeshBasicMaterial, NearestFilter, PlaneGeometry, Scene, ShaderMaterial, Vector2, WebGLRenderTarget, type WebGLRenderer,
} from 'three';

/** The layer that the mask is drawn from. */
const LAYER = 1;
/** Width of the line, CSS pixels. */
const WIDTH = 2;

const VERTEX = `
varying vec2 at;
void main() { at = uv; gl_Position = vec4(position.xy, 0.0, 1.0); }`;

const FRAGMENT = `
varying vec2 at;
uniform sampler2D mask;
uniform vec2 reach;
uniform vec3 ink;
void main() {
  if (texture2D(mask, at).r > 0.5) discard;
  float near = 0.0;
  for (int ring = 1; ring <= 2; ring++) for (int k = 0; k < 16; k++) {
    float turn = 6.2831853 * (float(k) + 0.5 * float(ring)) / 16.0;
    near += texture2D(mask, at + 0.5 * float(ring) * reach * vec2(cos(turn), sin(turn))).r;
  }
  // A straight edge covers a third of the rings at the line's middle: that is where it fades.
  gl_FragColor = vec4(ink, smoothstep(0.0, 5.0, near));
}`;

export class Outline {
  private readonly target = new WebGLRenderTarget(1, 1, { minFilter: NearestFilter, magFilter: NearestFilter, depthBuffer: false });
  private readonly flat = new MeshBasicMaterial({ color: 0xffffff, side: DoubleSide, toneMapped: false, depthTest: false });
  private readonly edge = new ShaderMaterial({
    vertexShader: VERTEX, fragmentShader: FRAGMENT, transparent: true, depthTest: false, depthWrite: false, toneMapped: false,
    uniforms: { mask: { value: this.target.texture }, reach: { value: new Vector2() }, ink: { value: [0.486, 0.227, 0.929] } },
  });
  private readonly page = new Scene();
  private readonly still = new Camera();
  private link: Group | null = null;

  constructor() {
    const quad = new Mesh(new PlaneGeometry(2, 2), this.edge);
    quad.frustumCulled = false;
    this.page.add(quad);
  }

  setDark(dark: boolean): void {
    this.edge.uniforms.ink!.value = dark ? [0.77, 0.71, 0.99] : [0.486, 0.227, 0.929];
  }

  /** Which link has the line. */
  around(link: Group | null): void {
    const mark = (group: Group | null, on: boolean): void => group?.children.forEach((child) => {
      if (!(child instanceof Mesh)) return;
      if (on) child.layers.enable(LAYER);
      else child.layers.disable(LAYER);
    });
    mark(this.link, false);
    mark(link, true);
    this.link = link;
  }

  /** Draws it over the picture that is there. */
  draw(renderer: WebGLRenderer, scene: Scene, camera: Camera): void {
    if (!this.link) return;
    const size = renderer.getDrawingBufferSize(new Vector2());
    this.target.setSize(size.x, size.y);
    const width = WIDTH * renderer.getPixelRatio();
    (this.edge.uniforms.reach!.value as Vector2).set(width / size.x, width / size.y);
    const { layers } = camera;
    const before = layers.mask;
    const shadows = renderer.shadowMap.autoUpdate;
    layers.set(LAYER);
    scene.overrideMaterial = this.flat;
    renderer.shadowMap.autoUpdate = false;
    renderer.setRenderTarget(this.target);
    renderer.clear();
    renderer.render(scene, camera);
    renderer.setRenderTarget(null);
    layers.mask = before;
    scene.overrideMaterial = null;
    renderer.shadowMap.autoUpdate = shadows;
    renderer.autoClear = false;
    renderer.render(this.page, this.still);
    renderer.autoClear = true;
  }
}
