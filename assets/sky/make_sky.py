"""Makes stars.bin and milky_way.pgm from the data of d3-celestial 0.7.35 (BSD-3-Clause).

    npm pack d3-celestial@0.7.35 && tar xzf d3-celestial-0.7.35.tgz
    python3 assets/sky/make_sky.py package/data assets/sky

Standard library only; the same bytes every time.
"""
import json
import math
import struct
import sys
import zlib
from pathlib import Path

WIDTH, HEIGHT = 720, 200  # galactic longitude 0 to 360 (column 0 begins at 0), latitude 50 to -50
REACH_DEG = 50.0
# Band of the outlines from the outermost inward, 10^-6 cd/m^2 above the sky between. They are drawn by
# eye after photographs; these values follow the photometry of Pioneer 10 at 440 nm and of Leinert et
# al. 1998, table 35: 40 to 100 S10 beside the band, some 300 in Cygnus, 500 in the clouds of
# Sagittarius (1 S10 = 8.3e-7 cd/m^2).
LEVELS = (45.0, 105.0, 190.0, 310.0, 490.0)
BLUR_DEG = (4.0, 2.2, 1.4, 1.0, 0.8)  # standard deviation: an outline's edge is no edge in the sky
UNIT = 2.0  # 10^-6 cd/m^2 for a step of the picture


def stars(source):
    """Magic, count, then right ascension and declination (10^-4 degree, J2000), magnitude (1/100) and
    colour index B-V (1/1000) of each star, brightest first; CRC-32 of all that."""
    rows = []
    for feature in json.loads((source / "stars.6.json").read_text())["features"]:
        ra, dec = feature["geometry"]["coordinates"]
        colour = feature["properties"]["bv"]
        magnitude = feature["properties"]["mag"]
        rows.append((round(magnitude * 100), round(ra % 360.0 * 1e4), round(dec * 1e4),
                     round(float(colour or 0.6) * 1000)))  # two have none: the sun's will do
    rows.sort()
    data = b"OFFSTAR1" + struct.pack("<I", len(rows))
    for magnitude, ra, dec, colour in rows:
        data += struct.pack("<Iihh", ra, dec, magnitude, colour)
    return data + struct.pack("<I", zlib.crc32(data))


def galactic_from_equatorial():
    """Rows: the axes of galactic coordinates in J2000 (pole 192.85948, 27.12825, node 32.93192)."""
    ra, dec, node = (math.radians(a) for a in (192.85948, 27.12825, 122.93192))
    pole = (math.cos(dec) * math.cos(ra), math.cos(dec) * math.sin(ra), math.sin(dec))
    # Toward the north celestial pole, square to the galactic pole: longitude 122.93192 there.
    north = (-math.sin(dec) * math.cos(ra), -math.sin(dec) * math.sin(ra), math.cos(dec))
    west = (north[1] * pole[2] - north[2] * pole[1], north[2] * pole[0] - north[0] * pole[2],
            north[0] * pole[1] - north[1] * pole[0])
    x = [math.cos(node) * n + math.sin(node) * w for n, w in zip(north, west)]
    y = [math.sin(node) * n - math.cos(node) * w for n, w in zip(north, west)]
    return x, y, pole


def fill(rings):
    """1 where the outline covers a pixel, 0 elsewhere: even and odd crossings on the way to the pole,
    which lies outside."""
    crossings = [[] for _ in range(WIDTH)]
    for ring in rings:
        for (l0, b0), (l1, b1) in zip(ring, ring[1:] + ring[:1]):
            step = (l1 - l0 + 180.0) % 360.0 - 180.0
            if step == 0.0:
                continue
            low, high = sorted((l0, l0 + step))
            first = math.ceil(low / 360.0 * WIDTH - 0.5)
            while (first + 0.5) * 360.0 / WIDTH < high:
                share = ((first + 0.5) * 360.0 / WIDTH - l0) / step
                crossings[first % WIDTH].append(b0 + share * (b1 - b0))
                first += 1
    picture = [[0.0] * WIDTH for _ in range(HEIGHT)]
    for column, at in enumerate(crossings):
        for row in range(HEIGHT):
            latitude = REACH_DEG * (1.0 - 2.0 * (row + 0.5) / HEIGHT)
            picture[row][column] = float(sum(b > latitude for b in at) % 2)
    return picture


def blur_line(line, radius, wrap):
    weights = [math.exp(-0.5 * (i / radius) ** 2) for i in range(-int(3 * radius), int(3 * radius) + 1)]
    total, reach = sum(weights), len(weights) // 2
    result = []
    for i in range(len(line)):
        value = 0.0
        for j, weight in enumerate(weights):
            at = i + j - reach
            if wrap:
                at %= len(line)
            if 0 <= at < len(line):
                value += weight * line[at]
        result.append(value / total)
    return result


def milky_way(source):
    """A PGM whose values times UNIT are 10^-6 cd/m^2."""
    x, y, z = galactic_from_equatorial()
    total = [[0.0] * WIDTH for _ in range(HEIGHT)]
    below = 0.0
    features = json.loads((source / "mw.json").read_text())["features"]
    for feature, level, blur in zip(features, LEVELS, BLUR_DEG):
        rings = []
        for polygon in feature["geometry"]["coordinates"]:
            for ring in polygon:
                points = []
                for ra, dec in ring:
                    a, d = math.radians(ra), math.radians(dec)
                    v = (math.cos(d) * math.cos(a), math.cos(d) * math.sin(a), math.sin(d))
                    gx, gy, gz = (sum(p * q for p, q in zip(axis, v)) for axis in (x, y, z))
                    points.append((math.degrees(math.atan2(gy, gx)) % 360.0,
                                   math.degrees(math.asin(max(-1.0, min(1.0, gz))))))
                rings.append(points)
        covered = [blur_line(row, blur / 360.0 * WIDTH, True) for row in fill(rings)]
        columns = [blur_line(column, blur / 360.0 * WIDTH, False) for column in zip(*covered)]
        for row in range(HEIGHT):
            for column in range(WIDTH):
                total[row][column] += (level - below) * columns[column][row]
        below = level
    pixels = bytes(min(255, round(value / UNIT)) for row in total for value in row)
    return b"P5\n%d %d\n255\n" % (WIDTH, HEIGHT) + pixels


def main():
    source, target = Path(sys.argv[1]), Path(sys.argv[2])
    (target / "stars.bin").write_bytes(stars(source))
    (target / "milky_way.pgm").write_bytes(milky_way(source))


main()
