# SPDX-License-Identifier: LGPL-2.1-or-later
"""Labels of arrows, as many as have room."""

import numpy as np

PAD = 1.5  # points around a text that stay free


class Labels:
    """Texts beside arrows in axes; none overlaps another, nor another's arrow."""

    def __init__(self, axes, font_size, **style):
        self.axes, self.style = axes, dict(style, fontsize=font_size)
        self.renderer = axes.figure.canvas.get_renderer()
        self.pad = PAD * axes.figure.dpi / 72
        self.boxes = []

    def place(self, arrows):
        """Label arrows (tip, tail, text), the first ones first; count those that
        have found no room."""
        shafts = [self.axes.transData.transform([tip, tail])
                  for tip, tail, _ in arrows]
        return sum(not self.place_one(i, arrow, shafts)
                   for i, arrow in enumerate(arrows))

    def place_one(self, i, arrow, shafts):
        tip, tail, text = arrow
        drawn = self.axes.annotate(
            text, tail, xytext=away(np.subtract(tail, tip)), annotation_clip=False,
            textcoords="offset points", **self.style)
        others = shafts[:i] + shafts[i + 1:]
        for ha, va in alignments(np.subtract(tail, tip)):
            drawn.set(ha=ha, va=va)
            box = drawn.get_window_extent(self.renderer).padded(self.pad)
            if self.is_free(box, others):
                self.boxes.append(box)
                return True
        drawn.remove()
        return False

    def is_free(self, box, shafts):
        return not any(box.overlaps(other) for other in self.boxes) and \
            not any(crosses(box, *shaft) for shaft in shafts)

    def extents(self):
        """Of the texts without what stays free around them, in pixels."""
        return [box.padded(-self.pad).extents.round(2).tolist()
                for box in self.boxes]


def alignments(back):
    """Where a text goes at an arrow's tail: behind it, or at its sides."""
    if abs(back[1]) >= abs(back[0]):
        behind = ("center", "bottom" if back[1] > 0 else "top")
        return [behind, ("left", behind[1]), ("right", behind[1])]
    side = "left" if back[0] > 0 else "right"
    return [(side, "center"), (side, "bottom"), (side, "top")]


def away(back):
    """A step from an arrow's tail, in points."""
    return PAD * back / max(np.linalg.norm(back), 1e-300)


def crosses(box, start, end):
    """Whether a segment crosses a box."""
    t = np.linspace(0, 1, 60)[:, None]
    points = start + t * (end - start)
    return np.all((points > box.min) & (points < box.max), axis=1).any()
