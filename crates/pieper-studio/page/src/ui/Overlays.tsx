// What lies over the page: the cheat sheet, the palette, notices.

import { useLayoutEffect, useRef, useState } from 'preact/hooks';
import { hintSeen, letters, overlay, phase, phaseText, said, seen, store, toasts, tumbling } from '../state';
import { ACTIONS, tumble } from './keys';
import { Icon, IconButton } from './icons';
import { picture, snapshot } from './snapshot';
import { Segments } from './Tool';

function Dialog({ title, children }: { title: string; children: preact.ComponentChildren }) {
  const dialog = useRef<HTMLDialogElement>(null);
  useLayoutEffect(() => dialog.current?.showModal(), []);
  return (
    <dialog ref={dialog} aria-label={title} onClose={() => (overlay.value = null)} onClick={(event) => { if (event.target === dialog.current) dialog.current?.close(); }}>
      <div class="dialog-body">
        <div class="row spread"><h2>{title}</h2><IconButton icon="close" label="Close" onClick={() => dialog.current?.close()} /></div>
        {children}
      </div>
    </dialog>
  );
}

const GESTURES: [string, string][] = [
  ['Drag a link', 'turn its joint'], ['Ctrl + drag a link', 'the whole arm follows'], ['Drag empty space', 'turn the view'],
  ['Right or Shift + drag', 'shift the view'], ['Wheel, pinch', 'zoom to the pointer'], ['Double-click a link', 'turn about it'],
  ['Esc while dragging', 'back to where it began'], ['Touch: hold, then drag', 'take hold of a link'],
];

function Help() {
  return (
    <Dialog title="Keys and gestures">
      <div class="sheet">
        <dl>{GESTURES.map(([what, does]) => <><dt key={what}>{what}</dt><dd>{does}</dd></>)}</dl>
        <dl>{ACTIONS.filter((action) => action.keys).map((action) => <><dt key={action.name}><kbd>{action.keys}</kbd></dt><dd>{action.name}</dd></>)}</dl>
      </div>
      <label class="check"><input type="checkbox" checked={letters.value} onChange={(event) => { letters.value = event.currentTarget.checked; store('letters', letters.value ? 'on' : 'off'); }} /> Single letters act as keys</label>
      <label class="check"><input type="checkbox" checked={tumbling.value} onChange={(event) => tumble(event.currentTarget.checked)} /> Dragging empty space turns the view freely, over the poles as well</label>
    </Dialog>
  );
}

function Palette() {
  const [text, setText] = useState('');
  const [at, setAt] = useState(0);
  const found = ACTIONS.filter((action) => action.name.toLowerCase().includes(text.toLowerCase()));
  const run = (index: number): void => {
    overlay.value = null;
    found[index]?.run();
  };
  return (
    <Dialog title="Commands">
      <input class="search" type="text" role="combobox" aria-expanded="true" aria-controls="palette-list" aria-label="Search commands" placeholder="Search commands" value={text}
        autofocus onInput={(event) => { setText(event.currentTarget.value); setAt(0); }}
        onKeyDown={(event) => {
          if (event.key === 'ArrowDown' || event.key === 'ArrowUp') { event.preventDefault(); setAt((at + (event.key === 'ArrowDown' ? 1 : found.length - 1)) % Math.max(1, found.length)); }
          if (event.key === 'Enter') run(at);
        }} />
      <ul class="palette" id="palette-list" role="listbox" aria-label="Commands">
        {found.map((action, index) => <li key={action.name} role="option" aria-selected={index === at} onClick={() => run(index)}><span>{action.name}</span>{action.keys && <kbd>{action.keys}</kbd>}</li>)}
      </ul>
    </Dialog>
  );
}

function PictureDialog() {
  const { scale, transparent, overlays } = picture;
  return (
    <Dialog title="A picture of the view">
      <div class="row"><span class="quiet">Size</span>
        <Segments label="Size" value={String(scale.value)} options={[['1', '1×'], ['2', '2×'], ['4', '4×']]} onChange={(next) => (scale.value = Number(next))} /></div>
      <label class="check"><input type="checkbox" checked={transparent.value} onChange={(event) => (transparent.value = event.currentTarget.checked)} /> Transparent background</label>
      <label class="check"><input type="checkbox" checked={overlays.value} onChange={(event) => (overlays.value = event.currentTarget.checked)} /> Ground, frames, ways and ghosts, as they are shown</label>
      <div class="row"><button type="button" class="text-button go" onClick={() => { overlay.value = null; void snapshot(); }}>Save as PNG</button></div>
    </Dialog>
  );
}

export function Overlays() {
  return (
    <>
      {overlay.value === 'help' && <Help />}
      {overlay.value === 'palette' && <Palette />}
      {overlay.value === 'picture' && <PictureDialog />}
      {phase.value === 'lost' && <div class="notice" role="alert"><Icon name="warn" /> The connection to the program is lost. Trying again…</div>}
      {phase.value === 'refused' && <div class="notice" role="alert"><Icon name="warn" /> {phaseText.value}</div>}
      <div class="toasts">{toasts.value.map((toast) => <div key={toast.id} class={`toast ${toast.kind}`} role={toast.kind === 'error' ? 'alert' : 'status'}>{toast.text}</div>)}</div>
      {!hintSeen.value && (
        <div class="hint" role="note">
          <p><strong>Drag a link</strong> to turn its joint.</p>
          <p><strong>Ctrl + drag</strong> pulls the whole arm.</p>
          <p><strong>?</strong> shows every key and gesture.</p>
          <button type="button" class="link" onClick={seen}>Got it</button>
        </div>
      )}
      <div class="visually-hidden" aria-live="polite">{said.value}</div>
    </>
  );
}
