// The arm: its table, what is known of it, where its numbers come from.

import { robot } from '../state';
import { Icon } from './icons';

const HEADS: Record<string, string> = { theta: 'θ', alpha: 'α', d: 'd', a: 'a' };

export function RobotInfo() {
  const value = robot.value;
  if (!value) return null;
  return (
    <section aria-label="Robot">
      <h2>{value.name}</h2>
      {value.summary && <p class="quiet">{value.summary}</p>}
      {value.problems.map((problem) => <p class="banner" key={problem}><Icon name="warn" /> {problem}</p>)}
      {value.table && (
        <div class="scroll">
          <table class="dh">
            <caption>{value.table.convention === 'standard' ? 'Standard' : 'Modified'} Denavit-Hartenberg</caption>
            <thead><tr><th scope="col">#</th>{value.table.columns.map((name) => <th scope="col" key={name}>{HEADS[name] ?? name}</th>)}</tr></thead>
            <tbody>{value.table.rows.map((row, i) => <tr key={i}><th scope="row">{i + 1}</th>{row.map((text, j) => <td key={j}>{text}</td>)}</tr>)}</tbody>
          </table>
        </div>
      )}
      {value.parameters.length > 0 && (
        <dl class="facts">{value.parameters.map(([name, text]) => <><dt key={name}>{name}</dt><dd>{text ?? '?'}</dd></>)}</dl>
      )}
      <dl class="facts">{value.facts.map(([name, text]) => <><dt key={name}>{name}</dt><dd>{text}</dd></>)}</dl>
      {value.source && <p class="quiet small">{value.source}</p>}
    </section>
  );
}
