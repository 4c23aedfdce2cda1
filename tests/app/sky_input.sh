#!/usr/bin/env bash
# shellcheck disable=SC2154 source-path=SCRIPTDIR source=../support/app.sh
# What the sky refuses: dates, places, palettes, star files.   sky_input.sh BINARY OUTDIR
source "$(dirname -- "$0")/../support/app.sh"
unset DISPLAY WAYLAND_DISPLAY

# refused WORD OPTION...: exit code 2 and one line on stderr that has the word.
refused() {
  local word=$1 code=0
  shift
  "$binary" "$@" > stdout.log 2> stderr.log || code=$?
  ((code == 2)) || fail "offing $*: exit code $code, not 2"
  (($(wc -l < stderr.log) == 1)) || fail "offing $*: $(wc -l < stderr.log) lines on stderr, not 1"
  grep -qF -- "$word" stderr.log || fail "offing $*: stderr does not name '$word'"
  [[ ! -e picture.png ]] || fail "offing $*: wrote a picture"
  printf 'ok: %s\n' "$(< stderr.log)"
}
draw=(render --out picture.png --size 32x18 --quality low --frames 1 --warmup 0)

refused environment.date "${draw[@]}" --set environment.date=1599-12-31
refused environment.date "${draw[@]}" --set environment.date=2201-01-01
refused environment.latitude "${draw[@]}" --set environment.latitude=90.001
refused environment.latitude "${draw[@]}" --set environment.latitude=-91
refused environment.longitude "${draw[@]}" --set environment.longitude=181

frame() { # HOUR
  printf '[[frame]]\nhour = %s\nzenith = "#204080"\nmiddle = "#4080c0"\nhorizon = "#c0d0e0"\n' "$1"
  printf 'luminance = [1000, 2000, 4000]\nsun = "#ffffff"\nsun_lux = 50000\nmoon = "#ffffff"\nmoon_lux = 0.2\n'
}
{ frame 12; frame 6; } > unsorted.toml
refused unsorted.toml:12 "${draw[@]}" --set sky.palette_mode=replace --set sky.palette=unsorted.toml
frame 12 > single.toml
refused single.toml:1 "${draw[@]}" --set sky.palette_mode=replace --set sky.palette=single.toml
refused nowhere "${draw[@]}" --set sky.palette=nowhere
refused sky.palette_mode "${draw[@]}" --set sky.palette_mode=paint

# The same program with a star file of which half is gone.
mkdir -p cut/assets/sky
ln -s "$root/shaders" cut/shaders
for folder in "$root"/assets/*/; do
  [[ $(basename -- "$folder") == sky ]] || ln -s "$folder" "cut/assets/$(basename -- "$folder")"
done
cp -- "$root"/assets/sky/* cut/assets/sky/
head -c 30000 "$root/assets/sky/stars.bin" > cut/assets/sky/stars.bin
OFFING_ROOT=$PWD/cut refused "stars.bin: cut short" "${draw[@]}"
