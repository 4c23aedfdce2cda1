#!/usr/bin/env python3
"""Makes r8.glb: the R8, an 8 m keelboat. Run it anywhere; Python 3 alone, the same bytes every time.

Boat frame: x starboard, y up, z aft, metres; origin on the centreline, on the design waterline, in
the middle of its length. README.md lists the nodes and their axes."""

import math
import os
import sys

sys.dont_write_bytecode = True
HERE = os.path.dirname(os.path.abspath(__file__))
sys.path[:0] = [HERE, os.path.join(HERE, "..", "..", "textures")]

from gear import make_gear  # noqa: E402
from glb import Node, Writer  # noqa: E402
from shapes import (Spline, add, box, foil, frames, grid, lathe, lerp, mix, polygon, quad, scale,  # noqa: E402
                    smooth, sub, surface, sweep, tube, unit)

# ---- dimensions ----------------------------------------------------------------------------------
BOW, STERN = -3.97, 4.03           # z of the stem head and of the transom's lower edge: LOA 8.0
MAST_Z = -0.60                     # the mast's axis, and the axis of boom and mainsail
MAST_TOP = 11.2
GOOSENECK = 1.62
TACK = (0.0, 1.16, -3.70)          # jib tack, on the forestay
HOUNDS = (0.0, 10.1, MAST_Z - 0.06)
STOCK_Z = 3.02                     # the rudder's stock
COCKPIT = (1.10, 3.50)             # fore and aft ends of the well
COCKPIT_HALF = 0.70
ROOF = (-1.95, 1.10)               # fore and aft ends of the coachroof
MAIN_AREA, JIB_AREA = 20.0, 14.0


def teak_uv(p):
    return (p[0] / 0.36, p[2] / 1.6)


# ---- hull lines ----------------------------------------------------------------------------------
half_beam = Spline([(0.0, 0.0), (0.2, 0.615), (0.45, 1.115), (0.66, 1.25), (0.85, 1.175), (1.0, 1.0)])
rocker = Spline([(-3.05, -0.120), (-2.2, -0.247), (-1.0, -0.327), (0.1, -0.34), (1.4, -0.288),
                 (2.5, -0.162), (3.35, 0.0), (4.03, 0.145)])
STEM_FOOT, STEM_CORNER = (-3.05, -0.120), (-3.56, -0.060)


def sheer(t):
    """Height of the deck's edge at t, 0 bow to 1 stern: one sweep, lowest abaft the middle."""
    return 0.81 + (0.22 * ((0.7 - t) / 0.7) ** 2 if t < 0.7 else 0.055 * ((t - 0.7) / 0.3) ** 2)


def station(t):
    """The section that meets the sheer at t: a function w (0 keel to 1 sheer) → (x, y, z)."""
    top_z = BOW + t * (3.80 - BOW)
    top_y, beam = sheer(t), half_beam(t)
    foot_z = lerp(STEM_FOOT[0], STERN, t ** 1.02)
    foot_y = rocker(foot_z)
    # The stem is a curve from the forefoot to the stem head; within the first sixth of the length
    # the sections straighten.
    bend = (1.0 - smooth(t / 0.16)) if t < 0.16 else 0.0
    middle = ((foot_z + top_z) / 2, (foot_y + top_y) / 2)
    corner = (lerp(middle[0], STEM_CORNER[0], bend), lerp(middle[1], STEM_CORNER[1], bend))
    # Sections: V forward, U amidships, flat-floored aft.
    fill = smooth(t / 0.5)
    p = lerp(1.06, 3.0, fill)
    q = lerp(1.2, 2.6, smooth(t / 0.46)) + 0.45 * smooth((t - 0.6) / 0.4)

    def at(w):
        a, b, c = (1 - w) ** 2, 2 * w * (1 - w), w * w
        y = a * foot_y + b * corner[1] + c * top_y
        z = a * foot_z + b * corner[0] + c * top_z
        v = min(max((y - foot_y) / (top_y - foot_y), 0.0), 1.0)
        x = beam * (1.0 - (1.0 - v) ** p) ** (1.0 / q)
        return (max(x, 0.0), y, z)

    return at


def solve(at, y):
    """The w at which a section reaches height y, clamped to its ends."""
    low, high = 0.0, 1.0
    if at(0.0)[1] >= y:
        return 0.0
    if at(1.0)[1] <= y:
        return 1.0
    for _ in range(50):
        mid = (low + high) / 2
        low, high = (mid, high) if at(mid)[1] < y else (low, mid)
    return (low + high) / 2


def boot_line(t):
    """The boot-top's lower edge, a little higher at the ends, as the eye wants it."""
    return 0.045 + 0.07 * max(0.0, 0.45 - t) ** 2 / 0.2 + 0.015 * max(0.0, t - 0.7) / 0.3


BANDS = [("antifouling", 9), ("boot", 1), ("topsides", 7), ("boot", 1), ("topsides", 1)]


def hull_section(t):
    """Half a section as points from keel to sheer, and the material of each strip."""
    at = station(t)
    edges = [0.0, solve(at, boot_line(t)), solve(at, boot_line(t) + 0.065),
             solve(at, sheer(t) - 0.150), solve(at, sheer(t) - 0.125), 1.0]
    points = []
    for band, (_, count) in enumerate(BANDS):
        for k in range(count):
            f = k / count
            f = f * f if band == 0 else f  # crowd the points where the bilge is round
            points.append(at(lerp(edges[band], edges[band + 1], f)))
    return points + [at(1.0)]


def stations(count):
    # Closer together at the stem, where the lines bend most.
    return [(i / count) ** 1.25 for i in range(count + 1)]


def hull_rings(count):
    rings = []
    for t in stations(count):
        half = hull_section(t)
        rings.append([(-x, y, z) for x, y, z in reversed(half)] + half[1:])
    return rings


def make_hull(node, rings):
    half = [name for name, count in BANDS for _ in range(count)]
    strips = list(reversed(half)) + half
    grid(lambda j: node.part(strips[j]), rings, flip=True)
    # The transom: varnished, bulged a little aft, closing the last section.
    last = rings[-1]
    middle = len(last) // 2
    rows = []
    for k in range(middle + 1):
        port, starboard = last[middle - k], last[middle + k]
        bulge = 0.05 * smooth(k / middle * 2.0)
        rows.append([add(mix(port, starboard, s / 12), (0.0, 0.0, bulge * (1 - (s / 6 - 1) ** 2)))
                     for s in range(13)])
    surface(node.part("varnish"), rows, flip=True)
    # Rubbing strake: a half-round along the topsides, under the rail.
    for side in (-1, 1):
        path = []
        for t in stations(36):
            at = station(max(t, 0.004))
            x, y, z = at(solve(at, sheer(t) - 0.035))
            path.append((side * (x + 0.006), y, z))
        tube(node.part("varnish"), path, 0.016, sides=5)


def make_mask(node, count=20):
    """A closed, coarse hull with a lid at deck level: where no water may be seen. Not to be drawn."""
    rings = []
    for t in stations(count):
        at = station(t)
        half = [at(w) for w in (0.0, 0.03, 0.1, 0.22, 0.4, 0.7, 1.0)]
        rings.append([(-x, y, z) for x, y, z in reversed(half)] + half[1:])
    closed = [r + [(0.0, r[0][1], r[0][2])] for r in rings]  # the lid: over the centreline
    part = node.part("topsides")
    surface(part, closed, wrap_v=True, flip=True)
    for ring, way in ((closed[0], -1.0), (closed[-1], 1.0)):
        polygon(part, ring, (0.0, 0.0, way))


# ---- deck ----------------------------------------------------------------------------------------
def deck_z(t):
    return station(t)(1.0)[2]


def deck_t(z):
    return min(max((z - BOW) / (3.80 - BOW), 0.0), 1.0)


def deck_y(x, z):
    t = deck_t(z)
    beam = max(half_beam(t), 1e-6)
    return sheer(t) + 0.055 * beam * (1.0 - min(abs(x) / beam, 1.0) ** 2)


def make_deck_plate(node):
    part, margin = node.part("teak"), node.part("varnish")
    cuts = sorted(set([BOW + 0.02 + i * (3.80 - BOW - 0.02) / 32 for i in range(33)] + list(COCKPIT)))

    def strip(zs, inner):
        for side in (-1, 1):
            rows = []
            for z in zs:
                edge = half_beam(deck_t(z))
                inside = min(inner, edge)
                plank = max(edge - 0.09, inside)
                xs = [lerp(inside, plank, k / 4) for k in range(5)] + [edge]
                rows.append([(side * x, deck_y(x, z), z) for x in xs])
            grid(lambda j: part if j < 4 else margin, rows, flip=side < 0,
                 uv=lambda i, j, r=rows: teak_uv(r[i][j]))

    fore, aft = COCKPIT
    strip([z for z in cuts if z <= fore], 0.0)
    strip([z for z in cuts if fore <= z <= aft], COCKPIT_HALF)
    strip([z for z in cuts if z >= aft], 0.0)
    # Toe rail: varnished, on the deck's edge, with a gap of nothing to catch the water: it tapers out
    # at the quarter.
    for side in (-1, 1):
        path = [(side * (half_beam(t) - 0.012), sheer(t) - 0.01, deck_z(t))
                for t in [0.006 + 0.994 * i / 40 for i in range(41)]]
        sweep(margin, path, [(-0.014, 0.0), (0.014, 0.0), (0.011, 0.062), (-0.011, 0.062)])
    # Taffrail across the transom's top.
    edge = half_beam(1.0)
    path = [(lerp(-edge, edge, k / 12), deck_y(lerp(-edge, edge, k / 12), 3.80) - 0.01,
             3.80 + 0.05 * (1 - (k / 6 - 1) ** 2)) for k in range(13)]
    sweep(margin, path, [(-0.022, 0.0), (0.022, 0.0), (0.018, 0.05), (-0.018, 0.05)])


def make_cockpit(node):
    gel, teak = node.part("gelcoat"), node.part("teak")
    fore, aft = COCKPIT
    seat_y, sole_y, seat_x, half = 0.56, 0.24, 0.33, COCKPIT_HALF
    bench_aft = 2.72
    for side in (-1, 1):
        # Side of the well, from the deck down to the seat.
        zs = [lerp(fore, aft, k / 12) for k in range(13)]
        wall = [[(side * half, deck_y(half, z), z), (side * half, seat_y, z)] for z in zs]
        surface(gel, wall, flip=side > 0)
        seat = [[(side * x, seat_y, z) for x in (half, seat_x)] for z in (fore, aft)]
        surface(teak, seat, flip=side > 0, uv=lambda i, j, s=seat: teak_uv(s[i][j]))
        front = [[(side * seat_x, y, z) for y in (seat_y, sole_y)] for z in (fore, bench_aft)]
        surface(gel, front, flip=side > 0)
    # Sole, the thwart over the rudder's stock, and the two bulkheads.
    p = lambda x, y, z: (x, y, z)
    quad(teak, p(-seat_x, sole_y, bench_aft), p(seat_x, sole_y, bench_aft), p(seat_x, sole_y, fore),
         p(-seat_x, sole_y, fore), teak_uv)
    quad(teak, p(-seat_x, seat_y, aft), p(seat_x, seat_y, aft), p(seat_x, seat_y, bench_aft),
         p(-seat_x, seat_y, bench_aft), teak_uv)
    quad(gel, p(seat_x, sole_y, bench_aft), p(-seat_x, sole_y, bench_aft), p(-seat_x, seat_y, bench_aft),
         p(seat_x, seat_y, bench_aft))
    for z, flip in ((fore, False), (aft, True)):
        xs = [lerp(-half, half, k / 8) for k in range(9)]
        wall = [[(x, 0.24, z), (x, deck_y(x, z), z)] for x in xs]
        surface(gel, wall, flip=flip)
    # Coaming: varnished boards that lean outboard, joined round the after end.
    path, count = [], 10
    for side in (-1, 1):
        leg = [(side * (half + 0.035), z) for z in [lerp(fore - 0.06, aft - 0.25, k / count)
                                                   for k in range(count + 1)]]
        corner = [(side * (half + 0.035 - 0.22 * (1 - math.cos(a))), aft - 0.25 + 0.28 * math.sin(a))
                  for a in (math.pi / 2 * k / 5 for k in range(1, 6))]
        leg += corner
        path.append(leg)
    outline = path[0] + list(reversed(path[1]))
    rail = []
    for x, z in outline:
        rail.append((x, deck_y(min(abs(x), half), z) - 0.01, z))
    height = 0.165
    sweep(node.part("varnish"), rail,
          [(-0.016, 0.0), (0.016, 0.0), (0.016 - 0.03, height), (-0.016 - 0.03, height)])
    cap = [add(r, (0.0, height, 0.0)) for r in rail]
    sweep(node.part("varnish"), cap,
          [(-0.062, 0.0), (0.002, 0.0), (0.002, 0.022), (-0.062, 0.022)])


# ---- coachroof -----------------------------------------------------------------------------------
def roof(z, a):
    """The coachroof's surface: z along, a from 0 (starboard foot) to pi (port foot)."""
    f = (z - ROOF[0]) / (ROOF[1] - ROOF[0])
    height = 0.36 * math.sqrt(max(1.0 - (1.0 - min(f / 0.55, 1.0)) ** 2.2, 0.0)) * lerp(0.98, 1.04, f)
    half = 0.70 * (1.0 - (1.0 - min(f / 0.95, 1.0)) ** 2.0) ** 0.62
    n = 4.2
    cx, sx = math.cos(a), math.sin(a)
    x = half * math.copysign(abs(cx) ** (2.0 / n), cx)
    # Crowned a little more than the deck; the foot is sunk into the deck.
    y = deck_y(half, z) - 0.02 + (height + 0.02) * abs(sx) ** (2.0 / n)
    y += 0.05 * (height / 0.36) * (1.0 - (x / max(half, 1e-6)) ** 2)
    # The sides lean inboard.
    x *= 1.0 - 0.10 * (abs(sx) ** (2.0 / n)) * (height / 0.36)
    return (x, y, z)


def roof_patch(part, z_of, a_of, rows, cols, lift=0.006, flip=False):
    """A patch that floats just above the roof: z_of(r, s), a_of(r, s) for r, s in 0 to 1."""
    points = []
    for i in range(rows + 1):
        row = []
        for j in range(cols + 1):
            z, a = z_of(i / rows, j / cols), a_of(i / rows, j / cols)
            e = 1e-3
            du, dv = sub(roof(z + e, a), roof(z - e, a)), sub(roof(z, a + e), roof(z, a - e))
            normal = unit((du[1] * dv[2] - du[2] * dv[1], du[2] * dv[0] - du[0] * dv[2],
                           du[0] * dv[1] - du[1] * dv[0]))
            outward = 1.0 if normal[1] + 0.3 * math.copysign(1, math.cos(a)) * normal[0] > 0 else -1.0
            row.append(add(roof(z, a), scale(normal, lift * outward)))
        points.append(row)
    surface(part, points, flip=flip)


def make_coachroof(node):
    gel, varnish, window = node.part("gelcoat"), node.part("varnish"), node.part("window")
    fore, aft = ROOF
    zs = [fore + 0.004 + (aft - fore - 0.004) * (k / 22) ** 1.5 for k in range(23)]
    arc = [math.pi * k / 24 for k in range(25)]
    surface(gel, [[roof(z, a) for a in arc] for z in zs], flip=True)
    # After bulkhead with the companionway's washboards.
    foot = [roof(aft, a) for a in arc]
    polygon(gel, foot, (0.0, 0.0, 1.0))
    top = roof(aft, math.pi / 2)[1]
    box(varnish, (-0.27, 0.30, aft - 0.02), (0.27, top - 0.03, aft + 0.018))
    for k in range(1, 4):
        y = lerp(0.30, top - 0.03, k / 4)
        box(node.part("black"), (-0.262, y - 0.004, aft), (0.262, y + 0.004, aft + 0.0205))
    # Eyebrow: a varnished line along the roof's shoulder.
    for side in (0, 1):
        path = []
        for k in range(19):
            z = lerp(fore + 0.35, aft - 0.005, k / 18)
            a = 0.30 if side == 0 else math.pi - 0.30
            path.append(add(roof(z, a), (0.004 if side == 0 else -0.004, 0.0, 0.0)))
        tube(varnish, path, 0.013, sides=5)
    # Two long windows a side, their ends rounded.
    for z0, z1 in ((-0.98, -0.12), (0.02, 0.88)):
        for side in (0, 1):
            def angle(r, s, side=side):
                round_end = (1.0 - abs(2.0 * r - 1.0) ** 6) ** 0.5
                a = 0.035 + (0.5 + (s - 0.5) * round_end) * 0.062
                return a if side == 0 else math.pi - a
            roof_patch(window, lambda r, s, z0=z0, z1=z1: lerp(z0, z1, 0.5 - 0.5 * math.cos(math.pi * r)),
                       angle, 12, 2, flip=side == 0)
    # Sliding hatch on its garage, two handrails, and a smoked deck hatch before the mast.
    y = roof(0.9, math.pi / 2)[1]
    slide = [[(x, y + 0.055 * (1 - (x / 0.31) ** 4) * e - 0.012, z) for x in
              [0.31 * (2 * k / 10 - 1) for k in range(11)]] for z, e in
             ((0.30, 0.0), (0.33, 0.85), (0.36, 1.0), (1.06, 1.0), (1.12, 1.0), (1.125, 0.0))]
    surface(varnish, slide)
    for side in (-1, 1):
        box(gel, (side * 0.33 - 0.02, y - 0.05, -0.1), (side * 0.33 + 0.02, y + 0.035, 1.08))
        rail = []
        for k in range(19):
            z = lerp(-0.25, 0.95, k / 18)
            lift = 0.05 * abs(math.sin(math.pi * 3 * k / 18)) ** 0.5
            x = side * 0.475
            a = math.pi / 2 - side * 0.62
            rail.append((x, roof(z, a)[1] + lift - 0.012, z))
        tube(varnish, rail, 0.014, sides=5)
    z0, z1 = -1.36, -0.92
    base = roof(z0, math.pi / 2)[1]
    tilt = (roof(z1, math.pi / 2)[1] - base) / (z1 - z0)
    for name, grow, low, high in (("aluminium", 0.02, -0.03, 0.022), ("window", 0.0, 0.0, 0.030)):
        rings = []
        for h, shrink in ((low, 0.0), (high - 0.006, 0.0), (high, 0.012), (high, 0.22)):
            ring = []
            for k in range(20):
                a = 2 * math.pi * k / 20
                cx, sz = math.cos(a), math.sin(a)
                x = (0.22 + grow - shrink) * math.copysign(abs(cx) ** 0.4, cx)
                z = (0.22 + grow - shrink) * math.copysign(abs(sz) ** 0.4, sz)
                ring.append((x, base + tilt * (z + 0.22) + h, (z0 + z1) / 2 + z))
            rings.append(ring)
        for lower, upper in zip(rings, rings[1:]):
            surface(node.part(name), [lower, upper], wrap_v=True)


def make_fittings(node):
    steel, black = node.part("steel"), node.part("black")
    # Winches: primaries on the side decks by the coaming, halyards on the roof.
    drum = [(0.075, 0.0), (0.075, 0.02), (0.052, 0.035), (0.047, 0.075), (0.062, 0.11), (0.066, 0.125),
            (0.055, 0.132), (0.02, 0.135), (0.02, 0.142), (0.0, 0.142)]
    for side in (-1, 1):
        at = (side * 0.90, deck_y(0.90, 1.75), 1.75)
        lathe(black, at, [(0.088, -0.01), (0.080, 0.055), (0.0, 0.055)], 18)
        lathe(steel, add(at, (0, 0.055, 0)), drum, 18)
        at = roof(0.62, math.pi / 2 - side * 0.42)
        lathe(steel, (side * 0.42, at[1] - 0.004, 0.62), [(r * 0.72, h * 0.8) for r, h in drum], 14)
        # Mooring cleats.
        for z in (-3.05, 3.66):
            x = half_beam(deck_t(z)) - 0.13
            y = deck_y(x, z)
            tube(steel, [(side * x, y + 0.045, z - 0.11), (side * x, y + 0.052, z),
                         (side * x, y + 0.045, z + 0.11)], [0.009, 0.013, 0.009], sides=6)
            for dz in (-0.035, 0.035):
                tube(steel, [(side * x, y - 0.01, z + dz), (side * x, y + 0.05, z + dz)], 0.011, sides=6)
    # Stem head fitting and the mast's collar; the mainsheet traveller across the seats.
    box(steel, (-0.035, 1.00, BOW + 0.06), (0.035, 1.115, BOW + 0.30))
    roof_y = roof(MAST_Z, math.pi / 2)[1]
    lathe(black, (0, roof_y - 0.02, MAST_Z), [(0.13, 0.0), (0.12, 0.05), (0.0, 0.05)], 20)
    box(black, (-COCKPIT_HALF, 0.565, 2.66), (COCKPIT_HALF, 0.60, 2.70))
    # Compass by the companionway.
    at = (-0.46, 0.95, ROOF[1] + 0.03)
    lathe(black, at, [(0.055, 0.0), (0.06, 0.05), (0.045, 0.075)], 16)
    lathe(node.part("window"), add(at, (0, 0.07, 0)), [(0.045, 0.0), (0.035, 0.02), (0.018, 0.032), (0.0, 0.035)], 16)


def make_rails(node):
    """Pulpit, pushpit, stanchions and lifelines, ensign staff, navigation lights."""
    steel, wire = node.part("steel"), node.part("wire")
    edge = lambda z, inset=0.05: half_beam(deck_t(z)) - inset
    # Pulpit: a hoop round the stem, on four feet.
    hoop = []
    for k in range(17):
        a = math.pi * (k / 16)
        x, z = 0.42 * math.cos(a), -3.02 - 1.0 * math.sin(a) ** 0.8
        hoop.append((x, 1.56 + 0.05 * math.sin(a), z))
    tube(steel, hoop, 0.0125, sides=8)
    for side in (-1, 1):
        for foot_z, top in ((-3.02, (0.42, 1.56, -3.02)), (-3.62, (0.30, 1.59, -3.72))):
            x = edge(foot_z)
            tube(steel, [(side * x, sheer(deck_t(foot_z)), foot_z), (side * top[0], top[1], top[2])],
                 0.0125, sides=8)
        # Stanchions with two lifelines.
        tops, mids = [(side * 0.42, 1.55, -3.02)], [(side * (edge(-3.02) * 0.5 + 0.21), 1.26, -3.02)]
        for z in (-1.75, -0.45, 0.85, 2.15):
            x, y = edge(z), sheer(deck_t(z))
            tube(steel, [(side * x, y, z), (side * (x - 0.01), y + 0.60, z)], 0.0115, sides=8)
            lathe(steel, (side * x, y, z), [(0.024, 0.0), (0.018, 0.05), (0.012, 0.055)], 8)
            tops.append((side * (x - 0.01), y + 0.59, z))
            mids.append((side * x, y + 0.30, z))
        gate = (3.10, edge(3.10), sheer(deck_t(3.10)))
        tops.append((side * gate[1], gate[2] + 0.60, gate[0]))
        mids.append((side * gate[1], gate[2] + 0.30, gate[0]))
        for line in (tops, mids):
            make_wire(wire, line, 0.0028)
        # Pushpit: one quarter each, open at the backstay.
        path = [(gate[1], gate[2] + 0.60, gate[0])]
        for k in range(9):
            a = math.pi / 2 * k / 8
            corner_x, corner_z = edge(3.62) - 0.28, 3.46
            path.append((corner_x + 0.28 * math.cos(a), gate[2] + 0.60, corner_z + 0.26 * math.sin(a)))
        path.append((0.34, gate[2] + 0.60, 3.74))
        path += [(0.30, gate[2] + 0.56, 3.745), (0.30, gate[2], 3.74)]
        path = [(side * x, y, z) for x, y, z in path]
        tube(steel, path, 0.0125, sides=8)
        middle = [(x, y - 0.30, z) for x, y, z in path[:-2]]
        tube(steel, middle, 0.009, sides=6)
        for z in (gate[0], 3.56):
            x = edge(z)
            tube(steel, [(side * x, sheer(deck_t(z)), z), (side * (x - 0.01), gate[2] + 0.60, z)], 0.0125,
                 sides=8)
        name = "light_port" if side < 0 else "light_starboard"
        lathe(node.part(name), (side * 0.325, 1.605, -3.66), [(0.028, 0.0), (0.030, 0.05), (0.0, 0.062)], 10)
    lathe(node.part("light_stern"), (-0.40, 1.47, 3.74), [(0.026, 0.0), (0.028, 0.05), (0.0, 0.06)], 10)
    staff = (0.62, 0.86, 3.70)
    tube(node.part("varnish"), [staff, add(staff, (0, 0.55, 0)), add(staff, (0, 1.22, 0))],
         [0.016, 0.014, 0.010], sides=8)
    lathe(node.part("varnish"), add(staff, (0, 1.215, 0)), [(0.012, 0.0), (0.02, 0.012), (0.012, 0.026), (0, 0.03)], 8)


def make_wire(part, path, radius):
    """A thin round line. uv = (radius, 0): a renderer may keep it at least a pixel wide."""
    tube(part, path, radius, sides=4, caps=False, uv=lambda i, j: (radius, 0.0))


# ---- rig -----------------------------------------------------------------------------------------
SPREADERS = ((4.55, 0.80), (7.55, 0.62))  # height, half span


def make_mast(node):
    """In the frame of the mast node: y from the waterline, the axis at x = z = 0."""
    part = node.part("aluminium")
    foot = roof(MAST_Z, math.pi / 2)[1] - 0.03
    heights = [foot, 1.6, 4.0, 7.0, 9.4, 10.2, 10.8, MAST_TOP]
    chord = Spline([(foot, 0.145), (7.0, 0.145), (9.4, 0.135), (MAST_TOP, 0.085)])
    rings = []
    for y in heights:
        c = chord(y)
        rings.append([(0.36 * c * math.cos(a), y, 0.5 * c * math.sin(a) - 0.5 * c + 0.07)
                      for a in (2 * math.pi * k / 24 for k in range(24))])
    surface(part, rings, wrap_v=True)
    polygon(part, rings[-1], (0.0, 1.0, 0.0))
    # The track of the mainsail: a dark slot down the after face.
    box(node.part("black"), (-0.006, GOOSENECK, 0.066), (0.006, 10.98, 0.0735))
    for y, span in SPREADERS:
        for side in (-1, 1):
            tip = (side * span, y + 0.05, 0.20)
            sweep(part, [(side * 0.04, y, 0.0), tip],
                  [(-0.028, 0.0), (0.0, -0.010), (0.028, 0.0), (0.0, 0.010)])
    # Crane with the backstay's fork, masthead light, wind vane and aerial.
    box(part, (-0.012, MAST_TOP - 0.05, -0.02), (0.012, MAST_TOP + 0.005, 0.20))
    lathe(node.part("light_masthead"), (0, MAST_TOP, 0.02), [(0.022, 0.0), (0.024, 0.06), (0.0, 0.075)], 10)
    tube(node.part("black"), [(0, MAST_TOP, 0.12), (0, MAST_TOP + 0.24, 0.12)], 0.004, sides=5)
    tube(node.part("black"), [(0.01, MAST_TOP, -0.03), (0.01, MAST_TOP + 0.8, -0.03)], [0.004, 0.0015], sides=5)


def make_rigging(node):
    wire = node.part("wire")
    side_z = 0.02
    for side in (-1, 1):
        chain_x = half_beam(deck_t(side_z)) - 0.10
        chain = (side * chain_x, deck_y(chain_x, side_z), side_z)
        tips = [(side * span, y + 0.05, MAST_Z + 0.20) for y, span in SPREADERS]
        make_wire(wire, [chain, tips[0], tips[1], (side * 0.03, HOUNDS[1], MAST_Z)], 0.0045)
        make_wire(wire, [(chain[0], chain[1], side_z - 0.06), (side * 0.04, SPREADERS[0][0] - 0.1, MAST_Z)], 0.0045)
        make_wire(wire, [tips[0], (side * 0.04, SPREADERS[1][0] - 0.1, MAST_Z)], 0.0035)
        for z in (side_z, side_z - 0.06):  # turnbuckles
            up = unit(sub(tips[0], chain)) if z == side_z else unit(
                sub((side * 0.04, 4.45, MAST_Z), (chain[0], chain[1], z)))
            low = (chain[0], chain[1] - 0.01, z)
            tube(node.part("steel"), [low, add(low, scale(up, 0.22))], 0.010, sides=6)
    stem = (0.0, 1.11, BOW + 0.12)
    direction = unit(sub(HOUNDS, TACK))
    foot = sub(TACK, scale(direction, 0.10))
    make_wire(wire, [stem, foot, HOUNDS], 0.0045)
    tube(node.part("black"), [sub(TACK, scale(direction, 0.08)), sub(TACK, scale(direction, 0.02))], 0.055, sides=14)
    make_wire(wire, [(0.0, MAST_TOP - 0.01, MAST_Z + 0.18), (0.0, 0.86, 3.79)], 0.004)


def make_boom(node):
    """In the frame of the boom node: origin at the gooseneck on the mast's axis, boom along +z."""
    part = node.part("aluminium")
    rings = []
    for z, c in ((0.10, 0.11), (0.4, 0.13), (3.2, 0.13), (3.86, 0.11)):
        rings.append([(0.34 * c * math.cos(a), -0.10 + 0.5 * c * math.sin(a) + 0.012 * z, z)
                      for a in (2 * math.pi * k / 24 for k in range(24))])
    surface(part, rings, wrap_v=True, flip=True)
    polygon(part, rings[0], (0, 0, -1.0))
    polygon(part, rings[-1], (0, 0, 1.0))
    # Gooseneck, vang, mainsheet block, clew outhaul.
    tube(node.part("steel"), [(0, -0.10, 0.06), (0, -0.10, 0.12)], 0.02, sides=8)
    tube(part, [(0, -0.40, 0.09), (0, -0.15, 0.95)], 0.02, sides=8)
    box(node.part("black"), (-0.016, -0.21, 2.78), (0.016, -0.10, 2.88))
    tube(node.part("steel"), [(0, -0.02, 3.78), (0, 0.02, 3.80)], 0.014, sides=6)


def sail_grid(part, luff, leech, foot_round, rows, cols):
    """A flat sail in its own frame: y along the luff, z toward the leech, x its normal. The belly is
    the renderer's. luff(v), leech(v) → (y, z)."""
    points = []
    for i in range(rows + 1):
        v = i / rows
        (y0, z0), (y1, z1) = luff(v), leech(v)
        row = []
        for j in range(cols + 1):
            u = j / cols
            drop = foot_round * math.sin(math.pi * u) * (1.0 - v) ** 8
            row.append((0.0, lerp(y0, y1, u) - drop, lerp(z0, z1, u)))
        points.append(row)
    surface(part, points, uv=lambda i, j: (j / cols, i / rows))
    area = 0.0
    for i in range(rows):
        for j in range(cols):
            a, b, c, d = points[i][j], points[i][j + 1], points[i + 1][j + 1], points[i + 1][j]
            area += 0.5 * abs((c[1] - a[1]) * (d[2] - b[2]) - (c[2] - a[2]) * (d[1] - b[1]))
    return area


def bisect(low, high, too_small):
    for _ in range(60):
        mid = 0.5 * (low + high)
        low, high = (mid, high) if too_small(mid) else (low, mid)
    return 0.5 * (low + high)


def make_mainsail(node):
    hoist, foot, head = 10.95 - GOOSENECK, 3.70, 0.32
    part = lambda: type(node.part("sail"))()

    def shape(roach):
        def leech(v):
            round_ = roach * 2.05 * v ** 0.95 * (1.0 - v) ** 0.62
            return (0.03 + (hoist - 0.03) * v + 0.14 * v * (1 - v), 0.085 + lerp(foot, head, v) + round_)
        return leech
    luff = lambda v: (hoist * v, 0.085)
    roach = bisect(0.0, 1.5, lambda r: sail_grid(part(), luff, shape(r), 0.10, 32, 18) < MAIN_AREA)
    return sail_grid(node.part("sail"), luff, shape(roach), 0.10, 32, 18), roach


def make_jib(node, lean):
    """Frame: y up the forestay, z perpendicular to it in the centreplane; origin at the tack."""
    hoist = 8.75
    along = lambda up, aft: (up * math.cos(lean) + aft * math.sin(lean),
                             aft * math.cos(lean) - up * math.sin(lean))
    part = lambda: type(node.part("sail"))()
    luff = lambda v: (0.05 + (hoist - 0.05) * v, 0.012)

    def shape(aft):
        clew = along(0.28, aft)
        def leech(v):
            hollow = 0.10 * math.sin(math.pi * v)
            return (lerp(clew[0], hoist, v), lerp(clew[1], 0.07, v) - hollow)
        return leech
    aft = bisect(2.0, 5.0, lambda a: sail_grid(part(), luff, shape(a), 0.16, 30, 16) < JIB_AREA)
    return sail_grid(node.part("sail"), luff, shape(aft), 0.16, 30, 16), aft


def make_flag(node):
    """Frame: origin at the lower end of the hoist, y up the hoist, z along the fly."""
    width, height, cols, rows = 0.84, 0.56, 24, 12
    points = [[(0.0, height * i / rows, width * j / cols) for j in range(cols + 1)]
              for i in range(rows + 1)]
    surface(node.part("flag"), points, uv=lambda i, j: (j / cols, i / rows))


# ---- under water ---------------------------------------------------------------------------------
def make_keel(node):
    part = node.part("antifouling")
    rows = [(-0.30, -0.42, 0.84), (-0.42, -0.34, 0.78), (-0.9, -0.23, 0.72), (-1.46, -0.10, 0.66)]
    foil(part, rows, 0.11)
    # Bulb: a body of revolution, flattened underneath; its bottom at the draught.
    rings, length_, centre_y = [], 1.55, -1.375
    for k in range(19):
        x = 0.5 - 0.5 * math.cos(math.pi * k / 18)
        r = 0.125 * math.sqrt(max(x, 0.0)) * (1 - x) ** 0.75 / 0.4625
        ring = []
        for s in range(14):
            a = 2 * math.pi * s / 14
            ring.append((1.12 * r * math.cos(a), centre_y + r * math.sin(a) * (0.95 if math.sin(a) > 0 else 1.0),
                         -0.58 + length_ * x))
        rings.append(ring)
    surface(part, rings, wrap_v=True, flip=True)


def make_rudder(node):
    """In the frame of the rudder node: origin on the stock's axis at the waterline, y along it."""
    part = node.part("antifouling")
    root = rocker(STOCK_Z + 0.05)
    rows = [(root + 0.0, -0.13, 0.47), (root - 0.3, -0.12, 0.45), (root - 0.7, -0.10, 0.40),
            (root - 0.95, -0.085, 0.34)]
    foil(part, rows, 0.13)
    tube(node.part("steel"), [(0, root - 0.2, 0), (0, 0.74, 0)], 0.022, sides=8)


WHEEL = (0.0, 1.02, 2.34)  # its hub, on the pedestal's after side
WHEEL_RADIUS = 0.36


def make_pedestal(node):
    """What the wheel stands on: in the boat's frame, with the compass on top."""
    gel, steel = node.part("gelcoat"), node.part("steel")
    x, y, z = WHEEL
    rings = []
    for height, wide, deep in ((0.24, 0.17, 0.15), (0.30, 0.13, 0.12), (0.85, 0.10, 0.09), (1.05, 0.11, 0.10),
                               (1.10, 0.09, 0.08)):
        rings.append([(wide * math.cos(a), height, z - 0.17 + deep * math.sin(a))
                      for a in (2 * math.pi * k / 16 for k in range(16))])
    surface(gel, rings, wrap_v=True)
    polygon(gel, rings[-1], (0.0, 1.0, 0.0))
    lathe(node.part("black"), (0, 1.10, z - 0.17), [(0.085, 0.0), (0.088, 0.05), (0.07, 0.07)], 18)
    lathe(node.part("window"), (0, 1.165, z - 0.17), [(0.07, 0.0), (0.055, 0.035), (0.03, 0.055), (0, 0.06)], 18)
    # Grab rail over the compass.
    rail = [(0.20, 0.42, z - 0.26), (0.20, 1.05, z - 0.26)]
    rail += [(0.20 * math.cos(a), 1.05 + 0.24 * math.sin(a), z - 0.26) for a in
             (math.pi * k / 10 for k in range(1, 10))]
    rail += [(-0.20, 1.05, z - 0.26), (-0.20, 0.42, z - 0.26)]
    tube(steel, rail, 0.0125, sides=12)


def make_wheel(node):
    """In the frame of the wheel node: origin at its hub, turning about z."""
    steel, wood = node.part("steel"), node.part("varnish")
    rim, count = [], 60
    for k in range(count + 1):
        a = 2 * math.pi * k / count
        rim.append((WHEEL_RADIUS * math.cos(a), WHEEL_RADIUS * math.sin(a), 0.0))
    tube(wood, rim, 0.016, sides=12, caps=False)
    for k in range(6):
        a = 2 * math.pi * k / 6 + math.pi / 2
        tube(steel, [(0, 0, 0), (WHEEL_RADIUS * math.cos(a), WHEEL_RADIUS * math.sin(a), 0)], 0.008, sides=6)
    tube(steel, [(0, 0, -0.09), (0, 0, 0.03)], 0.035, sides=14)
    # The turk's head on the king spoke: straight up when the rudder is amidships.
    tube(node.part("black"), [(-0.012, WHEEL_RADIUS, 0), (0.012, WHEEL_RADIUS, 0)], 0.022, sides=8)


# ---- materials -----------------------------------------------------------------------------------
def teak_image():
    """Six planks with black seams and a few butts; sRGB."""
    size = 128
    rows = []
    for y in range(size):
        row = []
        for x in range(size):
            plank, inside = divmod(x * 6, size)
            seam = inside < 28 / 2 or inside > size - 28 / 4
            tone = 0.92 + 0.12 * (((plank * 7919 + 13) % 17) / 16 - 0.5)
            grain = 0.04 * math.sin(x * 1.9 + 2.3 * math.sin(y * 2 * math.pi / size * (1 + plank % 3)))
            butt = abs((y + plank * 53) % size) < 1
            shade = tone + grain
            colour = (38, 32, 27) if seam or butt else tuple(
                int(min(255, max(0, round(c * shade)))) for c in (196, 152, 102))
            row += colour
        rows.append(row)
    return size, size, 3, rows


def material(name, colour, roughness, metallic=0.0, **extra):
    entry = {"name": name, "pbrMetallicRoughness": {
        "baseColorFactor": list(colour) + [1.0], "metallicFactor": metallic,
        "roughnessFactor": roughness}}
    if extra.pop("textured", False):
        entry["pbrMetallicRoughness"]["baseColorTexture"] = {"index": 0}
    entry.update(extra)
    return entry


MATERIALS = [
    material("topsides", (0.83, 0.82, 0.78), 0.22),
    material("boot", (0.010, 0.020, 0.060), 0.25),
    material("antifouling", (0.190, 0.028, 0.024), 0.75),
    material("gelcoat", (0.78, 0.76, 0.70), 0.42),
    material("teak", (1.0, 1.0, 1.0), 0.72, textured=True),
    material("varnish", (0.165, 0.048, 0.016), 0.20),
    material("aluminium", (0.66, 0.67, 0.68), 0.40, 0.35),
    material("steel", (0.66, 0.66, 0.67), 0.24, 1.0),
    material("wire", (0.42, 0.42, 0.43), 0.70, 0.3),
    material("window", (0.010, 0.012, 0.016), 0.08),
    material("black", (0.018, 0.018, 0.020), 0.50),
    material("rope", (0.62, 0.58, 0.46), 0.85),
    material("zinc", (0.50, 0.51, 0.52), 0.55, 0.8),
    material("yellow", (0.85, 0.50, 0.02), 0.60),
    material("sail", (0.80, 0.79, 0.75), 0.80, doubleSided=True),
    material("flag", (0.80, 0.80, 0.80), 0.85, doubleSided=True),
    material("light_port", (0.30, 0.010, 0.010), 0.2, emissiveFactor=[1.0, 0.02, 0.02]),
    material("light_starboard", (0.010, 0.22, 0.06), 0.2, emissiveFactor=[0.02, 1.0, 0.25]),
    material("light_stern", (0.60, 0.60, 0.55), 0.2, emissiveFactor=[1.0, 0.93, 0.80]),
    material("light_masthead", (0.60, 0.60, 0.55), 0.2, emissiveFactor=[1.0, 0.93, 0.80]),
]


# ---- the boat ------------------------------------------------------------------------------------
def hydrostatics():
    """Displacement and waterplane of the canoe body below y = 0, by the trapezoidal rule."""
    ats = [station(k / 600) for k in range(601)]
    levels = [-0.34 + 0.34 * k / 40 for k in range(41)]
    breadths = []
    for y in levels:
        line = sorted((p[2], p[0]) for p in (at(solve(at, y)) for at in ats if at(0.0)[1] < y))
        area = sum((b[0] - a[0]) * (a[1] + b[1]) for a, b in zip(line, line[1:]))
        breadths.append(area)
        if line:
            beam, span = 2 * max(p[1] for p in line), [line[0][0], line[-1][0]]
    volume = sum((a + b) / 2 * 0.34 / 40 for a, b in zip(breadths, breadths[1:]))
    waterplane = breadths[-1]
    return volume, waterplane, beam, span


def main():
    root = Node("r8")
    hull = root.add(Node("hull"))
    make_hull(hull, hull_rings(46))
    make_keel(root.add(Node("keel")))
    deck = root.add(Node("deck"))
    make_deck_plate(deck)
    make_coachroof(deck)
    make_cockpit(deck)
    make_fittings(deck)
    make_gear(deck, deck_y, roof)
    make_rails(root.add(Node("rails")))
    make_mast(root.add(Node("mast", (0.0, 0.0, MAST_Z))))
    make_rigging(root.add(Node("rigging")))
    boom = root.add(Node("boom", (0.0, GOOSENECK, MAST_Z)))
    make_boom(boom)
    main_area, roach = make_mainsail(boom.add(Node("mainsail")))
    lean = math.atan2(HOUNDS[2] - TACK[2], HOUNDS[1] - TACK[1])
    jib = root.add(Node("jib", TACK, (math.sin(lean / 2), 0.0, 0.0, math.cos(lean / 2))))
    jib_area, clew = make_jib(jib, lean)
    rudder = root.add(Node("rudder", (0.0, 0.0, STOCK_Z)))
    make_rudder(rudder)
    make_pedestal(deck)
    make_wheel(root.add(Node("wheel", WHEEL)))
    make_flag(root.add(Node("flag", (0.62, 1.46, 3.716))))
    make_mask(root.add(Node("mask")))

    extras = {"title": "R8, an 8 m keelboat", "licence": "MIT",
              "frame": "x starboard, y up, z aft; origin at the design waterline amidships"}
    out = os.path.join(HERE, "r8.glb")
    Writer(MATERIALS, {"teak": teak_image()}).write(out, root, extras)
    volume, waterplane, beam, span = hydrostatics()
    print("%s: %d triangles, %d bytes" % (os.path.basename(out), root.triangles(), os.path.getsize(out)))
    for node in root.children:
        print("  %-9s %6d" % (node.name, node.triangles()))
    print("main %.2f m2 (roach %.2f m), jib %.2f m2 (clew %.2f m aft of the tack)" %
          (main_area, roach, jib_area, clew))
    print("canoe body %.3f m3, waterplane %.2f m2, BWL %.2f m, LWL %.2f m (%.2f to %.2f)" %
          (volume, waterplane, beam, span[1] - span[0], span[0], span[1]))


if __name__ == "__main__":
    main()
