#!/bin/bash
# Each package of config/packages.txt is taken out of the list, one at a time, in a clean root: what says so, and how?
#
#   without_each.sh [--release NAME] [PACKAGE...]
#
# Goes on from the root that `clean_root.sh --keep` left.  Per package: what apt would not install any more is removed, then
# ./twinbus has to fail while it configures, or packages_test.py after it, and name the package.
set -euo pipefail
here=$(cd -- "$(dirname -- "$(readlink -f -- "$0")")" && pwd)
tree=$(dirname "$(dirname "$here")")
release=trixie
if [ "${1:-}" = --release ]; then release=$2; shift 2; fi
cache=${XDG_CACHE_HOME:-$HOME/.cache}/twinbus/roots
work=$cache/$release-$(printf %s "$tree" | cksum | cut -d' ' -f1)
[ -e "$work.commit" ] || { echo "without_each.sh: no root; run: $here/clean_root.sh --release $release --keep"; exit 2; }
list=$tree/config/packages.txt
packages=$(awk '/^#/ || NF == 0 || $1 ~ /:$/ {next} {print $1}' "$list")
wanted=${*:-$packages}
failed=0
in_root() { env -i HOME=/root LANG=C.UTF-8 PATH="$PATH" chroot "$1" "${@:2}"; }
try_without() {
  local package=$1 top=$work.without found
  rm -rf --one-file-system "$top"
  mkdir -p "$top/upper" "$top/work" "$top/merged"
  mount -t overlay overlay -o "lowerdir=$work,upperdir=$top/upper,workdir=$top/work" "$top/merged"
  mount -t proc proc "$top/merged/proc"
  mount --rbind /dev "$top/merged/dev"
  git -C "$top/merged/twinbus" fetch -q "file://$tree" HEAD
  git -C "$top/merged/twinbus" checkout -q --detach FETCH_HEAD
  sed -i "/^$package /d" "$top/merged/twinbus/config/packages.txt"
  # What is there only because of it goes.
  # shellcheck disable=SC2046
  in_root "$top/merged" sh -c "apt-mark auto $package && DEBIAN_FRONTEND=noninteractive apt-get autoremove -y -q -o APT::AutoRemove::RecommendsImportant=false -o APT::AutoRemove::SuggestsImportant=false" >"$top/apt.log" 2>&1
  # Once it configured it builds, and that is waited for no longer.
  (cd / && exec setsid unshare --pid --fork --kill-child env -i HOME=/root LANG=C.UTF-8 PATH="$PATH" chroot "$top/merged" \
    sh -c 'cd /twinbus && TWINBUS_BUILDS=/tmp/builds exec ./twinbus --no-install --version') </dev/null >"$top/said" 2>&1 &
  local child=$!
  while kill -0 "$child" 2>/dev/null && ! grep -q 'twinbus: builds' "$top/said"; do sleep 0.3; done
  kill -KILL "$child" 2>/dev/null || true
  wait "$child" 2>/dev/null || true
  found=$(grep -o 'apt-get install .*' "$top/said" | head -1 || true)
  if [[ " $found " == *" $package "* ]]; then
    echo "ok      without $package ./twinbus says: $found"
  else
    found=$(in_root "$top/merged" sh -c 'cd /twinbus && python3 test/structure/packages_test.py' 2>&1 | grep "^$package is" | head -1 || true)
    if [ -n "$found" ]; then
      echo "ok      without $package the unit tests say: $found"
    else
      echo "FAILED  without $package nothing names it"
      failed=1
    fi
  fi
  umount -R "$top/merged"
}
if [ "${TWINBUS_WITHOUT:-}" != inside ]; then
  TWINBUS_WITHOUT=inside exec unshare --mount --pid --fork --kill-child "$0" --release "$release" "$@"
fi
mount --make-rprivate /
for package in $wanted; do try_without "$package"; done
rm -rf --one-file-system "$work.without"
exit $failed
