// The one connection to the program: it comes back by itself, and every window gets the whole state again.

import type { Command } from './types';

export type Phase = 'connecting' | 'open' | 'lost' | 'refused';

export interface Listener {
  section(name: string, value: unknown): void;
  event(message: Record<string, unknown>): void;
  frame(buffer: ArrayBuffer): void;
  phase(phase: Phase, text: string): void;
  roundTrip(ms: number): void;
}

interface Waiting { resolve(value: unknown): void; reject(error: Error): void }

const FIRST_WAIT = 250;
const LONGEST_WAIT = 5000;

export class Connection {
  private socket: WebSocket | null = null;
  private waiting = new Map<number, Waiting>();
  private next = 1;
  private wait = FIRST_WAIT;

  constructor(private readonly listener: Listener) {}

  /** Swaps the token of the address for a cookie, then connects. */
  async open(): Promise<void> {
    const token = /(?:^#|&)token=([0-9a-f]+)/.exec(location.hash)?.[1];
    if (token) {
      const answer = await fetch('/api/session', { method: 'POST', body: JSON.stringify({ token }) }).catch(() => null);
      // The token leaves the address: it is not for bookmarks or screenshots.
      history.replaceState(null, '', location.pathname + location.search);
      if (answer && !answer.ok) return this.listener.phase('refused', await answer.text());
    }
    this.connect();
    setInterval(() => this.post({ ping: performance.now() }), 2000);
  }

  private connect(): void {
    this.listener.phase('connecting', '');
    const socket = new WebSocket(`ws://${location.host}/ws`);
    socket.binaryType = 'arraybuffer';
    this.socket = socket;
    socket.onopen = () => {
      this.wait = FIRST_WAIT;
      this.listener.phase('open', '');
      this.post({ ping: performance.now() });
    };
    socket.onmessage = (message) => {
      if (typeof message.data === 'string') this.text(JSON.parse(message.data) as Record<string, unknown>);
      else this.listener.frame(message.data as ArrayBuffer);
    };
    socket.onclose = () => void this.lost();
  }

  private async lost(): Promise<void> {
    for (const waiting of this.waiting.values()) waiting.reject(new Error('the connection was lost'));
    this.waiting.clear();
    const state = await fetch('/api/project.json').catch(() => null);
    if (state?.status === 401) {
      return this.listener.phase('refused', 'This window is not signed in: open the address that the program printed.');
    }
    this.listener.phase('lost', '');
    setTimeout(() => this.connect(), this.wait);
    this.wait = Math.min(2 * this.wait, LONGEST_WAIT);
  }

  private text(message: Record<string, unknown>): void {
    if (typeof message.section === 'string') return this.listener.section(message.section, message.value);
    if (typeof message.pong === 'number') return this.listener.roundTrip(performance.now() - message.pong);
    if (typeof message.ack === 'number') {
      const waiting = this.waiting.get(message.ack);
      this.waiting.delete(message.ack);
      if (typeof message.error === 'string') waiting?.reject(new Error(message.error));
      else waiting?.resolve(message.value);
      return;
    }
    if (typeof message.event === 'string') this.listener.event(message);
  }

  private post(message: unknown): boolean {
    if (this.socket?.readyState !== WebSocket.OPEN) return false;
    this.socket.send(JSON.stringify(message));
    return true;
  }

  /** Sends a command; the value that it is answered with. */
  send(command: Command): Promise<unknown> {
    const id = this.next++;
    return new Promise((resolve, reject) => {
      if (this.post({ ...command, id })) this.waiting.set(id, { resolve, reject });
      else reject(new Error('not connected'));
    });
  }

  /** For tests: drops the connection as a cut cable would. */
  drop(): void {
    this.socket?.close();
  }
}

/** Sends the newest of a stream of commands: one in flight, and the last always. */
export class Stream {
  private busy = false;
  private latest: Command | null = null;

  constructor(
    private readonly send: (command: Command) => Promise<unknown>,
    private readonly answered: (value: unknown) => void = () => {},
    private readonly failed: (error: Error) => void = () => {},
  ) {}

  push(command: Command): void {
    this.latest = command;
    if (!this.busy) void this.drain();
  }

  /** Resolves when all has been sent and answered. */
  private async drain(): Promise<void> {
    this.busy = true;
    while (this.latest) {
      const command = this.latest;
      this.latest = null;
      try {
        this.answered(await this.send(command));
      } catch (error) {
        this.failed(error as Error);
      }
    }
    this.busy = false;
    this.idle.splice(0).forEach((done) => done());
  }

  private idle: (() => void)[] = [];

  settled(): Promise<void> {
    return this.busy ? new Promise((done) => this.idle.push(done)) : Promise.resolve();
  }
}
