#!/usr/bin/env bash
# shellcheck disable=SC2154 source-path=SCRIPTDIR source=../support/app.sh
# Real keys sail the boat.   keys.sh BINARY OUTDIR
source "$(dirname -- "$0")/../support/app.sh"
need awk

start_display 640 480
# A beam reach in a fresh breeze, from a standstill: the trim is automatic at the start.
start_game --set boat.speed=0 --set boat.heading=90 --set environment.wind.from=0 \
  --set environment.wind.speed=8 --set environment.gusts=0
eventually 120 "the boat gathers way with automatic trim" state_holds 'speed > 1'
before=$(state t)
eventually 120 "ten seconds pass" state_holds "t > $before + 10"
state_holds "turn(90, heading) > -10 && turn(90, heading) < 10" ||
  fail "she does not hold her heading of 90: it is $(state heading)"

before=$(state heading)
xdotool keydown a
eventually 60 "A puts the rudder over" state_holds 'rudder != 0'
eventually 120 "A turns the bow to port" state_holds "turn($before, heading) < -10"
xdotool keyup a
eventually 60 "the rudder centres itself" state_holds 'rudder > -0.05 && rudder < 0.05'

before=$(state heading)
xdotool keydown Right
eventually 120 "Right turns the bow to starboard" state_holds "turn($before, heading) > 10"
xdotool keyup Right

xdotool key space
eventually 30 "Space shows the panels" state_holds 'panel == 1'
xdotool key space
eventually 30 "Space hides them again" state_holds 'panel == 0'

xdotool key p
eventually 30 "P pauses" state_holds 'paused == 1'
before=$(state t)
sleep 2.5 # long enough for two more lines
state_holds "t - $before < 0.1" || fail "time goes on while paused: t was $before, is $(state t)"
xdotool key p
eventually 30 "P goes on" state_holds "paused == 0 && t > $before"

xdotool keydown a keydown d
sleep 0.5
xdotool keyup a keyup d
kill -0 "$game" || fail "the game ended by itself"
python3 "$root/tests/support/x11.py" close "$window"
expect_exit "$game" 0
