// The top bar: which arm, undo and redo, what is shown, units, theme, the connection.

import { history, overlay, panelOpen, phase, robot, robots, roundTrip, send, show, store, theme, toast, units, type Theme } from '../state';
import { isSnapshot } from '../wire/snapshot';
import { Icon, IconButton } from './icons';

async function choose(select: HTMLSelectElement): Promise<void> {
  const entry = robots.value.find((candidate) => candidate.id === select.value);
  const values: Record<string, string> = {};
  for (const name of entry?.needs ?? []) {
    // A symbolic arm needs its lengths; a third of a metre makes an arm that can be looked at.
    const text = prompt(`${entry!.name}: the length ${name}, as in 0.3 or 250 mm`, '0.3');
    if (text === null) {
      select.value = robot.value?.id ?? '';
      return;
    }
    values[name] = text;
  }
  const done = await send({ do: 'load', robot: select.value, values });
  if (done === undefined) select.value = robot.value?.id ?? '';
}

async function openFile(file: File): Promise<void> {
  const text = await file.text();
  if (file.name.endsWith('.json')) await send({ do: 'open', text });
  else await send({ do: 'load', file: { name: file.name, text } });
}

export function TopBar() {
  const { undo, redo } = history.value;
  const known = robots.value.some((entry) => entry.id === robot.value?.id);
  const nextTheme: Record<Theme, Theme> = { system: 'light', light: 'dark', dark: 'system' };
  const trip = roundTrip.value;
  if (isSnapshot) return <SharedBar />;
  return (
    <header class="top">
      <span class="brand"><svg viewBox="0 0 32 32" aria-hidden="true"><path d="M9 25h14M12 25l-1-9 9-6 4 4" /><circle cx="11" cy="16" r="2.6" /><circle cx="20" cy="10" r="2.6" /></svg><span>pieper</span></span>
      <div class="picker">
        <select aria-label="Robot" value={robot.value?.id ?? ''} onChange={(event) => void choose(event.currentTarget)}>
          {!known && robot.value && <option value={robot.value.id}>{robot.value.name}</option>}
          {robots.value.map((entry) => <option key={entry.id} value={entry.id}>{entry.name}</option>)}
        </select><Icon name="down" />
      </div>
      <label class="icon-button" title="Open a robot (.toml, .urdf) or a project (.json)"><Icon name="upload" /><span class="visually-hidden">Open a robot or project file</span>
        <input type="file" class="visually-hidden" accept=".toml,.urdf,.xml,.json" onChange={(event) => { const file = event.currentTarget.files?.[0]; if (file) void openFile(file); event.currentTarget.value = ''; }} />
      </label>
      <span class="group">
        <IconButton icon="undo" label={undo ? `Undo: ${undo}` : 'Nothing to undo'} keys="Ctrl+Z" disabled={!undo} onClick={() => void send({ do: 'undo' })} />
        <IconButton icon="redo" label={redo ? `Redo: ${redo}` : 'Nothing to redo'} keys="Ctrl+Shift+Z" disabled={!redo} onClick={() => void send({ do: 'redo' })} />
      </span>
      <span class="grow" />
      <span class="group wide">
        <IconButton icon="move" label="Move the tool by a gizmo" keys="W" pressed={show.gizmo.value === 'translate'} onClick={() => (show.gizmo.value = show.gizmo.value === 'translate' ? 'off' : 'translate')} />
        <IconButton icon="rotate" label="Turn the tool by a gizmo" keys="E" pressed={show.gizmo.value === 'rotate'} onClick={() => (show.gizmo.value = show.gizmo.value === 'rotate' ? 'off' : 'rotate')} />
      </span>
      <span class="group wide">
        <IconButton icon="ghost" label="Ghosts of all solutions" keys="G" pressed={show.ghosts.value} onClick={toggleGhosts} />
        <IconButton icon="axes" label="Link frames" keys="T" pressed={show.frames.value} onClick={() => (show.frames.value = !show.frames.value)} />
        <IconButton icon="trail" label="The tool's way" pressed={show.trail.value} onClick={() => (show.trail.value = !show.trail.value)} />
        <IconButton icon="reach" label="Outline of the reach" keys="O" pressed={show.outline.value} onClick={() => (show.outline.value = !show.outline.value)} />
      </span>
      <span class="group">
        <button type="button" class="text-button" title="Units (U)" aria-label={`Units: ${units.value.angle} and ${units.value.length}`} onClick={nextUnits}>{units.value.angle === 'deg' ? '°' : 'rad'} · {units.value.length}</button>
        <IconButton icon="download" label="Share: this view as one file that needs no program" onClick={() => location.assign('/api/share.html')} />
        <IconButton icon="camera" label="A picture of the view" onClick={() => (overlay.value = 'picture')} />
        <IconButton icon={theme.value === 'system' ? 'auto' : theme.value === 'light' ? 'sun' : 'moon'} label={`Theme: ${theme.value}`} onClick={() => { theme.value = nextTheme[theme.value]; store('theme', theme.value); }} />
        <IconButton icon="help" label="Keys and gestures" keys="?" onClick={() => (overlay.value = 'help')} />
        <IconButton icon="panel" label="Side panel" pressed={panelOpen.value} onClick={() => (panelOpen.value = !panelOpen.value)} />
      </span>
      <span class={`connection ${phase.value}`} role="status" title="Time for a message to the program and back">
        <span class="dot" aria-hidden="true" />{phase.value === 'open' ? (trip === null ? 'connected' : `${trip.toFixed(1)} ms`) : phase.value}
      </span>
    </header>
  );
}

/** The bar of a shared file: what it shows, and how it is looked at. */
function SharedBar() {
  const nextTheme: Record<Theme, Theme> = { system: 'light', light: 'dark', dark: 'system' };
  return (
    <header class="top">
      <span class="brand"><span>{robot.value?.name}</span></span>
      <span class="quiet small">shared from pieper studio</span>
      <span class="grow" />
      <span class="group">
        <IconButton icon="ghost" label="Ghosts of all solutions" keys="G" pressed={show.ghosts.value} onClick={toggleGhosts} />
        <IconButton icon="axes" label="Link frames" keys="T" pressed={show.frames.value} onClick={() => (show.frames.value = !show.frames.value)} />
        <IconButton icon="reach" label="Outline of the reach" keys="O" pressed={show.outline.value} onClick={() => (show.outline.value = !show.outline.value)} />
      </span>
      <span class="group">
        <button type="button" class="text-button" title="Units (U)" onClick={nextUnits}>{units.value.angle === 'deg' ? '°' : 'rad'} · {units.value.length}</button>
        <IconButton icon={theme.value === 'system' ? 'auto' : theme.value === 'light' ? 'sun' : 'moon'} label={`Theme: ${theme.value}`} onClick={() => (theme.value = nextTheme[theme.value])} />
        <IconButton icon="panel" label="Side panel" pressed={panelOpen.value} onClick={() => (panelOpen.value = !panelOpen.value)} />
      </span>
    </header>
  );
}

export function toggleGhosts(): void {
  show.ghosts.value = !show.ghosts.value;
  void send({ do: 'ghosts', on: show.ghosts.value });
}

export function nextUnits(): void {
  const { angle, length } = units.value;
  units.value = angle === 'deg' && length === 'mm' ? { angle: 'rad', length: 'm' } : { angle: 'deg', length: 'mm' };
  store('angle', units.value.angle);
  store('length', units.value.length);
  toast(`Shown in ${units.value.angle === 'deg' ? 'degrees' : 'radians'} and ${units.value.length === 'mm' ? 'millimetres' : 'metres'}`, 'note');
}
