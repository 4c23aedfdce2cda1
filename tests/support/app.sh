# What the scripts of tests/app share. Source it first; they are run as: SCRIPT BINARY OUTDIR
# shellcheck shell=bash
set -euo pipefail

binary=$(realpath -- "$1")
root=$(realpath -- "$(dirname -- "${BASH_SOURCE[0]}")/../..")
# Everything a test leaves behind lies here; spaces, because users have them.
output=$(realpath -m -- "$2")/"app $(basename -- "$0" .sh)"
rm -rf -- "$output"
mkdir -p -- "$output"
cd -- "$output"

fail() {
  printf 'FAILED: %s\n' "$*"
  if [[ -s stdout.log ]]; then tail -n 5 stdout.log | sed 's/^/  stdout: /'; fi
  if [[ -s stderr.log ]]; then tail -n 10 stderr.log | sed 's/^/  stderr: /'; fi
  exit 1
}

skip() {
  printf 'skipped: %s\n' "$*"
  exit 77 # ctest's SKIP_RETURN_CODE
}

need() {
  local tool
  for tool in "$@"; do
    command -v "$tool" > /dev/null || skip "$tool is not installed (see packages.txt)"
  done
}

[[ -x $binary ]] || fail "$binary is not built"

# ---- a display of our own ------------------------------------------------------------------------
children=()
stop_children() {
  local child
  for child in "${children[@]}"; do kill "$child" 2> /dev/null || true; done
  wait 2> /dev/null || true
}
trap stop_children EXIT

# start_display WIDTH HEIGHT: an empty screen that nobody sees, with no window manager. Without
# -noreset, a server whose last client has left refuses the next one for a moment.
start_display() {
  need Xvfb xdotool
  unset WAYLAND_DISPLAY
  Xvfb -displayfd 3 -screen 0 "$1x$2x24" -nolisten tcp -noreset 3> display 2> xvfb.log &
  children+=($!)
  local try
  for ((try = 0; try < 100; ++try)); do
    if [[ -s display ]]; then break; fi
    sleep 0.1
  done
  [[ -s display ]] || fail "Xvfb did not start: $(tail -n 3 xvfb.log)"
  DISPLAY=:$(< display)
  export DISPLAY
}

# ---- the game, watched ---------------------------------------------------------------------------
# start_game OPTION...: sets `game` (its process) and `window` (its X window), and gives it the keys.
start_game() {
  OFFING_LOG_STATE=1 "$binary" play --size 320x180 --quality low "$@" > stdout.log 2> stderr.log &
  game=$!
  children+=("$game")
  window=""
  eventually 60 "a window opens" find_window
  xdotool windowfocus "$window"
  eventually 60 "the first frames are drawn" state_holds 't > 0'
}

find_window() {
  kill -0 "$game" 2> /dev/null || fail "the game ended before its window opened"
  window=$(xdotool search --onlyvisible --class offing 2> /dev/null | head -n 1)
  [[ $window ]]
}

# state KEY: its value in the newest line that the game logged ("state t=12.3 heading=045.2 …").
last_state() { grep '^state ' stdout.log | tail -n 1 | cut -d ' ' -f 2-; }
state() { last_state | tr ' ' '\n' | sed -n "s/^$1=//p"; }

# state_holds EXPRESSION: in awk, of the newest state. turn(from, to) is the angle from one heading
# to another, in degrees, positive to starboard.
state_holds() {
  local -a values
  read -ra values < <(last_state) || return 1
  awk 'function turn(from, to) { return (to - from + 540) % 360 - 180 }
       END { exit !('"$1"') }' "${values[@]}" /dev/null
}

# eventually SECONDS WHAT COMMAND...: the command succeeds within that time.
eventually() {
  local seconds=$1 what=$2 end=$((SECONDS + $1))
  shift 2
  until "$@"; do
    ((SECONDS < end)) || fail "not within $seconds s: $what ($*; state: $(last_state || true))"
    sleep 0.2
  done
  printf 'ok: %s\n' "$what"
}

ends() { ! kill -0 "$1" 2> /dev/null; }

# expect_exit PROCESS CODE
expect_exit() {
  local code=0
  eventually 30 "the game ends" ends "$1"
  wait "$1" || code=$?
  ((code == $2)) || fail "exit code $code, not $2"
}

# ---- pictures ------------------------------------------------------------------------------------
# deviation FILE: the standard deviation of its values, 0 to 0.5 of the full range.
deviation() { convert "$1" -alpha off -format '%[fx:standard_deviation]' info:; }

# expect_picture FILE WIDTH HEIGHT: it has that size and is no even surface.
expect_picture() {
  local size spread
  size=$(identify -format '%wx%h' "$1") || fail "$1 is no picture"
  [[ $size == "$2x$3" ]] || fail "$1 is $size, not $2x$3"
  spread=$(deviation "$1")
  awk -v spread="$spread" 'BEGIN { exit !(spread > 0.02) }' || fail "$1 is blank (deviation $spread)"
  printf 'ok: %s is a picture (%s, deviation %s)\n' "$1" "$size" "$spread"
}
