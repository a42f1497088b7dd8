// The edge between two parts of the page, which can be moved.

import { useRef } from 'preact/hooks';
import type { Signal } from '@preact/signals';
import { store } from '../state';

interface Props { label: string; size: Signal<number>; name: string; from: 'right' | 'bottom'; least: number; most: () => number }

const STEP = 16;

/** The sizes are CSS pixels, counted from the side of the window that the part stands at. */
export function Splitter({ label, size, name, from, least, most }: Props) {
  const held = useRef<{ at: number; size: number } | null>(null);
  const along = (event: PointerEvent): number => (from === 'right' ? event.clientX : event.clientY);
  const set = (next: number): void => {
    size.value = Math.round(Math.min(most(), Math.max(least, next)));
  };
  const keep = (): void => {
    if (held.current) store(name, String(size.value));
    held.current = null;
  };
  return (
    <div class={`splitter ${from}`} role="separator" tabIndex={0} aria-label={label} aria-orientation={from === 'right' ? 'vertical' : 'horizontal'}
      aria-valuenow={size.value} aria-valuemin={least} aria-valuemax={most()} aria-valuetext={`${size.value} pixels`}
      title={`${label}: drag, or arrow keys`}
      onPointerDown={(event) => { event.currentTarget.setPointerCapture(event.pointerId); held.current = { at: along(event), size: size.value }; }}
      onPointerMove={(event) => { if (held.current) set(held.current.size + held.current.at - along(event)); }}
      onPointerUp={keep} onPointerCancel={keep}
      onKeyDown={(event) => {
        const by = { ArrowLeft: 1, ArrowUp: 1, ArrowRight: -1, ArrowDown: -1 }[event.key];
        if (by === undefined) return;
        event.preventDefault();
        set(size.value + by * STEP);
        store(name, String(size.value));
      }} />
  );
}
