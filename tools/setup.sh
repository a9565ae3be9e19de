#!/usr/bin/env bash
# Installs the Debian packages that are missing; does nothing when all are there.
#
#   tools/setup.sh demo    what building and flying needs
#   tools/setup.sh test    that, and what the tests need
#   tools/setup.sh bench   what building needs, and the renderer that tools/bench.sh measures against
#
# Exit codes: 0 done, 2 bad usage, 3 the packages cannot be installed here.
set -euo pipefail

usage() { sed -n '4,6s/^# *//p' "${BASH_SOURCE[0]}"; }
fail() {
    printf 'setup: error: %s\n' "$@" >&2
    exit 3
}

demo_packages=(
    cmake ninja-build g++ pkg-config
    libglm-dev libfmt-dev libtbb-dev libhwy-dev nlohmann-json3-dev libcli11-dev libtomlplusplus-dev
    libflatbuffers-dev flatbuffers-compiler libxxhash-dev
    libopenimageio-dev fonts-dejavu-core zlib1g-dev libassimp-dev
    libembree-dev
    libusb-1.0-0-dev
    libsdl2-dev libavcodec-dev libavformat-dev libavutil-dev libswscale-dev
)
test_packages=(
    libgtest-dev libgmock-dev assimp-testmodels clang libclang-rt-dev clang-format clang-tidy python3
    xvfb xdotool ffmpeg openimageio-tools chromium libumockdev-dev umockdev
)

bench_packages=(libegl-dev libgl-dev libopengl-dev libgl1-mesa-dri libgtest-dev libgmock-dev python3)

set_name=${1:-demo}
case $set_name in
demo) packages=("${demo_packages[@]}") ;;
test) packages=("${demo_packages[@]}" "${test_packages[@]}") ;;
bench) packages=("${demo_packages[@]}" "${bench_packages[@]}") ;;
-h | --help) usage && exit 0 ;;
*) usage >&2 && exit 2 ;;
esac

command -v dpkg-query >/dev/null ||
    fail "this is not a Debian system (no dpkg-query); install by hand: ${packages[*]}"

declare -A installed=()
while read -r package status; do
    [[ $status == installed ]] && installed[$package]=1
done < <(dpkg-query -W -f='${Package} ${db:Status-Status}\n' "${packages[@]}" 2>/dev/null || true)

missing=()
for package in "${packages[@]}"; do
    [[ -n ${installed[$package]:-} ]] || missing+=("$package")
done
((${#missing[@]} > 0)) || exit 0

echo "setup: installing ${missing[*]}" >&2
command -v apt-get >/dev/null || fail "no apt-get here; install by hand: ${missing[*]}"

as_root=()
if ((EUID != 0)); then
    command -v sudo >/dev/null ||
        fail "not root and no sudo; have an administrator run: apt-get install ${missing[*]}"
    as_root=(sudo)
    [[ -t 0 ]] || as_root=(sudo -n) # without a terminal nobody can type a password
fi

apt() { "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get -o DPkg::Lock::Timeout=300 "$@" >&2; }
install() { apt install -y --no-install-recommends "${missing[@]}"; }
known() { apt-cache show --no-all-versions "${missing[@]}" >/dev/null 2>&1; }

# The package lists are fetched only where they are missing, or so old that the mirror no longer has their files.
if known && install; then exit 0; fi
apt update || fail "apt-get update failed: no network, no permission, or a broken mirror"
install || fail "apt-get could not install: ${missing[*]}"
