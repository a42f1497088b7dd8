// Every inverse solution: a list to choose from, families as sliders, and why there is none.

import { useRef } from 'preact/hooks';
import { connection, gesture, ik, pointed, pose, send, show, toast } from '../state';
import { Stream } from '../wire/connection';
import type { Family, Solution } from '../wire/types';
import { small } from '../units';
import { Icon } from './icons';

const along = new Stream((command) => connection.send(command), () => {}, (error) => toast(error.message));

function flags(solution: Solution): string[] {
  const words = [solution.shoulder, solution.elbow && `elbow ${solution.elbow}`, solution.wrist];
  const named = words.filter((word): word is string => typeof word === 'string');
  return named.length > 0 ? named : [solution.branch];
}

function FamilySlider({ family, index }: { family: Family; index: number }) {
  const name = useRef('');
  return (
    <div class="family">
      <p><strong>Infinitely many.</strong> {family.name}.</p>
      <input type="range" min={0} max={1} step={1 / 96} value={family.at} aria-label={`Family ${index + 1}: ${family.name}`}
        onPointerDown={() => (name.current = gesture('family'))} onKeyDown={(event) => { if (!event.repeat) name.current = gesture('family'); event.stopPropagation(); }}
        onInput={(event) => along.push({ do: 'family', index, at: Number(event.currentTarget.value), gesture: name.current })} />
    </div>
  );
}

export function Solutions() {
  const value = ik.value;
  const unlocked = pose.value?.unlocked ?? false;
  if (!value) return null;
  if (value.status === 'playing') return <p class="quiet">The list is made when the motion stands.</p>;
  const count = value.solutions.length;
  const headline = {
    solved: `${count} solution${count === 1 ? '' : 's'} for this pose`,
    singular: `A singular pose: ${value.families.length === 1 ? 'a family' : `${value.families.length} families`}${count > 0 ? ` and ${count} more` : ''}`,
    redundant: 'More joints than the pose needs', unreachable: 'No solution', none: 'No solver takes this arm', playing: '',
  }[value.status];
  return (
    <section aria-label="IK solutions">
      <div class="row spread">
        <strong>{headline}</strong>
        <label class="check"><input type="checkbox" checked={show.ghosts.value} onChange={(event) => { show.ghosts.value = event.currentTarget.checked; void send({ do: 'ghosts', on: show.ghosts.value }); }} /> Ghosts</label>
      </div>
      {value.missed && <p class="banner"><Icon name="warn" /> The pose asked for cannot be reached: {value.reason ?? 'every solution lies outside the limits'}. The arm stands at the nearest.</p>}
      {value.families.map((family, index) => <FamilySlider key={index} family={family} index={index} />)}
      <ol class="solutions">
        {value.solutions.map((solution, index) => {
          const closed = !solution.within_limits && !unlocked;
          return (
            <li key={index}>
              <button type="button" class={`solution ${solution.current ? 'current' : ''}`} aria-current={solution.current} disabled={closed}
                onMouseEnter={() => (pointed.value = index)} onMouseLeave={() => (pointed.value = null)}
                onFocus={() => (pointed.value = index)} onBlur={() => (pointed.value = null)}
                onClick={() => void send({ do: 'solution', index })}>
                <span class="number-of">{index + 1}</span>
                <span class="flags">{flags(solution).map((flag) => <span class="flag" key={flag}>{flag}</span>)}{solution.multiplicity > 1 && <span class="flag">×{solution.multiplicity}</span>}</span>
                <span class="details">
                  {solution.current ? <span class="here"><Icon name="check" /> here</span> : <span>{((solution.distance * 180) / Math.PI).toFixed(0)}° away</span>}
                  {closed && <span class="outside"><Icon name="lock" /> outside limits</span>}
                  <span class="residual" title="What forward kinematics misses the pose by">{small(solution.residual)}</span>
                </span>
              </button>
            </li>
          );
        })}
      </ol>
      {value.microseconds !== undefined && <p class="quiet small">Solved by <em>{value.solver}</em> in {value.microseconds.toFixed(1)} µs. <kbd>[</kbd> <kbd>]</kbd> step through.</p>}
    </section>
  );
}

/** Goes to the next or previous solution that may be taken. */
export function stepSolution(by: number): void {
  const solutions = ik.value?.solutions ?? [];
  const unlocked = pose.value?.unlocked ?? false;
  const here = Math.max(0, solutions.findIndex((solution) => solution.current));
  for (let k = 1; k <= solutions.length; k++) {
    const index = (here + by * k + solutions.length * k) % solutions.length;
    if (solutions[index]!.within_limits || unlocked) return void send({ do: 'solution', index });
  }
}
