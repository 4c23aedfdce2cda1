#!/usr/bin/env python3
"""Makes the cloth textures of the R8, 8 bit. Python 3 alone, the same bytes every time.

A picture shows the cloth as one sees it with the luff (or hoist) on the left and the head at the top.
*_alpha: 1 where there is cloth. *_pattern: 0 is colour A, 1 is colour B. The mainsail's pattern has one
channel for each side of the cloth, red to port and green to starboard, so that her letters read from
both; all other pictures are grey."""

import math
import os
import sys

sys.dont_write_bytecode = True

import png  # noqa: E402

HERE = os.path.dirname(os.path.abspath(__file__))
HOIST = 9.33  # metres; the height of the mainsail in the picture


def chord(v):
    """Breadth of the mainsail at height v (0 foot, 1 head), m: nearly that of make_r8.py."""
    return 3.70 + (0.32 - 3.70) * v + 0.41 * v**0.95 * (1.0 - v) ** 0.62


def segment(x, y, ax, ay, bx, by):
    t = ((x - ax) * (bx - ax) + (y - ay) * (by - ay)) / ((bx - ax) ** 2 + (by - ay) ** 2)
    t = min(max(t, 0.0), 1.0)
    return math.hypot(x - ax - t * (bx - ax), y - ay - t * (by - ay))


def emblem(x, y):
    """Distance to the strokes of "R8", each letter 0.6 wide and 1 high, R from x = 0."""
    d = min(segment(x, y, 0, 0, 0, 1), segment(x, y, 0, 1, 0.3, 1), segment(x, y, 0, 0.5, 0.3, 0.5),
            segment(x, y, 0.22, 0.5, 0.56, 0))
    d = min(d, abs(math.hypot(x - 0.3, y - 0.75) - 0.25) if x >= 0.3 else 9.0)
    d = min(d, abs(math.hypot(x - 1.22, y - 0.76) - 0.24), abs(math.hypot(x - 1.22, y - 0.26) - 0.26))
    return d


BATTENS = (0.30, 0.47, 0.64, 0.80)  # heights at the leech


def main_pattern(u, v, starboard):
    x, y = u * chord(v), v * HOIST
    from_leech = chord(v) - x
    shade = 0.0
    # Cross-cut cloths, square to the leech: seams drop toward the luff.
    along = (y + 0.33 * from_leech) / 0.92
    seam = abs(along - round(along)) * 0.92
    if seam < 0.014:
        shade = 0.16
    # Two reefs: a row of points between two patches, and a band.
    for reef in (1.55, 2.95):
        if abs(y - reef) < 0.03:
            shade = max(shade, 0.10)
        if math.hypot((x + 0.35) % 0.7 - 0.35, y - reef) < 0.035 and 0.4 < x < chord(v) - 0.4:
            shade = max(shade, 0.75)
        if math.hypot(x, y - reef) < 0.22 or math.hypot(from_leech, y - reef) < 0.30:
            shade = max(shade, 0.13)
    # Corner patches, batten pockets, luff and leech tapes.
    if math.hypot(x, y) < 0.55 or math.hypot(from_leech, y) < 0.75 or HOIST - y < 0.35:
        shade = max(shade, 0.11)
    for batten in BATTENS:
        level = batten * HOIST - 0.18 * from_leech
        if abs(y - level) < 0.035 and from_leech < (1.45 if batten < 0.7 else 3.0):
            shade = max(shade, 0.22 if abs(y - level) > 0.018 else 0.12)
    if x < 0.05 or from_leech < 0.035:
        shade = max(shade, 0.14)
    # Class emblem, and a stripe that follows the seams under it.
    ex, ey = (x - 0.40) / 0.68, (y - 5.42) / 0.68
    if emblem(1.48 - ex if starboard else ex, ey) < 0.085:
        shade = 1.0
    if abs(y - 5.17) < 0.040 and 0.30 < x < 1.52:
        shade = 1.0
    # A draught stripe, to read the belly by.
    if abs(y - 0.52 * HOIST) < 0.022 and x > 0.06:
        shade = max(shade, 0.55)
    return shade


def main_alpha(u, v):
    """The leech is hollow between the battens; the corners are rounded."""
    x, y = u * chord(v), v * HOIST
    edges = (0.0,) + BATTENS + (1.0,)
    hollow = 0.0
    for low, high in zip(edges, edges[1:]):
        if low <= v <= high:
            hollow = 0.030 * math.sin(math.pi * (v - low) / (high - low))
    return 1.0 if chord(v) - x > hollow and HOIST - y > 0.04 * min(x / 0.32, 1.0) ** 4 else 0.0


def jib_pattern(u, v):
    breadth, height = 3.3 * (1.0 - v) + 0.07, 8.7
    x, y = u * breadth, v * height
    shade = 0.0
    along = (y + 0.45 * u * (1.0 - v)) / 0.92
    if abs(along - round(along)) * 0.92 < 0.014:
        shade = 0.16
    if math.hypot(x, y) < 0.5 or math.hypot(breadth - x, y) < 0.7 or height - y < 0.4:
        shade = max(shade, 0.11)
    if x < 0.06 or breadth - x < 0.035 or y < 0.03:
        shade = max(shade, 0.16)
    for level in (0.30, 0.56):  # telltales, a pair of ribbons by the luff
        if abs(y - level * height) < 0.016 and 0.28 < x < 0.52:
            shade = 1.0
        if abs(y - (level + 0.006) * height) < 0.022 and x > 0.06:
            shade = max(shade, 0.40)
    return shade


def flag_pattern(u, v):
    """The horizon seen from the shore: a sun half up, and two waves."""
    x, y = u * 1.5, v
    shade = 0.0
    if y > 0.42 and math.hypot(x - 0.56, y - 0.42) < 0.27:
        shade = 1.0
    for level in (0.14, 0.28):
        if abs(y - level - 0.028 * math.sin(2 * math.pi * x / 0.36 + 9.0 * level)) < 0.030:
            shade = 1.0
    if abs(y - 0.40) < 0.018:
        shade = 1.0
    return shade


def flag_alpha(u, v):
    return 1.0 if (1.0 - u) * 1.5 > 0.30 * (1.0 - abs(2.0 * v - 1.0)) else 0.0


def render(name, functions, width, height, samples=3):
    """One function: a grey picture. More: one channel each, the rest black."""
    rows = []
    channels = 1 if len(functions) == 1 else 3
    for row in range(height):
        line = []
        for column in range(width):
            totals = [0.0] * channels
            for j in range(samples):
                for i in range(samples):
                    u = (column + (i + 0.5) / samples) / width
                    v = 1.0 - (row + (j + 0.5) / samples) / height
                    for channel, function in enumerate(functions):
                        totals[channel] += function(u, v)
            line += [int(255.0 * total / samples**2 + 0.5) for total in totals]
        rows.append(line)
    png.write(os.path.join(HERE, name + ".png"), width, height, channels, rows)


def main():
    render("main_pattern", [lambda u, v: main_pattern(u, v, False), lambda u, v: main_pattern(u, v, True)],
           256, 512)
    render("main_alpha", [main_alpha], 128, 256)
    render("jib_pattern", [jib_pattern], 256, 512)
    render("flag_pattern", [flag_pattern], 192, 128)
    render("flag_alpha", [flag_alpha], 192, 128)


if __name__ == "__main__":
    main()
