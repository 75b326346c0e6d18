# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a study is to run, from its TOML file."""

import hashlib
import itertools
import pathlib
import re
import tomllib
from types import SimpleNamespace

from program import Refusal

KEYS = ("scene", "directory", "jobs", "plot", "sheet", "grid", "run")
SUMMARY = ("first_yield", "mean_force", "work", "max_strain", "doubtful_states", "frames",
           "pieces", "processes", "seconds")
LONGEST = 120  # of the name of a directory


def read_study(path):
    """The study of a file, with its runs: settings, each with its directory's name.

    Raises Refusal where something is wrong with it."""
    try:
        with open(path, "rb") as file:
            table = tomllib.load(file)
    except OSError as error:
        raise Refusal(f"'{path}' cannot be read: {error.strerror}") from error
    except (tomllib.TOMLDecodeError, UnicodeDecodeError) as error:
        raise Refusal(f"'{path}' is no TOML file: {error}") from error
    for key in table:
        if key not in KEYS:
            raise Refusal(f"'{path}' has the unknown key '{key}'; there are "
                          f"{', '.join(KEYS)}")
    scene = text_of(path, table, "scene")
    directory = text_of(path, table, "directory")
    jobs = table.get("jobs", 1)
    if type(jobs) is not int or jobs < 1:
        raise Refusal(f"jobs of '{path}' must be a whole number of at least 1")
    sheet = table.get("sheet", False)
    if not isinstance(sheet, bool) and not (
            isinstance(sheet, list) and all(isinstance(word, str) for word in sheet)):
        raise Refusal(f"sheet of '{path}' must be true, false or a list of options of "
                      "scripts/render, such as ['--field', 'strain']")
    settings = settings_of(path, table)
    # As the program's include and Body/File: where the file is.
    return SimpleNamespace(scene=pathlib.Path(path).parent / scene,
                           directory=pathlib.Path(directory), jobs=jobs,
                           settings=settings, names=names_of(settings),
                           plots=plots_of(path, table, settings),
                           sheet=[] if sheet is True else sheet)


def text_of(path, table, key):
    if not isinstance(table.get(key), str) or not table[key]:
        raise Refusal(f"'{path}' has no {key} = '...'")
    return table[key]


def settings_of(path, table):
    """The settings of each run, as texts."""
    if ("grid" in table) == ("run" in table):
        raise Refusal(f"'{path}' must have either a [grid] or [[run]] tables")
    if "grid" in table:
        grid = table["grid"]
        if not isinstance(grid, dict) or not grid:
            raise Refusal(f"the [grid] of '{path}' is empty")
        for name, values in grid.items():
            if not isinstance(values, list) or not values:
                raise Refusal(f"'{name}' in the [grid] of '{path}' must be a list of "
                              "values that is not empty")
        settings = [dict(zip(grid, values)) for values in
                    itertools.product(*grid.values())]
    else:
        settings = table["run"]
        if not isinstance(settings, list) or not settings or \
                not all(isinstance(run, dict) for run in settings):
            raise Refusal(f"the runs of '{path}' must be [[run]] tables")
    settings = [{name: value_text(path, name, value) for name, value in run.items()}
                for run in settings]
    for i, run in enumerate(settings):
        if run in settings[:i]:
            raise Refusal(f"'{path}' has a run twice: {words(run)}")
        if "Output/Directory" in run:
            raise Refusal(f"Output/Directory in '{path}' is chosen by the study")
    return settings


def value_text(path, name, value):
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, (int, float, str)):
        return str(value)
    raise Refusal(f"'{name}' in '{path}' has a value that is neither a number nor a text")


def plots_of(path, table, settings):
    """Pairs of quantities: up, across."""
    plots = table.get("plot", [])
    if not isinstance(plots, list):
        plots = [plots]
    if len(plots) == 2 and all(isinstance(name, str) for name in plots):
        plots = [plots]
    known = {*SUMMARY, *(name for run in settings for name in run)}
    for pair in plots:
        if not isinstance(pair, list) or len(pair) != 2 or \
                not all(isinstance(name, str) for name in pair):
            raise Refusal(f"plot of '{path}' must be a pair of quantities or a list of "
                          "pairs, such as ['mean_force', 'Material/Toughness']")
        for name in pair:
            if name not in known:
                raise Refusal(f"plot of '{path}' names '{name}', which is neither a "
                              f"setting of a run nor one of {', '.join(SUMMARY)}")
    return plots


def words(settings):
    return ", ".join(f"{name} = {value}" for name, value in settings.items()) or \
        "the scene as it is"


def short_names(settings):
    """The parameters' names without their subsections, where that is clear."""
    every = list(dict.fromkeys(name for run in settings for name in run))
    last = [name.rpartition("/")[2] for name in every]
    return {name: short if last.count(short) == 1 else name
            for name, short in zip(every, last)}


def labels_of(settings):
    """What tells each run from the others, for people: the settings that all have, if
    they do, or all of them."""
    short = short_names(settings)
    common = [{name: run[name] for name in run if all(name in other for other in settings)}
              for run in settings]
    distinct = len({repr(run) for run in common}) == len(settings)
    return [", ".join(f"{short[name]} = {value}" for name, value in run.items())
            for run in (common if distinct else settings)]


def names_of(settings):
    """A directory's name for each run, which tells its settings."""
    short = short_names(settings)
    names = []
    for run in settings:
        name = "_".join(f"{slug(short[key])}={slug(value)}"
                        for key, value in run.items()) or "scene"
        if len(name) > LONGEST or name in names:
            digest = hashlib.sha256(repr(sorted(run.items())).encode()).hexdigest()
            name = f"{name[:LONGEST]}_{digest[:8]}"
        names.append(name)
    return names


def slug(text):
    return re.sub(r"[^A-Za-z0-9.+-]+", "_", text.replace("'", "")).strip("_")
