// The bottom drawer: motion, plots, log.

import { clock, drawer, log, motion, send, sizes, toast, type Drawer as Which } from '../state';
import { IconButton } from './icons';
import { NumberField } from './NumberField';
import { isSnapshot } from '../wire/snapshot';
import { ControllerPanel } from './Controller';
import { Formulas } from './Formulas';
import { Plots } from './Plots';
import { ScriptPanel } from './Script';
import { Splitter } from './Splitter';
import { Timeline } from './Timeline';

const TABS: [Exclude<Which, null>, string][] = [['motion', 'Motion'], ['plots', 'Plots'], ['formulas', 'Formulas'], ['script', 'Script'], ['controller', 'Controller'], ['log', 'Log']];

/** Formulas and scripts are long: their drawer has a size of its own. */
export function drawerSize(): 'drawer' | 'tall' {
  return drawer.value === 'script' || drawer.value === 'formulas' ? 'tall' : 'drawer';
}

export function Drawer() {
  const open = drawer.value;
  const value = motion.value;
  return (
    <footer class={`drawer ${open ? 'open' : ''}`}>
      {open && <Splitter key={drawerSize()} label="Height of the drawer" size={sizes[drawerSize()]} name={drawerSize()} from="bottom" least={120} most={() => Math.max(120, Math.round(0.7 * innerHeight))} />}
      <div class="drawer-bar">
        <Transport />
        <span class="grow" />
        <div class="tabs" role="tablist" aria-label="Drawer">
          {TABS.filter(([key]) => !isSnapshot || key === 'plots').map(([key, text]) => (
            <button type="button" key={key} role="tab" id={`drawer-tab-${key}`} aria-selected={open === key} aria-controls="drawer-body"
              onClick={() => (drawer.value = open === key ? null : key)}>
              {text}{key === 'log' && log.value.some((line) => line.level !== 'info') && <span class="badge">{log.value.length}</span>}
            </button>
          ))}
        </div>
      </div>
      <div class="drawer-body" id="drawer-body" role="tabpanel" hidden={!open} {...(open ? { 'aria-labelledby': `drawer-tab-${open}` } : {})}>
        {open === 'motion' && value && <MotionPanel />}
        {open === 'plots' && <Plots />}
        {open === 'formulas' && <Formulas />}
        {open === 'script' && <ScriptPanel />}
        {open === 'controller' && <ControllerPanel />}
        {open === 'log' && (log.value.length === 0 ? <p class="quiet">Nothing has happened that needs telling.</p> : <ol class="log">{log.value.map((line, k) => <li key={k} class={line.level}>{line.text}</li>)}</ol>)}
      </div>
    </footer>
  );
}

function Transport() {
  const value = motion.value;
  if (!value) return null;
  const ready = value.keyframes.length > 1;
  return (
    <div class="transport" role="group" aria-label="Playback">
 {!isSnapshot && <IconButton icon="plus" label="Add this posture as a keyframe" keys="K" text={ready ? undefined! : 'Keyframe'} onClick={addKeyframe} />}
      <IconButton icon="back" label="A step back" disabled={!ready} onClick={() => void send({ do: 'step', by: -1 })} />
      <IconButton icon={value.playing ? 'pause' : 'play'} class="primary" label={value.playing ? 'Pause' : 'Play'} keys="Space" disabled={!ready} onClick={playOrPause} />
      <IconButton icon="forward" label="A step on" disabled={!ready} onClick={() => void send({ do: 'step', by: 1 })} />
      <IconButton icon="loop" label="Again and again" pressed={value.loop} disabled={!ready} onClick={() => void send({ do: 'loop', on: !value.loop })} />
      {ready && (
        <>
          <input class="scrub" type="range" min={0} max={value.duration} step={value.duration / 1000} value={clock.value} aria-label="Time"
            aria-valuetext={`${clock.value.toFixed(2)} of ${value.duration.toFixed(2)} seconds`} onInput={(event) => { clock.value = Number(event.currentTarget.value); void send({ do: 'seek', t: clock.value }); }} />
          <span class="time">{clock.value.toFixed(2)} / {value.duration.toFixed(2)} s</span>
        </>
      )}
      {!ready && <span class="quiet small wide">Two keyframes or a table make a motion.</span>}
    </div>
  );
}

export function addKeyframe(): void {
  void send({ do: 'keyframe', op: 'add' }).then((answer) => { if (answer) toast('Keyframe added', 'note'); });
}

export function playOrPause(): void {
  void send({ do: motion.value?.playing ? 'pause' : 'play' });
}

/** The files that the program makes of the motion. */
const EXPORTS = ['motion.csv', 'motion.json', ...['joints', 'rates', 'accelerations', 'path'].flatMap((name) => [`${name}.svg`, `${name}.png`])];

function MotionPanel() {
  const value = motion.value!;
  const table = async (file: File): Promise<void> => {
    const answer = (await send({ do: 'motion_table', name: file.name, text: await file.text() })) as { rows: number } | undefined;
    if (answer) toast(`${file.name}: ${answer.rows} rows`, 'note');
  };
  const many = value.keyframes.length > 60;
  return (
    <div class="motion">
      <div class="row">
        <label class="text-button"><span>Open a table…</span><input type="file" class="visually-hidden" accept=".csv" onChange={(event) => { const file = event.currentTarget.files?.[0]; if (file) void table(file); event.currentTarget.value = ''; }} /></label>
        <label class="field">Law <select value={value.law} onChange={(event) => void send({ do: 'law', to: event.currentTarget.value })}>{value.laws.map((law) => <option key={law}>{law}</option>)}</select></label>
        <label class="field">Speed <input type="range" min={0.1} max={4} step={0.1} value={value.speed} aria-valuetext={`${value.speed} times`} onInput={(event) => void send({ do: 'speed', to: Number(event.currentTarget.value) })} /> <span class="time">{value.speed.toFixed(1)}×</span></label>
        <span class="grow" />
        <label class="field">Export <select value="" disabled={value.keyframes.length < 2} onChange={(event) => { location.assign(`/api/export/${event.currentTarget.value}`); event.currentTarget.value = ''; }}>
          <option value="">choose…</option>{EXPORTS.map((name) => <option key={name}>{name}</option>)}
        </select></label>
        <button type="button" class="text-button" disabled={value.keyframes.length === 0} onClick={() => void send({ do: 'keyframe', op: 'clear' })}>Clear</button>
      </div>
      {value.problem && <p class="banner">{value.problem}</p>}
      {value.name && <p class="quiet small">{value.name}: {value.keyframes.length} rows</p>}
      {value.keyframes.length === 0 && <p class="quiet">Bring the arm to a posture and press <kbd>K</kbd>; move it and press <kbd>K</kbd> again; <kbd>Space</kbd> plays.</p>}
      {!many && value.keyframes.length > 0 && <Timeline />}
      {!many && value.keyframes.length > 0 && (
        <ol class="keyframes">
          {value.keyframes.map((keyframe) => (
            <li key={keyframe.id} class={Math.abs(clock.value - keyframe.t) < 1e-6 ? 'here' : ''}>
              <button type="button" class="keyframe-name" onClick={() => void send({ do: 'keyframe', op: 'goto', keyframe: keyframe.id })}>{keyframe.label || keyframe.id}</button>
              <label class="field"><NumberField value={keyframe.t} kind="plain" label={`Time of keyframe ${keyframe.label}`} onCommit={(text) => void send({ do: 'keyframe', op: 'move', keyframe: keyframe.id, t: text.replace(/s$/, '') })} /> s</label>
              <button type="button" class="text-button" title="Takes the present posture" onClick={() => void send({ do: 'keyframe', op: 'set', keyframe: keyframe.id })}>Set</button>
              <IconButton icon="close" label={`Remove keyframe ${keyframe.label}`} onClick={() => void send({ do: 'keyframe', op: 'remove', keyframe: keyframe.id })} />
            </li>
          ))}
        </ol>
      )}
    </div>
  );
}
