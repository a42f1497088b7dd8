"""The closed-form inverse derived, and its C code timed: pieper beside Roboticstoolbox for Python 1.5, in one run.

    pip install roboticstoolbox-python==1.5.0
    python bench/symbolic_peer.py --bin target/release/pieper
"""

import argparse
import pathlib
import subprocess
import tempfile
import time

import numpy as np
import roboticstoolbox as rtb
from roboticstoolbox.robot.symbolic_ik import generate_code

POSES = 10_000

MAIN = """
#include <stdio.h>
#include <stdlib.h>
#include <time.h>
int main(void) {
    static double T[%d][16];
    FILE *f = fopen("poses.txt", "r");
    for (int i = 0; i < %d; ++i) for (int j = 0; j < 16; ++j) if (fscanf(f, "%%lf", &T[i][j]) != 1) return 1;
    long found = 0;
    struct timespec a, b;
    double best = 1e9;
    for (int round = 0; round < 7; ++round) {
        found = 0;
        clock_gettime(CLOCK_MONOTONIC, &a);
        for (int i = 0; i < %d; ++i) { %s }
        clock_gettime(CLOCK_MONOTONIC, &b);
        double us = ((b.tv_sec - a.tv_sec) * 1e9 + (b.tv_nsec - a.tv_nsec)) / 1e3 / %d;
        if (us < best) best = us;
    }
    printf("%%.3f us a pose, %%.3f solutions\\n", best, (double)found / %d);
}
"""


def timed(folder, name, source, call):
    """Compiles a generated source with the loop over the poses, and gives what it says."""
    path = folder / f"{name}.c"
    path.write_text("#define _GNU_SOURCE\n" + source + MAIN % (POSES, POSES, POSES, call, POSES, POSES))
    subprocess.run(["gcc", "-O2", "-std=gnu11", str(path), "-o", str(folder / name), "-lm"], check=True)
    return subprocess.run([str(folder / name)], cwd=folder, check=True, capture_output=True, text=True).stdout.strip()


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--bin", required=True)
    arguments = parser.parse_args()
    binary = str(pathlib.Path(arguments.bin).resolve())
    start = time.perf_counter()
    ours = subprocess.run(
        [binary, "codegen", "puma560", "--lang", "c", "--what", "inverse"], check=True, capture_output=True, text=True
    ).stdout
    print(f"pieper: PUMA 560 derived and written in {1e3 * (time.perf_counter() - start):.1f} ms, process included")
    start = time.perf_counter()
    theirs = generate_code(rtb.models.DH.Puma560(), "c", "ikine")
    print(f"Roboticstoolbox 1.5: the same in {time.perf_counter() - start:.1f} s")
    robot = rtb.models.DH.Puma560()
    rng = np.random.default_rng(3)
    poses = [robot.fkine(rng.uniform(-3, 3, 6)).A for _ in range(POSES)]
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        np.savetxt(folder / "poses.txt", np.array(poses).reshape(POSES, 16))
        call = "double A[3][4], q[8][6]; for (int j = 0; j < 12; ++j) A[j / 4][j % 4] = T[i][j]; found += puma560_inverse(A, 0, q);"
        print("pieper:", timed(folder, "ours", ours, call))
        call = "double q[16][6]; int n = 0; ikine(T[i], 1e-6, q, &n); found += n;"
        print("Roboticstoolbox:", timed(folder, "theirs", theirs, call))


if __name__ == "__main__":
    main()
