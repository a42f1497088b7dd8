// The sections of the wire, as WIRE.md describes them.

export interface RobotEntry { id: string; name: string; joints: number; needs: string[] }

export interface Joint {
  name: string; label: string; kind: 'revolute' | 'continuous' | 'prismatic';
  lower: number; upper: number; unlimited: boolean; velocity: number | null; home: number;
}

export interface Part { mesh: string; color: [number, number, number, number]; collision: boolean; placed: number[][] }
export interface Link { name: string; joint: number | null; parts: Part[] }

export interface TreeLink { name: string; parent: number | null; joint: string | null; how: string | null }

export interface Robot {
  id: string; name: string; summary: string; source: string; revision: number; up: 'x' | 'y' | 'z';
  joints: Joint[]; links: Link[];
  table: { convention: string; columns: string[]; rows: string[][] } | null;
  tree: TreeLink[] | null;
  facts: [string, string][]; parameters: [string, string | null][]; problems: string[];
  reach: number; outline: [number, number][]; outline_frame: number[][];
}

export interface PoseNumbers {
  position: [number, number, number]; rpy: [number, number, number]; quaternion: [number, number, number, number];
  axis: [number, number, number]; angle: number;
}

export interface Pose {
  q: number[]; tool: PoseNumbers; matrix: number[][]; method: 'matrix' | 'quaternion';
  methods: { matrix: number[][]; quaternion: number[][]; difference: number } | null;
  measures: { manipulability: number; smallest_singular_value: number; condition: number | null } | null;
  over_limit: boolean[]; unlocked: boolean;
}

export interface Solution {
  q: number[]; branch: string; shoulder: string | null; elbow: string | null; wrist: string | null;
  residual: number; multiplicity: number; within_limits: boolean; distance: number; current: boolean;
}

export interface Family { name: string; branch: string; q: number[]; free: number[]; at: number }

export interface Ik {
  status: 'solved' | 'singular' | 'redundant' | 'unreachable' | 'none' | 'playing';
  solver?: string; microseconds?: number; missed?: boolean; reason?: string | null;
  goal?: PoseNumbers; solutions: Solution[]; families: Family[];
}

export interface Keyframe { id: number; t: number; label: string }

export interface Motion {
  keyframes: Keyframe[]; law: string; laws: string[]; duration: number; playing: boolean; time: number;
  speed: number; loop: boolean; name: string | null; samples: number; problem: string | null;
}

export interface Samples { t: number[]; q: number[][]; qd: number[][]; qdd: number[][]; tool: [number, number, number][]; tool_speed: number[] }

export interface History { undo: string | null; redo: string | null }
export interface LogLine { level: 'info' | 'warning' | 'error'; text: string }

export interface Sections {
  robots: RobotEntry[]; robot: Robot; pose: Pose; ik: Ik; motion: Motion; history: History; log: LogLine[]; script: Script; controller: Controller;
}

export interface Script {
  text: string; running: boolean; error: { line: number | null; text: string } | null; ended: string | null;
  python: { found: boolean; version: string; numpy: boolean; sentence: string } | null;
}

export interface Controller {
  phase: string; live?: boolean; held?: boolean; address?: string; protocol?: string; controller?: string | null;
  sentence?: string | null; said: string[]; measured?: number[] | null; commanded?: number[] | null;
  error?: { joint: number; error: number } | null; lag?: number | null; latency?: number | null;
  progress?: [number, number] | null; sent?: number; late?: number; dropped?: number;
}

export type Command = { do: string } & Record<string, unknown>;
