#!/usr/bin/env bash
# A running window opens its database again when its author saves it, and the flight goes on where it was.
#
#   reload_test.sh LINKDIG
#
# SDL's dummy driver is enough: what the window shows is held by its status on stderr and by what it records of itself.
# Exit codes: 0 passed, 1 failed. Nothing is judged by how long it took: every wait polls.
set -uo pipefail

linkdig=$1
work=$(mktemp -d)
flight= watcher=
cleanup() {
    [[ -n $flight ]] && kill "$flight" 2>/dev/null
    [[ -n $watcher ]] && kill "$watcher" 2>/dev/null
    wait 2>/dev/null
    rm -rf "$work"
}
trap cleanup EXIT
unset DISPLAY WAYLAND_DISPLAY
export SDL_VIDEODRIVER=dummy SDL_AUDIODRIVER=dummy
fail() {
    echo "failed: $*"
    sed 's/^/  fly: /' "$work/fly" 2>/dev/null
    sed 's/^/  compile: /' "$work/compile" 2>/dev/null
    exit 1
}
# until_true WHAT COMMAND...: polls.
until_true() {
    local what=$1 end=$((SECONDS + 120))
    shift
    until "$@"; do
        [[ $SECONDS -lt $end ]] || fail "$what: not within two minutes"
        sleep 0.1
    done
}

# world RGB: a box in a colour, in a file that is replaced at once as editors do.
world() {
    cat >"$work/w.new" <<TOML
[database]
name = "w"
[[sun]]
name = "world"
[[colour]]
name = "paint"
rgb = [$1]
[[cluster]]
name = "box"
priority = 1
[[object_list]]
name = "box"
cluster = "box"
sun = "world"
[[object]]
name = "box"
list = "box"
colour = "paint"
[[object.box]]
from_m = [-5, -5, 0]
to_m = [5, 5, 10]
TOML
    mv "$work/w.new" "$work/w.toml"
}
cat >"$work/flight.toml" <<'TOML'
[scenario]
name = "f"
database = "w.igdb"
duration_s = 9.0
[suns.world]
azimuth_deg = 200.0
elevation_deg = 40.0
[own_ship]
kind = "fixed"
position_m = [0, -60, 15]
aim_m = [0, 0, 5]
[[channel]]
name = "ahead"
horizontal_field_deg = 56.0
TOML

world "200, 0, 0"
"$linkdig" compile "$work/w.toml" -o "$work/w.igdb" --watch >"$work/compile" 2>&1 &
watcher=$!
until_true "the first compilation" test -s "$work/w.igdb"

"$linkdig" fly "$work/flight.toml" --size 64x64 --threads 1 >"$work/fly" 2>&1 &
flight=$!
sleep 1 # it opens the first database; were it slower, it would open the second at once and say nothing: see below
opened() { grep -q "$1" "$work/fly"; }
for attempt in 1 2 3 4 5 6 7 8 9; do
    world "0, 0, 20$attempt"
    end=$((SECONDS + 5))
    until opened 'w opened again: 6 faces' || [[ $SECONDS -ge $end ]]; do sleep 0.1; done
    opened 'w opened again: 6 faces' && break
done
opened 'w opened again: 6 faces' || fail "the window never opened what was compiled"
echo "passed: a save reaches the running window"

# A mistake is told by the compiler; the window keeps what it has, and goes on.
sed -i 's/^rgb.*/rgb = [1, 2]/' "$work/w.toml"
until_true "the mistake is told" grep -q 'w.toml:7:7: error' "$work/compile"
kill -0 "$flight" || fail "a mistake ended the window"
echo broken >"$work/w.igdb"
until_true "a broken file is told" opened 'w.igdb: cannot be read as a visual database'
kill -0 "$flight" || fail "a broken file ended the window"
world "0, 200, 0"
count() { [[ $(grep -c 'opened again' "$work/fly") -ge 2 ]]; }
until_true "the mended file is opened" count
echo "passed: mistakes and broken files change nothing, mending is seen"
