// The tool's pose, editable, and the two ways in which it is computed.

import { signal } from '@preact/signals';
import { ik, pose, send, show, toast, units } from '../state';
import { small, unit } from '../units';
import { Icon } from './icons';
import { NumberField } from './NumberField';

const form = signal<'rpy' | 'quaternion' | 'axis'>('rpy');
const frame = signal<'base' | 'tool'>('base');

async function move(command: Record<string, unknown>): Promise<void> {
  const answer = (await send({ do: 'tool', ...command })) as { reached: boolean; sentence: string } | undefined;
  if (answer && !answer.reached) toast(answer.sentence);
}

export function Segments<T extends string>({ label, value, options, onChange }: { label: string; value: T; options: [T, string][]; onChange: (value: T) => void }) {
  return (
    <div class="segments" role="radiogroup" aria-label={label}>
      {options.map(([key, text]) => (
        <button type="button" key={key} role="radio" aria-checked={key === value} onClick={() => onChange(key)}>{text}</button>
      ))}
    </div>
  );
}

export function Tool() {
  const value = pose.value;
  if (!value) return null;
  const { tool, methods } = value;
  const inTool = frame.value === 'tool';
  // In the tool's own axes one types a displacement: it starts at nothing.
  const position = inTool ? [0, 0, 0] : tool.position;
  const rpy = inTool ? [0, 0, 0] : tool.rpy;
  const put = (values: readonly number[], place: number, text: string) => values.map((x, k) => (k === place ? text : x));
  const shownMatrix = value.method === 'matrix' ? methods?.matrix : methods?.quaternion;
  return (
    <section aria-label="Tool pose">
      <div class="row spread">
        <span class="quiet">Frame</span>
        <Segments label="Frame" value={frame.value} options={[['base', 'Base'], ['tool', 'Tool']]} onChange={(next) => { frame.value = next; show.local.value = next === 'tool'; }} />
      </div>
      <div class="triple">
        {['X', 'Y', 'Z'].map((name, k) => (
          <label key={name}><span><span class={`axis axis-${name.toLowerCase()}`}>{name}</span> <span class="quiet">{unit('length', units.value)}</span></span>
            <NumberField value={position[k]!} kind="length" label={`Tool ${name}`} onCommit={(text) => void move({ position: put(position, k, text), frame: frame.value })} /></label>
        ))}
      </div>
      <div class="row spread">
        <span class="quiet">Orientation</span>
        <Segments label="Orientation as" value={form.value} options={[['rpy', 'RPY'], ['quaternion', 'Quaternion'], ['axis', 'Axis']]} onChange={(next) => (form.value = next)} />
      </div>
      {form.value === 'rpy' && (
        <div class="triple">
          {['Roll', 'Pitch', 'Yaw'].map((name, k) => (
            <label key={name}><span><span class="axis">{name}</span> <span class="quiet">{unit('angle', units.value)}</span></span>
              <NumberField value={rpy[k]!} kind="angle" label={name} onCommit={(text) => void move({ rpy: put(rpy, k, text), frame: frame.value })} /></label>
          ))}
        </div>
      )}
      {form.value === 'quaternion' && (
        <div class="triple four">
          {['w', 'x', 'y', 'z'].map((name, k) => (
            <label key={name}><span class="axis">{name}</span>
              <NumberField value={tool.quaternion[k]!} kind="plain" label={`Quaternion ${name}`}
                onCommit={(text) => void move({ quaternion: tool.quaternion.map((x, i) => (i === k ? Number(text) : x)) })} /></label>
          ))}
        </div>
      )}
      {form.value === 'axis' && (
        <div class="triple four">
          {['x', 'y', 'z'].map((name, k) => (
            <label key={name}><span class="axis">{name}</span>
              <NumberField value={tool.axis[k]!} kind="plain" label={`Axis ${name}`} onCommit={(text) => void move({ axis_angle: [...put(tool.axis, k, text), tool.angle] })} /></label>
          ))}
          <label><span class="axis">angle</span>
            <NumberField value={tool.angle} kind="angle" label="Angle" onCommit={(text) => void move({ axis_angle: [...tool.axis, text] })} /></label>
        </div>
      )}
      {ik.value?.missed && (
        <p class="banner"><Icon name="warn" /> Not reached: {ik.value.reason ?? 'every solution lies outside the limits'}. The arm stands at the nearest pose.</p>
      )}
      <div class="row spread">
        <span class="quiet">Computed by</span>
        <Segments label="Computed by" value={value.method} options={[['matrix', 'Matrices'], ['quaternion', 'Quaternions']]} onChange={(to) => void send({ do: 'method', to })} />
      </div>
      {shownMatrix && (
        <table class="matrix" aria-label="Tool pose as a matrix">
          <tbody>{shownMatrix.map((row, i) => <tr key={i}>{row.map((x, j) => <td key={j}>{x.toFixed(5)}</td>)}</tr>)}</tbody>
        </table>
      )}
      {methods && <p class="quiet small">The two ways differ by {small(methods.difference)} at most.</p>}
      {value.measures && (
        <dl class="facts">
          <dt>Manipulability</dt><dd>{value.measures.manipulability.toPrecision(3)}</dd>
          <dt>Smallest singular value</dt><dd>{value.measures.smallest_singular_value.toPrecision(3)}{value.measures.smallest_singular_value < 1e-3 && ' – singular'}</dd>
          <dt>Condition</dt><dd>{value.measures.condition === null ? '∞' : value.measures.condition.toPrecision(3)}</dd>
        </dl>
      )}
    </section>
  );
}
