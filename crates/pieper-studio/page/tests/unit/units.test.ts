import { describe, expect, it } from 'vitest';
import { shown, small, spoken, typed } from '../../src/units';

const degrees = { angle: 'deg', length: 'mm' } as const;
const plain = { angle: 'rad', length: 'm' } as const;

describe('units', () => {
  it('shows values in the units chosen', () => {
    expect(shown(Math.PI / 2, 'angle', degrees)).toBe('90.00');
    expect(shown(0.25, 'length', degrees)).toBe('250.00');
    expect(shown(1, 'angle', plain)).toBe('1.0000');
    expect(shown(-1e-9, 'angle', degrees)).toBe('0.00');
    expect(shown(Number.NaN, 'angle', degrees)).toBe('–');
  });
  it('gives a bare number the unit shown, and leaves others alone', () => {
    expect(typed('45', 'angle', degrees)).toBe('45 deg');
    expect(typed(' -1,5 ', 'length', degrees)).toBe('-1.5 mm');
    expect(typed('2', 'angle', plain)).toBe('2 rad');
    for (const text of ['pi/2', '90deg', '1.57rad', '0.25 m']) expect(typed(text, 'angle', degrees)).toBe(text);
  });
  it('speaks', () => {
    expect(spoken(Math.PI / 4, 'angle')).toBe('45.0 degrees');
    expect(small(0)).toBe('0');
    expect(small(2.22e-16)).toBe('2.2e-16');
  });
});

describe('small numbers', () => {
  it('keep one digit behind the point', () => {
    expect([0, 6.14e-16, 9.98e-16, -2e-3, 12].map(small)).toEqual(['0', '6.1e-16', '1.0e-15', '-2.0e-3', '1.2e1']);
  });
});
