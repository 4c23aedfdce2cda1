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
# The sea from a calm to a gale, from high up and toward the sun.
sea() { # NAME SCENE WIND POSITION TARGET [option...]
  local name=$1 scene=$2 wind=$3 position=$4 target=$5
  shift 5
  shot "sea_$name" "$scene" 20 --set camera.mode=free --set camera.position="$position" \
    --set camera.target="$target" --set environment.wind.speed="$wind" "$@"
}
sea calm calm 2 12,4,14 40,0,0
sea trade default 9 12,4,14 40,0,0
sea gale gale 18 12,5,14 40,0,0
sea high gale 18 0,500,0 400,0,300
sea sun sunset 6 12,4,14 -40,1,10
