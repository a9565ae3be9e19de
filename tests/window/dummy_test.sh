#!/usr/bin/env bash
# Which way `linkdig demo` takes: a window where SDL can open one, files where it cannot.
#
#   dummy_test.sh LINKDIG
#
# Exit codes: 0 passed, 1 failed.
set -uo pipefail

linkdig=$1
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
unset DISPLAY WAYLAND_DISPLAY SDL_VIDEODRIVER
fail() {
    echo "failed: $*"
    sed 's/^/  linkdig: /' "$work/log"
    exit 1
}
# demo NAME ARGUMENT...: runs the demo with output to $work/NAME.
demo() {
    local name=$1
    shift
    "$linkdig" demo --frames 3 --size 64x64 --out "$work/$name" "$@" >"$work/log" 2>&1
}

# SDL's dummy driver needs no display: a window that nobody sees, and no files.
SDL_VIDEODRIVER=dummy demo window || fail "exit code $? with SDL's dummy driver"
grep -q '^3 frames at 60 Hz' "$work/log" || fail "no summary of the window's flight"
[[ ! -e $work/window ]] || fail "a window wrote files"
echo "passed: window on SDL's dummy driver"

# written NAME: three frames, a film and a sheet.
written() {
    [[ -s $work/$1/frame_000000.png && -s $work/$1/frame_000002.png && ! -e $work/$1/frame_000003.png &&
        -s $work/$1/contact.png ]]
}

demo files || fail "exit code $? without a display"
written files || fail "no files without a display"
echo "passed: files without a display"

DISPLAY=:65534 demo unreachable || fail "exit code $? with a display that is not there"
written unreachable || fail "no files with a display that is not there"
grep -q 'files are written instead' "$work/log" || fail "nobody said why there is no window"
echo "passed: files where the display cannot be opened"

SDL_VIDEODRIVER=dummy demo headless --headless || fail "exit code $? with --headless"
written headless || fail "no files with --headless"
diff -r "$work/files" "$work/headless" >"$work/log" || fail "two runs differ"
echo "passed: --headless, with the same bytes"
