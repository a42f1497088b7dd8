// The other solutions: one instanced mesh for each part of the arm, whatever their number. Where a ghost coincides with the arm
// it lies behind it.

import { Color, Group, InstancedMesh, Matrix4, MeshLambertMaterial } from 'three';
import type { GhostFrame } from '../wire/frames';
import type { Arm, DrawnPart } from './arm';

const MOST = 16;
/** The real arm, as the controller tells of it. */
export const REAL = { color: new Color(0xe8590c), opacity: 0.55 };
const POINTED = new Color(0x7c3aed);

export class Ghosts {
  readonly object = new Group();
  private meshes: { mesh: InstancedMesh; part: DrawnPart }[] = [];
  private plainColor = new Color(0x6b7486);
  private frame: GhostFrame | null = null;
  private hidden: boolean[] = [];
  private pointed: number | null = null;

  /** Without a look of their own, ghosts are grey and faint. */
  constructor(private readonly look: { color: Color; opacity: number } | null = null) {}

  load(arm: Arm): void {
    this.object.clear();
    this.meshes.forEach(({ mesh }) => mesh.dispose());
    this.meshes = arm.parts.map((part) => {
      const material = new MeshLambertMaterial({ transparent: true, opacity: this.opacity, depthWrite: false, polygonOffset: true, polygonOffsetFactor: 3, polygonOffsetUnits: 12 });
      const mesh = new InstancedMesh(part.geometry, material, MOST);
      mesh.frustumCulled = false;
      mesh.count = 0;
      mesh.renderOrder = 2;
      this.object.add(mesh);
      return { mesh, part };
    });
    if (this.frame) this.move(this.frame, this.hidden);
  }

  setDark(dark: boolean): void {
    this.plainColor = this.look?.color ?? new Color(dark ? 0xaab3c5 : 0x5b6478);
    this.paint();
  }

  /** The poses of all solutions; those hidden (the present one) are not drawn. */
  move(frame: GhostFrame, hidden: boolean[]): void {
    this.frame = frame;
    this.hidden = hidden;
    const drawn: number[] = [];
    for (let k = 0; k < Math.min(frame.count, MOST); k++) if (!hidden[k]) drawn.push(k);
    const matrix = new Matrix4();
    for (const { mesh, part } of this.meshes) {
      mesh.count = 0;
      for (const k of drawn) {
        const at = 16 * (k * frame.links + part.link);
        if (at + 16 > frame.matrices.length) continue;
        mesh.setMatrixAt(mesh.count++, matrix.fromArray(frame.matrices, at).multiply(part.placed));
      }
      mesh.instanceMatrix.needsUpdate = true;
    }
    this.paint();
  }

  point(index: number | null): void {
    this.pointed = index;
    this.paint();
  }

  private get opacity(): number {
    return this.look?.opacity ?? 0.17;
  }

  private paint(): void {
    if (!this.frame) return;
    const drawn: number[] = [];
    for (let k = 0; k < Math.min(this.frame.count, MOST); k++) if (!this.hidden[k]) drawn.push(k);
    for (const { mesh } of this.meshes) {
      drawn.forEach((k, place) => mesh.setColorAt(place, k === this.pointed ? POINTED : this.plainColor));
      if (mesh.instanceColor) mesh.instanceColor.needsUpdate = true;
      (mesh.material as MeshLambertMaterial).opacity = this.opacity + (this.pointed === null ? 0 : 0.07);
    }
  }
}
