#!/usr/bin/env python3
"""The golden poses of the built-in robots, computed with 50 digits, independently of the library.

    golden.py --check [FILE...]   exit 1 if a golden pose is off by more than 1e-14, or a file is malformed
    golden.py --write [FILE...]   recompute the golden sections, at the end of each file

Without FILE: every robot beside this script. Needs Python 3.11 and mpmath.

Joint values are chosen by rule and by a seed made from the file's name, so --write gives the same bytes
each time: all zeros; two right-angle poses; three random ones within the limits.
A revolute value within 1e-14 of a multiple of 15 degrees stands for that exact multiple.
"""

import argparse
import random
import re
import sys
import tomllib
from pathlib import Path

import mpmath as mp

mp.mp.dps = 50
TOLERANCE = mp.mpf("1e-14")
MARKER = "# Golden poses, computed by golden.py: do not edit.\n"
UNITS = {"mm": mp.mpf(1) / 1000, "m": mp.mpf(1), "deg": mp.pi / 180, "rad": mp.mpf(1)}
TOKEN = re.compile(r"\s*(?:(\d+\.?\d*(?:[eE][+-]?\d+)?|\.\d+(?:[eE][+-]?\d+)?)|([A-Za-z_]\w*)|([-+*/()]))")
UNKNOWN = "?"  # the value of a parameter that the user has to give
SAMPLE_LENGTHS = (mp.mpf("0.3"), mp.mpf("0.5"))  # range from which golden poses draw such values


class Wrong(Exception):
    """What is wrong with a robot file, in words."""


# --- expressions: affine in the joint variables, with exact constants ------------------------------------


class Affine:
    """constant + sum of coefficient * q; the only form an entry of the table may take."""

    def __init__(self, constant, terms=None):
        self.constant, self.terms = mp.mpf(constant), {k: v for k, v in (terms or {}).items() if v}

    def plus(self, other, sign):
        terms = dict(self.terms)
        for name, c in other.terms.items():
            terms[name] = terms.get(name, 0) + sign * c
        return Affine(self.constant + sign * other.constant, terms)

    def scaled(self, factor):
        return Affine(self.constant * factor, {k: v * factor for k, v in self.terms.items()})


def parse(value, names):
    """A number, or a string such as "290 mm", "pi/2 - q3", "-(d1 + a2)"."""
    if not isinstance(value, str):
        return Affine(value)
    tokens, at = [], 0
    text = value.strip()
    while at < len(text):
        m = TOKEN.match(text, at)
        if not m:
            raise Wrong(f"{value!r}: cannot read {text[at:]!r}")
        tokens.append((m.lastindex, m.group(m.lastindex)))
        at = m.end()
    tokens.append((0, "end"))
    pos = 0

    def take(*symbols):
        nonlocal pos
        if tokens[pos][0] == 3 and tokens[pos][1] in symbols:
            pos += 1
            return tokens[pos - 1][1]
        return None

    def total():
        left = product()
        while op := take("+", "-"):
            left = left.plus(product(), 1 if op == "+" else -1)
        return left

    def product():
        left = signed()
        while op := take("*", "/"):
            right = signed()
            if op == "/":
                if right.terms or not right.constant:
                    raise Wrong(f"{value!r}: cannot divide by that")
                left = left.scaled(1 / right.constant)
            elif right.terms and left.terms:
                raise Wrong(f"{value!r}: joint variables cannot be multiplied")
            else:
                left = left.scaled(right.constant) if not right.terms else right.scaled(left.constant)
        return left

    def signed():
        nonlocal pos
        if op := take("-", "+"):
            return signed().scaled(-1 if op == "-" else 1)
        if take("("):
            inner = total()
            if not take(")"):
                raise Wrong(f"{value!r}: a bracket is not closed")
            return inner
        kind, text = tokens[pos]
        pos += 1
        if kind == 1:
            number = mp.mpf(text)
            if tokens[pos][0] == 2 and tokens[pos][1] in UNITS:
                number *= UNITS[tokens[pos][1]]
                pos += 1
            return Affine(number)
        if kind == 2 and text == "pi":
            return Affine(mp.pi)
        if kind == 2 and text in names:
            return Affine(names[text])
        if kind == 2 and re.fullmatch(r"q[1-9]\d*", text):
            return Affine(0, {text: mp.mpf(1)})
        raise Wrong(f"{value!r}: {text!r} is not a number, a parameter or a joint variable")

    result = total()
    if tokens[pos][0] != 0:
        raise Wrong(f"{value!r}: cannot read {tokens[pos][1]!r}")
    return result


def constant(value, names):
    e = parse(value, names)
    if e.terms:
        raise Wrong(f"{value!r}: no joint variable is allowed here")
    return e.constant


# --- transforms ------------------------------------------------------------------------------------------


def rot(axis, angle):
    c, s = mp.cos(angle), mp.sin(angle)
    i, j = [(1, 2), (2, 0), (0, 1)][axis]
    m = mp.eye(4)
    m[i, i] = m[j, j] = c
    m[i, j], m[j, i] = -s, s
    return m


def shift(x, y, z):
    m = mp.eye(4)
    m[0, 3], m[1, 3], m[2, 3] = x, y, z
    return m


def fixed(table, names):
    """[base] or [tool]: xyz, then fixed-axis roll, pitch, yaw."""
    xyz = [constant(v, names) for v in table.get("xyz", [0, 0, 0])]
    roll, pitch, yaw = (constant(v, names) for v in table.get("rpy", [0, 0, 0]))
    return shift(*xyz) * rot(2, yaw) * rot(1, pitch) * rot(0, roll)


# --- robots ----------------------------------------------------------------------------------------------


class Robot:
    def __init__(self, path):
        self.path, self.id = path, path.stem
        self.doc = tomllib.loads(path.read_text(encoding="utf-8"), parse_float=mp.mpf)
        self.joints = self.doc.get("joint", [])
        self.convention = self.doc.get("convention")
        if self.convention not in ("standard", "modified"):
            raise Wrong(f"convention = {self.convention!r}: expected \"standard\" or \"modified\"")
        for key in ("name", "summary", "source"):
            if not str(self.doc.get(key, "")).strip():
                raise Wrong(f"`{key}` is missing")
        if not self.joints:
            raise Wrong("there is no [[joint]]")
        parameters = self.doc.get("parameters", {})
        self.open = sorted(k for k, v in parameters.items() if v == UNKNOWN)
        self.names = {k: constant(v, {}) for k, v in parameters.items() if v != UNKNOWN}
        sample = self.names | {k: mp.mpf(1) for k in self.open}
        self.revolute = [self.row(i, sample)[0] for i in range(len(self.joints))]
        self.limits = [self.limit(i) for i in range(len(self.joints))]

    def row(self, i, names):
        """(is revolute, {theta, d, a, alpha}) of row i, with its form checked."""
        joint, q = self.joints[i], f"q{i + 1}"
        unknown = joint.keys() - {"theta", "d", "a", "alpha", "name", "limits", "velocity", "acceleration"}
        if unknown:
            raise Wrong(f"joint {i + 1}: unknown keys {sorted(unknown)}")
        for key in ("theta", "d", "a", "alpha"):
            if key not in joint:
                raise Wrong(f"joint {i + 1}: `{key}` is missing")
        row = {key: parse(joint[key], names) for key in ("theta", "d", "a", "alpha")}
        moving = [key for key, e in row.items() if e.terms]
        if len(moving) != 1 or moving[0] not in ("theta", "d"):
            raise Wrong(f"joint {i + 1}: exactly one of theta and d must hold {q}")
        if list(row[moving[0]].terms) != [q] or abs(row[moving[0]].terms[q]) != 1:
            raise Wrong(f"joint {i + 1}: {moving[0]} must be an offset + {q} or - {q}")
        return moving[0] == "theta", row

    def limit(self, i):
        wide = [-mp.pi, mp.pi] if self.revolute[i] else [mp.mpf(0), mp.mpf("0.5")]
        low, high = (constant(v, self.names) for v in self.joints[i].get("limits", wide))
        if not low < high:
            raise Wrong(f"joint {i + 1}: limits are not in order")
        return low, high

    def pose(self, q, extra):
        """base * A1 * ... * An * tool at q (floats), with the values of the open parameters."""
        missing = set(self.open) ^ set(extra)
        if missing:
            raise Wrong(f"golden pose: parameters {sorted(missing)} are missing or too many")
        if len(q) != len(self.joints):
            raise Wrong(f"golden pose: {len(q)} joint values for {len(self.joints)} joints")
        names = self.names | extra
        t = fixed(self.doc.get("base", {}), names)
        for i, value in enumerate(q):
            revolute, row = self.row(i, names)
            exact = snap(value) if revolute else mp.mpf(value)
            e = {k: v.constant + sum(c * exact for c in v.terms.values()) for k, v in row.items()}
            screw_z = rot(2, e["theta"]) * shift(0, 0, e["d"])
            screw_x = shift(e["a"], 0, 0) * rot(0, e["alpha"])
            t = t * (screw_z * screw_x if self.convention == "standard" else screw_x * screw_z)
        return t * fixed(self.doc.get("tool", {}), names)

    def choose(self):
        """The joint values of the golden poses."""
        rng = random.Random(f"pieper {self.id}")
        n = len(self.joints)

        def inside(i, v):
            return self.limits[i][0] <= v <= self.limits[i][1]

        def right(i):
            if not self.revolute[i]:
                return round(float(sum(self.limits[i]) / 2), 3)
            for v in (mp.pi / 2, -mp.pi / 2, mp.pi / 4, -mp.pi / 4, mp.pi, mp.mpf(0)):
                if inside(i, v):
                    return float(v)
            return round(float(sum(self.limits[i]) / 2), 3)

        def anywhere(i):
            low, high = (float(v) for v in self.limits[i])
            return min(max(round(rng.uniform(low, high), 4), low), high)

        rows = [[0.0] * n, [right(i) for i in range(n)], [right(i) if i % 2 else 0.0 for i in range(n)]]
        rows += [[anywhere(i) for i in range(n)] for _ in range(3)]
        lows, highs = (float(v) for v in SAMPLE_LENGTHS)
        return [(q, {k: round(rng.uniform(lows, highs), 3) for k in self.open}) for q in rows]


def snap(value):
    step = mp.pi / 12
    turns = mp.nint(mp.mpf(value) / step)
    return turns * step if abs(turns * step - mp.mpf(value)) <= TOLERANCE else mp.mpf(value)


# --- the two commands ------------------------------------------------------------------------------------


def digits(x):
    """17 significant digits; what is zero but for rounding is written as zero."""
    return repr(0.0) if abs(x) < mp.mpf("1e-30") else f"{float(x):.17g}" if float(x) % 1 else f"{float(x):.1f}"


def golden_text(robot):
    out = [MARKER]
    for q, extra in robot.choose():
        t = robot.pose(q, {k: mp.mpf(v) for k, v in extra.items()})
        out.append("\n[[golden]]\n")
        if extra:
            out.append("parameters = { " + ", ".join(f"{k} = {v!r}" for k, v in extra.items()) + " }\n")
        out.append("q = [" + ", ".join(repr(v) for v in q) + "]\n")
        rows = ("[" + ", ".join(digits(t[r, c]) for c in range(4)) + "]" for r in range(4))
        out.append("pose = [\n" + "".join(f"    {row},\n" for row in rows) + "]\n")
    return "".join(out)


def write(path):
    text = golden_text(Robot(path))
    head = path.read_text(encoding="utf-8").split(MARKER)[0].rstrip("\n")
    path.write_text(f"{head}\n\n{text}", encoding="utf-8")
    return f"{path.name}: written"


def check(path):
    robot = Robot(path)
    golden = robot.doc.get("golden", [])
    if len(golden) < 5:
        raise Wrong(f"{len(golden)} golden poses, at least 5 are wanted: run golden.py --write")
    worst = mp.mpf(0)
    for k, g in enumerate(golden, 1):
        t = robot.pose([mp.mpf(float(v)) for v in g["q"]], {n: mp.mpf(v) for n, v in g.get("parameters", {}).items()})
        for r in range(4):
            for c in range(4):
                off = abs(t[r, c] - mp.mpf(float(g["pose"][r][c])))
                worst = max(worst, off)
                if off > TOLERANCE:
                    raise Wrong(
                        f"golden pose {k} at q = {[float(v) for v in g['q']]}: row {r + 1}, column {c + 1} is "
                        f"{float(g['pose'][r][c])!r}, the table gives {float(t[r, c])!r} (off by {mp.nstr(off, 3)})"
                    )
    return f"{path.name}: {len(robot.joints)} joints, {len(golden)} poses, worst {mp.nstr(worst, 2)}"


def main():
    parser = argparse.ArgumentParser(description="golden poses of the built-in robots")
    what = parser.add_mutually_exclusive_group(required=True)
    what.add_argument("--check", action="store_true", help="compare the golden poses with the tables")
    what.add_argument("--write", action="store_true", help="recompute the golden poses")
    parser.add_argument("files", nargs="*", type=Path, metavar="FILE")
    args = parser.parse_args()
    failed = False
    for path in args.files or sorted(path for path in Path(__file__).parent.glob("*.toml") if path.name != "Cargo.toml"):
        try:
            print(write(path) if args.write else check(path))
        except (Wrong, tomllib.TOMLDecodeError, OSError) as error:
            failed = True
            print(f"{path.name}: {error}", file=sys.stderr)
    sys.exit(failed)


if __name__ == "__main__":
    main()
