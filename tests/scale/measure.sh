#!/usr/bin/env bash
# Compiles, opens and draws a terrain of FACES faces (default a million), and shows what each takes. Fails where memory
# passes 2 GiB or a step fails; times are shown, not judged: they are the machine's affair.
#
#   measure.sh LINKDIG [FACES]
set -euo pipefail
linkdig=$1 faces=${2:-1000000}
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

python3 "$here/terrain.py" "$faces" "$work"
ls -l "$work" | awk 'NR > 1 { print $5, $9 }'
measured() {
    local what=$1
    shift
    python3 - "$what" "$@" <<'PYTHON'
import resource, subprocess, sys, time
begin = time.monotonic()
code = subprocess.call(sys.argv[2:])
used = resource.getrusage(resource.RUSAGE_CHILDREN)
print(f"{sys.argv[1]}: {time.monotonic() - begin:.2f} s ({used.ru_utime:.2f} user, {used.ru_stime:.2f} system), "
      f"{used.ru_maxrss / 1024:.0f} MiB", flush=True)
sys.exit(code or (1 if used.ru_maxrss > 2 * 1024 * 1024 else 0))
PYTHON
}
measured compile "$linkdig" compile "$work/terrain.toml" -o "$work/terrain.igdb"
measured inspect "$linkdig" inspect "$work/terrain.igdb"
measured preview "$linkdig" preview "$work/terrain.igdb" -o "$work/sheet.png"
[[ -z ${SHEET:-} ]] || cp "$work/sheet.png" "$SHEET"
