#!/bin/bash
# Makes the root with which the preset arm64 builds: Debian's libraries for arm64, unpacked; nothing of them is run.
#
#   test/arm64/root.sh [FOLDER]     default: $TWINBUS_ARM64_ROOT, or ~/.cache/twinbus/roots/arm64
#
# Needs debootstrap; the preset needs g++-aarch64-linux-gnu, and who runs its programs here qemu-user.  The release is that of this
# machine, so that both have one libc.
set -euo pipefail

root=${1:-${TWINBUS_ARM64_ROOT:-$HOME/.cache/twinbus/roots/arm64}}
# Those of config/packages.txt that programs link or include.
libraries=liblcm-dev,libeigen3-dev,libode-dev,libfcl-dev,liburdfdom-dev,libconsole-bridge-dev,libexpat1-dev,libyaml-cpp-dev
libraries+=,nlohmann-json3-dev,libboost-dev,libsdl2-dev,zlib1g-dev,libzstd-dev,libgtest-dev
distribution=$(. /etc/os-release && echo "$ID")
release=$(. /etc/os-release && echo "${VERSION_CODENAME:-}")

[ ! -e "$root/made" ] || { echo "$root is there"; exit 0; }
[ "$distribution" = debian ] || { echo "arm64: takes Debian's libraries from Debian's mirror; this is $distribution: use a machine with Debian" >&2; exit 1; }
command -v debootstrap >/dev/null || { echo "arm64: debootstrap is missing; run: apt-get install debootstrap" >&2; exit 1; }
mirror=$(apt-get indextargets --format '$(CREATED_BY) $(LABEL) $(COMPONENT) $(REPO_URI)' 2>/dev/null |
  awk '$1 == "Packages" && $2 == "Debian" && $3 == "main" {print $4; exit}')
part=$root.part
rm -rf --one-file-system "$part" "$root"
mkdir -p "$part"
# shellcheck disable=SC2086
debootstrap --foreign --arch=arm64 --variant=minbase --include="$libraries" "$release" "$part" $mirror >"$part.log" 2>&1 ||
  { echo "arm64: debootstrap could not: $(tail -1 "$part.log") (all it said: $part.log)" >&2; exit 1; }
for package in "$part"/var/cache/apt/archives/*.deb; do dpkg-deb -x "$package" "$part"; done
rm -f "$part"/var/cache/apt/archives/*.deb
# libm.so -> /lib/...: within the root.
find "$part/usr/lib" "$part/lib" -type l -lname '/*' | while read -r link; do ln -sfn "$(realpath --relative-to "$(dirname "$link")" "$part")$(readlink "$link")" "$link"; done
mv "$part" "$root"
touch "$root/made"
echo "$root is made"
