// The step sheet of the arm, with the present numbers behind its equations.

import { useEffect, useRef, useState } from 'preact/hooks';
import { effect, signal } from '@preact/signals';
import { connection, pose, robot } from '../state';
import { Stream } from '../wire/connection';
import { Segments } from './Tool';

type Scope = 'forward' | 'inverse';
const scope = signal<Scope>('forward');

export function Formulas() {
  const host = useRef<HTMLDivElement>(null);
  const [problem, setProblem] = useState('');
  useEffect(() => {
    const put = (values: unknown): void => {
      const places = host.current?.querySelectorAll<HTMLOutputElement>('output.value');
      (values as (number | null)[]).forEach((value, k) => {
        const place = places?.[k];
        if (place) place.textContent = value === null ? '' : `= ${Number(value.toFixed(5))}`;
      });
    };
    const values = new Stream((command) => connection.send(command), put, () => {});
    let shown = '';
    const stop = effect(() => {
      const [which, revision] = [scope.value, robot.value?.revision];
      void pose.value;
      const key = `${which} ${revision}`;
      if (key === shown) return values.push({ do: 'formula_values', scope: which });
      shown = key;
      connection.send({ do: 'formulas', scope: which }).then(
        (sheet) => {
          // Made by the program from exact formulas, everything in it escaped; the page's policy allows no scripts in it.
          if (host.current) host.current.innerHTML = (sheet as { html: string }).html;
          setProblem('');
          values.push({ do: 'formula_values', scope: which });
        },
        (error: Error) => {
          if (host.current) host.current.textContent = '';
          setProblem(error.message);
        },
      );
    });
    return stop;
  }, []);
  return (
    <div class="formulas">
      <Segments label="Which way" value={scope.value} onChange={(next) => (scope.value = next)} options={[['forward', 'Forward'], ['inverse', 'Inverse']]} />
      {problem && <p class="quiet">{problem}</p>}
      <div class="sheet-body" ref={host} tabIndex={0} role="region" aria-label="Formulas of the arm" />
    </div>
  );
}
