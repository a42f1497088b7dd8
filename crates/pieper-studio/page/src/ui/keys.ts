// The keyboard. Single letters act only where nothing is typed, and can be switched off (WCAG 2.1.4).

import { controller, drawer, letters, overlay, send, show, store, tumbling } from '../state';
import { stopArm } from './Controller';
import { addKeyframe, playOrPause } from './Drawer';
import { fromClipboard } from './paste';
import { stopScript } from './Script';
import { snapshot } from './snapshot';
import { stepSolution } from './Solutions';
import { nextUnits, toggleGhosts } from './TopBar';
import { viewer } from './View';

export interface Action { name: string; keys: string; run: () => void }

const toggle = (flag: { value: boolean }) => (): void => void (flag.value = !flag.value);
const mode = (next: 'translate' | 'rotate') => (): void => void (show.gizmo.value = show.gizmo.value === next ? 'off' : next);

/** Free tumbling on or off. */
export function tumble(on: boolean): void {
  tumbling.value = on;
  store('tumble', on ? 'on' : 'off');
}

/** Everything that has a key, for the keyboard, the palette and the cheat sheet. */
export const ACTIONS: Action[] = [
  { name: 'Fit the arm', keys: 'F', run: () => viewer?.fit('here') },
  { name: 'Recentre the view', keys: 'V', run: () => viewer?.fit('home') },
  { name: 'Front view', keys: '1', run: () => viewer?.fit('front') },
  { name: 'Right view', keys: '3', run: () => viewer?.fit('right') },
  { name: 'Top view', keys: '7', run: () => viewer?.fit('top') },
  { name: 'Parallel or central projection', keys: '5', run: () => viewer?.toggleProjection() },
  { name: 'Turn the view freely, or about the upright axis', keys: '', run: () => tumble(!tumbling.value) },
  { name: 'Home posture', keys: 'H', run: () => void send({ do: 'named', to: 'home' }) },
  { name: 'Zero posture', keys: '0', run: () => void send({ do: 'named', to: 'zero' }) },
  { name: 'Random posture', keys: '', run: () => void send({ do: 'named', to: 'random' }) },
  { name: 'Play or pause', keys: 'Space', run: playOrPause },
  { name: 'Add a keyframe', keys: 'K', run: addKeyframe },
  { name: 'Ghosts of all solutions', keys: 'G', run: toggleGhosts },
  { name: 'Next solution', keys: ']', run: () => stepSolution(1) },
  { name: 'Previous solution', keys: '[', run: () => stepSolution(-1) },
  { name: 'Link frames', keys: 'T', run: toggle(show.frames) },
  { name: 'Collision shapes', keys: 'C', run: toggle(show.collision) },
  { name: 'Outline of the reach', keys: 'O', run: toggle(show.outline) },
  { name: 'Move the tool by a gizmo', keys: 'W', run: mode('translate') },
  { name: 'Turn the tool by a gizmo', keys: 'E', run: mode('rotate') },
  { name: 'Gizmo in the tool\u2019s or the base\u2019s axes', keys: 'X', run: toggle(show.local) },
  { name: 'Snapshot', keys: 'P', run: () => void snapshot() },
  { name: 'Snapshot: size, background, what is in it', keys: '', run: () => (overlay.value = 'picture') },
  { name: 'Share this view as one file', keys: '', run: () => location.assign('/api/share.html') },
  { name: 'Units', keys: 'U', run: nextUnits },
  { name: 'Plots', keys: '', run: () => (drawer.value = drawer.value === 'plots' ? null : 'plots') },
  { name: 'Formulas', keys: '', run: () => (drawer.value = drawer.value === 'formulas' ? null : 'formulas') },
  { name: 'Script', keys: '', run: () => (drawer.value = drawer.value === 'script' ? null : 'script') },
  { name: 'Stop the script', keys: '', run: stopScript },
  { name: 'Controller of a real arm', keys: '', run: () => (drawer.value = drawer.value === 'controller' ? null : 'controller') },
  { name: 'Stop the real arm', keys: 'Escape', run: stopArm },
  { name: 'Paste joint values', keys: 'Ctrl+V', run: fromClipboard },
  { name: 'Undo', keys: 'Ctrl+Z', run: () => void send({ do: 'undo' }) },
  { name: 'Redo', keys: 'Ctrl+Shift+Z', run: () => void send({ do: 'redo' }) },
  { name: 'Save the project', keys: 'Ctrl+S', run: () => location.assign('/api/project.json?download') },
  { name: 'All commands', keys: 'Ctrl+K', run: () => (overlay.value = 'palette') },
  { name: 'Keys and gestures', keys: '?', run: () => (overlay.value = 'help') },
];

export function listen(): void {
  addEventListener('keydown', (event) => {
    // Before anything else, wherever the focus is.
    if (event.key === 'Escape' && controller.value.live) return stopArm();
    const typing = event.target instanceof HTMLElement && event.target.closest('input:not([type=range]):not([type=checkbox]), textarea, select, .cm-editor, dialog');
    if (event.ctrlKey || event.metaKey) {
      const name = `Ctrl+${event.shiftKey ? 'Shift+' : ''}${event.key.toUpperCase()}`;
      const action = ACTIONS.find((candidate) => candidate.keys === name);
      // The browser's own paste brings the text without a question.
      if (!action || name === 'Ctrl+V' || (typing && name !== 'Ctrl+K')) return;
      event.preventDefault();
      return action.run();
    }
    if (typing || event.altKey || !letters.value || overlay.value) return;
    const name = event.key === ' ' ? 'Space' : event.key.length === 1 ? event.key.toUpperCase() : '';
    // Space on a button presses it.
    if (name === 'Space' && event.target instanceof HTMLElement && event.target.closest('button, input')) return;
    const action = ACTIONS.find((candidate) => candidate.keys === name);
    if (!action || name === '') return;
    event.preventDefault();
    action.run();
  });
}
