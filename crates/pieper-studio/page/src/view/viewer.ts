// The 3D view: draws what the program says, when something has changed, and never otherwise.

import {
  ACESFilmicToneMapping, AxesHelper, Box3, Color, DirectionalLight, Group, HemisphereLight, Matrix4, PCFSoftShadowMap, PerspectiveCamera,
  OrthographicCamera, Quaternion, Raycaster, Scene, Sphere, Vector2, Vector3, WebGLRenderer, type Camera, type Object3D,
} from 'three';
import { OrbitControls } from 'three/examples/jsm/controls/OrbitControls.js';
import type { Robot } from '../wire/types';
import { Arm } from './arm';
import { Ghosts, REAL } from './ghosts';
import { Ground } from './ground';
import { Outline } from './outline';
import { Path } from './path';

const plain = new URLSearchParams(location.search).has('plain');

export interface Ray { origin: [number, number, number]; direction: [number, number, number] }

export class Viewer {
  readonly renderer: WebGLRenderer;
  readonly scene = new Scene();
  readonly perspective = new PerspectiveCamera(38, 1, 0.01, 200);
  readonly orthographic = new OrthographicCamera(-1, 1, 1, -1, -100, 200);
  camera: PerspectiveCamera | OrthographicCamera = this.perspective;
  readonly controls: OrbitControls;
  readonly arm: Arm;
  readonly ghosts: Ghosts;
  readonly real = new Ghosts(REAL);
  readonly ground = new Ground();
  readonly path = new Path();
  readonly outline = new Outline();
  /** From axes with Z up to those of the arm's base. */
  private readonly upright = new Quaternion();
  readonly tool = new Group();
  private readonly triad = new AxesHelper(1);
  private readonly sun = new DirectionalLight(0xffffff, 2.2);
  private readonly sky = new HemisphereLight(0xffffff, 0x8a8f9a, 1.5);
  private readonly fill = new DirectionalLight(0xdfe6ff, 0.7);
  private reach = 1;
  private wanted = false;
  /** For tests: pictures drawn, and what the last one took. */
  readonly statistics = { pictures: 0, calls: 0, triangles: 0, milliseconds: 0 };
  private readonly beforeDraw: (() => void)[] = [];

  constructor(readonly canvas: HTMLCanvasElement) {
    this.renderer = new WebGLRenderer({ canvas, antialias: !plain, alpha: true, preserveDrawingBuffer: plain, powerPreference: 'high-performance' });
    this.renderer.toneMapping = ACESFilmicToneMapping;
    this.renderer.toneMappingExposure = 1.05;
    this.renderer.shadowMap.enabled = !plain;
    this.renderer.shadowMap.type = PCFSoftShadowMap;
    this.renderer.info.autoReset = false;
    this.controls = new OrbitControls(this.perspective, canvas);
    this.stand('z');
    this.controls.zoomToCursor = true;
    this.controls.enableDamping = false;
    this.controls.addEventListener('change', () => this.invalidate());
    this.arm = new Arm(() => this.invalidate());
    this.ghosts = new Ghosts();
    this.sun.castShadow = !plain;
    this.sun.shadow.mapSize.set(2048, 2048);
    this.sun.shadow.radius = 6;
    this.sun.shadow.bias = -0.0004;
    this.sun.shadow.normalBias = 0.01;
    this.tool.add(this.triad);
    this.scene.add(this.sky, this.sun, this.sun.target, this.fill, this.ground.object, this.arm.object, this.ghosts.object, this.real.object, this.path.object, this.tool);
    new ResizeObserver(() => this.resize()).observe(canvas.parentElement as HTMLElement);
    this.resize();
  }

  /** Draws soon. */
  invalidate(): void {
    if (this.wanted) return;
    this.wanted = true;
    requestAnimationFrame(() => {
      this.wanted = false;
      this.draw();
    });
  }

  onDraw(listener: () => void): void {
    this.beforeDraw.push(listener);
  }

  private draw(): void {
    const start = performance.now();
    this.renderer.info.reset();
    for (const listener of this.beforeDraw) listener();
    this.renderer.render(this.scene, this.camera);
    this.outline.draw(this.renderer, this.scene, this.camera);
    const { calls, triangles } = this.renderer.info.render;
    Object.assign(this.statistics, { calls, triangles, milliseconds: performance.now() - start });
    this.statistics.pictures += 1;
  }

  private resize(): void {
    const frame = this.canvas.parentElement as HTMLElement;
    const [width, height] = [Math.max(1, frame.clientWidth), Math.max(1, frame.clientHeight)];
    this.renderer.setPixelRatio(plain ? 1 : Math.min(devicePixelRatio, 2));
    this.renderer.setSize(width, height, false);
    this.perspective.aspect = width / height;
    this.perspective.updateProjectionMatrix();
    this.matchOrthographic();
    this.invalidate();
  }

  /** A new arm: its meshes, and the camera on it. */
  async show(robot: Robot, keepCamera: boolean): Promise<void> {
    this.reach = robot.reach;
    this.perspective.near = robot.reach / 200;
    this.perspective.far = robot.reach * 200;
    const s = robot.reach;
    this.stand(robot.up);
    this.sun.position.set(1.2 * s, -1.6 * s, 3.2 * s).applyQuaternion(this.upright);
    this.fill.position.set(-2 * s, 1.5 * s, 1.2 * s).applyQuaternion(this.upright);
    const shadow = this.sun.shadow.camera;
    Object.assign(shadow, { left: -1.7 * s, right: 1.7 * s, top: 1.7 * s, bottom: -1.7 * s, near: 0.2 * s, far: 8 * s });
    shadow.updateProjectionMatrix();
    this.triad.scale.setScalar(0.12 * s);
    this.ground.resize(s);
    await this.arm.load(robot);
    this.ghosts.load(this.arm);
    this.real.load(this.arm);
    this.path.outline(robot);
    if (!keepCamera) this.fit('home');
    this.invalidate();
  }

  /** Which axis of the base points up: what the camera turns about, and what the ground is square to. */
  private stand(up: Robot['up']): void {
    const axis = new Vector3(Number(up === 'x'), Number(up === 'y'), Number(up === 'z'));
    this.upright.setFromUnitVectors(new Vector3(0, 0, 1), axis);
    this.ground.object.quaternion.copy(this.upright);
    this.sky.position.copy(axis);
    this.level();
    // The turntable keeps the axis it was made with.
    const turntable = this.controls as unknown as { _quat: Quaternion; _quatInverse: Quaternion };
    turntable._quat.setFromUnitVectors(axis, new Vector3(0, 1, 0));
    turntable._quatInverse.copy(turntable._quat).invert();
  }

  /** Brings the cameras upright again. */
  level(): void {
    for (const camera of [this.perspective, this.orthographic]) camera.up.set(0, 0, 1).applyQuaternion(this.upright);
    this.controls.update();
  }

  /** Takes away what is not the arm: frames, lines, ghosts, handles and the ground. What it returns brings them back. */
  strip(): () => void {
    const kept = new Set<Object3D>([this.sky, this.sun, this.sun.target, this.fill, this.arm.object, this.real.object]);
    const hidden = this.scene.children.filter((child) => child.visible && !kept.has(child));
    const frames = this.arm.framesShown;
    hidden.forEach((child) => (child.visible = false));
    this.arm.showFrames(false);
    return () => {
      hidden.forEach((child) => (child.visible = true));
      this.arm.showFrames(frames);
    };
  }

  /** Light and dark. */
  setDark(dark: boolean): void {
    this.scene.background = null;
    this.sky.intensity = dark ? 1.05 : 1.5;
    this.sky.groundColor = new Color(dark ? 0x2a2d36 : 0x9a9ea8);
    this.ground.setDark(dark);
    this.path.setDark(dark);
    this.outline.setDark(dark);
    this.ghosts.setDark(dark);
    this.real.setDark(dark);
    this.invalidate();
  }

  /** Looks at the whole arm: from a named side, or from where the camera is. */
  fit(from: 'home' | 'front' | 'right' | 'top' | 'here'): void {
    const box = new Box3().setFromObject(this.arm.object);
    if (box.isEmpty()) box.setFromCenterAndSize(new Vector3(0, 0, this.reach / 2).applyQuaternion(this.upright), new Vector3(1, 1, 1).multiplyScalar(this.reach));
    const ball = box.getBoundingSphere(new Sphere());
    const directions = {
      home: new Vector3(1, -1.25, 0.62), front: new Vector3(1, 0, 0), right: new Vector3(0, -1, 0), top: new Vector3(0, -0.0001, 1),
    };
    const direction = from === 'here' ? this.camera.position.clone().sub(this.controls.target) : directions[from].applyQuaternion(this.upright);
    if (from !== 'here') this.level();
    const aspect = Math.min(1, this.perspective.aspect);
    const distance = (0.94 * ball.radius) / Math.sin((this.perspective.fov * Math.PI) / 360) / aspect;
    this.controls.target.copy(ball.center);
    this.perspective.position.copy(ball.center).addScaledVector(direction.normalize(), distance);
    this.orthographic.position.copy(this.perspective.position);
    this.matchOrthographic();
    this.controls.update();
    this.invalidate();
  }

  /** Parallel or central projection. */
  toggleProjection(): void {
    const next = this.camera === this.perspective ? this.orthographic : this.perspective;
    next.position.copy(this.camera.position);
    next.up.copy(this.camera.up);
    this.camera = next;
    this.controls.object = next;
    this.matchOrthographic();
    this.controls.update();
    this.invalidate();
  }

  private matchOrthographic(): void {
    const half = this.controls ? this.camera.position.distanceTo(this.controls.target) * Math.tan((this.perspective.fov * Math.PI) / 360) : 1;
    const { aspect } = this.perspective;
    Object.assign(this.orthographic, { left: -half * aspect, right: half * aspect, top: half, bottom: -half });
    this.orthographic.updateProjectionMatrix();
  }

  /** The ray under the pointer. */
  ray(event: { clientX: number; clientY: number }): Ray {
    const frame = this.canvas.getBoundingClientRect();
    const at = new Vector2((2 * (event.clientX - frame.left)) / frame.width - 1, 1 - (2 * (event.clientY - frame.top)) / frame.height);
    const caster = new Raycaster();
    caster.setFromCamera(at, this.camera as Camera);
    return { origin: caster.ray.origin.toArray(), direction: caster.ray.direction.toArray() };
  }

  /** Where a point of the world is in the window. */
  project(point: [number, number, number]): [number, number] {
    const frame = this.canvas.getBoundingClientRect();
    const p = new Vector3(...point).project(this.camera as Camera);
    return [frame.left + ((p.x + 1) / 2) * frame.width, frame.top + ((1 - p.y) / 2) * frame.height];
  }

  setTool(matrix: number[][]): void {
    place(this.tool, matrix);
    this.tool.updateMatrixWorld();
  }

  get size(): number {
    return this.reach;
  }
}

/** Puts an object where a row-major matrix says. */
export function place(object: Object3D, rows: number[][]): void {
  object.matrixAutoUpdate = false;
  const flat = rows.flat() as Parameters<Matrix4['set']>;
  object.matrix.set(...flat);
  object.matrixWorldNeedsUpdate = true;
}
