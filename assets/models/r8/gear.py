"""What lies about on R8's deck: anchor, ventilators, jib tracks, coils, lifebuoy. Boat frame.

`deck_y(x, z)` and `roof(z, a)` are the surfaces that make_r8.py lofts."""

import math

from shapes import add, box, cross, lathe, lerp, polygon, scale, sub, sweep, tube, unit

TRACK_X = 0.575  # the jib's cars: 8 degrees from the tack


def roof_at(roof, x, z):
    """The coachroof's point over (x, z)."""
    low, high = 0.05, math.pi / 2
    for _ in range(50):
        a = 0.5 * (low + high)
        low, high = (a, high) if roof(z, a)[0] > abs(x) else (low, a)
    return (x, roof(z, low)[1], z)


def make_jib_tracks(node, roof):
    """On the coachroof, with the cars that the jib's sheets run through."""
    steel, black = node.part("steel"), node.part("black")
    for side in (-1, 1):
        x = side * TRACK_X
        path = [add(roof_at(roof, x, lerp(0.02, 0.78, k / 6)), (0.0, 0.004, 0.0)) for k in range(7)]
        sweep(black, path, [(-0.016, -0.012), (0.016, -0.012), (0.016, 0.012), (-0.016, 0.012)])
        car = roof_at(roof, x, 0.39)
        box(steel, add(car, (-0.026, 0.008, -0.055)), add(car, (0.026, 0.034, 0.055)))
        for dx in (-0.017, 0.017):
            box(steel, add(car, (dx - 0.003, 0.034, -0.024)), add(car, (dx + 0.003, 0.085, 0.024)))
        tube(black, [add(car, (-0.013, 0.06, 0.0)), add(car, (0.013, 0.06, 0.0))], 0.026, sides=14)


def make_anchor(node, deck_y):
    """A plough in its roller at the stem, and its cleat."""
    zinc, black = node.part("zinc"), node.part("black")
    y = deck_y(0.0, -3.6)
    box(node.part("steel"), (0.05, y - 0.01, -4.07), (0.062, y + 0.06, -3.78))
    box(node.part("steel"), (0.148, y - 0.01, -4.07), (0.16, y + 0.06, -3.78))
    tube(black, [(0.062, y + 0.03, -4.05), (0.148, y + 0.03, -4.05)], 0.034, sides=14)
    shank = [(0.105, y + 0.08, -3.45), (0.105, y + 0.09, -3.75), (0.105, y + 0.08, -4.08),
             (0.105, y + 0.02, -4.24), (0.105, y - 0.12, -4.27)]
    sweep(zinc, shank, [(-0.011, -0.022), (0.011, -0.022), (0.011, 0.022), (-0.011, 0.022)],
          up=(0.0, 0.6, -0.8), fixed_up=False)
    tip, heel = (0.105, y - 0.10, -3.93), (0.105, y - 0.16, -4.28)
    for side in (-1, 1):  # the two blades of the plough
        wing = add(heel, (side * 0.10, 0.07, 0.03))
        rows = [(tip, tip), (heel, wing)]
        for lift in (0.0, 0.006):
            part = [add(p, (0.0, lift, 0.0)) for p in (rows[0][0], rows[1][1], rows[1][0])]
            triangle(zinc, part if (side > 0) == (lift > 0) else list(reversed(part)))
    ring = [(0.105 + 0.025 * math.cos(a), y + 0.08, -3.435 + 0.025 * math.sin(a))
            for a in (2 * math.pi * k / 10 for k in range(11))]
    tube(zinc, ring, 0.006, sides=6, caps=False)


def triangle(part, corners):
    polygon(part, corners, unit(cross(sub(corners[1], corners[0]), sub(corners[2], corners[0]))))


def make_ventilators(node, roof):
    """Two cowls on their boxes before the mast."""
    gel, steel = node.part("gelcoat"), node.part("steel")
    for side in (-1, 1):
        foot = roof_at(roof, side * 0.30, -0.62)
        box(node.part("varnish"), add(foot, (-0.10, -0.03, -0.13)), add(foot, (0.10, 0.085, 0.13)))
        path, radii = [], []
        for k in range(9):  # a bend from upright to looking forward
            a = 0.5 * math.pi * k / 8
            path.append(add(foot, (0.0, 0.085 + 0.10 + 0.085 * math.sin(a), -0.03 - 0.085 * (1 - math.cos(a)))))
            radii.append(lerp(0.044, 0.075, (k / 8) ** 1.6))
        path.insert(0, add(foot, (0.0, 0.08, -0.03)))
        radii.insert(0, 0.046)
        path.append(add(path[-1], (0.0, 0.0, -0.03)))
        radii.append(0.088)
        tube(gel, path, radii, sides=14, caps=False)
        inside = list(reversed(path[3:]))  # red within, seen from ahead
        tube(node.part("antifouling"), inside, [r - 0.004 for r in reversed(radii[3:])], sides=14, caps=True)
        lathe(steel, add(foot, (0.0, 0.085, -0.03)), [(0.058, 0.0), (0.058, 0.012), (0.046, 0.016)], 18)


def coil(part, centre, radius, turns, thickness=0.007):
    """A rope made up flat, as it lies on a deck."""
    path = []
    for k in range(turns * 11 + 1):
        a = 2 * math.pi * k / 11
        r = radius - 0.9 * thickness * (k / 11)
        wobble = 0.006 * math.sin(2.3 * a)
        path.append(add(centre, (r * math.cos(a) + wobble, thickness + 0.0025 * math.sin(5.0 * a), 1.15 * r * math.sin(a))))
    tube(part, path, thickness, sides=4)


def make_ropes(node, deck_y, roof):
    """Halyards led aft over the coachroof to clutches, and the coils of their tails."""
    rope, black = node.part("rope"), node.part("black")
    for side in (-1, 1):
        for k, x in enumerate((0.36, 0.395, 0.43)):
            path = [roof_at(roof, side * lerp(0.10 + 0.02 * k, x, smooth_part(z)), z)
                    for z in (lerp(-0.46, 0.50, i / 5) for i in range(6))]
            tube(rope, [add(p, (0.0, 0.012, 0.0)) for p in path], 0.005, sides=4)
        at = roof_at(roof, side * 0.395, 0.46)
        box(black, add(at, (-0.065, 0.0, -0.06)), add(at, (0.065, 0.045, 0.06)))
        for dx in (-0.035, 0.0, 0.035):  # their levers
            box(node.part("aluminium"), add(at, (dx - 0.010, 0.045, -0.05)), add(at, (dx + 0.010, 0.056, 0.05)))
    coil(rope, (-0.50, 0.562, 1.42), 0.13, 4)
    coil(rope, (0.52, 0.562, 1.75), 0.12, 4)
    coil(rope, (0.30, deck_y(0.30, -2.55) - 0.002, -2.55), 0.16, 5, 0.008)


def smooth_part(z):
    t = min(max((z + 0.46) / 0.6, 0.0), 1.0)
    return t * t * (3.0 - 2.0 * t)


def make_lifebuoy(node):
    """A horseshoe in its bracket on the port quarter's rail."""
    path = []
    for k in range(21):
        a = math.pi * (0.5 + 1.64 * (k / 20 - 0.5)) + math.pi
        path.append((-0.98 + 0.0, 1.22 + 0.20 * math.sin(a) * 1.2, 3.24 + 0.20 * math.cos(a)))
    path = [add(p, (-0.02, 0.0, 0.0)) for p in path]
    tube(node.part("yellow"), path, [0.042] + [0.052] * 19 + [0.042], sides=8)
    for k in (4, 10, 16):
        a, b = path[k], path[k + 1]
        way = scale(unit(sub(b, a)), 0.03)
        tube(node.part("topsides"), [sub(a, way), add(a, way)], 0.0535, sides=12, caps=False)


def make_gear(node, deck_y, roof):
    make_jib_tracks(node, roof)
    make_anchor(node, deck_y)
    make_ventilators(node, roof)
    make_ropes(node, deck_y, roof)
    make_lifebuoy(node)
