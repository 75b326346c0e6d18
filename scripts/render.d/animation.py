# SPDX-License-Identifier: LGPL-2.1-or-later
"""Pictures one after the other."""

from PIL import Image

SHOWN = 8.0                    # seconds of an animation that is not short
SHORTEST, LONGEST = 0.12, 1.5  # seconds a frame is shown


def animate(files, name):
    seconds = min(LONGEST, max(SHORTEST, SHOWN / len(files)))
    images = [Image.open(file).convert("RGB") for file in files]
    palette = common_palette(images)
    images = [image.quantize(palette=palette, dither=Image.Dither.NONE)
              for image in images]
    durations = [int(1000 * seconds)] * (len(images) - 1) + [2500]
    images[0].save(name, save_all=True, append_images=images[1:], loop=0,
                   duration=durations)


def common_palette(images):
    """256 colours for all pictures, rare ones as the arrows' among them."""
    few = images[::max(1, len(images) // 4)]
    width, height = (n // 2 for n in few[0].size)
    sheet = Image.new("RGB", (width, height * len(few)))
    for i, image in enumerate(few):
        sheet.paste(image.resize((width, height)), (0, i * height))
    return sheet.quantize(256, method=Image.Quantize.MAXCOVERAGE)
