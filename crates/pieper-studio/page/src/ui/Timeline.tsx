// The keyframes on a line of time: dragged, they go to another moment; a click on the line moves the clock.

import { useRef } from 'preact/hooks';
import { clock, connection, gesture, motion, send, toast } from '../state';
import { Stream } from '../wire/connection';
import type { Keyframe } from '../wire/types';

const move = new Stream((command) => connection.send(command), () => {}, (error) => toast(error.message));

/** Room behind the last keyframe, as a part of the whole: it can be dragged there. */
const ROOM = 0.12;
/** Times are rounded to this, seconds. */
const GRID = 0.01;

const round = (t: number): number => Math.max(0, Math.round(t / GRID) * GRID);

/** Seconds between marks of the scale: 1, 2 or 5 times a power of ten, some eight of them. */
export function spacing(span: number): number {
  const wanted = span / 8;
  const power = 10 ** Math.floor(Math.log10(wanted));
  return power * ([1, 2, 5, 10].find((step) => step * power >= wanted * (1 - 1e-9)) ?? 10);
}

export function Timeline() {
  const value = motion.value!;
  const line = useRef<HTMLDivElement>(null);
  const held = useRef<{ id: number; name: string; span: number; from: number; x: number } | null>(null);
  // While one is dragged the scale stands still.
  const span = held.current?.span ?? Math.max(1, value.duration) * (1 + ROOM);
  const place = (t: number): string => `${(100 * Math.min(t, span)) / span}%`;
  const timeAt = (x: number): number => {
    const frame = line.current!.getBoundingClientRect();
    return ((x - frame.left) / frame.width) * span;
  };
  const shift = (keyframe: Keyframe, t: number, name: string): void => {
    // Two keyframes cannot stand at one time: this one waits until it is past.
    if (value.keyframes.some((other) => other.id !== keyframe.id && Math.abs(other.t - t) < GRID / 2)) return;
    move.push({ do: 'keyframe', op: 'move', keyframe: keyframe.id, t, gesture: name });
  };
  const key = (event: KeyboardEvent, keyframe: Keyframe): void => {
    const by = { ArrowRight: 1, ArrowUp: 1, ArrowLeft: -1, ArrowDown: -1 }[event.key];
    if (by === undefined) return;
    event.preventDefault();
    event.stopPropagation();
    shift(keyframe, round(keyframe.t + by * (event.shiftKey ? 1 : event.altKey ? GRID : 0.1)), gesture('keyframe'));
  };
  const step = spacing(span);
  const ticks = Array.from({ length: Math.floor(span / step) + 1 }, (_, k) => k * step);
  return (
    <div class="timeline" ref={line} role="group" aria-label="Keyframes in time"
      onPointerDown={(event) => { if (event.target === line.current) void send({ do: 'seek', t: Math.min(value.duration, Math.max(0, timeAt(event.clientX))) }); }}>
      {ticks.map((t) => <span key={t} class="tick" aria-hidden="true" ref={at('left', place(t))}>{Number(t.toPrecision(6))} s</span>)}
      <span class="clock" aria-hidden="true" ref={at('left', place(clock.value))} />
      {value.keyframes.map((keyframe) => (
        <button type="button" key={keyframe.id} class="mark" role="slider" ref={at('left', place(keyframe.t))}
          aria-label={`Keyframe ${keyframe.label || keyframe.id}`} aria-valuenow={keyframe.t} aria-valuemin={0} aria-valuemax={span} aria-valuetext={`${keyframe.t.toFixed(2)} seconds`}
          title={`${keyframe.label || keyframe.id} at ${keyframe.t.toFixed(2)} s: drag to another time, double-click to go there`}
          onPointerDown={(event) => {
            event.currentTarget.setPointerCapture(event.pointerId);
            held.current = { id: keyframe.id, name: gesture('keyframe'), span, from: keyframe.t, x: event.clientX };
          }}
          onPointerMove={(event) => {
            const now = held.current;
            if (now?.id !== keyframe.id) return;
            const t = now.from + timeAt(event.clientX) - timeAt(now.x);
            shift(keyframe, round(Math.min(t, now.span)), now.name);
          }}
          onPointerUp={() => (held.current = null)} onPointerCancel={() => (held.current = null)}
          onDblClick={() => void send({ do: 'keyframe', op: 'goto', keyframe: keyframe.id })} onKeyDown={(event) => key(event, keyframe)}>
          <span>{keyframe.label || keyframe.id}</span>
        </button>
      ))}
    </div>
  );
}

/** Sets a style by the element, which the page's content policy allows, unlike a style attribute. */
function at(property: string, value: string) {
  return (element: HTMLElement | null): void => element?.style.setProperty(property, value);
}
