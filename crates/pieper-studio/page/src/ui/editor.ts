// The script's editor: a chunk of its own, fetched when a person wants to write.

import { defaultKeymap, history, historyKeymap, indentWithTab } from '@codemirror/commands';
import { python } from '@codemirror/lang-python';
import { HighlightStyle, bracketMatching, indentOnInput, indentUnit, syntaxHighlighting } from '@codemirror/language';
import { Compartment, EditorState, Prec, StateEffect, StateField } from '@codemirror/state';
import { Decoration, EditorView, drawSelection, highlightActiveLine, highlightActiveLineGutter, keymap, lineNumbers, type DecorationSet } from '@codemirror/view';
import { tags } from '@lezer/highlight';

const mark = StateEffect.define<number | null>();

/** The line that an error names. */
const marked = StateField.define<DecorationSet>({
  create: () => Decoration.none,
  update(lines, transaction) {
    let next = transaction.docChanged ? Decoration.none : lines;
    for (const effect of transaction.effects) {
      if (!effect.is(mark)) continue;
      const line = effect.value;
      const inside = line !== null && line >= 1 && line <= transaction.state.doc.lines;
      next = inside ? Decoration.set([Decoration.line({ class: 'cm-failed' }).range(transaction.state.doc.line(line).from)]) : Decoration.none;
    }
    return next;
  },
  provide: (field) => EditorView.decorations.from(field),
});

const colors = HighlightStyle.define([
  { tag: tags.keyword, class: 'tok-keyword' }, { tag: [tags.string, tags.special(tags.string)], class: 'tok-string' },
  { tag: tags.comment, class: 'tok-comment' }, { tag: [tags.number, tags.bool, tags.null], class: 'tok-number' },
  { tag: [tags.function(tags.variableName), tags.definition(tags.variableName)], class: 'tok-name' },
]);

export interface Editor { text(): string; setText(text: string): void; markLine(line: number | null): void; setDark(dark: boolean): void; destroy(): void }

export function makeEditor(host: HTMLElement, text: string, run: () => void, changed: (text: string) => void): Editor {
  const nonce = document.querySelector<HTMLMetaElement>('meta[name=style-nonce]')?.content ?? '';
  const theme = new Compartment();
  const look = (dark: boolean) => EditorView.theme({}, { dark });
  const view = new EditorView({
    parent: host,
    state: EditorState.create({
      doc: text,
      extensions: [
        EditorView.cspNonce.of(nonce),
        Prec.highest(keymap.of([{ key: 'Mod-Enter', run: () => { run(); return true; } }])),
        // Without completion: its tooltips carry inline styles, which the page's policy forbids.
        lineNumbers(), history(), drawSelection(), indentOnInput(), indentUnit.of('    '), bracketMatching(), highlightActiveLine(), highlightActiveLineGutter(),
        python(), syntaxHighlighting(colors), marked, theme.of(look(false)),
        keymap.of([...defaultKeymap, ...historyKeymap, indentWithTab]),
        EditorView.contentAttributes.of({ tabindex: '0', 'aria-label': 'Script in Python; Escape, then Tab leaves the editor' }),
        EditorView.updateListener.of((update) => { if (update.docChanged) changed(update.state.doc.toString()); }),
      ],
    }),
  });
  return {
    text: () => view.state.doc.toString(),
    setText: (next) => view.dispatch({ changes: { from: 0, to: view.state.doc.length, insert: next } }),
    markLine: (line) => view.dispatch({ effects: mark.of(line) }),
    setDark: (dark) => view.dispatch({ effects: theme.reconfigure(look(dark)) }),
    destroy: () => view.destroy(),
  };
}
