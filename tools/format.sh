#!/usr/bin/env bash
# Checks that the C++ sources are laid out as .clang-format says; with --fix, lays them out.
#
#   tools/format.sh [--fix]
#
# Exit codes: 0 as it should be, 1 differs, 2 bad usage, 77 no clang-format here (a skipped test).
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

mode=(--dry-run --Werror)
case ${1:-} in
'') ;;
--fix) mode=(-i) ;;
*) sed -n '4s/^# *//p' "${BASH_SOURCE[0]}" >&2 && exit 2 ;;
esac
command -v clang-format >/dev/null || { echo "format: no clang-format" >&2 && exit 77; }

find database host ig tools tests \( -name '*.h' -o -name '*.cpp' \) -print0 |
    xargs -0 -r clang-format "${mode[@]}" || exit 1
