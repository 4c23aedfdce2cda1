#!/usr/bin/env bash
# shellcheck disable=SC2154 source-path=SCRIPTDIR source=../support/app.sh
# The window shows a picture, and survives what windows go through.   window.sh BINARY OUTDIR
source "$(dirname -- "$0")/../support/app.sh"
need awk import convert identify python3

# grab NAME WIDTH HEIGHT: what the screen shows where the window is.
grab() {
  import -window root screen.png
  convert screen.png -crop "$2x$3+$left+$top" +repage "$1"
}

drawn_since() { state_holds "t > $1"; }
menu_shown() { state_holds 'menu == 1'; }
menu_hidden() { state_holds 'menu == 0'; }

start_display 800 600
start_game --seed 1
eval "$(xdotool getwindowgeometry --shell "$window" | sed -n 's/^X=/left=/p; s/^Y=/top=/p')"

grab first.png 320 180
expect_picture first.png 320 180

xdotool windowsize "$window" 480 270
sleep 1
now=$(state t)
eventually 60 "it draws on after a resize" drawn_since "$now"
grab larger.png 480 270
expect_picture larger.png 480 270
convert larger.png -crop 150x80+330+190 +repage corner.png # was not there before
expect_picture corner.png 150 80

xdotool windowsize "$window" 1 1 # the smallest there is: half of it is nothing
sleep 1
now=$(state t)
eventually 60 "it lives on at 1x1" drawn_since "$now"

xdotool windowsize "$window" 320 180
python3 "$root/tests/support/x11.py" iconify "$window"
sleep 2
kill -0 "$game" || fail "the game ended when it was minimised"
now=$(state t)
sleep 2.5 # long enough for two more lines
state_holds "t == $now" || fail "it goes on drawing what nobody sees: t was $now, is $(state t)"
python3 "$root/tests/support/x11.py" restore "$window"
sleep 1
now=$(state t)
eventually 60 "it draws on after it was minimised" drawn_since "$now"
grab restored.png 320 180
expect_picture restored.png 320 180

xdotool windowfocus "$window" key Escape
eventually 30 "Esc opens the menu" menu_shown
xdotool key Escape
eventually 30 "Esc closes it" menu_hidden

python3 "$root/tests/support/x11.py" close "$window"
expect_exit "$game" 0
if grep -iE 'warning|error' stderr.log; then fail "it complained on stderr"; fi
