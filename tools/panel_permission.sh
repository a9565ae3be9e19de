#!/usr/bin/env bash
# Lets whoever sits at this machine open the Logitech (Saitek) Pro Flight panels: installs a udev rule (docs/panel.md).
#
#   tools/panel_permission.sh           installs it, and applies it to panels that are plugged in
#   tools/panel_permission.sh --print   prints it
#
# Exit codes: 0 done, 2 bad usage, 3 it cannot be installed here.
set -euo pipefail

rule='SUBSYSTEM=="usb", ATTR{idVendor}=="06a3", ATTR{idProduct}=="0d05|0d06|0d67", TAG+="uaccess"'
# Rules with this tag count only before 73-seat-late.rules.
file=/etc/udev/rules.d/70-linkdig-panels.rules

fail() {
    printf 'panel_permission: error: %s\n' "$@" >&2
    exit 3
}
case ${1:-} in
'') ;;
--print) echo "$rule" && exit 0 ;;
-h | --help) sed -n '4,5s/^# *//p' "${BASH_SOURCE[0]}" && exit 0 ;;
*) sed -n '4,5s/^# *//p' "${BASH_SOURCE[0]}" >&2 && exit 2 ;;
esac

as_root=()
if ((EUID != 0)); then
    command -v sudo >/dev/null || fail "not root and no sudo; have an administrator write to $file: $rule"
    as_root=(sudo)
fi
[[ -d ${file%/*} ]] || fail "there is no ${file%/*}: this system has no udev"
echo "$rule" | "${as_root[@]}" tee "$file" >/dev/null || fail "$file cannot be written"
command -v udevadm >/dev/null || fail "$file is written, but there is no udevadm; plug the panels in again"
"${as_root[@]}" udevadm control --reload || fail "$file is written, but udev does not listen; plug the panels in again"
"${as_root[@]}" udevadm trigger --subsystem-match=usb --attr-match=idVendor=06a3
echo "$file: $rule"
