// The joints: a slider and a number each.

import { useRef } from 'preact/hooks';
import { connection, gesture, liveQ, pose, robot, send, toast, units } from '../state';
import { kindOf, shown, spoken } from '../units';
import type { Joint } from '../wire/types';
import { Stream } from '../wire/connection';
import { Icon, IconButton } from './icons';
import { NumberField } from './NumberField';
import { fromClipboard } from './paste';

const DEGREE = Math.PI / 180;
/** A joint this part of its range from a limit is near it. */
const NEAR = 0.04;

const slide = new Stream((command) => connection.send(command), () => {}, (error) => toast(error.message));

function Row({ joint, index }: { joint: Joint; index: number }) {
  const name = useRef('');
  const kind = kindOf(joint);
  const value = liveQ.value[index] ?? 0;
  const { lower, upper } = joint;
  const range = upper - lower;
  const step = kind === 'angle' ? 0.1 * DEGREE : 0.0005;
  const near = !joint.unlimited && Math.min(value - lower, upper - value) < NEAR * range;
  const over = pose.value?.over_limit[index] ?? false;
  // Keys come faster than answers: the next step starts from what was asked for.
  const asked = useRef({ value, at: 0 });
  const set = (next: number): void => {
    asked.current = { value: next, at: performance.now() };
    slide.push({ do: 'joint', joint: index, value: next, gesture: name.current });
  };
  const key = (event: KeyboardEvent): void => {
    const direction = { ArrowUp: 1, ArrowRight: 1, ArrowDown: -1, ArrowLeft: -1 }[event.key];
    if (direction === undefined) return;
    event.preventDefault();
    event.stopPropagation();
    if (!event.repeat) name.current = gesture(`key-${index}`);
    const from = performance.now() - asked.current.at < 200 ? asked.current.value : value;
    const size = event.shiftKey ? 10 : event.altKey ? 0.1 : 1;
    set(Math.min(upper, Math.max(lower, from + direction * size * (kind === 'angle' ? DEGREE : 0.001))));
  };
  const ticks = kind === 'angle' ? [-90, -45, 0, 45, 90].map((tick) => tick * DEGREE).filter((tick) => tick > lower && tick < upper) : lower < 0 && upper > 0 ? [0] : [];
  const limits = joint.unlimited ? 'no limits' : `limits ${shown(lower, kind, units.value)} to ${shown(upper, kind, units.value)}`;
  return (
    <li class={`joint ${over ? 'over' : near ? 'near' : ''}`}>
      <button type="button" class="joint-name" title={`${joint.name}: ${limits}. Double-click for zero.`}
        onDblClick={() => void send({ do: 'joint', joint: index, value: 0 })} aria-label={`${joint.label}, ${joint.name}, ${limits}`}>
        {joint.label}
      </button>
      <span class="track">
        <input type="range" min={lower} max={upper} step={step} value={value} aria-label={`${joint.label} slider`}
          aria-valuetext={`${joint.label}, ${spoken(value, kind)}, ${over ? 'over its limit' : near ? 'near its limit' : limits}`}
          onPointerDown={() => (name.current = gesture(`slider-${index}`))} onKeyDown={key}
          onInput={(event) => set(Number(event.currentTarget.value))} />
        <svg class="ticks" viewBox="0 0 100 4" preserveAspectRatio="none" aria-hidden="true">
          {ticks.map((tick) => { const x = (100 * (tick - lower)) / range; return <line key={tick} x1={x} x2={x} y1="0" y2="4" />; })}
        </svg>
      </span>
      <NumberField value={value} kind={kind} label={`${joint.label} value`} onCommit={(text) => void send({ do: 'joint', joint: index, value: text })} />
      <span class="joint-state" title={over ? 'over its limit' : near ? 'near its limit' : ''}>{(over || near) && <Icon name="warn" />}</span>
    </li>
  );
}

export function Joints() {
  const joints = robot.value?.joints ?? [];
  const unlocked = pose.value?.unlocked ?? false;
  const copy = (): void => {
    const text = Array.from(liveQ.value, (value, j) => shown(value, kindOf(joints[j]!), units.value)).join(', ');
    void navigator.clipboard?.writeText(text).then(() => toast('Joint values copied', 'note'), () => toast('The clipboard is closed to this page'));
  };
  return (
    <section aria-label="Joints">
      <ul class="joints">{joints.map((joint, index) => <Row key={`${robot.value?.revision}-${index}`} joint={joint} index={index} />)}</ul>
      {unlocked && <p class="banner"><Icon name="warn" /> Limits are unlocked: joints may go where the arm cannot.</p>}
      <div class="buttons">
        <IconButton icon="home" label="Home" keys="H" text="Home" onClick={() => void send({ do: 'named', to: 'home' })} />
        <IconButton icon="fit" label="Zero" keys="0" text="Zero" onClick={() => void send({ do: 'named', to: 'zero' })} />
        <IconButton icon="dice" label="Random posture within the limits" text="Random" onClick={() => void send({ do: 'named', to: 'random' })} />
        <IconButton icon="copy" label="Copy the joint values" text="Copy" onClick={copy} />
        <IconButton icon="paste" label="Paste joint values, as Copy or a table gives them" keys="Ctrl+V" text="Paste" onClick={fromClipboard} />
        <IconButton icon={unlocked ? 'unlock' : 'lock'} label={unlocked ? 'Lock the limits' : 'Unlock the limits'} pressed={unlocked} onClick={() => void send({ do: 'unlock', on: !unlocked })} text="Limits" />
      </div>
      <button type="button" class="link" onClick={() => void send({ do: 'set_home' }).then(() => toast('This posture is home now', 'note'))}>Make this posture home</button>
    </section>
  );
}
