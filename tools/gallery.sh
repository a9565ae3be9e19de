#!/usr/bin/env bash
# The pictures of docs/gallery.md: a contact sheet of every shipped database and sea, and frames of the shipped scenarios.
#
#   tools/gallery.sh [LINKDIG [FOLDER]]     defaults: build/release/tools/linkdig, docs/images/gallery
#
# Needs oiiotool (package openimageio-tools). Pictures are drawn anew, none is touched up.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
linkdig=${1:-$root/build/release/tools/linkdig} out=${2:-$root/docs/images/gallery}
scenes=$root/database/scenes
command -v oiiotool >/dev/null || { echo "gallery: error: no oiiotool; install openimageio-tools" >&2; exit 3; }
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
mkdir -p "$out"

# jpeg PICTURE NAME
jpeg() { oiiotool "$1" --compression jpeg:78 -o "$out/$2.jpg"; }
# sheet DATABASE NAME
sheet() {
    "$linkdig" preview "$1" -o "$work/sheet.png" --size 480x320
    jpeg "$work/sheet.png" "$2"
}
# frames SCENARIO NAME FRAME...: frames side by side, two to a row
frames() {
    local scenario=$1 name=$2 frame
    shift 2
    for frame in "$@"; do
        "$linkdig" render "$scenes/$scenario" --frames "$frame" --size 720x480 --out "$work/$name"
    done
    oiiotool "$work/$name"/colour_*.png --mosaic:pad=6 "2x$((($# + 1) / 2))" -o "$work/$name.png"
    jpeg "$work/$name.png" "$name"
}

for database in first_flight two_ships pier runway_lights plattsburgh pease; do
    sheet "$scenes/$database/$database.toml" "$database"
done

# A sea is no database of its own: under a sky, alone.
for sea in "$scenes"/seas/*.toml; do
    name=$(basename "$sea" .toml)
    {
        printf 'include = ["%s", "%s"]\n' "../..$scenes/skies/day.toml" "../..$sea"
        printf '[database]\nname = "%s"\n' "$name"
        printf '[[sun]]\nname = "%s"\n' world ocean churn sky
    } >"$work/$name.toml"
    sheet "$work/$name.toml" "sea_$name"
done

frames first_flight/approach.toml scenario_approach 0 240 420 599
frames two_ships/in_company.toml scenario_in_company 0 240 420 599
frames two_ships/night_in_company.toml scenario_night_in_company 0 240 420 599
frames pier/passing.toml scenario_passing 0 200 400 599
frames plattsburgh/approach.toml scenario_plattsburgh 0 900 1400 1799
frames plattsburgh/night.toml scenario_plattsburgh_night 0 900 1400 1799
frames plattsburgh/pattern.toml scenario_plattsburgh_pattern 0 600 900 1199
frames plattsburgh/vtol.toml scenario_plattsburgh_vtol 0 300 600 890
frames plattsburgh/ramp.toml scenario_plattsburgh_ramp 0 300 600 890
frames pease/approach.toml scenario_pease 0 900 1400 1799
frames pease/pattern.toml scenario_pease_pattern 0 600 900 1199
frames pease/night.toml scenario_pease_night 0 900 1400 1799
frames runway_lights/night_approach.toml scenario_runway_lights 0 200 400 599
