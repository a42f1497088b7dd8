// Scripts: an editor, what they print, and how they end.

import { useEffect, useRef, useState } from 'preact/hooks';
import { effect } from '@preact/signals';
import { consoleLines, dark, script, send } from '../state';
import type { Editor } from './editor';
import { IconButton } from './icons';

interface Example { name: string; text: string }
interface HelpRow { name: string; does: string; example: string }

let editor: Editor | null = null;
let escapes = 0;

export function runScript(): void {
  if (!editor || script.value?.running) return;
  consoleLines.value = [];
  editor.markLine(null);
  void send({ do: 'script_run', text: editor.text() });
}

export function stopScript(): void {
  void send({ do: 'script_stop' });
}

export function ScriptPanel() {
  const host = useRef<HTMLDivElement>(null);
  const output = useRef<HTMLDivElement>(null);
  const [examples, setExamples] = useState<Example[]>([]);
  const [help, setHelp] = useState<HelpRow[] | null>(null);
  const status = script.value;

  useEffect(() => {
    let gone = false;
    let saving: ReturnType<typeof setTimeout> | undefined;
    void Promise.all([import('./editor'), send({ do: 'script_examples' }) as Promise<Example[] | undefined>]).then(([{ makeEditor }, found]) => {
      if (gone || !host.current) return;
      setExamples(found ?? []);
      const text = script.value?.text || found?.[0]?.text || '';
      editor = makeEditor(host.current, text, runScript, (next) => {
        clearTimeout(saving);
        saving = setTimeout(() => void send({ do: 'script_save', text: next }), 800);
      });
      editor.setDark(dark.value);
    });
    const stops = [
      // Read first: the editor may not be there yet, and an effect hears only of what it has read.
      effect(() => { const on = dark.value; editor?.setDark(on); }),
      effect(() => { const line = script.value?.error?.line ?? null; editor?.markLine(line); }),
      effect(() => { void consoleLines.value; requestAnimationFrame(() => output.current?.scrollTo(0, output.current.scrollHeight)); }),
    ];
    return () => { gone = true; stops.forEach((stop) => stop()); editor?.destroy(); editor = null; };
  }, []);

  const key = (event: KeyboardEvent): void => {
    // Esc twice stops.
    escapes = event.key === 'Escape' ? escapes + 1 : 0;
    if (escapes >= 2 && status?.running) { escapes = 0; stopScript(); }
  };
  return (
    <div class="script" onKeyDown={key}>
      <div class="script-edit">
        <div class="row">
          <button type="button" class="text-button go" disabled={status?.running || !status?.python?.found} onClick={runScript} title="Ctrl+Enter">Run</button>
          <button type="button" class="text-button" disabled={!status?.running} onClick={stopScript} title="Esc twice">Stop</button>
          <label class="field">Examples <select value="" onChange={(event) => {
            const chosen = examples.find((example) => example.name === event.currentTarget.value);
            if (chosen) editor?.setText(chosen.text);
            event.currentTarget.value = '';
          }}><option value="">choose…</option>{examples.map((example) => <option key={example.name}>{example.name}</option>)}</select></label>
          <button type="button" class="text-button" aria-expanded={help !== null} onClick={() => void (help ? setHelp(null) : send({ do: 'script_help' }).then((rows) => setHelp(rows as HelpRow[])))}>mathmodel</button>
          <span class="grow" />
          <span class={status?.python?.found ? 'quiet small' : 'banner'}>{status?.python?.sentence ?? 'Looking for Python…'}</span>
        </div>
        <div class="editor" ref={host} />
      </div>
      <div class="script-side">
        {help ? (
          <div class="scroll-box" role="region" tabIndex={0} aria-label="What mathmodel offers">
            <div class="row spread"><strong>import mathmodel</strong><IconButton icon="close" label="Close" onClick={() => setHelp(null)} /></div>
            <dl class="help">{help.map((row) => <><dt key={row.name}><code>{row.name}</code></dt><dd>{row.does}<br /><code class="quiet">{row.example}</code></dd></>)}</dl>
          </div>
        ) : (
          <div class="console" ref={output} role="log" tabIndex={0} aria-label="Output of the script">
            {consoleLines.value.map((line, k) => <span key={k} class={line.stream}>{line.text}</span>)}
            {status?.ended && !status.running && <span class={status.error ? 'err' : 'note'}>{status.ended}{'\n'}</span>}
          </div>
        )}
      </div>
    </div>
  );
}

