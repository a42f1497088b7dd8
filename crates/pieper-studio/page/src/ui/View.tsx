// The 3D view in the page, and what connects it to the state.

import { useEffect, useRef } from 'preact/hooks';
import { effect } from '@preact/signals';
import { dark, ik, motion, onFrame, pointed, pose, robot, samples, show } from '../state';
import { Viewer } from '../view/viewer';
import { handBack } from './snapshot';
import { gestures } from '../view/gestures';
import type { GhostFrame } from '../wire/frames';

/** `?frame=1280x720`: one picture for a program that waits for it. */
const frame = /[?&]frame=(\d+)x(\d+)/.exec(location.search);

export let viewer: Viewer | null = null;

export function View() {
  const canvas = useRef<HTMLCanvasElement>(null);
  const label = useRef<HTMLDivElement>(null);
  useEffect(() => {
    const made = new Viewer(canvas.current!);
    viewer = made;
    (window as unknown as Record<string, unknown>).pieperViewer = made;
    gestures(made, label.current!);
    connect(made);
  }, []);
  return (
    <div class="view">
      <canvas ref={canvas} tabIndex={0} aria-label="3D view of the arm. Every action is in the panels too; press ? for keys." />
      <div ref={label} class="touch-label" hidden />
    </div>
  );
}

function connect(view: Viewer): void {
  let revision = 0;
  let ghosts: GhostFrame | null = null;
  let shownId = '';
  onFrame((frame) => {
    if (frame.kind === 'pose') {
      view.arm.move(frame.matrices);
    } else if (frame.kind === 'real') {
      view.real.move(frame, []);
    } else {
      ghosts = frame;
      drawGhosts();
    }
    view.invalidate();
  });
  const drawGhosts = (): void => {
    if (!ghosts) return;
    const solutions = ik.value?.solutions ?? [];
    view.ghosts.move(ghosts, Array.from({ length: ghosts.count }, (_, k) => solutions[k]?.current ?? false));
    view.invalidate();
  };
  effect(() => {
    const value = robot.value;
    if (!value || value.revision === revision) return;
    revision = value.revision;
    const keep = shownId === value.id;
    shownId = value.id;
    void view.show(value, keep).then(() => {
      document.documentElement.dataset.ready = '1';
      if (frame) void handBack(Number(frame[1]), Number(frame[2]));
    });
  });
  effect(() => view.setDark(dark.value));
  effect(() => {
    const matrix = pose.value?.matrix;
    if (!matrix) return;
    view.setTool(matrix);
    if (show.trail.value) view.path.add([matrix[0]![3]!, matrix[1]![3]!, matrix[2]![3]!]);
    view.invalidate();
  });
  effect(() => {
    view.path.setWay(samples.value?.tool ?? []);
    view.invalidate();
  });
  effect(() => {
    view.arm.showFrames(show.frames.value);
    view.arm.showCollision(show.collision.value);
    view.path.showTrail(show.trail.value);
    view.path.showOutline(show.outline.value);
    view.ghosts.object.visible = show.ghosts.value && motion.value?.playing !== true;
    view.invalidate();
  });
  effect(() => {
    void ik.value;
    drawGhosts();
  });
  effect(() => {
    view.ghosts.point(pointed.value);
    view.invalidate();
  });
}
