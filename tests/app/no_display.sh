#!/usr/bin/env bash
# shellcheck disable=SC2154 source-path=SCRIPTDIR source=../support/app.sh
# Without a display, play says so and renders a picture instead.   no_display.sh BINARY OUTDIR
source "$(dirname -- "$0")/../support/app.sh"
need awk convert identify

# expect_rendered HOW COMMAND...
expect_rendered() {
  local how=$1
  shift
  rm -f offing.png
  "$@" > stdout.log 2> stderr.log || fail "$how: exit code $?"
  grep -qi display stdout.log stderr.log || fail "$how: it does not say that there is no display"
  [[ -s offing.png ]] || fail "$how: offing.png was not written to the working directory"
  expect_picture offing.png 320 180
}

options=(--size 320x180 --quality low)
expect_rendered "no display" env -u DISPLAY -u WAYLAND_DISPLAY "$binary" "${options[@]}"
# As after a broken ssh connection.
expect_rendered "a dead display" env -u WAYLAND_DISPLAY DISPLAY=:4094 "$binary" play "${options[@]}"
