// Joint values out of the clipboard: what Copy wrote, a row of a table, a list in brackets.

import { robot, send, toast, units } from '../state';
import { kindOf, typed } from '../units';

/** The values in a text. */
export function values(text: string): string[] {
  const plain = text.trim().replace(/^[^[{]*[[{]/, '').replace(/[\]}].*$/s, '').replace(/^\((.*)\)$/s, '$1');
  // Values may carry units, "250 mm", so a blank parts only where there is nothing else.
  const parts = /[,;\t\n]/.test(plain) ? plain.split(/[,;\t\n]+/) : plain.split(/\s+/);
  return parts.map((part) => part.trim()).filter((part) => part !== '');
}

export async function put(text: string): Promise<void> {
  const joints = robot.value?.joints ?? [];
  const found = values(text);
  if (found.length !== joints.length) {
    const start = text.trim().slice(0, 40);
    return toast(`${start === '' ? 'The clipboard is empty' : `"${start}" has ${found.length} value${found.length === 1 ? '' : 's'}`}: ${joints.length} were expected, one for each joint, as in ${joints.map(() => '0').join(', ')}`);
  }
  const q = found.map((part, k) => typed(part, kindOf(joints[k]!), units.value));
  if ((await send({ do: 'joints', q })) !== undefined) toast('Joint values pasted', 'note');
}

export function fromClipboard(): void {
  const read = navigator.clipboard?.readText();
  if (!read) return toast('The clipboard is closed to this page: press Ctrl+V over the view instead');
  void read.then(put, () => toast('The clipboard is closed to this page: press Ctrl+V over the view instead'));
}

/** Ctrl+V, where nothing is typed. */
export function listenToPaste(): void {
  addEventListener('paste', (event) => {
    const into = event.target instanceof HTMLElement && event.target.closest('input:not([type=range]), textarea, .cm-editor, dialog');
    const text = event.clipboardData?.getData('text/plain');
    if (into || text === undefined) return;
    event.preventDefault();
    void put(text);
  });
}
