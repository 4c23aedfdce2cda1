#!/usr/bin/env bash
# Makes beaufort.png: the sea by wind force 0 to 10, side by side, with a fetch of 300 km.
# docs/pictures/make_beaufort.sh [QUALITY]; needs ImageMagick. A minute or two without a GPU.
set -euo pipefail
cd -- "$(dirname -- "${BASH_SOURCE[0]}")/../.."
folder=$(mktemp -d)
trap 'rm -rf -- "$folder"' EXIT
# Wind in the middle of each force, m/s.
winds=(0.1 0.9 2.4 4.4 6.7 9.3 12.3 15.5 19.0 22.6 26.5)
pictures=()
for force in "${!winds[@]}"; do
  ./offing render --scene sea --quality "${1:-low}" --size 180x240 --frames 1 --warmup 12 --fps 15 \
    --set environment.wind.speed="${winds[force]}" --set sea.swell.height=0 --set sea.fetch=300 \
    --set camera.position=300,7,0 --set camera.target=400,-18,-40 --out "$folder/$force.png"
  pictures+=("$folder/$force.png")
done
convert "${pictures[@]}" +append -colors 200 -strip docs/pictures/beaufort.png
