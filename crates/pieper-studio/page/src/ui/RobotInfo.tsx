// The arm: its table, what is known of it, where its numbers come from.

import { robot } from '../state';
import type { TreeLink } from '../wire/types';
import { Icon } from './icons';

const HEADS: Record<string, string> = { theta: 'θ', alpha: 'α', d: 'd', a: 'a' };

/** A link and, below it, what hangs on it. */
function Branch({ links, at }: { links: TreeLink[]; at: number }) {
  const link = links[at]!;
  const below = links.flatMap((other, index) => (other.parent === at ? [index] : []));
  return (
    <li>
      <span>{link.name}</span>{link.joint && <span class="quiet small"> by {link.joint}, {link.how}</span>}
      {below.length > 0 && <ul>{below.map((index) => <Branch key={index} links={links} at={index} />)}</ul>}
    </li>
  );
}

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
      {value.tree && <ul class="tree" aria-label="Links">{value.tree.flatMap((link, index) => (link.parent === null ? [<Branch key={index} links={value.tree!} at={index} />] : []))}</ul>}
      {value.parameters.length > 0 && (
        <dl class="facts">{value.parameters.map(([name, text]) => <><dt key={name}>{name}</dt><dd>{text ?? '?'}</dd></>)}</dl>
      )}
      <dl class="facts">{value.facts.map(([name, text]) => <><dt key={name}>{name}</dt><dd>{text}</dd></>)}</dl>
      {value.source && <p class="quiet small">{value.source}</p>}
    </section>
  );
}
