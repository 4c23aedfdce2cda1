#!/usr/bin/env bash
# shellcheck disable=SC2154 source-path=SCRIPTDIR source=../support/app.sh
# The command line keeps its contract.   command_line.sh BINARY OUTDIR
source "$(dirname -- "$0")/../support/app.sh"
need python3 cmp
unset DISPLAY WAYLAND_DISPLAY
mkdir empty

# expect_refusal CODE WORD OPTION...: one line on stderr that has the word, nothing else, no file.
expect_refusal() {
  local expected=$1 word=$2 code=0
  shift 2
  (cd empty && "$binary" "$@") > stdout.log 2> stderr.log || code=$?
  ((code == expected)) || fail "offing $*: exit code $code, not $expected"
  (($(wc -l < stderr.log) == 1)) || fail "offing $*: $(wc -l < stderr.log) lines on stderr, not 1"
  grep -qF -- "$word" stderr.log || fail "offing $*: stderr does not name '$word'"
  [[ ! -s stdout.log ]] || fail "offing $*: wrote to stdout"
  [[ -z $(ls -A empty) ]] || fail "offing $*: wrote $(ls -A empty)"
  printf 'ok: %s\n' "$(< stderr.log)"
}

# expect_text PATTERN OPTION...: exit code 0, and stdout has a line that matches.
expect_text() {
  local pattern=$1
  shift
  "$binary" "$@" > stdout.log 2> stderr.log || fail "offing $*: exit code $?"
  grep -qE -- "$pattern" stdout.log || fail "offing $*: no line like '$pattern'"
  [[ ! -s stderr.log ]] || fail "offing $*: wrote to stderr"
}

small=(--size 64x36 --quality low --frames 1 --warmup 0)
draw=(render --out picture.png "${small[@]}")

# ---- wrong usage or bad input: 2 -----------------------------------------------------------------
expect_refusal 2 sial sial
expect_refusal 2 --outt "${draw[@]}" --outt other.png
expect_refusal 2 --out render "${small[@]}"
expect_refusal 2 environment.wind.sped "${draw[@]}" --set environment.wind.sped=3
expect_refusal 2 environment.wind.speed "${draw[@]}" --set environment.wind.speed=-3
expect_refusal 2 environment.wind.speed "${draw[@]}" --set environment.wind.speed=strong
expect_refusal 2 environment.wind.speed "${draw[@]}" --set environment.wind.speed=nan
expect_refusal 2 environment.wind.speed "${draw[@]}" --set environment.wind.speed=
expect_refusal 2 environment.wind.speed "${draw[@]}" --set environment.wind.speed
expect_refusal 2 environment.date "${draw[@]}" --set environment.date=2026-02-30
expect_refusal 2 sea.spectrum "${draw[@]}" --set sea.spectrum=phillips
expect_refusal 2 camera.position "${draw[@]}" --set camera.position=1,2
expect_refusal 2 nowhere "${draw[@]}" --scene nowhere
expect_refusal 2 no/such.toml "${draw[@]}" --scene no/such.toml
expect_refusal 2 huge "${draw[@]}" --quality huge
expect_refusal 2 0x36 render --out picture.png --size 0x36
expect_refusal 2 64by36 render --out picture.png --size 64by36
expect_refusal 2 999999x999999 render --out picture.png --size 999999x999999
expect_refusal 2 --frames render --out picture.png --frames 0
expect_refusal 2 --fps "${draw[@]}" --fps 0
expect_refusal 2 --seed "${draw[@]}" --seed minus
expect_refusal 2 picture.bmp render --out picture.bmp "${small[@]}"
expect_refusal 2 no/such/folder render --out no/such/folder/picture.png "${small[@]}"

printf 'mass = 1950\nrig.mast_top = 0\n' > "$output/hulk.toml"
expect_refusal 2 hulk.toml:2 "${draw[@]}" --set boat.file="$output/hulk.toml"
expect_refusal 2 rig.mast_top export polar --out polar.csv --set boat.file="$output/hulk.toml"
expect_refusal 2 boat.file "${draw[@]}" --set boat.file=r9
expect_refusal 2 boat.glb "${draw[@]}" --set boat.model="$output/boat.glb"

printf '[environment.wind]\nspeed = 5.0\nfrm = 30.0\n' > "$output/typo.toml"
expect_refusal 2 typo.toml:3 "${draw[@]}" --scene "$output/typo.toml"
printf '[environment.wind\n' > "$output/broken.toml"
expect_refusal 2 broken.toml:1 "${draw[@]}" --scene "$output/broken.toml"

# ---- what cannot be done: 1 ----------------------------------------------------------------------
ln -s /dev/full full.png
ln -s /dev/full full.json
expect_refusal 1 full.png render --out "$output/full.png" "${small[@]}"
code=0
"$binary" render --out "$output/kept.png" --report "$output/full.json" "${small[@]}" \
  > stdout.log 2> stderr.log || code=$?
((code == 1)) || fail "a report that cannot be written: exit code $code, not 1"

# ---- asked for -----------------------------------------------------------------------------------
expect_text 'render' --help
expect_text '--out' render --help
expect_text '^(offing )?[0-9]+\.[0-9]+\.[0-9]+$' --version
expect_text 'environment\.wind\.speed.*m/s' --list-keys
for key in environment.{date,time,latitude,longitude,gusts} environment.wind.{speed,from} \
  environment.clouds.{cover,type,precipitation,high} sea.{spectrum,spreading,fetch,depth,choppiness} \
  sea.swell.{height,period,from} boat.{heading,speed,position} camera.{mode,position,target} seed; do
  grep -qE "^ *$key\b" stdout.log || fail "--list-keys does not list $key"
done

# ---- determinism, files --------------------------------------------------------------------------
frames=(--size 64x36 --quality low --frames 3 --fps 10)
"$binary" render --out a.png "${frames[@]}" > stdout.log 2> stderr.log || fail "render: exit code $?"
"$binary" render --out 'all %04d.png' "${frames[@]}" > stdout.log 2> stderr.log ||
  fail "render of every frame: exit code $?"
(($(find . -name 'all *.png' | wc -l) == 3)) || fail "not three frames: $(ls)"
last=$(find . -name 'all *.png' | sort | tail -n 1)
cmp a.png "$last" || fail "two runs of the same scene differ"
first=$(find . -name 'all *.png' | sort | head -n 1)
if cmp -s "$first" "$last"; then fail "nothing moves"; fi
"$binary" render --out other.png --seed 7 "${frames[@]}" > stdout.log 2> stderr.log ||
  fail "render with another seed: exit code $?"
if cmp -s a.png other.png; then fail "another seed makes the same sea"; fi
printf 'ok: the same inputs make the same picture, others another\n'
