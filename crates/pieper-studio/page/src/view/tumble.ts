// Free tumbling: the view turns about the screen's own axes, over the poles as well.

import { Quaternion, Vector3 } from 'three';
import type { Viewer } from './viewer';

export class Tumble {
  on = false;
  private at: { pointer: number; x: number; y: number } | null = null;

  /** To be made after the other gestures: what they take is not seen here. */
  constructor(private readonly viewer: Viewer) {
    const { canvas } = viewer;
    canvas.addEventListener('pointerdown', (event) => {
      // A finger turns the turntable, which knows about two of them.
      if (!this.on || event.button !== 0 || event.shiftKey || event.pointerType === 'touch' || !viewer.controls.enabled) return;
      event.stopImmediatePropagation();
      this.at = { pointer: event.pointerId, x: event.clientX, y: event.clientY };
      canvas.setPointerCapture(event.pointerId);
    }, { capture: true });
    canvas.addEventListener('pointermove', (event) => {
      if (this.at?.pointer !== event.pointerId) return;
      this.turn(event.clientX - this.at.x, event.clientY - this.at.y);
      Object.assign(this.at, { x: event.clientX, y: event.clientY });
    });
    const done = (): void => void (this.at = null);
    canvas.addEventListener('pointerup', done);
    canvas.addEventListener('pointercancel', done);
  }

  /** A drag by so many pixels; the height of the view is one whole turn, as it is for the turntable. */
  turn(dx: number, dy: number): void {
    const { camera, controls, canvas } = this.viewer;
    const way = Math.hypot(dx, dy);
    if (way === 0) return;
    const axis = new Vector3(dy, dx, 0).divideScalar(way).applyQuaternion(camera.quaternion);
    const turn = new Quaternion().setFromAxisAngle(axis, (-2 * Math.PI * way) / canvas.clientHeight);
    camera.position.sub(controls.target).applyQuaternion(turn).add(controls.target);
    camera.up.set(0, 1, 0).applyQuaternion(camera.quaternion).applyQuaternion(turn);
    controls.update();
  }
}
