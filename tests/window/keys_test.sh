#!/usr/bin/env bash
# The window under a virtual display: every key changes what the help says that it changes.
#
#   keys_test.sh LINKDIG [FOLDER]     FOLDER: keep the screenshots there, as PNG
#
# Exit codes: 0 passed, 1 failed, 77 skipped: a program is missing or no virtual display can be had.
# Nothing is judged by how long it took: every wait polls, up to a limit that only a hang reaches.
set -uo pipefail

linkdig=$1
shots=${2:-}
limit_s=60
screen=$(dirname "${BASH_SOURCE[0]}")/screen.py
for program in Xvfb xdotool python3; do
    command -v "$program" >/dev/null || { echo "skipped: no $program"; exit 77; }
done

work=$(mktemp -d)
[[ -z $shots ]] || mkdir -p "$shots"
server=
flight=
cleanup() {
    [[ -n $flight ]] && kill "$flight" 2>/dev/null
    [[ -n $server ]] && kill "$server" 2>/dev/null
    wait 2>/dev/null
    rm -rf "$work"
}
trap cleanup EXIT

fail() {
    echo "failed: $*"
    sed 's/^/  linkdig: /' "$work/log" 2>/dev/null
    exit 1
}
# until_true WHAT COMMAND...: polls.
until_true() {
    local what=$1 end=$((SECONDS + limit_s))
    shift
    until "$@"; do
        [[ $SECONDS -lt $end ]] || fail "$what: not within $limit_s s"
        [[ -z $flight ]] || kill -0 "$flight" 2>/dev/null || fail "$what: linkdig has ended"
        sleep 0.05
    done
}
passed() { echo "passed: $*"; }

# A display number that the server finds itself.
Xvfb -displayfd 3 -screen 0 640x480x24 -nolisten tcp -fbdir "$work" 3>"$work/display" 2>"$work/xvfb" &
server=$!
ready() { [[ -s $work/display ]]; }
alive_or_skip() {
    kill -0 "$server" 2>/dev/null || { cat "$work/xvfb"; echo "skipped: Xvfb does not start"; exit 77; }
    ready
}
until_true "Xvfb starts" alive_or_skip
DISPLAY=:$(cat "$work/display")
export DISPLAY
unset WAYLAND_DISPLAY SDL_VIDEODRIVER
export SDL_RENDER_DRIVER=software SDL_AUDIODRIVER=dummy

"$linkdig" demo --seconds 60 --size 640x480 >"$work/log" 2>&1 &
flight=$!
window() { xdotool search --onlyvisible --name '^linkdig' >"$work/window" 2>/dev/null && [[ -s $work/window ]]; }
until_true "the window opens" window
window=$(head -1 "$work/window")
focused() { xdotool windowfocus "$window" && [[ $(xdotool getwindowfocus) == "$window" ]]; }
until_true "the window takes the keyboard" focused

key() { xdotool key --clearmodifiers "$1" || fail "xdotool key $1"; }

# shot NAME: a screenshot. same NAME NAME AREA: do both show the same there? AREA is picture (right of the help, above
# the status), help, status (its second line, which tells what the keys have set), or all.
shot() {
    python3 "$screen" "$work/Xvfb_screen0" grab "$work/$1.xwd" || fail "no screenshot"
    [[ -z $shots ]] || python3 "$screen" "$work/$1.xwd" png "$shots/$1.png"
}
area() {
    case $1 in
    picture) echo 320 0 320 420 ;;
    help) echo 0 0 300 240 ;;
    status) echo 0 454 640 20 ;;
    all) echo 0 0 640 480 ;;
    esac
}
same() { # shellcheck disable=SC2046 # an area is four words
    python3 "$screen" "$work/$1.xwd" same "$work/$2.xwd" $(area "$3")
}
# Takes a new screenshot NAME and compares with OLD.
now_differs() { shot "$1" && ! same "$1" "$2" "$3"; }
now_same() { shot "$1" && same "$1" "$2" "$3"; }
# Waits until two screenshots in a row are the same: what a key set in motion has arrived.
at_rest() { shot "$1" && sleep 0.3 && now_same rest_again "$1" all; }

# The flight runs.
shot start
until_true "the flight moves" now_differs running start picture
passed "the flight moves"

# pause: nothing changes any more, for longer than it took to change while it ran.
key space
until_true "pause stops the picture" at_rest paused
for again in 1 2 3 4 5; do
    sleep 0.2
    now_same "paused_$again" paused all || fail "the picture moves while paused"
done
passed "pause"

# single step: exactly what was not there before, then at rest again.
key period
until_true "single step changes the picture" now_differs stepped paused picture
until_true "single step stops again" at_rest stepped
passed "single step"

# switch WHAT KEY AREA KEY_BACK: the key changes the area, the other key brings the very same pixels back.
switch() {
    local what=$1 there=$2 where=$3 back=$4 name=${1//[ \']/_}
    key "$there"
    until_true "$what changes the $where" now_differs "$name" stepped "$where"
    until_true "$what comes to rest" at_rest "$name"
    key "$back"
    until_true "$what and back restores the $where" now_same back stepped "$where"
    until_true "$what and back restores the status" now_same back stepped status
    passed "$what"
}
switch "smooth shading off" s picture s
switch "view left" l picture a
switch "view right" 3 picture 1
switch "view down" d picture a
switch "sun up" Up picture Down
switch "sun down" Down picture Up
switch "sea's sun faster" Right status Left
switch "sea's sun slower" Left status Right
switch "help off" h help h

# The three views differ from one another too.
for pair in "view_left view_right" "view_left view_down" "view_right view_down"; do
    read -r one other <<<"$pair"
    same "$one" "$other" picture && fail "$one and $other are the same picture"
done
passed "the views differ"

# reset: the same first frame from wherever it is asked for; and a faster sun makes another second frame of it.
key BackSpace
until_true "reset changes the picture" now_differs reset stepped picture
until_true "reset comes to rest" at_rest reset
key period
until_true "a step after the reset" now_differs second reset picture
until_true "the step comes to rest" at_rest second
key BackSpace
until_true "reset shows the first frame again" now_same reset_again reset picture
passed "reset"
for _ in 1 2 3 4 5 6 7 8; do key Right; done
until_true "eight presses show" now_differs fast reset status
key period
until_true "a step with a fast sun" now_differs fast_second reset picture
until_true "the step comes to rest" at_rest fast_second
same fast_second second picture && fail "three times the rate gives the same second frame"
passed "the sea's pace"

# go on, then quit.
key space
until_true "the flight goes on" now_differs going_on reset picture
key q
end=$((SECONDS + limit_s))
while kill -0 "$flight" 2>/dev/null; do
    [[ $SECONDS -lt $end ]] || fail "quit does not end the program"
    sleep 0.05
done
wait "$flight"
code=$?
flight=
[[ $code == 0 ]] || fail "quit ends with exit code $code"
passed "quit"
