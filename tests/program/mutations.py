# SPDX-License-Identifier: LGPL-2.1-or-later
"""Changes of scenes and of files of bodies, as people, editors and converters make
them, or as chance does. Each is a function of a generator of random numbers and of
a text; where it finds nothing to change it gives the text as it is."""

import math
import re

NUMBER = re.compile(r"(?<![\w.])[-+]?\d+\.?\d*(?:[eE][-+]?\d+)?")
TEXTS = ["0", "-1", "1", "0.5", "1e-300", "1e300", "-1e300", "1e400", "nan", "inf",
         "4294967296", "-9223372036854775809", "1e9", "", "x", ";", ",", ":", "all",
         "0:0", "#", "\\", "'", '"', "%s%n", "\0", "\t", "é", "../..", "{", "}"]
WORDS = ["bottom", "top", "left", "inner", "drop", "hold", "none", "file", "box",
         "ramp", "direct", "iterative", "element row", "stages", "true", "every row"]
# What word processors, web pages and other keyboards make of characters.
LOOK_ALIKE = {"-": "−–—‐", "'": "’‘′", '"': "“”„«", " ": "\u00a0\u3000\u2009\u200b\u202f",
              ",": "，、‚", ":": "：∶", ";": "；;", "=": "＝", "(": "（", "*": "×∗", ".": "。．",
              "0": "０O", "1": "１l", "2": "２²", "x": "х×", "\n": "\u2028\u0085"}
SECTIONS = ("Nodes", "Elements", "PhysicalNames", "Entities", "MeshFormat")
GROUP = re.compile(r'^(\d) (\d+) "(.*)"$', re.M)
PHYSICAL = re.compile(r'Physical (\w+)\((?:"([^"]*)"(?:, *)?)?(\d*)\)')


def mutated_number(generator, match):
    value = float(match.group())
    choices = [value * 2, value / 2, -value, value + 1, value - 1, 0]
    if generator.random() < 0.4:
        return generator.choice(TEXTS)
    changed = generator.choice(choices)
    if not math.isfinite(changed):
        return repr(changed)
    return str(int(changed)) if changed == int(changed) else repr(changed)


def replaced(text, match, new):
    return text[: match.start()] + new + text[match.end() :]


def any_match(generator, pattern, text):
    matches = list(re.finditer(pattern, text))
    return generator.choice(matches) if matches else None


def of_lines(change):
    """A change of two lines as one of a text."""
    def mutation(generator, text):
        lines = text.splitlines(keepends=True) or ["\n"]
        i, j = (generator.randrange(len(lines)) for _ in range(2))
        change(lines, i, j)
        return "".join(lines)

    return mutation


@of_lines
def remove_line(lines, i, _):
    del lines[i]


@of_lines
def repeat_line(lines, i, j):
    lines.insert(j, lines[i])


@of_lines
def exchange_lines(lines, i, j):
    lines[i], lines[j] = lines[j], lines[i]


def cut_off(generator, text):
    return text[: generator.randrange(len(text) + 1)]


def flip_bit(generator, text):
    if not text:
        return text
    position = generator.randrange(len(text))
    flipped = chr(ord(text[position]) ^ (1 << generator.randrange(7)))
    return text[:position] + flipped + text[position + 1 :]


def change_value(generator, text):
    match = any_match(generator, r"=[^\n]*", text)
    return replaced(text, match, "= " + generator.choice(TEXTS + WORDS)) if match else text


def change_number(generator, text):
    match = any_match(generator, NUMBER, text)
    return replaced(text, match, mutated_number(generator, match)) if match else text


def look_alike(generator, text):
    """A character, or all of its kind, as another that looks alike."""
    found = sorted(set(text) & set(LOOK_ALIKE))
    if not found:
        return text
    character = generator.choice(found)
    other = generator.choice(LOOK_ALIKE[character])
    if generator.random() < 0.3:
        return text.replace(character, other)
    match = any_match(generator, re.escape(character), text)
    return replaced(text, match, other)


def decimal_commas(generator, text):
    """Points of numbers as commas: of one, or of all."""
    if generator.random() < 0.5:
        return re.sub(r"(?<=\d)\.(?=\d)", ",", text)
    match = any_match(generator, r"(?<=\d)\.(?=\d)", text)
    return replaced(text, match, ",") if match else text


def byte_order_mark(generator, text):
    """A mark at the beginning, as Windows' editors write it, or where files that have
    one were joined."""
    if generator.random() < 0.7:
        return "\ufeff" + text
    return replaced(text, any_match(generator, r"(?m)^", text), "\ufeff")


def line_ends(generator, text):
    """Line ends of another system, of all lines or of one."""
    other = generator.choice(["\r\n", "\r", "\n\r"])
    if generator.random() < 0.6:
        return text.replace("\n", other)
    match = any_match(generator, r"\n", text)
    return replaced(text, match, other) if match else text


def equal_groups(generator, text):
    """A group with the number, the name or the dimension of another one."""
    pattern = GROUP if "$PhysicalNames" in text else PHYSICAL
    one, other = (any_match(generator, pattern, text) for _ in range(2))
    if not one:
        return text
    parts, others = list(one.groups()), other.groups()
    i = generator.randrange(3)
    parts[i] = others[i]
    if pattern is GROUP:
        return replaced(text, one, f'{parts[0]} {parts[1]} "{parts[2]}"')
    name = [f'"{parts[1]}"'] if parts[1] is not None else []
    number = [parts[2]] if parts[2] else []
    return replaced(text, one, f"Physical {parts[0]}({', '.join(name + number)})")


def section_of(generator, text):
    """A section of a mesh, or a subsection of a scene."""
    return any_match(generator, r"(?ms)^\$(%s)\n.*?^\$End\1\n" % "|".join(SECTIONS),
                     text) or any_match(generator, r"(?ms)^subsection .*?^end\n", text)


def repeat_section(generator, text):
    """A section twice: behind itself, at the end, or in halves."""
    match = section_of(generator, text)
    if not match:
        return text
    section = match.group()
    kind = generator.randrange(3)
    if kind == 0:
        return replaced(text, match, section + section)
    if kind == 1:
        return text + section
    lines = section.splitlines(keepends=True)
    half = generator.randrange(1, len(lines))
    return replaced(text, match, "".join(lines[:half] + lines[-1:] + lines[:2]
                                         + lines[half:]))


def move_section(generator, text):
    """A section at the end, or not at all."""
    match = section_of(generator, text)
    if not match:
        return text
    rest = replaced(text, match, "")
    return rest + (match.group() if generator.random() < 0.7 else "")


def wrong_count(generator, text):
    """A count of a section that is more or less by one."""
    match = any_match(generator, r"(?m)(\$(?:%s)\n)([\d ]+)$" % "|".join(SECTIONS[:4]),
                      text)
    if not match:
        return text
    words = match.group(2).split()
    i = generator.randrange(len(words))
    words[i] = str(max(0, int(words[i]) + generator.choice((-1, 1))))
    return replaced(text, match, match.group(1) + " ".join(words))


def with_node_twice(generator, text):
    """The section of nodes with one of them there twice: its number, that of the copy,
    and the section."""
    lines = text.splitlines()
    header = lines[0].split()
    if len(header) == 1:
        nodes = [line for line in lines[1:] if line.split()]
        node = generator.choice(nodes).split()
        new = str(max(int(line.split()[0]) for line in nodes) + 1)
        return node[0], new, [str(len(nodes) + 1), *nodes, " ".join([new, *node[1:]])]
    begin, block, largest = 1, 1, 0
    for _ in range(int(header[0])):
        size = int(lines[begin].split()[3])
        if size > largest:
            block, largest = begin, size
        begin += 1 + 2 * size
    i = generator.randrange(largest)
    new = str(int(header[3]) + 1)
    tags = lines[block + 1 : block + 1 + largest]
    places = lines[block + 1 + largest : block + 1 + 2 * largest]
    head = lines[block].split()
    changed = [" ".join([header[0], str(int(header[1]) + 1), header[2], new]),
               *lines[1:block], " ".join([*head[:3], str(largest + 1)]), *tags, new,
               *places, places[i], *lines[block + 1 + 2 * largest :]]
    return tags[i], new, changed


def double_node(generator, text):
    """A node twice, and an element that has the copy of it."""
    match = re.search(r"(?ms)^\$Nodes\n(.*?)^\$EndNodes\n", text)
    if not match:
        return text
    try:
        old, new, lines = with_node_twice(generator, match.group(1))
    except (IndexError, ValueError):
        # The section is damaged already.
        return text
    text = replaced(text, match, "\n".join(["$Nodes", *lines, "$EndNodes", ""]))
    head, sign, elements = text.partition("$Elements\n")
    line = any_match(generator, rf"(?m)^\d+ [\d ]*\b{old}\b[\d ]*$", elements)
    if not line:
        return text
    words = line.group().split()
    at = len(words) - 1 - words[::-1].index(old)
    words[at] = new
    return head + sign + replaced(elements, line, " ".join(words))


MUTATIONS = [remove_line, repeat_line, exchange_lines, cut_off, flip_bit, change_value,
             change_number, change_number, change_number, change_number, look_alike,
             decimal_commas, byte_order_mark, line_ends, repeat_section, move_section]
# What changes groups and the sections of meshes.
OF_BODIES = [equal_groups, wrong_count, double_node]


def mutate(generator, text, is_body=False):
    """One change of a text."""
    kinds = MUTATIONS + 2 * OF_BODIES if is_body else MUTATIONS
    return generator.choice(kinds)(generator, text)
