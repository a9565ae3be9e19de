#!/usr/bin/env bash
# Installs what is missing, builds, and runs the tests. Stops at the first preset that fails, so that ctest's closing
# lines are the last output and tell the truth.
#
#   tools/test.sh          the machine's hashes under g++ Debug, clang++ Release and clang++ Debug; three fuzzers
#                          under the address and undefined-behaviour sanitizers, threads under the thread sanitizer;
#                          then every test of the g++ Release build, with format check and clang-tidy of the machine
#   tools/test.sh --all    the same with all short tests in every preset, under the thread sanitizer those in which
#                          threads take part; in g++ Release the long ones too, and clang-tidy of everything (hours)
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
cd "$root"

all=no
case ${1:-} in
'') ;;
--all) all=yes ;;
-h | --help) sed -n '5,9s/^# \{0,3\}//p' "${BASH_SOURCE[0]}" && exit 0 ;;
*) sed -n '5,9s/^# \{0,3\}//p' "${BASH_SOURCE[0]}" >&2 && exit 2 ;;
esac

tools/setup.sh test
if command -v ccache >/dev/null; then export CMAKE_CXX_COMPILER_LAUNCHER=${CMAKE_CXX_COMPILER_LAUNCHER-ccache}; fi
jobs=$(nproc)

headline() { printf '\n== %s (%d:%02d)\n' "$1" $((SECONDS / 60)) $((SECONDS % 60)); }

# build PRESET TARGET...: configures and builds; only a failure shows the compiler's output.
build() {
    local preset=$1 log=build/$1.log
    shift
    mkdir -p build
    headline "$preset: build"
    if ! { cmake --preset "$preset" && cmake --build --preset "$preset" -j "$jobs" --target "$@"; } >"$log" 2>&1; then
        cat "$log"
        echo "test: error: preset $preset does not build" >&2
        exit 1
    fi
}

for preset in gcc-debug clang-release clang-debug; do
    if [[ $all == yes ]]; then
        build "$preset" all
        headline "$preset: every short test"
        ctest --test-dir "build/$preset" -LE long --output-on-failure --no-tests=error -j "$jobs"
    else
        build "$preset" determinism_test
        headline "$preset: determinism"
        ctest --preset "$preset" -j "$jobs"
    fi
done

# The sanitizers: the short form builds only what it runs.
if [[ $all == yes ]]; then
    build asan all
    headline "asan: every short test"
    ctest --test-dir build/asan -LE long --output-on-failure --no-tests=error -j "$jobs"
    build tsan all
    headline "tsan: every short test with threads"
    # Compiling takes one thread; of the databases' tests those that read, and those that fill fields of waves.
    ctest --test-dir build/tsan -LE 'database|long' --output-on-failure --no-tests=error -j "$jobs"
    ctest --test-dir build/tsan -R '^database_test\.(ReadDatabase|Validate|Kelvin)' --output-on-failure --no-tests=error -j "$jobs"
else
    build asan fuzz_test write_seeds fuzz_packet_bytes fuzz_packet_json fuzz_database_file
    headline "asan: fuzzers"
    ctest --preset asan -j 3 # a minute of the clock for all three
    build tsan determinism_test
    headline "tsan: threads"
    ctest --preset tsan -j "$jobs"
fi

build release all
headline "release: every test"
if [[ $all == yes ]]; then
    ctest --test-dir build/release --output-on-failure --no-tests=error -j "$jobs"
else
    ctest --preset release -j "$jobs"
fi
