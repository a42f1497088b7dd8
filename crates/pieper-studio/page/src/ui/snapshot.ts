// The picture of the view as a file.

import { robot, toast } from '../state';
import { viewer } from './View';

export function save(name: string, data: Blob): void {
  const link = document.createElement('a');
  link.href = URL.createObjectURL(data);
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 10_000);
}

/** The view at 1, 2 or 4 times its size, its background transparent. */
export async function snapshot(scale: number): Promise<void> {
  if (!viewer) return;
  const { renderer, canvas } = viewer;
  const before = renderer.getPixelRatio();
  renderer.setPixelRatio(scale);
  renderer.render(viewer.scene, viewer.camera);
  const blob = await new Promise<Blob | null>((done) => canvas.toBlob(done, 'image/png'));
  renderer.setPixelRatio(before);
  viewer.invalidate();
  if (blob) save(`${robot.value?.id ?? 'arm'}.png`, blob);
  else toast('The picture could not be made');
}
