// The picture of the view as a file.

import { signal } from '@preact/signals';
import { robot, toast } from '../state';
import { viewer } from './View';

export function save(name: string, data: Blob): void {
  const link = document.createElement('a');
  link.href = URL.createObjectURL(data);
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 10_000);
}

/** A picture of the view with the page's background behind it. */
function onBackground(canvas: HTMLCanvasElement): HTMLCanvasElement {
  const { width, height } = canvas;
  const sheet = document.createElement('canvas');
  [sheet.width, sheet.height] = [width, height];
  const ink = sheet.getContext('2d')!;
  const tones = getComputedStyle(document.documentElement);
  const shade = ink.createRadialGradient(width / 2, 0.35 * height, 0, width / 2, 0.35 * height, 0.75 * Math.max(width, height));
  shade.addColorStop(0, tones.getPropertyValue('--bg-1'));
  shade.addColorStop(1, tones.getPropertyValue('--bg-2'));
  ink.fillStyle = shade;
  ink.fillRect(0, 0, width, height);
  ink.drawImage(canvas, 0, 0);
  return sheet;
}

/** The view on its background at a size in pixels, for a program that waits for it. */
export async function handBack(width: number, height: number): Promise<void> {
  if (!viewer) return;
  const { renderer, canvas, perspective } = viewer;
  renderer.setPixelRatio(1);
  renderer.setSize(width, height, false);
  perspective.aspect = width / height;
  perspective.updateProjectionMatrix();
  viewer.fit('home');
  renderer.render(viewer.scene, viewer.camera);
  const blob = await new Promise<Blob | null>((done) => onBackground(canvas).toBlob(done, 'image/png'));
  if (blob) await fetch('/api/picture', { method: 'POST', body: blob });
}

/** How the next picture is to be: in the view's size, its background transparent, frames and lines in it. */
export const picture = { scale: signal(2), transparent: signal(true), overlays: signal(true) };

/** The view as a PNG. */
export async function snapshot(scale = picture.scale.value): Promise<void> {
  if (!viewer) return;
  const { renderer, canvas } = viewer;
  const before = renderer.getPixelRatio();
  const bare = picture.overlays.value ? () => {} : viewer.strip();
  renderer.setPixelRatio(scale);
  renderer.render(viewer.scene, viewer.camera);
  const made = picture.transparent.value ? canvas : onBackground(canvas);
  const blob = await new Promise<Blob | null>((done) => made.toBlob(done, 'image/png'));
  bare();
  renderer.setPixelRatio(before);
  viewer.invalidate();
  if (blob) save(`${robot.value?.id ?? 'arm'}.png`, blob);
  else toast('The picture could not be made');
}
