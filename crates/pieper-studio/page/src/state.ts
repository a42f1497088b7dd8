// What the page knows: the program's sections as signals, and what is only this window's.

import { computed, signal } from '@preact/signals';
import { Connection, type Listener, type Phase } from './wire/connection';
import { Shared, isSnapshot } from './wire/snapshot';
import { decode, type GhostFrame, type PoseFrame } from './wire/frames';
import type { Command, Controller, History, Ik, LogLine, Motion, Pose, Robot, RobotEntry, Samples, Script, Sections } from './wire/types';
import type { Units } from './units';

export const robots = signal<RobotEntry[]>([]);
export const robot = signal<Robot | null>(null);
export const pose = signal<Pose | null>(null);
export const ik = signal<Ik | null>(null);
export const motion = signal<Motion | null>(null);
export const history = signal<History>({ undo: null, redo: null });
export const log = signal<LogLine[]>([]);
export const script = signal<Script | null>(null);
export const controller = signal<Controller>({ phase: 'off', said: [] });
export interface ConsoleLine { stream: 'out' | 'err' | 'note'; text: string }
export const consoleLines = signal<ConsoleLine[]>([]);
export const samples = signal<Samples | null>(null);

/** Joint values as last drawn: sixty times a second while something moves. */
export const liveQ = signal<Float32Array>(new Float32Array());
/** Where the motion's clock stands. */
export const clock = signal(0);

export const phase = signal<Phase>('connecting');
export const phaseText = signal('');
export const roundTrip = signal<number | null>(null);

export interface Toast { id: number; text: string; kind: 'error' | 'note' }
export const toasts = signal<Toast[]>([]);
/** Said to screen readers, politely. */
export const said = signal('');

export type Tab = 'joints' | 'tool' | 'ik' | 'robot';
export type Drawer = 'motion' | 'plots' | 'formulas' | 'script' | 'controller' | 'log' | null;
export type Theme = 'system' | 'light' | 'dark';

function stored<T extends string>(key: string, values: readonly T[], first: T): T {
  const value = safely(() => localStorage.getItem(`pieper.${key}`)) as T | null;
  return value && values.includes(value) ? value : first;
}

function storedNumber(key: string, first: number): number {
  const value = Number(safely(() => localStorage.getItem(`pieper.${key}`)));
  return Number.isFinite(value) && value > 0 ? value : first;
}

function safely<T>(read: () => T): T | null {
  try {
    return read();
  } catch {
    return null;
  }
}

export function store(key: string, value: string): void {
  safely(() => localStorage.setItem(`pieper.${key}`, value));
}

export const tab = signal<Tab>('joints');
export const drawer = signal<Drawer>(null);
export const panelOpen = signal(true);
/** Sizes of the side panel, the drawer, and the drawer with long texts, CSS pixels. */
export const sizes = { panel: signal(storedNumber('panel', 336)), drawer: signal(storedNumber('drawer', 236)), tall: signal(storedNumber('tall', Math.min(420, Math.round(0.46 * innerHeight)))) };
export const theme = signal<Theme>(stored('theme', ['system', 'light', 'dark'], 'system'));
export const units = signal<Units>({
  angle: stored('angle', ['deg', 'rad'] as const, 'deg'),
  length: stored('length', ['mm', 'm'] as const, 'mm'),
});
export const letters = signal(stored('letters', ['on', 'off'], 'on') === 'on');
/** The view turns freely, not about the upright axis. */
export const tumbling = signal(stored('tumble', ['on', 'off'], 'off') === 'on');
export const hintSeen = signal(isSnapshot || stored('hint', ['seen', 'new'], 'new') === 'seen');
/** The hint of the first start has done its work. */
export function seen(): void {
  hintSeen.value = true;
  store('hint', 'seen');
}

export const overlay = signal<'help' | 'palette' | 'picture' | null>(null);

export const show = {
  ghosts: signal(false),
  frames: signal(false),
  trail: signal(true),
  outline: signal(false),
  gizmo: signal<'off' | 'translate' | 'rotate'>('off'),
  local: signal(false),
  collision: signal(false),
};

/** The link under the pointer, and the solution pointed at in the list. */
export const hovered = signal<number | null>(null);
export const pointed = signal<number | null>(null);
export const dragging = signal(false);

export const dark = computed(() => theme.value === 'dark' || (theme.value === 'system' && systemDark.value));
const query = matchMedia('(prefers-color-scheme: dark)');
const systemDark = signal(query.matches);
query.addEventListener('change', (event) => (systemDark.value = event.matches));

type FrameListener = (frame: PoseFrame | GhostFrame) => void;
const frameListeners: FrameListener[] = [];
export function onFrame(listener: FrameListener): void {
  frameListeners.push(listener);
}

const into: { [K in keyof Sections]?: (value: Sections[K]) => void } = {
  robots: (value) => (robots.value = value),
  robot: (value) => (robot.value = value),
  pose: (value) => (pose.value = value),
  ik: (value) => (ik.value = value),
  motion: (value) => {
    const changed = value.samples !== motion.value?.samples || !samples.value;
    motion.value = value;
    if (!value.playing) clock.value = value.time;
    if (changed) void fetchSamples();
  },
  script: (value) => (script.value = value),
  controller: (value) => (controller.value = value),
  history: (value) => (history.value = value),
  log: (value) => (log.value = value),
};

async function fetchSamples(): Promise<void> {
  samples.value = (await connection.send({ do: 'samples', rate: 60 })) as Samples;
}

const listener: Listener = {
  section: (name, value) => (into[name as keyof Sections] as ((value: unknown) => void) | undefined)?.(value),
  event: (message) => {
    if (message.event !== 'console') return;
    const line = { stream: message.stream, text: message.text } as ConsoleLine;
    consoleLines.value = [...consoleLines.value, line].slice(-500);
  },
  frame: (buffer) => {
    const frame = decode(buffer);
    if (!frame) return;
    if (frame.kind === 'pose') {
      liveQ.value = frame.q;
      if (frame.playing) clock.value = frame.time;
    }
    for (const listener of frameListeners) listener(frame);
  },
  phase: (next, text) => {
    phase.value = next;
    phaseText.value = text;
  },
  roundTrip: (ms) => (roundTrip.value = ms),
};

export const connection: Connection | Shared = isSnapshot ? new Shared(listener) : new Connection(listener);

let lastToast = 0;
export function toast(text: string, kind: Toast['kind'] = 'error'): void {
  const id = ++lastToast;
  toasts.value = [...toasts.value.filter((other) => other.text !== text), { id, text, kind }].slice(-3);
  setTimeout(() => (toasts.value = toasts.value.filter((other) => other.id !== id)), kind === 'error' ? 7000 : 3500);
}

/** Sends a command; what goes wrong is shown. */
export async function send(command: Command): Promise<unknown> {
  try {
    return await connection.send(command);
  } catch (error) {
    toast((error as Error).message);
    return undefined;
  }
}

let gestures = 0;
/** A name for one gesture: its changes are one step of undo. */
export function gesture(what: string): string {
  return `${what}-${++gestures}-${Date.now()}`;
}
