# SPDX-License-Identifier: LGPL-2.1-or-later
"""The stages of a cut beside each other, as in figure 5 of the paper."""

from math import ceil

from matplotlib import pyplot as plt
from panel import save_small, write
from words import legend, load, stage

PANELS = 8            # at most
WIDTH = 7.1           # inches: a page of two columns
TITLE, CAPTION, FOOT, EDGE = 0.3, 0.36, 0.78, 0.08
MARGIN = 0.05         # around what is seen, of a picture's height
DPI, FINE = 150, 300  # of the picture and of the images in the PDF
SHARES = (0.25, 0.5, 0.75)


def choose(run):
    """The frames that tell the story: of one cut the quarters, of several the
    first, middle and last state of each."""
    frames = list(run.frames)
    of_cut = [[frame for frame in frames if cut_of(run, frame) == cut]
              for cut in run.cuts]
    of_cut = [states for states in of_cut if states]
    if len(of_cut) == 1:
        return sorted({frames[0], *stations(of_cut[0], (0, *SHARES)), frames[-1]})
    for shares in ((0, 0.5), (0.5,)):
        wanted = {frames[0], frames[-1],
                  *(states[-1] for states in of_cut if shares[0] == 0),
                  *(frame for states in of_cut
                    for frame in stations(states, shares))}
        without_ends = wanted - {states[-1] for states in of_cut[:-1]}
        for chosen in (wanted, without_ends):
            if len(chosen) <= PANELS:
                return sorted(chosen)
    return stations(sorted(wanted), [i / (PANELS - 1) for i in range(PANELS)])


def cut_of(run, frame):
    """The cut that a frame belongs to; none, if it is the body at rest."""
    line = run.events(frame)[-1]
    return None if line["event"] == "rest" else line["cut"]


def stations(states, shares):
    """States at shares of the way; what has divided the body is the end."""
    way = states[:-1] if len(states) > 1 else states
    return [way[round(share * (len(way) - 1))] for share in shares]


def draw_film_strip(pictures, name):
    """NAME.png and NAME.pdf; returns what its panels show."""
    run, view = pictures.run, pictures.view
    chosen = choose(run)
    columns = len(chosen) if len(chosen) <= 4 else ceil(len(chosen) / 2)
    rows = ceil(len(chosen) / columns)
    panel = (WIDTH - 2 * EDGE) / columns
    left, right, below, above = window = pictures.window(MARGIN)
    tall = panel * (above - below) / (right - left)
    height = TITLE + rows * (CAPTION + tall) + FOOT
    figure = plt.figure(figsize=(WIDTH, height), dpi=DPI)
    write(figure, EDGE / WIDTH, 1 - 0.2 / height, view["title"], fontsize=10)
    shown = []
    for i, frame in enumerate(chosen):
        row, column = divmod(i, columns)
        x = EDGE + column * panel
        top = height - TITLE - row * (CAPTION + tall)
        axes = figure.add_axes([x / WIDTH, (top - CAPTION - tall) / height,
                                panel / WIDTH, tall / height])
        caption = caption_of(run, view, frame)
        figure.text(x / WIDTH, (top - 0.03) / height,
                    f"({chr(ord('a') + i)}) " + "\n".join(caption), fontsize=8,
                    va="top", linespacing=1.15)
        shown.append({"frame": frame, "caption": caption,
                      "labels": pictures.draw(axes, frame, font_size=7, window=window)})
    draw_foot(figure, pictures, tall / (above - below))
    save_small(figure, f"{name}.png")
    figure.savefig(f"{name}.pdf", dpi=FINE)
    plt.close(figure)
    return shown


def caption_of(run, view, frame):
    second = "pieces drawn apart" if view["frames"][str(frame)]["apart"] \
        else load(run, frame)
    return [text for text in (stage(run, frame), second) if text]


def draw_foot(figure, pictures, picture_height):
    """Scale, colours and what is what, in narrow figures in two lines."""
    width, height = figure.get_size_inches()
    words = legend(pictures.run, pictures.view)
    if width < 6:
        words = words.replace(" Grey", "\nGrey")
    pictures.draw_scale(figure, (2 * EDGE, 0.42), picture_height, 7)
    bar = figure.add_axes([0.58, 0.55 / height, 0.38, 0.08 / height])
    pictures.draw_colours(figure, bar, 7, orientation="horizontal")
    figure.text(EDGE / width, 0.06 / height, words, fontsize=7)
