// Lines: the tool's way along the motion, the way it has just gone, and the outline of its reach.

import { BufferAttribute, BufferGeometry, Color, DynamicDrawUsage, Group, Line, LineBasicMaterial, LineLoop } from 'three';
import type { Robot } from '../wire/types';
import { place } from './viewer';

const TRAIL = 600;

export class Path {
  readonly object = new Group();
  private readonly way = new Line(new BufferGeometry(), new LineBasicMaterial({ color: 0x7c3aed, transparent: true, opacity: 0.85 }));
  private readonly trail: Line;
  private readonly points = new Float32Array(3 * TRAIL);
  private length = 0;
  private readonly reach = new LineLoop(new BufferGeometry(), new LineBasicMaterial({ transparent: true, opacity: 0.6 }));

  constructor() {
    const geometry = new BufferGeometry();
    geometry.setAttribute('position', new BufferAttribute(this.points, 3).setUsage(DynamicDrawUsage));
    geometry.setDrawRange(0, 0);
    this.trail = new Line(geometry, new LineBasicMaterial({ color: 0xe8590c, transparent: true, opacity: 0.9 }));
    this.trail.frustumCulled = this.way.frustumCulled = false;
    this.reach.visible = false;
    this.object.add(this.way, this.trail, this.reach);
  }

  setDark(dark: boolean): void {
    (this.way.material as LineBasicMaterial).color = new Color(dark ? 0xa78bfa : 0x6d28d9);
    (this.trail.material as LineBasicMaterial).color = new Color(dark ? 0xfb923c : 0xd9480f);
    (this.reach.material as LineBasicMaterial).color = new Color(dark ? 0x5eead4 : 0x0f766e);
  }

  setWay(tool: [number, number, number][]): void {
    this.way.geometry.dispose();
    this.way.geometry = new BufferGeometry();
    this.way.geometry.setAttribute('position', new BufferAttribute(new Float32Array(tool.flat()), 3));
  }

  /** Adds where the tool is to the way it has gone. */
  add(point: [number, number, number]): void {
    const last = 3 * (this.length - 1);
    if (this.length > 0) {
      const moved = Math.hypot(...point.map((x, k) => x - this.points[last + k]!));
      if (moved < 1e-5) return;
    }
    if (this.length === TRAIL) {
      this.points.copyWithin(0, 3);
      this.length -= 1;
    }
    this.points.set(point, 3 * this.length);
    this.length += 1;
    const { geometry } = this.trail;
    geometry.setDrawRange(0, this.length);
    (geometry.attributes.position as BufferAttribute).needsUpdate = true;
  }

  clearTrail(): void {
    this.length = 0;
    this.trail.geometry.setDrawRange(0, 0);
  }

  showTrail(on: boolean): void {
    this.trail.visible = this.way.visible = on;
  }

  outline(robot: Robot): void {
    // Down the right side of the axis and up the left one.
    const right = robot.outline.map(([r, z]) => [r, 0, z]);
    const left = [...robot.outline].reverse().map(([r, z]) => [-r, 0, z]);
    this.reach.geometry.dispose();
    this.reach.geometry = new BufferGeometry();
    this.reach.geometry.setAttribute('position', new BufferAttribute(new Float32Array([...right, ...left].flat()), 3));
    place(this.reach, robot.outline_frame);
    this.clearTrail();
  }

  showOutline(on: boolean): void {
    this.reach.visible = on;
  }
}
