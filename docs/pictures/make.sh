#!/usr/bin/env bash
# Makes the pictures of the READMEs, from the repository's root: docs/pictures/make.sh
set -euo pipefail
cd -- "$(dirname -- "${BASH_SOURCE[0]}")/../.."
shot() { # NAME SCENE [option...]
  local name=$1 scene=$2
  shift 2
  ./offing render --scene "$scene" --out "docs/pictures/$name.png" --size 960x540 --quality high --warmup 240 "$@"
}
shot default default
shot gale gale
shot sunset sunset
shot moonlight moonlight
shot helm default --set camera.mode=helm
shot calm calm
