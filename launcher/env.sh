#!/bin/sh
# Prints what a shell needs so that stock LCM tools meet this bus and know its messages:  eval "$(./twinbus env)"
set -eu
command=${TWINBUS_COMMAND:-./twinbus env}  # as it was typed
case "${1:-}" in
  -h | --help)
    echo "usage: eval \"\$($command)\""
    echo "Sets LCM_DEFAULT_URL, CLASSPATH (lcm.jar, types.jar) and PYTHONPATH for lcm-logger, lcm-logplayer and clients."
    exit 0 ;;
  "") ;;
  *) echo "twinbus env: unknown argument $1; see $command --help" >&2; exit 2 ;;
esac
root=$(cd "$(dirname "$0")/.." && pwd)
build=${TWINBUS_BUILD:-$root/build/release}
classes=$build/share/types.jar
for folder in /usr/share/java /usr/local/share/java; do
  [ -f "$folder/lcm.jar" ] && { classes=$folder/lcm.jar:$classes; break; }
done
# In single quotes for whoever evaluates it.
quoted() { printf "'%s'" "$(printf %s "$1" | sed "s/'/'\\\\''/g")"; }
echo "export LCM_DEFAULT_URL=$(quoted "${LCM_DEFAULT_URL:-udpm://239.255.76.67:17667?ttl=0&recv_buf_size=4194304}")"
echo "export CLASSPATH=$(quoted "$classes")"
echo "export PYTHONPATH=$(quoted "$root/python${PYTHONPATH:+:$PYTHONPATH}")"
