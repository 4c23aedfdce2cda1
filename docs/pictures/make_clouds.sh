#!/usr/bin/env bash
# Makes the pictures of engine/clouds/README.md: docs/pictures/make_clouds.sh [views|kinds]. Minutes without a
# GPU. Needs ImageMagick's montage.
set -euo pipefail
cd -- "$(dirname -- "${BASH_SOURCE[0]}")/../.."
work=$(mktemp -d)
trap 'rm -rf -- "$work"' EXIT
wanted=${1:-views kinds}

# shot NAME SIZE TIME AZIMUTH ELEVATION FOV HEIGHT [option...]: from a boat-less place at sea.
shot() {
  local name=$1 size=$2 time=$3 azimuth=$4 elevation=$5 fov=$6 height=$7
  shift 7
  local target
  target=$(awk -v a="$azimuth" -v e="$elevation" -v h="$height" 'BEGIN { r = atan2(0, -1) / 180
    printf "%.4f,%.4f,%.4f", 900 + 1000 * cos(e * r) * sin(a * r), h + 1000 * sin(e * r), 900 - 1000 * cos(e * r) * cos(a * r) }')
  ./offing render --scene default --out "$work/$name.png" --size "$size" --quality medium --frames 1 --warmup 16 \
    --fps 20 --set boat.position=-3000,0 --set environment.time="$time" --set camera.mode=free \
    --set camera.position="900,$height,900" --set camera.target="$target" --set camera.fov="$fov" "$@"
}

if [[ $wanted == *views* ]]; then
  # The sun stands 60 degrees high, then 5; the last view looks up 55 degrees.
  shot noon 640x360 11:55:00 285 12 60 3
  shot sunset 640x360 19:08:00 285 8.5 60 3
  shot up 640x360 11:55:00 130 55 75 3
  montage "$work"/noon.png "$work"/sunset.png "$work"/up.png -tile 1x3 -geometry +2+2 docs/pictures/clouds-views.png
fi
if [[ $wanted == *kinds* ]]; then
  shot 1stratus 320x180 14:00:00 285 12 60 3 --set environment.clouds.cover=0.7 --set environment.clouds.type=0
  shot 2stratocumulus 320x180 14:00:00 285 12 60 3 --set environment.clouds.cover=0.6 --set environment.clouds.type=0.5
  shot 3cumulus 320x180 14:00:00 340 10 60 3
  shot 4storm 320x180 14:00:00 285 12 60 3 --set environment.clouds.cover=0.5 --set environment.clouds.precipitation=0.8 \
    --set camera.position=-4000,3,-2000 --set camera.target=-3134,200,-1500
  shot 5overcast 320x180 14:00:00 285 12 60 3 --set environment.clouds.cover=1 --set environment.clouds.type=0.5
  shot 6cirrus 320x180 11:55:00 285 25 75 3 --set environment.clouds.cover=0.05 --set environment.clouds.high=0.5 --set environment.clouds.middle=0
  shot 7moon 320x180 22:00:00 149 14 60 3 --set environment.date=2026-08-26
  shot 8above 320x180 11:55:00 285 -12 60 3600
  shot 9among 320x180 11:55:00 285 3 60 1150
  montage "$work"/[1-9]*.png -tile 3x3 -geometry +2+2 docs/pictures/clouds-kinds.png
fi
