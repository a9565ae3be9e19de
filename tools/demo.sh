#!/usr/bin/env bash
# Installs what is missing, builds, and flies the approach: everything after `git clone`.
#
#   tools/demo.sh [options of `linkdig demo`, see tools/demo.sh --help]
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)

"$root/tools/setup.sh" demo
if command -v ccache >/dev/null; then export CMAKE_CXX_COMPILER_LAUNCHER=${CMAKE_CXX_COMPILER_LAUNCHER-ccache}; fi

# The caller's directory stays the current one: `--out D` means the caller's D. Standard output belongs to the demo.
(
    cd "$root"
    cmake --preset release
    cmake --build --preset release --target linkdig -j "$(nproc)"
) >&2

exec "$root/build/release/tools/linkdig" demo "$@"
