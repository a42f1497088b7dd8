// Binary frames: WIRE.md section 5. Little endian.

export interface PoseFrame { kind: 'pose'; playing: boolean; sequence: number; time: number; q: Float32Array; links: number; matrices: Float32Array }
export interface GhostFrame { kind: 'ghosts' | 'real'; sequence: number; links: number; count: number; matrices: Float32Array }

const HEAD = 16;

/** Reads a frame; null for one that is not known or cut short. */
export function decode(buffer: ArrayBuffer): PoseFrame | GhostFrame | null {
  if (buffer.byteLength < HEAD + 4) return null;
  const view = new DataView(buffer);
  const kind = view.getUint8(0);
  const links = view.getUint16(2, true);
  const sequence = view.getUint32(4, true);
  const count = view.getUint32(HEAD, true);
  if (kind === 1) {
    const start = HEAD + 4 + 4 * count;
    if (buffer.byteLength < start + 64 * links) return null;
    return {
      kind: 'pose', playing: (view.getUint8(1) & 1) === 1, sequence, links, time: view.getFloat64(8, true),
      q: new Float32Array(buffer, HEAD + 4, count), matrices: new Float32Array(buffer, start, 16 * links),
    };
  }
  if (kind === 2 || kind === 3) {
    if (buffer.byteLength < HEAD + 4 + 64 * links * count) return null;
    return { kind: kind === 2 ? 'ghosts' : 'real', sequence, links, count, matrices: new Float32Array(buffer, HEAD + 4, 16 * links * count) };
  }
  return null;
}

export interface MeshData { positions: Float32Array; normals: Float32Array; indices: Uint32Array }

/** Reads a mesh: WIRE.md section 6. */
export function decodeMesh(buffer: ArrayBuffer): MeshData | null {
  if (buffer.byteLength < 12) return null;
  const view = new DataView(buffer);
  if (view.getUint32(0, true) !== 0x314d5050) return null;
  const corners = view.getUint32(4, true);
  const indices = view.getUint32(8, true);
  if (buffer.byteLength !== 12 + 24 * corners + 4 * indices) return null;
  return {
    positions: new Float32Array(buffer, 12, 3 * corners),
    normals: new Float32Array(buffer, 12 + 12 * corners, 3 * corners),
    indices: new Uint32Array(buffer, 12 + 24 * corners, indices),
  };
}
