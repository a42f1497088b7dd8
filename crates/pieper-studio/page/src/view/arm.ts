// The arm: one group for each link, moved by the matrices that the program sends.

import { AxesHelper, BufferAttribute, BufferGeometry, Color, FrontSide, Group, Matrix4, Mesh, MeshStandardMaterial } from 'three';
import type { Robot } from '../wire/types';
import { decodeMesh } from '../wire/frames';
import { embedded } from '../wire/snapshot';
import { place } from './viewer';

export interface DrawnPart { geometry: BufferGeometry; placed: Matrix4; link: number }

async function meshBytes(hash: string): Promise<ArrayBuffer | null> {
  const own = embedded(hash);
  if (own) return own;
  const answer = await fetch(`/mesh/${hash}`);
  return answer.ok ? answer.arrayBuffer() : null;
}

const HIGHLIGHT = new Color(0x7c3aed);
const NONE = new Color(0x000000);

export class Arm {
  readonly object = new Group();
  links: Group[] = [];
  parts: DrawnPart[] = [];
  private axes: AxesHelper[] = [];
  private collision: Mesh[] = [];
  private readonly cache = new Map<string, Promise<BufferGeometry>>();
  private matrices: Float32Array | null = null;
  private generation = 0;

  constructor(private readonly invalidate: () => void) {}

  async load(robot: Robot): Promise<void> {
    const generation = ++this.generation;
    const geometries = new Map<string, BufferGeometry>();
    const hashes = new Set(robot.links.flatMap((link) => link.parts.map((part) => part.mesh)));
    await Promise.all([...hashes].map(async (hash) => geometries.set(hash, await this.geometry(hash))));
    // Another arm may have come while the meshes were on their way.
    if (generation !== this.generation) return;
    this.object.clear();
    this.links = [];
    this.parts = [];
    this.axes = [];
    this.collision = [];
    robot.links.forEach((link, index) => {
      const group = new Group();
      group.name = link.name;
      group.matrixAutoUpdate = false;
      for (const part of link.parts) {
        const geometry = geometries.get(part.mesh);
        if (!geometry) continue;
        const [r, g, b, opacity] = part.color;
        const material = new MeshStandardMaterial({
          color: new Color().setRGB(r, g, b, 'srgb'), roughness: 0.46, metalness: 0.08, side: FrontSide, opacity, transparent: opacity < 1, wireframe: part.collision,
        });
        const mesh = new Mesh(geometry, material);
        mesh.castShadow = mesh.receiveShadow = !part.collision;
        mesh.visible = !part.collision;
        place(mesh, part.placed);
        if (part.collision) this.collision.push(mesh);
        else this.parts.push({ geometry, placed: mesh.matrix.clone(), link: index });
        group.add(mesh);
      }
      const axes = new AxesHelper(0.11 * robot.reach);
      axes.visible = false;
      this.axes.push(axes);
      group.add(axes);
      this.links.push(group);
      this.object.add(group);
    });
    if (this.matrices) this.move(this.matrices);
    this.invalidate();
  }

  private geometry(hash: string): Promise<BufferGeometry> {
    let known = this.cache.get(hash);
    if (!known) {
      known = meshBytes(hash).then((buffer) => {
        const geometry = new BufferGeometry();
        const data = buffer ? decodeMesh(buffer) : null;
        if (data) {
          geometry.setAttribute('position', new BufferAttribute(data.positions, 3));
          geometry.setAttribute('normal', new BufferAttribute(data.normals, 3));
          geometry.setIndex(new BufferAttribute(data.indices, 1));
        }
        return geometry;
      });
      this.cache.set(hash, known);
    }
    return known;
  }

  move(matrices: Float32Array): void {
    this.matrices = matrices;
    if (matrices.length < 16 * this.links.length) return;
    this.links.forEach((group, index) => {
      group.matrix.fromArray(matrices, 16 * index);
      group.matrixWorldNeedsUpdate = true;
    });
  }

  highlight(link: number | null): void {
    this.links.forEach((group, index) => {
      for (const child of group.children) {
        if (child instanceof Mesh) {
          const material = child.material as MeshStandardMaterial;
          const own = (child.userData.color ??= material.color.clone()) as Color;
          // A light housing takes the tint by its colour, a dark one by its glow.
          material.color.copy(own).lerp(HIGHLIGHT, index === link ? 0.5 : 0);
          material.emissive = index === link ? HIGHLIGHT : NONE;
          material.emissiveIntensity = index === link ? 0.35 : 0;
        }
      }
    });
    this.invalidate();
  }

  /** Whether the links' frames are drawn. */
  get framesShown(): boolean {
    return this.axes.some((axes) => axes.visible);
  }

  showFrames(on: boolean): void {
    for (const axes of this.axes) axes.visible = on;
    this.invalidate();
  }

  showCollision(on: boolean): void {
    for (const mesh of this.collision) mesh.visible = on;
    this.invalidate();
  }
}
