import { describe, expect, it } from 'vitest';
import { decode, decodeMesh } from '../../src/wire/frames';

function poseFrame(links: number, q: number[]): ArrayBuffer {
  const buffer = new ArrayBuffer(20 + 4 * q.length + 64 * links);
  const view = new DataView(buffer);
  view.setUint8(0, 1);
  view.setUint8(1, 1);
  view.setUint16(2, links, true);
  view.setUint32(4, 7, true);
  view.setFloat64(8, 1.5, true);
  view.setUint32(16, q.length, true);
  q.forEach((value, k) => view.setFloat32(20 + 4 * k, value, true));
  for (let k = 0; k < 16 * links; k++) view.setFloat32(20 + 4 * q.length + 4 * k, k, true);
  return buffer;
}

describe('frames', () => {
  it('reads a pose', () => {
    const frame = decode(poseFrame(3, [0.5, -1]));
    expect(frame).toMatchObject({ kind: 'pose', playing: true, sequence: 7, time: 1.5, links: 3 });
    expect(frame?.kind === 'pose' && [...frame.q]).toEqual([0.5, -1]);
    expect(frame?.matrices[47]).toBe(47);
  });
  it('refuses what is cut short or unknown', () => {
    const whole = poseFrame(2, [1, 2, 3]);
    for (let length = 0; length < whole.byteLength; length++) expect(decode(whole.slice(0, length))).toBeNull();
    new DataView(whole).setUint8(0, 9);
    expect(decode(whole)).toBeNull();
  });
  it('reads a mesh of the length it names, and no other', () => {
    const buffer = new ArrayBuffer(12 + 3 * 24 + 3 * 4);
    const view = new DataView(buffer);
    view.setUint32(0, 0x314d5050, true);
    view.setUint32(4, 3, true);
    view.setUint32(8, 3, true);
    expect(decodeMesh(buffer)?.indices.length).toBe(3);
    expect(decodeMesh(buffer.slice(0, 40))).toBeNull();
  });
});
