import { describe, expect, it } from 'vitest';
import { Stream } from '../../src/wire/connection';

describe('a stream of commands', () => {
  it('has one in flight, drops what is old, and always sends the last', async () => {
    const sent: number[] = [];
    let inFlight = 0;
    let most = 0;
    const stream = new Stream(async (command) => {
      most = Math.max(most, ++inFlight);
      sent.push(command.k as number);
      await new Promise((done) => setTimeout(done, 2));
      inFlight--;
    });
    for (let k = 0; k < 200; k++) {
      stream.push({ do: 'x', k });
      if (k % 20 === 0) await new Promise((done) => setTimeout(done, 1));
    }
    await stream.settled();
    expect(most).toBe(1);
    expect(sent.at(-1)).toBe(199);
    expect(sent.length).toBeLessThan(60);
    expect([...sent].sort((a, b) => a - b)).toEqual(sent);
  });
  it('goes on after an error', async () => {
    const errors: string[] = [];
    const stream = new Stream(async (command) => { if (command.k === 0) throw new Error('no'); return command.k; }, () => {}, (error) => errors.push(error.message));
    stream.push({ do: 'x', k: 0 });
    stream.push({ do: 'x', k: 1 });
    await stream.settled();
    expect(errors).toEqual(['no']);
  });
});
