#!/usr/bin/env bash
# Sets linkdig against Mesa's software renderer, llvmpipe: the same frames, in turns of four, the same number of threads.
#
#   tools/bench.sh                 every scene at 1024 and 2048 pixels, with one and with two threads; some minutes
#   tools/bench.sh --quick         three rounds of each instead of fifteen, at 1024 pixels alone
#   tools/bench.sh --json FILE     the rows as JSON, too
#
# A ratio is the peer's time divided by ours: above 1 linkdig is faster. Exit codes: 0 done, 2 bad usage, 3 cannot run here.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
usage() { sed -n '4,6s/^# \{0,3\}//p' "${BASH_SOURCE[0]}"; }

rounds=15 sizes=(1024 2048) json=
while (($# > 0)); do
    case $1 in
    --quick) rounds=3 sizes=(1024) ;;
    --json)
        json=${2:-}
        [[ -n $json ]] || { usage >&2 && exit 2; }
        shift
        ;;
    -h | --help) usage && exit 0 ;;
    *) usage >&2 && exit 2 ;;
    esac
    shift
done

cd "$root"
tools/setup.sh bench
cmake --preset release >/dev/null
cmake --build --preset release -j "$(nproc)" --target bench_peer >/dev/null

scenes=(sea airfield dense approach ames)
parts=$(mktemp -d)
trap 'rm -rf "$parts"' EXIT
for size in "${sizes[@]}"; do
    for threads in 1 2; do
        # llvmpipe draws in the calling thread if it is given none of its own.
        peer_threads=$((threads == 1 ? 0 : threads))
        for scene in "${scenes[@]}"; do
            LP_NUM_THREADS=$peer_threads LIBGL_ALWAYS_SOFTWARE=1 GALLIUM_DRIVER=llvmpipe \
                build/release/tests/bench_peer "$threads" "$size" "$rounds" "$scene" \
                >"$parts/$size-$threads-$scene.json"
        done
    done
done

python3 - "$json" "$parts"/*.json <<'PYTHON'
import json, sys
rows = [row for path in sys.argv[2:] for row in json.load(open(path))]
rows.sort(key=lambda row: (row["smoothing"], row["peer"], row["size"], row["threads"], row["scene"]))
print(f'{"scene":<10}{"size":>6}{"threads":>8}  {"against":<32}{"median":>8}{"min":>8}{"max":>8}{"linkdig ms":>12}{"peer ms":>10}')
for row in rows:
    print(f'{row["scene"]:<10}{row["size"]:>6}{row["threads"]:>8}  {row["peer"] + (", smoothed" if row["smoothing"] else ""):<32}'
          f'{row["ratio_median"]:>8.2f}{row["ratio_min"]:>8.2f}{row["ratio_max"]:>8.2f}{row["linkdig_ms"]:>12.3f}{row["peer_ms"]:>10.3f}')
print("A ratio is the peer's time divided by linkdig's. 'itself': linkdig's own time without smoothing or in clear air.")
if sys.argv[1]:
    with open(sys.argv[1], "w") as file:
        json.dump(rows, file, indent=2)
PYTHON
