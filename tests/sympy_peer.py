"""Equality of formulas, decided by pieper and by SymPy: random expressions and rewritings of them, right and wrong.

    python tests/sympy_peer.py --bin target/release/pieper [--cases 400]
"""

import argparse
import json
import pathlib
import random
import subprocess
import sys
import tempfile

import sympy as sp

Q = sp.symbols("q1:7")
LENGTHS = sp.symbols("S1 a1 l2 l4 l6")


def expression(rng, depth):
    """A random expression over sines and cosines of joint variables and their sums, lengths and numbers."""
    if depth == 0:
        kind = rng.randrange(4)
        if kind == 0:
            return rng.choice(LENGTHS)
        if kind == 1:
            return sp.Rational(rng.randint(-5, 5), rng.choice([1, 2, 3, 10]))
        angle = rng.choice(Q)
        if rng.random() < 0.4:
            angle += rng.choice([1, -1]) * rng.choice(Q) + rng.choice([0, sp.pi / 2, sp.pi / 3, -sp.pi / 4])
        return rng.choice([sp.sin, sp.cos])(angle, evaluate=False)
    left, right = expression(rng, depth - 1), expression(rng, depth - 1)
    return rng.choice([sp.Add, sp.Mul, sp.Mul, lambda a, b: a - b])(left, right)


def rewritten(rng, expr):
    """The same function, written otherwise."""
    way = rng.randrange(4)
    if way == 0:
        return sp.expand(expr)
    if way == 1:
        return sp.expand_trig(expr)
    if way == 2:
        return sp.expand(expr * (sp.sin(Q[2]) ** 2 + sp.cos(Q[2]) ** 2))
    return sp.expand(sp.expand_trig(expr), trig=False)


def is_equal(a, b):
    """SymPy's own answer: the normal form modulo s^2 + c^2 - 1 of every joint."""
    s, c = sp.symbols("s1:7"), sp.symbols("c1:7")
    difference = sp.expand(sp.expand_trig(a - b))
    replace = {}
    for i, q in enumerate(Q):
        replace[sp.sin(q)] = s[i]
        replace[sp.cos(q)] = c[i]
    difference = sp.expand(difference.xreplace(replace))
    if difference == 0:
        return True
    relations = [x**2 + y**2 - 1 for x, y in zip(s, c)]
    _, rest = sp.reduced(difference, relations, *s, *c, *LENGTHS, order="lex")
    return sp.expand(rest) == 0


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--bin", required=True)
    parser.add_argument("--cases", type=int, default=300)
    arguments = parser.parse_args()
    rng = random.Random(20)
    claims, expected = [], []
    for _ in range(arguments.cases):
        first = expression(rng, rng.choice([1, 2, 2, 3]))
        second = rewritten(rng, first)
        if rng.random() < 0.5:
            # A slip: another term, or a sign.
            slip = expression(rng, 0)
            second = second + slip if rng.random() < 0.5 else -second
        claims.append(f"{sp.sstr(first)} = {sp.sstr(second)}".replace("**", "^"))
        expected.append(is_equal(first, second))
    with tempfile.TemporaryDirectory() as folder:
        path = pathlib.Path(folder) / "claims.txt"
        path.write_text(";\n".join(claims))
        done = subprocess.run(
            [arguments.bin, "check", "ar3", str(path), "--json"], capture_output=True, text=True, check=False
        )
    if done.returncode not in (0, 1):
        sys.exit(done.stderr)
    verdicts = json.loads(done.stdout)
    assert len(verdicts) == len(claims), (len(verdicts), len(claims))
    wrong = [(c, v["holds"], e) for c, v, e in zip(claims, verdicts, expected) if v["holds"] != e]
    for claim, ours, theirs in wrong[:5]:
        print(f"{claim}\n  pieper: {ours}, SymPy: {theirs}")
    print(f"{len(claims)} claims, {sum(expected)} of them true: {len(wrong)} answers differ from SymPy {sp.__version__}")
    sys.exit(bool(wrong))


if __name__ == "__main__":
    main()
