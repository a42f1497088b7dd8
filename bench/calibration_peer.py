"""The same calibration by SciPy's least_squares, on the same measurements: parameters, residuals and time.

    pieper calibrate irb120 --simulate --out m.csv
    python bench/calibration_peer.py --bin target/release/pieper --robot irb120 m.csv

The model is written here anew: the table of `pieper info --json`, with base and tool frames, and Hayati's turn between nearly parallel
axes. What pieper holds is held here too, as SciPy would need to be told; its own residuals and rates by differences.
"""

import argparse
import csv
import json
import subprocess
import time

import numpy as np
from scipy.optimize import least_squares
from scipy.spatial.transform import Rotation


def turn(axis, angle):
    m = np.eye(4)
    m[:3, :3] = Rotation.from_rotvec(angle * np.eye(3)[axis]).as_matrix()
    return m


def shift(axis, by):
    m = np.eye(4)
    m[axis, 3] = by
    return m


def tool(values, q, rows):
    """Base, rows of theta, d, a, alpha, beta, and tool, with these values by name."""
    frame = lambda name: (shift(0, values[f"{name}.x"]) @ shift(1, values[f"{name}.y"]) @ shift(2, values[f"{name}.z"])
                          @ turn(2, values[f"{name}.yaw"]) @ turn(1, values[f"{name}.pitch"]) @ turn(0, values[f"{name}.roll"]))
    m = frame("base")
    for k in range(1, rows + 1):
        m = m @ turn(2, values[f"theta{k}"] + q[k - 1]) @ shift(2, values[f"d{k}"]) @ shift(0, values[f"a{k}"])
        m = m @ turn(0, values[f"alpha{k}"]) @ turn(1, values.get(f"beta{k}", 0.0))
    return m @ frame("tool")


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--bin", default="target/release/pieper")
    parser.add_argument("--robot", default="irb120")
    parser.add_argument("measurements")
    arguments = parser.parse_args()
    command = [arguments.bin, "calibrate", arguments.robot, arguments.measurements, "--out", "/dev/null", "--plain", "--json"]
    command[command.index("/dev/null")] = arguments.measurements + ".toml"
    start = time.perf_counter()
    ours = json.loads(subprocess.run(command, capture_output=True, text=True, check=True).stdout)
    whole = time.perf_counter() - start
    with open(arguments.measurements) as file:
        lines = list(csv.DictReader(line for line in file if not line.startswith("#")))
    joints = [name for name in lines[0] if name.endswith("_deg") and name != "sigma_angle_deg"]
    q = np.radians([[float(line[name]) for name in joints] for line in lines])
    place = np.array([[float(line[f"{c}_mm"]) for c in "xyz"] for line in lines]) / 1000
    seen = Rotation.from_quat([[float(line[f"q{c}"]) for c in "xyzw"] for line in lines])
    sigma, sigma_angle = float(lines[0]["sigma_mm"]) / 1000, np.radians(float(lines[0]["sigma_angle_deg"]))
    nominal = {p["name"]: p["nominal"] for p in ours["parameters"]}
    fitted = ours["fitted"]

    def residuals(x):
        values = dict(nominal, **dict(zip(fitted, x)))
        tools = np.array([tool(values, row, q.shape[1]) for row in q])
        angles = (Rotation.from_matrix(tools[:, :3, :3]) * seen.inv()).as_rotvec()
        return np.concatenate([((tools[:, :3, 3] - place) / sigma).ravel(), (angles / sigma_angle).ravel()])

    start = time.perf_counter()
    found = least_squares(residuals, [nominal[name] for name in fitted], method="lm", x_scale="jac")
    theirs = time.perf_counter() - start
    value = {p["name"]: p["value"] for p in ours["parameters"]}
    spread = {p["name"]: p["sigma"] for p in ours["parameters"]}
    worst = max(abs(x - value[name]) / spread[name] for name, x in zip(fitted, found.x))
    rms = np.sqrt(np.mean(np.sum((residuals(found.x)[: 3 * len(q)].reshape(-1, 3) * sigma) ** 2, axis=1)))
    print(f"| | parameters | residual, mm | time, s |\n|---|---|---|---|")
    print(f"| pieper (the whole program, with cross-validation and report) | {len(fitted)} | {1000 * ours['rms_after']:.5f} | {whole:.3f} |")
    print(f"| SciPy {method_name()} | {len(fitted)} | {1000 * rms:.5f} | {theirs:.3f} |")
    print(f"largest difference of a parameter: {worst:.2e} of its standard deviation")


def method_name():
    import scipy

    return f"{scipy.__version__} least_squares, MINPACK"


main()
