#!/usr/bin/env bash
# Makes the pictures of engine/sky/README.md: docs/pictures/make_sky.sh [day|night|discs|probe]. Some minutes
# without a GPU. Needs ImageMagick's montage.
set -euo pipefail
cd -- "$(dirname -- "${BASH_SOURCE[0]}")/../.."
work=$(mktemp -d)
trap 'rm -rf -- "$work"' EXIT
wanted=${1:-day night discs probe}

# shot NAME SIZE DATE TIME AZIMUTH ELEVATION FOV [option...]: from a boat-less place at sea.
shot() {
  local name=$1 size=$2 date=$3 time=$4 azimuth=$5 elevation=$6 fov=$7
  shift 7
  local target
  target=$(awk -v a="$azimuth" -v e="$elevation" 'BEGIN { r = atan2(0, -1) / 180
    printf "%.4f,%.4f,%.4f", 900 + 1000 * cos(e * r) * sin(a * r), 3 + 1000 * sin(e * r), 900 - 1000 * cos(e * r) * cos(a * r) }')
  ./offing render --scene default --out "$work/$name.png" --size "$size" --quality medium --frames 1 --warmup 2 \
    --set environment.date="$date" --set environment.time="$time" --set camera.mode=free \
    --set camera.position=900,3,900 --set camera.target="$target" --set camera.fov="$fov" \
    --set boat.position=4000,-4000 --set environment.clouds.cover=0 --set environment.clouds.high=0 \
    --set environment.clouds.middle=0 "$@"
}

if [[ $wanted == *day* ]]; then
  # Off A Coruña at midsummer, toward the west where the sun sets.
  i=0
  for time in 04:40 07:00 12:30 17:30 19:45 20:15 20:40 23:30; do
    shot "day$i" 240x135 2026-06-21 "$time" 290 12 60
    i=$((i + 1))
  done
  montage "$work"/day[0-7].png -tile 4x2 -geometry +2+2 docs/pictures/sky-day.png
fi
if [[ $wanted == *night* ]]; then
  shot night0 480x270 2026-08-28 21:05 115 14 60                           # full moon, 17 degrees up
  shot night1 480x270 2026-08-13 22:30 200 25 80 --set environment.haze=0  # no moon: the Milky Way
  montage "$work"/night[01].png -tile 2x1 -geometry +2+2 docs/pictures/sky-night.png
fi
if [[ $wanted == *discs* ]]; then
  # azimuth and elevation: ./offing export ephemeris
  # (through a dark glass)
  shot disc0 240x135 2026-08-12 18:20 277.78 13.51 2 --set exposure.bloom=0.02 --set exposure.ev=-6  # the bite
  shot disc1 240x135 2026-08-12 18:28 279.10 12.08 4                       # totality
  shot disc2 240x135 2026-08-26 22:00 153.11 25.50 1.2                     # nearly full
  shot disc3 240x135 2026-08-18 20:50 229.90 8.94 1.2                      # crescent with earthshine
  shot disc4 240x135 2026-08-28 04:12 237.52 16.97 1.2                     # in the earth's shadow
  shot disc5 240x135 2026-08-12 19:38 290.82 0.24 2 --set exposure.bloom=0.02 --set exposure.ev=-2  # the setting sun, flattened
  montage "$work"/disc[0-5].png -tile 3x2 -geometry +2+2 docs/pictures/sky-discs.png
fi
if [[ $wanted == *probe* ]]; then
  # Without the probe and with it: a hazy sky under cumulus, and a low sun.
  for i in 0 1; do
    probe=$([[ $i == 0 ]] && echo false || echo true)
    for time in 15:00 19:00; do
      ./offing render --scene default --out "$work/probe-$time-$i.png" --size 480x270 --quality medium --frames 1 --warmup 4 \
        --set sky.probe="$probe" --set environment.time="$time" --set environment.clouds.cover=0.6
    done
  done
  montage "$work"/probe-15:00-[01].png "$work"/probe-19:00-[01].png -tile 2x2 -geometry +2+2 docs/pictures/sky-probe.png
fi
