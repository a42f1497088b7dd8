// A shared file: the state of a studio with no program behind it. It can be looked at and its motion played.

import type { Listener } from './connection';
import type { Command, Motion, Samples, Sections } from './types';

interface Snapshot {
  sections: Partial<Sections>; frame: string; ghosts: string; meshes: Record<string, string>; samples: Samples; pictures: string[];
}

const element = document.getElementById('snapshot');
const snapshot: Snapshot | null = element ? (JSON.parse(element.textContent ?? 'null') as Snapshot) : null;

export const isSnapshot = snapshot !== null;

export function bytes(text: string): ArrayBuffer {
  const binary = atob(text);
  const out = new Uint8Array(binary.length);
  for (let k = 0; k < binary.length; k++) out[k] = binary.charCodeAt(k);
  return out.buffer;
}

/** A mesh that the file carries. */
export function embedded(hash: string): ArrayBuffer | null {
  const text = snapshot?.meshes[hash];
  return text === undefined ? null : bytes(text);
}

export class Shared {
  private readonly data = snapshot!;
  private motion: Motion | undefined = this.data.sections.motion;
  private readonly pictures = this.data.pictures.map(bytes);
  private last = 0;

  constructor(private readonly listener: Listener) {}

  open(): Promise<void> {
    for (const [name, value] of Object.entries(this.data.sections)) this.listener.section(name, value);
    this.listener.frame(bytes(this.data.frame));
    this.listener.frame(bytes(this.data.ghosts));
    this.listener.phase('open', 'shared');
    return Promise.resolve();
  }

  drop(): void {}

  send(command: Command): Promise<unknown> {
    const { motion } = this;
    if (command.do === 'samples') return Promise.resolve(this.data.samples);
    if (command.do === 'ghosts') return Promise.resolve(null);
    if (command.do === 'pick') return Promise.resolve(null);
    if (motion) {
      switch (command.do) {
        case 'play':
          if (motion.time >= motion.duration) motion.time = 0;
          this.change({ playing: true });
          this.last = performance.now();
          requestAnimationFrame(() => this.advance());
          return Promise.resolve(null);
        case 'pause': this.change({ playing: false }); return Promise.resolve(null);
        case 'seek': this.show(Number(command.t)); this.change({}); return Promise.resolve(null);
        case 'step': this.change({ playing: false }); this.show(motion.time + Number(command.by) / 30); this.change({}); return Promise.resolve(null);
        case 'loop': this.change({ loop: command.on === true }); return Promise.resolve(null);
        case 'speed': this.change({ speed: Number(command.to) }); return Promise.resolve(null);
      }
    }
    return Promise.reject(new Error('This is a shared file: there is no program behind it.'));
  }

  private change(what: Partial<Motion>): void {
    if (!this.motion) return;
    this.motion = { ...this.motion, ...what };
    this.listener.section('motion', this.motion);
  }

  /** Shows the picture nearest to a time. */
  private show(t: number): void {
    const { motion } = this;
    if (!motion) return;
    motion.time = Math.min(motion.duration, Math.max(0, t));
    const index = Math.round((motion.time / motion.duration) * (this.pictures.length - 1));
    const picture = this.pictures[index];
    if (picture) this.listener.frame(picture);
  }

  private advance(): void {
    const { motion } = this;
    if (!motion?.playing) return;
    const now = performance.now();
    let t = motion.time + (motion.speed * (now - this.last)) / 1000;
    this.last = now;
    if (t > motion.duration && motion.loop) t %= motion.duration;
    this.show(t);
    if (t > motion.duration) return this.change({ playing: false });
    requestAnimationFrame(() => this.advance());
  }
}
