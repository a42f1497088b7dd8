// Plots of the motion, their cursor shared with the clock.

import { useEffect, useRef } from 'preact/hooks';
import { effect, signal } from '@preact/signals';
import uPlot from 'uplot';
import 'uplot/dist/uPlot.min.css';
import { clock, dark, robot, samples, send, units } from '../state';
import { kindOf } from '../units';
import { Segments } from './Tool';

type What = 'q' | 'qd' | 'qdd' | 'tool_speed';
const what = signal<What>('q');

/** Told apart with every kind of colour vision (Okabe and Ito), light and dark. */
export const COLORS = { light: ['#0072b2', '#b35c00', '#007a5a', '#a8327d', '#5b4bd6', '#1f1f1f', '#8a6d00'], dark: ['#56b4e9', '#f5a742', '#3fd6a5', '#f08cc8', '#b3a5ff', '#e8e8e8', '#f0e442'] };

/** Height of the legend under a plot. */
const LEGEND = 30;

export function Plots() {
  const host = useRef<HTMLDivElement>(null);
  useEffect(() => {
    let plot: uPlot | null = null;
    const stopBuild = effect(() => {
      plot?.destroy();
      plot = host.current ? build(host.current, what.value) : null;
    });
    const stopCursor = effect(() => {
      void clock.value;
      plot?.redraw(false, false);
    });
    const observer = new ResizeObserver(() => host.current && plot?.setSize({ width: host.current.clientWidth, height: host.current.clientHeight - LEGEND }));
    if (host.current) observer.observe(host.current);
    return () => { stopBuild(); stopCursor(); observer.disconnect(); plot?.destroy(); };
  }, []);
  const empty = (samples.value?.t.length ?? 0) === 0;
  return (
    <div class="plots">
      <Segments label="What is plotted" value={what.value} onChange={(next) => (what.value = next)}
        options={[['q', 'Joints'], ['qd', 'Rates'], ['qdd', 'Accelerations'], ['tool_speed', 'Tool speed']]} />
      {empty && <p class="quiet">A motion shows its joints, rates and the tool's speed here.</p>}
      <div class="plot" ref={host} hidden={empty} role="img" aria-label={`Plot of ${what.value} over time`} />
    </div>
  );
}

function build(host: HTMLElement, kind: What): uPlot | null {
  const data = samples.value;
  const joints = robot.value?.joints ?? [];
  if (!data || data.t.length === 0) return null;
  const ink = dark.value ? '#c9cfdb' : '#3a4150';
  const faint = dark.value ? '#2c313c' : '#e4e7ed';
  const colors = COLORS[dark.value ? 'dark' : 'light'];
  const degrees = units.value.angle === 'deg';
  const scale = (joint: number): number => (kindOf(joints[joint]!) === 'angle' ? (degrees ? 180 / Math.PI : 1) : units.value.length === 'mm' ? 1000 : 1);
  const suffix = { q: '', qd: '/s', qdd: '/s²', tool_speed: '' }[kind];
  const series: uPlot.Series[] = [{ label: 't', value: (_, t) => (t === null ? '–' : `${t.toFixed(2)} s`) }];
  const columns: number[][] = [data.t];
  if (kind === 'tool_speed') {
    const by = units.value.length === 'mm' ? 1000 : 1;
    columns.push(data.tool_speed.map((value) => value * by));
    series.push({ label: `tool, ${units.value.length}/s`, stroke: colors[4]!, width: 1.75, pxAlign: 0 });
  } else {
    data[kind].forEach((values, j) => {
      if (!joints[j]) return;
      const unit = kindOf(joints[j]) === 'angle' ? (degrees ? '°' : 'rad') : units.value.length;
      columns.push(values.map((value) => value * scale(j)));
      series.push({ label: `${joints[j].label}, ${unit}${suffix}`, stroke: colors[j % colors.length]!, width: 1.75, pxAlign: 0, ...(j > 3 ? { dash: [6, 3] } : {}) });
    });
  }
  const axis = { stroke: ink, grid: { stroke: faint, width: 1 }, ticks: { stroke: faint }, font: '12px system-ui, sans-serif' };
  return new uPlot(
    {
      width: host.clientWidth || 600, height: (host.clientHeight || 180) - LEGEND, series,
      scales: { x: { time: false } }, legend: { live: true },
      axes: [axis, { ...axis, size: 56 }], cursor: { drag: { x: false, y: false } },
      hooks: {
        ready: [(plot) => plot.over.addEventListener('click', () => { const left = plot.cursor.left; if (left !== undefined) void send({ do: 'seek', t: plot.posToVal(left, 'x') }); })],
        draw: [(plot) => {
          const x = Math.round(plot.valToPos(clock.peek(), 'x', true));
          plot.ctx.save();
          plot.ctx.strokeStyle = '#7c3aed';
          plot.ctx.lineWidth = 2;
          plot.ctx.beginPath();
          plot.ctx.moveTo(x, plot.bbox.top);
          plot.ctx.lineTo(x, plot.bbox.top + plot.bbox.height);
          plot.ctx.stroke();
          plot.ctx.restore();
        }],
      },
    },
    columns as uPlot.AlignedData,
    host,
  );
}
