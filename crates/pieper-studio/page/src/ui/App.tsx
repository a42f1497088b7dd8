import { useEffect } from 'preact/hooks';
import { effect } from '@preact/signals';
import { dark, ik, panelOpen, pose, sizes, tab, type Tab } from '../state';
import { LiveFrame } from './Controller';
import { Drawer, drawerSize } from './Drawer';
import { Joints } from './Joints';
import { Overlays } from './Overlays';
import { RobotInfo } from './RobotInfo';
import { Solutions } from './Solutions';
import { Splitter } from './Splitter';
import { Tool } from './Tool';
import { TopBar } from './TopBar';
import { View } from './View';
import { isSnapshot } from '../wire/snapshot';
import { shown } from '../units';
import { units } from '../state';

const TABS: [Tab, string][] = [['joints', 'Joints'], ['tool', 'Tool'], ['ik', 'Solutions'], ['robot', 'Robot']];

function Panel() {
  const open = tab.value;
  const count = (ik.value?.solutions.length ?? 0) + (ik.value?.families.length ?? 0);
  const move = (event: KeyboardEvent): void => {
    const by = { ArrowRight: 1, ArrowLeft: 3 }[event.key];
    if (by === undefined) return;
    const index = (TABS.findIndex(([key]) => key === open) + by) % TABS.length;
    tab.value = TABS[index]![0];
    document.getElementById(`tab-${TABS[index]![0]}`)?.focus();
  };
  return (
    <aside class="panel" aria-label="Control panel">
      <Splitter label="Width of the side panel" size={sizes.panel} name="panel" from="right" least={300} most={() => Math.max(300, Math.round(0.6 * innerWidth))} />
      <div class="tabs" role="tablist" aria-label="Control panel" onKeyDown={move}>
        {TABS.map(([key, text]) => (
          <button type="button" key={key} id={`tab-${key}`} role="tab" aria-selected={open === key} aria-controls="panel-body" tabIndex={open === key ? 0 : -1} onClick={() => (tab.value = key)}>
            {text}{key === 'ik' && count > 0 && <span class="badge">{count}</span>}
          </button>
        ))}
      </div>
      <div class="panel-body" id="panel-body" role="tabpanel" aria-labelledby={`tab-${open}`} tabIndex={0}>
        <fieldset class="bare" disabled={isSnapshot}>
          {open === 'joints' && <Joints />}
          {open === 'tool' && <Tool />}
          {open === 'ik' && <Solutions />}
        </fieldset>
        {open === 'robot' && <RobotInfo />}
      </div>
      <Readout />
    </aside>
  );
}

/** Where the tool is, always in sight. */
function Readout() {
  const tool = pose.value?.tool;
  if (!tool) return null;
  return (
    <dl class="readout" aria-label="Tool position">
      {['X', 'Y', 'Z'].map((name, k) => <div key={name}><dt class={`axis axis-${name.toLowerCase()}`}>{name}</dt><dd>{shown(tool.position[k]!, 'length', units.value)}</dd></div>)}
      <div><dt>{units.value.length}</dt></div>
    </dl>
  );
}

export function App() {
  useEffect(() => effect(() => {
    document.documentElement.dataset.theme = dark.value ? 'dark' : 'light';
  }), []);
  useEffect(() => effect(() => {
    const { style } = document.documentElement;
    style.setProperty('--panel-width', `${sizes.panel.value}px`);
    style.setProperty('--drawer-height', `${sizes[drawerSize()].value}px`);
  }), []);
  return (
    <div class={`app ${panelOpen.value ? '' : 'no-panel'}`}>
      <TopBar />
      <main class="stage" aria-label="3D view"><View /></main>
      {panelOpen.value && <Panel />}
      <Drawer />
      <LiveFrame />
      <Overlays />
    </div>
  );
}
