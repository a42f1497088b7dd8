// What people read and type; the wire is always radians and metres.

export type Kind = 'angle' | 'length';
export interface Units { angle: 'deg' | 'rad'; length: 'mm' | 'm' }

const DEGREE = Math.PI / 180;

export function unit(kind: Kind, units: Units): string {
  return kind === 'angle' ? (units.angle === 'deg' ? '°' : 'rad') : units.length;
}

/** A value in its unit, without the unit's name. */
export function shown(value: number, kind: Kind, units: Units): string {
  if (!Number.isFinite(value)) return '–';
  const [scaled, digits] =
    kind === 'angle'
      ? units.angle === 'deg' ? [value / DEGREE, 2] : [value, 4]
      : units.length === 'mm' ? [value * 1000, 2] : [value, 5];
  const text = scaled.toFixed(digits);
  // No minus in front of nothing.
  return Number(text) === 0 ? (0).toFixed(digits) : text;
}

/** What a person typed, as the wire takes it: a bare number is in the unit shown. */
export function typed(text: string, kind: Kind, units: Units): string {
  const plain = text.trim().replace(',', '.');
  const bare = /^[-+]?(\d+\.?\d*|\.\d+)(e[-+]?\d+)?$/i.test(plain);
  if (!bare) return plain;
  return `${plain} ${kind === 'angle' ? units.angle : units.length}`;
}

/** Words for a screen reader: "45.0 degrees". */
export function spoken(value: number, kind: Kind): string {
  return kind === 'angle' ? `${(value / DEGREE).toFixed(1)} degrees` : `${(value * 1000).toFixed(1)} millimetres`;
}

export function kindOf(joint: { kind: string }): Kind {
  return joint.kind === 'prismatic' ? 'length' : 'angle';
}

export function small(value: number): string {
  return value === 0 ? '0' : value.toExponential(1).replace('e+', 'e');
}
