# SPDX-License-Identifier: LGPL-2.1-or-later
"""The BLAS that the program computes with is fast: its matrix product runs at no
less than 60 % of what OpenBLAS's best kernels for this processor give. What counts
is the processor's time, and the best of several rounds.

usage: blas_speed.py PROGRAM
"""

import ctypes
import os
import re
import subprocess
import sys
import time

REQUIRED = 0.6
SIZE = 1000
REPETITIONS = 3
ROUNDS = 3
NO_TRANSPOSITION, COLUMN_MAJOR = 111, 102
CORES = {"avx512f": "SkylakeX", "avx2": "Haswell", "sse3": "Prescott"}


def measure():
    """Billion operations per second of the matrix product, by one thread."""
    blas = ctypes.CDLL("libopenblas.so.0")
    doubles = ctypes.c_double * (SIZE * SIZE)
    a, b, c = doubles(*([0.5] * (SIZE * SIZE))), doubles(), doubles()
    double, pointer = ctypes.c_double, ctypes.POINTER(ctypes.c_double)
    blas.cblas_dgemm.argtypes = ([ctypes.c_int] * 6 + [double, pointer, ctypes.c_int]
                                 + [pointer, ctypes.c_int, double, pointer,
                                    ctypes.c_int])
    best = float("inf")
    for _ in range(REPETITIONS):
        begin = time.process_time()
        blas.cblas_dgemm(COLUMN_MAJOR, NO_TRANSPOSITION, NO_TRANSPOSITION, SIZE, SIZE,
                         SIZE, 1.0, a, SIZE, b, SIZE, 0.0, c, SIZE)
        best = min(best, time.process_time() - begin)
    return 2e-9 * SIZE**3 / best


def measure_with(core):
    """The speed of these kernels; of OpenBLAS's own choice where there is none."""
    environment = {**os.environ, "OPENBLAS_NUM_THREADS": "1"}
    environment.pop("OPENBLAS_CORETYPE", None)
    if core:
        environment["OPENBLAS_CORETYPE"] = core
    result = subprocess.run([sys.executable, "-B", __file__, "--measure"],
                            env=environment, stdout=subprocess.PIPE, check=True,
                            universal_newlines=True)
    return float(result.stdout)


def core_of(program):
    """The kernels that the program says it computes with."""
    environment = dict(os.environ)
    environment.pop("OPENBLAS_CORETYPE", None)
    result = subprocess.run([program, "--print-parameters", "--verbose"],
                            env=environment, stdout=subprocess.PIPE, check=True,
                            universal_newlines=True)
    match = re.match(r"Linear algebra: OpenBLAS with kernels for (\w+), \d+ thread",
                     result.stdout)
    if not match:
        raise SystemExit("the program does not say which kernels it has: "
                         + result.stdout.splitlines()[0])
    return match.group(1)


def main(program):
    with open("/proc/cpuinfo", encoding="ascii") as information:
        flags = set(re.search(r"^flags\s*:(.*)", information.read(), re.M)[1].split())
    chosen = core_of(program)
    cores = [None] + [core for flag, core in CORES.items() if flag in flags]
    speeds = dict.fromkeys({chosen, *cores}, 0)
    for _ in range(ROUNDS):
        speeds = {core: max(speed, measure_with(core)) for core, speed in speeds.items()}
    best = max(speeds.values())
    for core, speed in speeds.items():
        print(f"{core or 'own choice':12} {speed / best:.2f} of the best"
              + (", which the program has" if core == chosen else ""))
    return 0 if speeds[chosen] >= REQUIRED * best else 1


if __name__ == "__main__":
    if sys.argv[1] == "--measure":
        print(measure())
    else:
        sys.exit(main(sys.argv[1]))
