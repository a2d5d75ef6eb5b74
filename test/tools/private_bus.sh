#!/bin/sh
# Runs a command on an LCM bus of its own: a network namespace with loopback only.
#
#   private_bus.sh COMMAND [ARGUMENT...]
#
# Any number of these run at once on the same port without hearing each other.  Works as root and, where the kernel
# allows unprivileged user namespaces, as an ordinary user.  Exit status 77 (skipped) where neither is possible.
set -eu
if [ "${1:-}" = --inside ]; then
  shift
  ip link set lo up
  # Loopback has no multicast route of its own; without it LCM cannot start.
  ip route add 224.0.0.0/4 dev lo
  exec "$@"
fi
[ $# -gt 0 ] || { echo "usage: private_bus.sh COMMAND [ARGUMENT...]" >&2; exit 2; }
if [ "$(id -u)" -eq 0 ] && unshare --net true 2>/dev/null; then
  exec unshare --net "$0" --inside "$@"
fi
if unshare --user --map-root-user --net true 2>/dev/null; then
  exec unshare --user --map-root-user --net "$0" --inside "$@"
fi
echo "private_bus.sh: this system allows no network namespace; skipped" >&2
exit 77
