import { describe, expect, it, vi } from 'vitest';

vi.mock('../../src/state', () => ({ clock: {}, connection: {}, gesture: () => '', motion: {}, robot: {}, send: () => {}, toast: () => {}, units: {} }));
const { values } = await import('../../src/ui/paste');
const { spacing } = await import('../../src/ui/Timeline');

describe('joint values in a text', () => {
  it('come out of lists, rows of tables and code', () => {
    for (const text of ['1, 2, 3', '1 2 3', '[1, 2, 3]', 'q = [1,2,3]  # home', '(1, 2, 3)', '1\t2\t3\n', '{1; 2; 3}', ' 1,2,3, ']) {
      expect(values(text)).toEqual(['1', '2', '3']);
    }
  });
  it('keep their units and expressions', () => {
    expect(values('90 deg, 250 mm, pi/2')).toEqual(['90 deg', '250 mm', 'pi/2']);
    expect(values('2*(pi/4), 0')).toEqual(['2*(pi/4)', '0']);
  });
  it('are none in nothing', () => expect(values('  ')).toEqual([]));
});

describe('marks on a line of time', () => {
  it('are 1, 2 or 5 times a power of ten, five to ten of them', () => {
    for (const span of [0.02, 0.7, 1.12, 3.36, 8, 10, 45, 1e4]) {
      const step = spacing(span);
      expect([1, 2, 5]).toContain(Math.round(step / 10 ** Math.floor(Math.log10(step) + 1e-9)));
      expect(span / step).toBeGreaterThan(3);
      expect(span / step).toBeLessThanOrEqual(8.001);
    }
  });
});
