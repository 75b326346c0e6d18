# SPDX-License-Identifier: LGPL-2.1-or-later
"""Scenes and bodies that are wrong at random: the program takes them, or refuses
them in a sentence; it never crashes and never hangs.

Each try changes a scene of prm/ or tests/scenes, or the file of its body, and
validates it; every third is run. A try is known by its number alone, so that one
that fails can be repeated, and looked at, with --only and --keep.

usage: fuzz.py PROGRAM FORK_SERVER [--tries N] [--first N] [--only N] [--keep DIRECTORY]
"""

import argparse
import concurrent.futures
import os
import pathlib
import queue
import random
import re
import signal
import subprocess
import sys
import tempfile

from fork_server import ForkServer
from mutations import NUMBER, mutate

ROOT = pathlib.Path(__file__).resolve().parents[2]
# A run that is right may take long; what is tried here are the wrong ones.
TIME_LIMIT = 60
MEMORY_LIMIT = 6 << 30
MOST_ELEMENTS = 100
# Most of a short run is MPI, which waits as it begins.
N_WORKERS = 6
CASES = ["slit_of_double_nodes/scene.prm", "quarter_points/scene_near.prm",
         "partitioned_mesh/scene_22.prm", "partitioned_mesh/scene_cut.prm",
         "sparse_numbers/scene_serendipity.prm", "number_in_two_dimensions/scene.prm",
         "group_turned_round/scene.prm"]
LIMITED = {"Refinement": 1, "Refinement near cut": 1}


def inlined(path):
    """A scene without its includes, and the file of its body."""
    lines, body = [], None
    for line in path.read_text().splitlines():
        words = line.split()
        if words[:1] == ["include"]:
            included, included_body = inlined(path.parent / words[1])
            lines += included
            body = included_body or body
        else:
            lines.append(line)
            match = re.match(r"\s*set\s+File\s*=\s*(\S+)", line)
            if match:
                body = path.parent / match.group(1)
    return lines, body


def corpus(program, directory):
    """Scenes, each with the text of its body's file, if it has one."""
    scenes = []
    for folder in ("prm", "tests/scenes"):
        for path in sorted((ROOT / folder).rglob("*.prm")):
            lines, body = inlined(path)
            if body and not body.exists():
                # Its test makes the body.
                print(f"left out: {path.name}, whose body is not in the tree")
                continue
            text = "\n".join(lines) + "\n"
            scenes.append((text, body.read_text() if body else None, ".geo"))
    # Small bodies of other kinds: of version 2.2, in partitions, with a slit.
    for scene in CASES:
        lines, body = inlined(ROOT / "tests" / "cases" / scene)
        scenes += [("\n".join(lines) + "\n", body.read_text(), body.suffix)] * 2
    # Pieces of a small cut, straight and curved, are bodies of the kind .msh.
    for scene in ("prm/kakefuda_1996/cut.prm", "prm/bodies/tube.prm"):
        output = pathlib.Path(directory) / pathlib.Path(scene).stem
        subprocess.run(
            [program, str(ROOT / scene), "--output", str(output),
             "--set", "Output/Frames=none"],
            check=True, stdout=subprocess.DEVNULL)
        body = (output / "piece_0.msh").read_text()
        text = ("subsection Body\n  set Shape = file\n  set File = body.msh\nend\n"
                "subsection Support\n  set Fixed boxes = -99,-99,-99,99,99,0:xyz\n"
                "end\nsubsection Cut\n  set Surfaces = where : x + y - 3\nend\n"
                "subsection Blade\n  set Sharpness = 1\nend\n")
        scenes += [(text, body, ".msh")] * 3
    return scenes


def is_large(scene):
    """Whether a scene may be right and take long."""
    for name, most in LIMITED.items():
        for value in re.findall(r"set\s+" + name + r"\s*=([^#\n]*)", scene):
            numbers = [float(number) for number in NUMBER.findall(value)]
            if any(number > most for number in numbers[:1]):
                return True
    for value in re.findall(r"set\s+Elements\s*=([^#\n]*)", scene):
        product = 1.0
        for number in NUMBER.findall(value):
            product *= float(number)
        if product > MOST_ELEMENTS:
            return True
    return False


def make_case(scenes, number):
    """The files of a try, and the options of the program."""
    generator = random.Random(f"setsudan {number}")
    scene, body, ending = generator.choice(scenes)
    n_changes = generator.choice([1, 1, 1, 2, 3, 5])
    for _ in range(n_changes):
        if body is not None and generator.random() < 0.5:
            body = mutate(generator, body, is_body=True)
        else:
            scene = mutate(generator, scene)
    if body is not None:
        scene = re.sub(r"(set\s+File\s*=\s*)[\w.]*\.(geo|msh)",
                       r"\1body" + ending, scene)
    options = ["--output", "out"]
    if number % 3 != 0 or is_large(scene) or body is not None and ending == ".geo":
        options.append("--validate")
    files = {"scene.prm": scene}
    if body is not None:
        files["body" + ending] = body
    return files, options


def problem_of(status, message):
    """What is wrong with how a run has ended; None if nothing is."""
    lines = message.splitlines()
    if status == 0 and not lines:
        return None
    if status == -signal.SIGXCPU:
        return f"no end within {TIME_LIMIT} s of processor time"
    if status != 1:
        return f"exit status {status}"
    if len(lines) != 1:
        return f"{len(lines)} lines instead of a sentence"
    if not (lines[0].startswith("setsudan: ") and lines[0].endswith(".")):
        return "no sentence"
    return None


def try_case(servers, files, options, directory):
    """What is wrong, what the program said, and its status."""
    for name, text in files.items():
        (directory / name).write_bytes(text.encode(errors="surrogatepass"))
    server = servers.get()
    status, message = server.run(["scene.prm", *options], directory, TIME_LIMIT,
                                 MEMORY_LIMIT)
    servers.put(server)
    message = message.strip("\n")
    return problem_of(status, message), message, status


def run_try(servers, scenes, number, keep):
    files, options = make_case(scenes, number)
    if keep:
        directory = pathlib.Path(keep) / str(number)
        directory.mkdir(parents=True, exist_ok=True)
        return try_case(servers, files, options, directory)
    with tempfile.TemporaryDirectory() as name:
        return try_case(servers, files, options, pathlib.Path(name))


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("program")
    parser.add_argument("fork_server")
    parser.add_argument("--tries", type=int, default=500)
    parser.add_argument("--first", type=int, default=0)
    parser.add_argument("--only", type=int)
    parser.add_argument("--keep")
    options = parser.parse_args()
    numbers = range(options.first, options.first + options.tries)
    if options.only is not None:
        numbers = [options.only]

    program = os.path.abspath(options.program)
    with tempfile.TemporaryDirectory() as directory:
        scenes = corpus(program, directory)
    ends = {0: 0, 1: 0}
    n_failed = 0
    servers = queue.SimpleQueue()
    for _ in range(N_WORKERS):
        servers.put(ForkServer(program, os.path.abspath(options.fork_server)))
    with concurrent.futures.ThreadPoolExecutor(N_WORKERS) as pool:
        results = pool.map(
            lambda number: run_try(servers, scenes, number, options.keep), numbers)
        for number, (problem, message, status) in zip(numbers, results):
            if problem:
                n_failed += 1
                print(f"FAILED: try {number}: {problem}\n{message}", flush=True)
            else:
                ends[status] += 1
            if options.only is not None:
                print(message)
    for _ in range(N_WORKERS):
        servers.get().close()
    print(f"{len(numbers)} tries: {ends[0]} taken, {ends[1]} refused, "
          f"{n_failed} failed")
    # Changes that are always refused, or never, would try nothing.
    one_sided = options.only is None and 0 in ends.values()
    return 1 if n_failed or one_sided else 0


if __name__ == "__main__":
    sys.exit(main())
