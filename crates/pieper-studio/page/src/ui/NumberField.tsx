// A number in the unit shown; what is typed may carry its own: 90deg, pi/2, 250mm.

import { useState } from 'preact/hooks';
import { units } from '../state';
import { shown, typed, unit, type Kind } from '../units';

interface Props { value: number; kind: Kind | 'plain'; label: string; onCommit: (text: string) => void; id?: string }

export function NumberField({ value, kind, label, onCommit, id }: Props) {
  const [draft, setDraft] = useState<string | null>(null);
  const now = kind === 'plain' ? value.toFixed(4) : shown(value, kind, units.value);
  const commit = (): void => {
    if (draft !== null && draft.trim() !== '' && draft !== now) onCommit(kind === 'plain' ? draft.trim() : typed(draft, kind, units.value));
    setDraft(null);
  };
  return (
    <span class="number">
      <input id={id} type="text" inputMode="text" spellcheck={false} autocomplete="off" aria-label={label} value={draft ?? now}
        onFocus={(event) => { setDraft(now); event.currentTarget.select(); }}
        onInput={(event) => setDraft(event.currentTarget.value)}
        onBlur={commit}
        onKeyDown={(event) => {
          if (event.key === 'Enter') { commit(); event.currentTarget.blur(); }
          if (event.key === 'Escape') { setDraft(null); event.currentTarget.blur(); }
          event.stopPropagation();
        }} />
      {kind !== 'plain' && <span class="unit" aria-hidden="true">{unit(kind, units.value)}</span>}
    </span>
  );
}
