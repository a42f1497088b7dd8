// The real arm: connect, arm, hold to move, stop.

import { signal } from '@preact/signals';
import { useEffect } from 'preact/hooks';
import { controller, motion, robot, send, store, units } from '../state';
import { shown } from '../units';

interface Choices { ports: { path: string; what: string }[]; protocols: { name: string; summary: string }[] }

const choices = signal<Choices>({ ports: [], protocols: [] });
const address = signal('simulated');
const protocol = signal('packets');

/** This window armed the arm, and says that it is there: ten times a second, and what it holds. */
const mine = signal(false);
const held = signal<'move' | 'run' | null>(null);

let wasLive = false;

function beat(): void {
  const { live } = controller.value;
  // It ends with what was armed; before that, the answer to the arming may still be on its way.
  if (wasLive && !live) mine.value = false;
  wasLive = live === true;
  if (!mine.value || !live) return;
  void send({ do: 'controller_beat', hold: held.value === 'move', run: held.value === 'run' });
}
setInterval(beat, 80);

export const stopArm = (): void => {
  held.value = null;
  void send({ do: 'controller_stop' });
};

const let_go = (): void => {
  if (held.value === null) return;
  held.value = null;
  beat();
};
for (const event of ['blur', 'pointerup', 'pointercancel']) addEventListener(event, let_go);
document.addEventListener('visibilitychange', let_go);

/** A button that counts as long as it is pressed: by pointer, or by Space or Enter. */
function Hold({ what, text, disabled, begin }: { what: 'move' | 'run'; text: string; disabled: boolean; begin?: () => Promise<unknown> }) {
  const press = async (): Promise<void> => {
    if (held.value) return;
    held.value = what;
    if (begin) await begin();
    beat();
  };
  return (
    <button type="button" class={`hold ${held.value === what ? 'held' : ''}`} disabled={disabled} aria-pressed={held.value === what}
      onPointerDown={() => void press()}
      onKeyDown={(event) => { if ([' ', 'Enter'].includes(event.key) && !event.repeat) { event.preventDefault(); void press(); } }}
      onKeyUp={(event) => { if ([' ', 'Enter'].includes(event.key)) { event.preventDefault(); let_go(); } }} onBlur={() => { if (held.value === what) let_go(); }}>{text}</button>
  );
}

export function ControllerPanel() {
  const value = controller.value;
  useEffect(() => {
    void send({ do: 'controller_ports' }).then((answer) => { if (answer) choices.value = answer as Choices; });
  }, []);
  return value.phase === 'off' || value.phase === 'connecting' ? <Connect /> : <Connected />;
}

function Connect() {
  const value = controller.value;
  const connect = (event: Event): void => {
    event.preventDefault();
    store('protocol', protocol.value);
    void send({ do: 'controller_connect', address: address.value.trim(), protocol: protocol.value });
  };
  return (
    <form class="controller" onSubmit={connect}>
      <p class="quiet">A connection shows the real arm beside the one in the picture, and moves nothing. <code>simulated</code> is a controller that is not there.</p>
      <div class="row">
        <label class="field">Protocol <select value={protocol.value} onChange={(event) => (protocol.value = event.currentTarget.value)}>
          {choices.value.protocols.map(({ name, summary }) => <option key={name} value={name}>{name}: {summary}</option>)}
        </select></label>
        <label class="field">At <input class="address" value={address.value} list="ports" spellcheck={false} onInput={(event) => (address.value = event.currentTarget.value)} /></label>
        <datalist id="ports"><option value="simulated" />{choices.value.ports.map(({ path, what }) => <option key={path} value={path}>{what}</option>)}</datalist>
        <button type="submit" class="text-button go" disabled={value.phase === 'connecting'}>{value.phase === 'connecting' ? 'Connecting…' : 'Connect'}</button>
        {value.phase === 'connecting' && <button type="button" class="text-button" onClick={() => void send({ do: 'controller_disconnect' })}>Give up</button>}
      </div>
      <Said />
    </form>
  );
}

function Connected() {
  const value = controller.value;
  const gone = value.phase === 'lost';
  const arm = (): void => {
    // What ended a moment ago is not this: the next beat must not take the new arming for the old one's end.
    wasLive = false;
    mine.value = true;
    void send({ do: 'controller_arm' });
  };
  const run = (): Promise<unknown> => send({ do: 'controller_play' });
  const ready = (motion.value?.keyframes.length ?? 0) > 1;
  return (
    <div class="controller">
      <div class="row">
        <strong class={`phase ${value.live ? 'live' : ''}`}>{value.phase}</strong>
        <span class="quiet">{value.protocol} at {value.address}: {value.controller}</span>
      </div>
      <div class="row">
        {!value.live && <button type="button" class="text-button go" disabled={gone || value.phase === 'arming'} onClick={arm}>Arm</button>}
        {value.live && <button type="button" class="text-button" disabled={!mine.value} onClick={() => void send({ do: 'controller_disarm' })}>Disarm</button>}
        <Hold what="move" text="Hold to move here" disabled={!value.live || !mine.value || value.phase === 'playing'} />
        <Hold what="run" text="Hold to run the motion" disabled={!value.live || !mine.value || !ready || value.phase === 'moving'} begin={run} />
        {value.live && !mine.value && <span class="quiet small">Another window has armed it.</span>}
        {value.progress && <span class="time">{value.progress[0].toFixed(1)} / {value.progress[1].toFixed(1)} s</span>}
        <span class="grow" />
        <button type="button" class="text-button" onClick={() => void send({ do: 'controller_disconnect' })}>Disconnect</button>
      </div>
      <Said />
      <Numbers />
    </div>
  );
}

function Said() {
  const { said, sentence } = controller.value;
  const last = sentence ?? said[said.length - 1];
  return last ? <p class="banner" role="status">{last}</p> : null;
}

/** Where the joints were sent and where they are. */
function Numbers() {
  const { measured, commanded, error, lag, latency, dropped, late } = controller.value;
  const joints = robot.value?.joints ?? [];
  if (!measured) return null;
  const kind = (index: number): 'angle' | 'length' => (joints[index]?.kind === 'prismatic' ? 'length' : 'angle');
  const cell = (values: number[] | null | undefined, index: number): string => (values ? shown(values[index]!, kind(index), units.value) : '–');
  const facts: [string, string][] = [
    ['farthest off', error ? `${joints[error.joint]?.label ?? ''} ${shown(Math.abs(error.error), kind(error.joint), units.value)}` : '–'],
    ['lag', lag == null ? '–' : `${Math.round(1000 * lag)} ms`], ['answers after', latency == null ? '–' : `${(1000 * latency).toFixed(1)} ms`],
    ['late cycles', `${late ?? 0}`], ['dropped', `${dropped ?? 0}`],
  ];
  return (
    <div class="mirror">
      <table class="dh"><caption>Joints in {units.value.angle === 'deg' ? 'degrees' : 'radians'}</caption>
        <thead><tr><th />{joints.map(({ label }) => <th key={label} scope="col">{label}</th>)}</tr></thead>
        <tbody>
          <tr><th scope="row">sent</th>{joints.map((_, k) => <td key={k}>{cell(commanded, k)}</td>)}</tr>
          <tr><th scope="row">measured</th>{joints.map((_, k) => <td key={k} class="real">{cell(measured, k)}</td>)}</tr>
        </tbody>
      </table>
      <dl class="facts">{facts.map(([name, text]) => <><dt key={name}>{name}</dt><dd>{text}</dd></>)}</dl>
    </div>
  );
}

/** While the arm is live: a red frame around everything, and one large button that stops it. */
export function LiveFrame() {
  if (!controller.value.live) return null;
  return (
    <>
      <div class="live-frame" aria-hidden="true" />
      <button type="button" class="stop-arm" onClick={stopArm}>Stop the arm</button>
    </>
  );
}
