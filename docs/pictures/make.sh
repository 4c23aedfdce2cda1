#!/usr/bin/env bash
# Makes the pictures of the READMEs: docs/pictures/make.sh [NAME...]. Minutes each without a GPU.
set -euo pipefail
cd -- "$(dirname -- "${BASH_SOURCE[0]}")/../.."
wanted=" $* "
shot() { # NAME SCENE FRAMES_BEFORE [option...]
  local name=$1 scene=$2 before=$3
  shift 3
  if [[ $wanted != "  " && $wanted != *" $name "* ]]; then return; fi
  ./offing render --scene "$scene" --out "docs/pictures/$name.png" --size "${size:-960x540}" \
    --quality "${quality:-high}" --fps 15 --warmup "$before" "$@"
}
shot default default 45
shot gale gale 45
shot sunset sunset 15
shot moonlight moonlight 15
shot helm default 15 --set camera.mode=helm
shot underwater default 3 --set camera.mode=free --set camera.position=6.5,-1.7,4.2 \
  --set camera.target=0,0.9,0
# The boat from her deck and from astern, in three sea states.
size=640x360 quality=medium
for wind in 4 9 15; do
  shot "boat_deck_$wind" default 30 --set camera.mode=helm --set environment.wind.speed="$wind"
  shot "boat_astern_$wind" default 30 --set camera.mode=chase --set environment.wind.speed="$wind"
done
