"""Curves and surfaces: everything a boat is lofted, swept or turned from."""

import math


def add(a, b):
    return tuple(x + y for x, y in zip(a, b))


def sub(a, b):
    return tuple(x - y for x, y in zip(a, b))


def scale(a, s):
    return tuple(x * s for x in a)


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def length(a):
    return math.sqrt(dot(a, a))


def unit(a):
    size = length(a)
    return scale(a, 1.0 / size) if size > 1e-12 else (0.0, 1.0, 0.0)


def lerp(a, b, t):
    return a + (b - a) * t


def mix(a, b, t):
    return tuple(lerp(x, y, t) for x, y in zip(a, b))


def smooth(t):
    t = min(max(t, 0.0), 1.0)
    return t * t * (3.0 - 2.0 * t)


class Spline:
    """Natural cubic spline through (x, y): fair in the boatbuilder's sense, C2."""

    def __init__(self, knots):
        self.x = [k[0] for k in knots]
        self.y = [k[1] for k in knots]
        n = len(knots)
        self.m = [0.0] * n  # second derivatives, by the tridiagonal algorithm
        c, d = [0.0] * n, [0.0] * n
        for i in range(1, n - 1):
            h0, h1 = self.x[i] - self.x[i - 1], self.x[i + 1] - self.x[i]
            rhs = 6.0 * ((self.y[i + 1] - self.y[i]) / h1 - (self.y[i] - self.y[i - 1]) / h0)
            w = 2.0 * (h0 + h1) - h0 * c[i - 1]
            c[i], d[i] = h1 / w, (rhs - h0 * d[i - 1]) / w
        for i in range(n - 2, 0, -1):
            self.m[i] = d[i] - c[i] * self.m[i + 1]

    def __call__(self, x):
        i = 0
        while i < len(self.x) - 2 and x > self.x[i + 1]:
            i += 1
        h = self.x[i + 1] - self.x[i]
        a, b = (self.x[i + 1] - x) / h, (x - self.x[i]) / h
        return (a * self.y[i] + b * self.y[i + 1] +
                ((a**3 - a) * self.m[i] + (b**3 - b) * self.m[i + 1]) * h * h / 6.0)


def grid(part_of, points, wrap_u=False, wrap_v=False, uv=None, flip=False):
    """A smooth surface through points[i][j]. Its front is where (next i) × (next j) points.

    `part_of(j)` gives the Part of the strip between columns j and j + 1, so that one smooth surface
    can change its material along a crisp line. `uv(i, j)` defaults to (0, 0)."""
    rows, cols = len(points), len(points[0])
    normals = [[(0.0, 0.0, 0.0)] * cols for _ in range(rows)]
    cells = [(i, (i + 1) % rows, j, (j + 1) % cols)
             for i in range(rows if wrap_u else rows - 1) for j in range(cols if wrap_v else cols - 1)]
    triangles = []
    for i0, i1, j0, j1 in cells:
        quad = [(i0, j0), (i1, j0), (i1, j1), (i0, j1)]
        if flip:
            quad.reverse()
        for corners in ((quad[0], quad[1], quad[2]), (quad[0], quad[2], quad[3])):
            a, b, c = (points[i][j] for i, j in corners)
            normal = cross(sub(b, a), sub(c, a))
            if length(normal) < 1e-9:
                continue
            triangles.append((j0, corners))
            for i, j in corners:
                normals[i][j] = add(normals[i][j], normal)
    # A corner that only slivers touch takes its normal from the nearest one in its row.
    for i in range(rows):
        for j in range(cols):
            if length(normals[i][j]) < 1e-12:
                known = [k for k in range(cols) if length(normals[i][k]) >= 1e-12]
                if known:
                    normals[i][j] = normals[i][min(known, key=lambda k: abs(k - j))]
    placed = {}
    for strip, corners in triangles:
        part = part_of(strip)
        for i, j in corners:
            key = (id(part), i, j)
            if key not in placed:
                placed[key] = len(part.vertices)
                part.vertices.append((points[i][j], unit(normals[i][j]), uv(i, j) if uv else (0.0, 0.0)))
            part.indices.append(placed[key])


def surface(part, points, **options):
    grid(lambda _: part, points, **options)


def quad(part, a, b, c, d, uv=None):
    """Flat, seen from where a, b, c, d run counter-clockwise."""
    corners = [a, b, c, d]
    surface(part, [[a, d], [b, c]], uv=(lambda i, j: uv(corners[[[0, 3], [1, 2]][i][j]])) if uv else None)


def polygon(part, points, normal, uv=None):
    """A flat convex outline, fanned."""
    first = len(part.vertices)
    for p in points:
        part.vertices.append((p, normal, uv(p) if uv else (0.0, 0.0)))
    for k in range(1, len(points) - 1):
        turn = dot(cross(sub(points[k], points[0]), sub(points[k + 1], points[0])), normal)
        a, b = (k, k + 1) if turn > 0 else (k + 1, k)
        part.indices += [first, first + a, first + b]


def box(part, low, high, uv=None):
    (x0, y0, z0), (x1, y1, z1) = low, high
    p = lambda i, j, k: ((x0, x1)[i], (y0, y1)[j], (z0, z1)[k])
    quad(part, p(0, 1, 1), p(1, 1, 1), p(1, 1, 0), p(0, 1, 0), uv)
    quad(part, p(0, 0, 0), p(1, 0, 0), p(1, 0, 1), p(0, 0, 1), uv)
    quad(part, p(1, 0, 1), p(1, 0, 0), p(1, 1, 0), p(1, 1, 1), uv)
    quad(part, p(0, 0, 0), p(0, 0, 1), p(0, 1, 1), p(0, 1, 0), uv)
    quad(part, p(0, 0, 1), p(1, 0, 1), p(1, 1, 1), p(0, 1, 1), uv)
    quad(part, p(1, 0, 0), p(0, 0, 0), p(0, 1, 0), p(1, 1, 0), uv)


def frames(path, up):
    """(tangent, side, up) at each point of a path."""
    out = []
    for i, _ in enumerate(path):
        tangent = unit(sub(path[min(i + 1, len(path) - 1)], path[max(i - 1, 0)]))
        hint = up if abs(dot(tangent, up)) < 0.98 else (0.0, 0.0, 1.0)
        if out:  # carried along, so that a tube does not twist
            hint = out[-1][2] if abs(dot(tangent, out[-1][2])) < 0.98 else hint
        side = unit(cross(tangent, hint))
        out.append((tangent, side, cross(side, tangent)))
    return out


def tube(part, path, radius, sides=8, caps=True, uv=None):
    """A round tube; `radius` may be one number or one per point."""
    radii = radius if isinstance(radius, list) else [radius] * len(path)
    rings = []
    for p, r, (_, side, up) in zip(path, radii, frames(path, (0.0, 1.0, 0.0))):
        rings.append([add(p, add(scale(side, r * math.cos(a)), scale(up, r * math.sin(a))))
                      for a in (2.0 * math.pi * k / sides for k in range(sides))])
    surface(part, rings, wrap_v=True, uv=uv)
    if caps:
        tangents = frames(path, (0.0, 1.0, 0.0))
        polygon(part, rings[0], scale(tangents[0][0], -1.0), (lambda p: uv(0, 0)) if uv else None)
        polygon(part, rings[-1], tangents[-1][0], (lambda p: uv(0, 0)) if uv else None)


def sweep(part, path, profile, up=(0.0, 1.0, 0.0), fixed_up=True, caps=True, uv=None):
    """A hard-edged profile [(side, up), …], counter-clockwise seen against the path, along a path."""
    placed = []
    for i, p in enumerate(path):
        tangent = unit(sub(path[min(i + 1, len(path) - 1)], path[max(i - 1, 0)]))
        side = unit(cross(tangent, up))
        above = up if fixed_up else cross(side, tangent)
        placed.append([add(p, add(scale(side, s), scale(above, u))) for s, u in profile])
    count = len(profile)
    for k in range(count):
        strip = [[ring[k], ring[(k + 1) % count]] for ring in placed]
        surface(part, strip, uv=(lambda i, j, s=strip: uv(s[i][j])) if uv else None)
    if caps:
        ends = frames(path, up)
        polygon(part, placed[0], scale(ends[0][0], -1.0), uv)
        polygon(part, placed[-1], ends[-1][0], uv)


def lathe(part, centre, profile, sides=20):
    """A body turned about the vertical: profile [(radius, height), …] from the bottom up. Equal
    neighbours are not joined smoothly: each run of the profile is faceted on its own."""
    for (r0, y0), (r1, y1) in zip(profile, profile[1:]):
        rings = [[(centre[0] + r * math.cos(a), centre[1] + y, centre[2] - r * math.sin(a))
                  for a in (2.0 * math.pi * k / sides for k in range(sides))]
                 for r, y in ((r0, y0), (r1, y1))]
        surface(part, rings, wrap_v=True, flip=True)


def naca(x, thickness):
    """Half thickness of a symmetric four-digit section of unit chord (Abbott & von Doenhoff 1959,
    eq. 6.2, with the closed trailing edge)."""
    return 5.0 * thickness * (0.2969 * math.sqrt(x) - 0.1260 * x - 0.3516 * x**2 + 0.2843 * x**3 -
                              0.1036 * x**4)


def foil(part, stations, thickness, chordwise=14):
    """A fin: stations [(y, z of the leading edge, chord), …] from the root down; the tip is closed."""
    rings = []
    for y, lead, chord in stations:
        xs = [0.5 - 0.5 * math.cos(math.pi * k / chordwise) for k in range(chordwise + 1)]
        ring = [(-naca(x, thickness) * chord, y, lead + x * chord) for x in xs]
        ring += [(naca(x, thickness) * chord, y, lead + x * chord) for x in reversed(xs[1:-1])]
        rings.append(ring)
    surface(part, rings, wrap_v=True)
    half = chordwise + 1
    tip = rings[-1]
    outline = [[tip[k], tip[-k % len(tip)]] for k in range(half)]
    surface(part, outline, flip=True)
