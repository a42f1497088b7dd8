// Line icons, one path each on a 20 x 20 grid.

const PATHS = {
  undo: 'M7 5 3.5 8.5 7 12M4 8.5h7.5a4.5 4.5 0 0 1 0 9H9',
  redo: 'M13 5l3.5 3.5L13 12M16 8.5H8.5a4.5 4.5 0 0 0 0 9H11',
  play: 'M6 4.5v11l9-5.5z',
  pause: 'M6.5 4.5v11M13.5 4.5v11',
  back: 'M14 5v10l-6-5zM5.5 5v10',
  forward: 'M6 5v10l6-5zM14.5 5v10',
  stop: 'M5.5 5.5h9v9h-9z',
  loop: 'M4 10a5 5 0 0 1 5-5h6M12.5 2.5 15 5l-2.5 2.5M16 10a5 5 0 0 1-5 5H5M7.5 17.5 5 15l2.5-2.5',
  sun: 'M10 6.2a3.8 3.8 0 1 0 0 7.6 3.8 3.8 0 0 0 0-7.6M10 1.5v2M10 16.5v2M1.5 10h2M16.5 10h2M4 4l1.4 1.4M14.6 14.6 16 16M16 4l-1.4 1.4M5.4 14.6 4 16',
  moon: 'M16 11.8A6.5 6.5 0 0 1 8.2 4 6.5 6.5 0 1 0 16 11.8z',
  auto: 'M10 3a7 7 0 1 0 0 14zM10 3a7 7 0 0 1 0 14',
  camera: 'M3 6.5h3l1.3-2h5.4l1.3 2h3v9H3zM10 8.2a2.6 2.6 0 1 0 0 5.2 2.6 2.6 0 0 0 0-5.2',
  home: 'M3.5 9.5 10 4l6.5 5.5M5.5 8.5V16h9V8.5',
  ghost: 'M4.5 16V9a5.5 5.5 0 0 1 11 0v7l-2-1.5-1.8 1.5L10 14.5 8.3 16l-1.8-1.5zM8 9v.01M12 9v.01',
  axes: 'M6 14V4M6 14h10M6 14l-3 3M4.3 5.7 6 4l1.7 1.7M14.3 12.3 16 14l-1.7 1.7',
  trail: 'M3 15c4 0 3-9 7-9s3 7 7 4',
  reach: 'M3 16a7 7 0 0 1 14 0M6.5 16a3.5 3.5 0 0 1 7 0',
  move: 'M10 2.5v15M2.5 10h15M7.8 4.7 10 2.5l2.2 2.2M7.8 15.3 10 17.5l2.2-2.2M4.7 7.8 2.5 10l2.2 2.2M15.3 7.8 17.5 10l-2.2 2.2',
  rotate: 'M15.5 7A6.5 6.5 0 1 0 16.5 11M16 3v4h-4',
  plus: 'M10 4v12M4 10h12',
  close: 'M5 5l10 10M15 5 5 15',
  lock: 'M5.5 9h9v7.5h-9zM7 9V6.5a3 3 0 0 1 6 0V9',
  unlock: 'M5.5 9h9v7.5h-9zM7 9V6.5a3 3 0 0 1 5.8-1',
  warn: 'M10 3.5 17.5 16h-15zM10 8v4M10 14v.01',
  check: 'M4.5 10.5 8.5 14.5 15.5 6',
  help: 'M7.5 7.5a2.5 2.5 0 1 1 3.6 2.2c-.7.4-1.1.9-1.1 1.8M10 14.5v.01',
  down: 'M5 7.5 10 12.5 15 7.5',
  panel: 'M3 4.5h14v11H3zM12.5 4.5v11',
  download: 'M10 3.5v9M6.5 9.5 10 13l3.5-3.5M4 16h12',
  upload: 'M10 13V4M6.5 7.5 10 4l3.5 3.5M4 16h12',
  dice: 'M4 4h12v12H4zM7.5 7.5v.01M12.5 7.5v.01M10 10v.01M7.5 12.5v.01M12.5 12.5v.01',
  copy: 'M7 7h9v9H7zM13 7V4H4v9h3',
  paste: 'M7 4.5H4.5V17h11V4.5H13M7.5 3h5v3h-5zM10 8.5v5M7.8 11.3 10 13.5l2.2-2.2',
  fit: 'M3 7V3h4M13 3h4v4M17 13v4h-4M7 17H3v-4',
} as const;

export type IconName = keyof typeof PATHS;

export function Icon({ name }: { name: IconName }) {
  return (
    <svg class="icon" viewBox="0 0 20 20" aria-hidden="true">
      <path d={PATHS[name]} />
    </svg>
  );
}

interface ButtonProps { icon: IconName; label: string; onClick: () => void; pressed?: boolean; disabled?: boolean; keys?: string; text?: string; class?: string }

/** A button with an icon; its label is said and shown as a tip. */
export function IconButton({ icon, label, onClick, pressed, disabled, keys, text, class: extra }: ButtonProps) {
  const tip = keys ? `${label} (${keys})` : label;
  return (
    <button type="button" class={`icon-button ${extra ?? ''}`} title={tip} aria-label={label} disabled={disabled ?? false} onClick={onClick}
      {...(pressed === undefined ? {} : { 'aria-pressed': pressed })}>
      <Icon name={icon} />
      {text && <span>{text}</span>}
    </button>
  );
}
