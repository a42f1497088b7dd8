// Pointer gestures: hover, drag a link, drag the whole arm, the gizmo. Rays go to the program; joint values come back.

import { Object3D, Quaternion, Vector3 } from 'three';
import { TransformControls } from 'three/examples/jsm/controls/TransformControls.js';
import { effect } from '@preact/signals';
import { connection, dragging, gesture, hintSeen, hovered, liveQ, pose, robot, said, seen, send, show, toast, tumbling, units } from '../state';
import { shown, kindOf, unit } from '../units';
import { Stream } from '../wire/connection';
import { Tumble } from './tumble';
import type { Viewer } from './viewer';

interface Touched { link: number; joint: number | null; point: [number, number, number] }

const LONG_PRESS = 420;

export function gestures(viewer: Viewer, label: HTMLElement): void {
  const { canvas } = viewer;
  let active: { pointer: number } | null = null;
  let down = 0;

  const pick = new Stream((command) => connection.send(command), (value) => {
    if (active) return;
    const touched = value as Touched | null;
    hovered.value = touched?.link ?? null;
  });
  const drag = new Stream((command) => connection.send(command), () => {}, (error) => toast(error.message));

  const over = (event: PointerEvent): void => {
    label.style.setProperty('transform', `translate(${event.offsetX + 16}px, ${event.offsetY + 12}px)`);
    pick.push({ do: 'pick', ...viewer.ray(event) });
  };

  canvas.addEventListener('pointermove', (event) => {
    if (active?.pointer === event.pointerId) {
      label.style.setProperty('transform', `translate(${event.offsetX + 16}px, ${event.offsetY + 12}px)`);
      drag.push({ do: 'drag', ...viewer.ray(event) });
      event.stopImmediatePropagation();
      return;
    }
    if (event.buttons === 0 && event.pointerType !== 'touch' && gizmo.axis === null) over(event);
  }, { capture: true });

  canvas.addEventListener('pointerleave', () => {
    if (!active) hovered.value = null;
  });

  const begin = async (event: PointerEvent): Promise<void> => {
    active = { pointer: event.pointerId };
    dragging.value = true;
    viewer.controls.enabled = false;
    canvas.setPointerCapture(event.pointerId);
    const touched = (await send({ do: 'grab', ...viewer.ray(event), arm: event.ctrlKey || event.metaKey })) as Touched | null | undefined;
    if (!touched) return end(false);
    if (!hintSeen.value) seen();
    hovered.value = touched.link;
  };

  const end = (cancel: boolean): void => {
    if (!active) return;
    active = null;
    dragging.value = false;
    viewer.controls.enabled = true;
    void drag.settled().then(() => send({ do: 'release', cancel })).then(sayPose);
  };

  let press: ReturnType<typeof setTimeout> | undefined;
  canvas.addEventListener('pointerdown', (event) => {
    down = event.timeStamp;
    if (gizmo.axis !== null) return;
    if (event.pointerType === 'touch') {
      // A finger that rests takes hold of the link under it; one that moves turns the view.
      const start = event;
      press = setTimeout(() => void begin(start), LONG_PRESS);
      return;
    }
    const onLink = hovered.value !== null && robot.value?.links[hovered.value]?.joint !== null;
    if (event.button === 0 && onLink && !event.shiftKey) {
      event.stopImmediatePropagation();
      void begin(event);
    }
  }, { capture: true });

  canvas.addEventListener('pointermove', (event) => {
    if (press && Math.hypot(event.movementX, event.movementY) > 2) clearTimeout(press);
  });

  const up = (event: PointerEvent): void => {
    clearTimeout(press);
    if (active?.pointer === event.pointerId) end(event.type === 'pointercancel');
  };
  canvas.addEventListener('pointerup', up);
  canvas.addEventListener('pointercancel', up);
  addEventListener('keydown', (event) => {
    if (event.key === 'Escape' && active) end(true);
  });

  canvas.addEventListener('dblclick', () => {
    const group = hovered.value === null ? null : viewer.arm.links[hovered.value];
    if (!group || performance.now() - down > 5000) return;
    viewer.controls.target.setFromMatrixPosition(group.matrixWorld);
    viewer.controls.update();
  });

  // The name and value of the joint beside the pointer.
  effect(() => {
    const link = hovered.value;
    const joint = link === null ? null : robot.value?.links[link]?.joint ?? null;
    viewer.arm.highlight(link);
    viewer.outline.around(link === null ? null : viewer.arm.links[link] ?? null);
    canvas.style.setProperty('cursor', dragging.value ? 'grabbing' : joint !== null && link !== null ? 'grab' : 'default');
    const joints = robot.value?.joints;
    const info = joint === null ? undefined : joints?.[joint];
    label.hidden = info === undefined;
    if (info && joint !== null) {
      const kind = kindOf(info);
      label.textContent = `${info.label}  ${shown(liveQ.value[joint] ?? 0, kind, units.value)} ${unit(kind, units.value)}`;
    }
  });

  const gizmo = makeGizmo(viewer);
  const tumble = new Tumble(viewer);
  effect(() => {
    tumble.on = tumbling.value;
    if (!tumble.on) viewer.level();
  });
}

export function sayPose(): void {
  const tool = pose.value?.tool;
  if (tool) said.value = `Tool at ${tool.position.map((x) => `${(1000 * x).toFixed(0)}`).join(', ')} millimetres`;
}

function makeGizmo(viewer: Viewer): TransformControls {
  const handle = new Object3D();
  viewer.scene.add(handle);
  const gizmo = new TransformControls(viewer.camera, viewer.canvas);
  gizmo.size = 0.75;
  gizmo.attach(handle);
  viewer.scene.add(gizmo.getHelper());
  let name = '';
  let held = false;
  const goal = new Stream((command) => connection.send(command), (value) => {
    const answer = value as { reached: boolean; sentence: string };
    if (!answer.reached) toast(answer.sentence);
  }, (error) => toast(error.message));

  const follow = (): void => {
    if (held) return;
    viewer.tool.matrix.decompose(handle.position, handle.quaternion, new Vector3());
  };
  gizmo.addEventListener('dragging-changed', (event) => {
    held = event.value as boolean;
    viewer.controls.enabled = !held;
    dragging.value = held;
    if (held) name = gesture('gizmo');
    else void goal.settled().then(follow).then(sayPose).then(() => viewer.invalidate());
  });
  gizmo.addEventListener('objectChange', () => {
    const q: Quaternion = handle.quaternion;
    goal.push({ do: 'tool', position: handle.position.toArray(), quaternion: [q.w, q.x, q.y, q.z], gesture: name });
  });
  gizmo.addEventListener('change', () => viewer.invalidate());
  viewer.onDraw(() => {
    gizmo.camera = viewer.camera;
    follow();
  });
  addEventListener('keydown', (event) => event.key === 'Control' && snap(true));
  addEventListener('keyup', (event) => event.key === 'Control' && snap(false));
  const snap = (on: boolean): void => {
    gizmo.setTranslationSnap(on ? 0.01 : null);
    gizmo.setRotationSnap(on ? Math.PI / 36 : null);
  };
  effect(() => {
    const mode = show.gizmo.value;
    gizmo.enabled = mode !== 'off';
    gizmo.getHelper().visible = mode !== 'off';
    if (mode !== 'off') gizmo.setMode(mode);
    gizmo.setSpace(show.local.value ? 'local' : 'world');
    viewer.invalidate();
  });
  return gizmo;
}
