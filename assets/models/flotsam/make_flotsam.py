#!/usr/bin/env python3
"""Makes flotsam.glb: an oil barrel, a crate and a raft. Python 3 alone, the same bytes every time.

Each node is in the frame of its floating body (engine/boat/floating_body.cpp): y up, z along, metres;
the barrel lies on its side about its axis, crate and raft have their bottom at y = 0."""

import math
import os
import sys

sys.dont_write_bytecode = True
HERE = os.path.dirname(os.path.abspath(__file__))
sys.path[:0] = [os.path.join(HERE, "..", "r8"), os.path.join(HERE, "..", "..", "textures")]

from glb import Node, Writer  # noqa: E402
from shapes import box, polygon, surface, tube  # noqa: E402


def make_barrel(node):
    """0.88 m long, 0.29 m in radius: a steel drum with two rolling hoops."""
    paint, steel = node.part("paint"), node.part("rust")
    radius, half = 0.286, 0.44
    profile = [(-half, radius - 0.004), (-half + 0.015, radius + 0.006), (-half + 0.03, radius)]
    for hoop in (-0.15, 0.15):
        profile += [(hoop - 0.03, radius), (hoop, radius + 0.012), (hoop + 0.03, radius)]
    profile += [(half - 0.03, radius), (half - 0.015, radius + 0.006), (half, radius - 0.004)]
    ring = lambda r, z: [(r * math.cos(a), r * math.sin(a), z)
                         for a in (2 * math.pi * k / 32 for k in range(32))]
    surface(paint, [ring(r, z) for z, r in profile], wrap_v=True, flip=True)
    for way in (-1, 1):
        z = way * (half - 0.02)
        polygon(steel, ring(radius - 0.004, z), (0.0, 0.0, way))
        surface(steel, [ring(radius - 0.004, z), ring(radius - 0.004, way * half)], wrap_v=True, flip=way > 0)
        tube(steel, [(0.0, 0.19, z), (0.0, 0.19, z + way * 0.02)], 0.035, sides=12)


def make_crate(node):
    """1.2 by 0.8 by 0.7 m, boarded, with battens at the corners and a diagonal on each long side."""
    wood, edge = node.part("plank"), node.part("batten")
    x, h, z, gap = 0.40, 0.70, 0.60, 0.006
    box(wood, (-x + 0.02, 0.02, -z + 0.02), (x - 0.02, h - 0.02, z - 0.02))
    for k in range(5):
        low, high = h * k / 5 + gap, h * (k + 1) / 5 - gap
        for side in (-1, 1):
            a, b = sorted((side * (x - 0.02), side * (x - 0.006)))
            box(wood, (a, low, -z + 0.01), (b, high, z - 0.01))
            a, b = sorted((side * (z - 0.02), side * (z - 0.006)))
            box(wood, (-x + 0.01, low, a), (x - 0.01, high, b))
    for k in range(6):
        low, high = -z + 2 * z * k / 6 + gap, -z + 2 * z * (k + 1) / 6 - gap
        box(wood, (-x + 0.01, h - 0.02, low), (x - 0.01, h - 0.006, high))
    for sx in (-1, 1):
        for sz in (-1, 1):
            a, b = sorted((sx * (x - 0.09), sx * x))
            c, d = sorted((sz * (z - 0.09), sz * z))
            box(edge, (a, 0.0, c), (b, h, d))
        a, b = sorted((sx * (x - 0.02), sx * (x + 0.004)))
        for low in (0.0, h - 0.09):
            box(edge, (a, low, -z), (b, low + 0.09, z))
    for sz in (-1, 1):
        a, b = sorted((sz * (z - 0.02), sz * (z + 0.004)))
        for low in (0.0, h - 0.09):
            box(edge, (-x, low, a), (x, low + 0.09, b))
    for side in (-1, 1):
        for y0, y1 in ((0.10, 0.60),):
            tube(edge, [(side * (x - 0.002), y0, -0.5), (side * (x - 0.002), y1, 0.5)], 0.022, sides=4)


def make_raft(node):
    """3 by 2 m: seven logs under four cross timbers, lashed."""
    wood, dark = node.part("log"), node.part("rope")
    radius = 0.125
    for k in range(7):
        x = -0.86 + 1.72 * k / 6
        reach = 1.5 - 0.05 * ((k * 5) % 3)
        path = [(x, radius + 0.004 * ((k * 3) % 4), -reach + 2 * reach * i / 6) for i in range(7)]
        tube(wood, path, [radius * (1.0 + 0.04 * math.sin(2.1 * k + i)) for i in range(7)], sides=12)
    for z in (-1.15, -0.4, 0.4, 1.15):
        tube(node.part("batten"), [(-0.98, 0.285, z), (0.98, 0.285, z)], 0.05, sides=10)
        for k in range(7):
            x = -0.86 + 1.72 * k / 6
            tube(dark, [(x - 0.06, 0.24, z - 0.06), (x, 0.345, z), (x + 0.06, 0.24, z + 0.06)], 0.014, sides=6)
            tube(dark, [(x + 0.06, 0.24, z - 0.06), (x, 0.345, z), (x - 0.06, 0.24, z + 0.06)], 0.014, sides=6)


def material(name, colour, roughness, metallic=0.0):
    return {"name": name, "pbrMetallicRoughness": {"baseColorFactor": list(colour) + [1.0],
                                                   "metallicFactor": metallic, "roughnessFactor": roughness}}


MATERIALS = [
    material("paint", (0.035, 0.10, 0.22), 0.38),
    material("rust", (0.20, 0.085, 0.045), 0.75, 0.2),
    material("plank", (0.40, 0.27, 0.15), 0.80),
    material("batten", (0.30, 0.19, 0.10), 0.80),
    material("log", (0.24, 0.165, 0.10), 0.90),
    material("rope", (0.42, 0.34, 0.20), 0.95),
]


def main():
    root = Node("flotsam")
    make_barrel(root.add(Node("barrel")))
    make_crate(root.add(Node("crate")))
    make_raft(root.add(Node("raft")))
    out = os.path.join(HERE, "flotsam.glb")
    Writer(MATERIALS, {}).write(out, root, {"title": "Barrel, crate and raft", "licence": "MIT"})
    print("%s: %d triangles, %d bytes" % (os.path.basename(out), root.triangles(), os.path.getsize(out)))


if __name__ == "__main__":
    main()
