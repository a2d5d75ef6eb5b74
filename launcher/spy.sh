#!/bin/sh
# lcm-spy on current Java with this project's message types.  The packaged /usr/bin/lcm-spy fails: -Xincgc is gone.
set -eu
command=${TWINBUS_COMMAND:-./twinbus spy}  # as it was typed
check=no
robot=hrp1s
while [ $# -gt 0 ]; do
  case $1 in
    -h | --help)
      echo "usage: $command [--check] [--url URL] [--robot NAME]"
      echo "STATE_NAMED has the joints of the robot (default hrp1s) by their names, 50 times a second."
      echo "Opens lcm-spy; double-click a channel for its fields, a field's line for a plot.  --check only says what is missing."
      exit 0 ;;
    --check) check=yes ;;
    --robot)
      [ $# -ge 2 ] || { echo "twinbus spy: --robot needs a name" >&2; exit 2; }
      robot=$2
      shift ;;
    --url)
      [ $# -ge 2 ] || { echo "twinbus spy: --url needs a value" >&2; exit 2; }
      LCM_DEFAULT_URL=$2
      shift ;;
    *) echo "twinbus spy: unknown argument $1; see $command --help" >&2; exit 2 ;;
  esac
  shift
done
if [ "$check" = no ] && [ -z "${DISPLAY:-}" ]; then
  echo "twinbus spy: no display; log in on a desktop or with ssh -X, or start it under xvfb-run" >&2
  exit 1
fi
root=$(cd "$(dirname "$0")/.." && pwd)
types=${TWINBUS_BUILD:-$root/build/release}/share/types.jar
missing=
find_jar() {
  for folder in /usr/share/java /usr/local/share/java; do
    [ -f "$folder/$1" ] && { echo "$folder/$1"; return 0; }
  done
  return 1
}
lcm=$(find_jar lcm.jar) || missing="$missing liblcm-java"
chart=$(find_jar jchart2d.jar) || missing="$missing libjchart2d-java"
command -v java >/dev/null 2>&1 || missing="$missing default-jre"
if [ -n "$missing" ]; then
  echo "twinbus spy: missing; run: apt-get install$missing" >&2
fi
if [ ! -f "$types" ]; then
  echo "twinbus spy: no $types, so nothing would be decoded; install default-jdk-headless and build again" >&2
fi
[ -z "$missing" ] && [ -f "$types" ] || exit 1
[ "$check" = no ] || { echo "lcm-spy can run: $lcm $chart $types"; exit 0; }
export LCM_DEFAULT_URL="${LCM_DEFAULT_URL:-udpm://239.255.76.67:17667?ttl=0&recv_buf_size=4194304}"
build=${TWINBUS_BUILD:-$root/build/release}
keep=$build/share
[ -w "$keep" ] || keep=${XDG_CACHE_HOME:-$HOME/.cache}/twinbus
named=$keep/named/$(basename "$robot")
if python3 "$root/launcher/named_state.py" --make "$named" --robot "$robot" --twinbus "$build/bin/twinbus"; then
  python3 "$root/launcher/named_state.py" --run "$named" --url "$LCM_DEFAULT_URL" >/dev/null &
  trap 'kill $! 2>/dev/null' EXIT INT TERM
  types=$types:$named/named.jar
fi
export CLASSPATH="$types"  # where lcm-spy looks for types
java -Djava.net.preferIPv4Stack=true -Xmx128m -ea -cp "$lcm:$chart:$types" lcm.spy.Spy
