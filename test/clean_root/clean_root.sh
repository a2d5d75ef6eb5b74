#!/bin/bash
# The commands of the README in a root of Debian that has nothing yet: what a fresh machine meets.
#
#   clean_root.sh [--release NAME] [--within SECONDS] [--only-build] [--keep] [COMMAND ARGUMENT...]
#
#   --release NAME   trixie (the default), bookworm ...
#   --within SECONDS what is not done by then is left out, and said; config/packages.txt is checked in any case
#   --only-build     makes the root, installs and builds; a later call goes on from there
#   --keep           leaves the root behind and says where
#   COMMAND ...      runs this in the clone there, in the network of this machine, instead of `up stand` (on a bus of its own)
#                    and the unit tests; the root is left for further commands
#
# The last commit is cloned, not what is not committed.  What debootstrap made and the packages are kept in
# ${XDG_CACHE_HOME:-~/.cache}/twinbus/roots and made anew when a month old; compilations are in this machine's own ccache.
# Mirror, proxies and certificates are those that apt uses here.  Exit status 77 (skipped) and one sentence where no root can
# be made.
set -euo pipefail

# In namespaces of its own: nothing that is mounted here stays behind, and nothing that is started.
if [ "${1:-}" = --inside ]; then
  work=$2 archives=$3 ccache=$4 network=$5
  shift 5
  mount --make-rprivate /
  mount -t proc proc "$work/proc"
  mount --rbind /dev "$work/dev"
  mount --rbind /sys "$work/sys"
  mount --bind "$archives" "$work/var/cache/apt/archives"
  mount --bind "$ccache" "$work/ccache"
  if [ "$network" = own ]; then
    ip link set lo up
    ip route add 224.0.0.0/4 dev lo
  fi
  # shellcheck disable=SC2016
  exec chroot "$work" /bin/sh -c 'cd /twinbus && exec "$@"' sh "$@"
fi

tree=$(cd -- "$(dirname -- "$(readlink -f -- "$0")")/../.." && pwd)
release=trixie only_build=no keep=no entered=no within=
while [ $# -gt 0 ]; do
  case $1 in
    --release) release=$2; shift ;;
    --within) within=$2; shift ;;
    --only-build) only_build=yes ;;
    --keep) keep=yes ;;
    --enter) entered=yes; shift; break ;;  # ROOT NETWORK COMMAND...: for dockerfile_test.py
    -h | --help) sed -n '2,/^set/s/^# \{0,1\}//p' "$0"; exit 0 ;;
    -*) echo "clean_root.sh: unknown argument $1" >&2; exit 2 ;;
    *) break ;;
  esac
  shift
done

say() { printf 'clean root: %s\n' "$*"; }
skip() { say "skipped: $*"; exit 77; }

cache=${XDG_CACHE_HOME:-$HOME/.cache}/twinbus/roots
base=$cache/$release
work=$cache/$release-$(printf %s "$tree" | cksum | cut -d' ' -f1)  # one per checkout, so that two of them may run
archives=$cache/archives-$release
ccache=$(ccache --get-config cache_dir 2>/dev/null) || ccache=$cache/ccache

[ "$(id -u)" -eq 0 ] || skip "only root can make one"
command -v debootstrap >/dev/null || skip "debootstrap is missing; run: apt-get install debootstrap"
git -C "$tree" rev-parse HEAD >/dev/null 2>&1 || skip "this is no git checkout"
unshare --mount --pid --fork mount --make-rprivate / 2>/dev/null || skip "this system allows no mounts"
mkdir -p "$archives/partial" "$ccache"

# in_time COMMAND...: ended, with status 124, when the time is up.
in_time() {
  local left=$((${within:-0} - SECONDS)) status=0
  [ $entered = no ] || exec "$@"  # who ends this ends that
  [ -n "$within" ] || { "$@"; return; }
  [ "$left" -gt 0 ] || return 124
  timeout --foreground --kill-after 2 "$left" "$@" || status=$?
  [ $status -ne 137 ] || status=124  # unshare hears nothing but SIGKILL
  return $status
}

# enter ROOT NETWORK COMMAND...: in a root, without a terminal, without anything of this shell but its proxies.  NETWORK: shared
# (that of this machine), own (a bus of its own), or the name of one that `ip netns` knows.
enter() {
  local root=$1 network=$2 name spaces=(--mount --pid --fork --kill-child) there=()
  shift 2
  case $network in
    shared) ;;
    own) spaces+=(--net) ;;
    *) there=(nsenter "--net=/run/netns/$network") ;;
  esac
  local settings=(HOME=/root LANG=C.UTF-8 TERM=dumb CCACHE_DIR=/ccache
    PATH=/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin)
  # In CI, which has a limit, another compiler's warning is no reason to stop.
  [ -n "$within" ] || settings+=("TWINBUS_WERROR=${TWINBUS_WERROR:-}")
  for name in http_proxy https_proxy no_proxy TWINBUS_NO_INSTALL TWINBUS_FULL; do
    [ -z "${!name:-}" ] || settings+=("$name=${!name}")
  done
  in_time env -i "${settings[@]}" "${there[@]}" unshare "${spaces[@]}" \
    bash "$tree/test/clean_root/clean_root.sh" --inside "$root" "$archives" "$ccache" "$network" "$@" </dev/null
}

if [ $entered = yes ]; then
  enter "$@"
  exit
fi
exec 8>"$work.lock"
flock 8

make_base() {
  [ ! -e "$base.made" ] || [ -z "$(find "$base.made" -mtime -30)" ] || return 0
  rm -rf --one-file-system "$base" "$base.made" "$base.part"
  # Where apt gets its packages here; where it knows no Debian, debootstrap's own mirror.
  local mirror script=
  mirror=$(apt-get indextargets --format '$(CREATED_BY) $(LABEL) $(COMPONENT) $(REPO_URI)' 2>/dev/null |
    awk '$1 == "Packages" && $2 == "Debian" && $3 == "main" {print $4; exit}')
  [ -e "/usr/share/debootstrap/scripts/$release" ] || script=/usr/share/debootstrap/scripts/sid
  # shellcheck disable=SC2086
  in_time unshare --mount --pid --fork --kill-child debootstrap --variant=minbase --include=ca-certificates "$release" "$base.part" $mirror $script >"$base.log" 2>&1 || {
    [ $? -ne 124 ] || return 124
    skip "debootstrap could not: $(grep -v '^I:' "$base.log" | tail -1) (all it said: $base.log)"
  }
  # What apt says here about proxies, certificates and times holds there.
  apt-config dump | grep -E '^Acquire::(https?|ForceIP|Retries|Check)' >"$base.part/etc/apt/apt.conf.d/99host" || true
  cp -a /etc/apt/auth.conf.d "$base.part/etc/apt/" 2>/dev/null || true
  cp -L /etc/ssl/certs/ca-certificates.crt "$base.part/etc/ssl/certs/" 2>/dev/null || true
  cp -L /etc/resolv.conf /etc/hosts "$base.part/etc/" 2>/dev/null || true
  echo force-unsafe-io >"$base.part/etc/dpkg/dpkg.cfg.d/99clean-root"
  printf '#!/bin/sh\nexit 101\n' >"$base.part/usr/sbin/policy-rc.d"  # no service is started
  chmod +x "$base.part/usr/sbin/policy-rc.d"
  rm -f "$base.part"/var/cache/apt/archives/*.deb
  mkdir "$base.part/ccache"
  mv "$base.part" "$base"
  touch "$base.made"
}

make_work() {
  local commit
  commit=$(git -C "$tree" rev-parse HEAD)
  [ "$(cat "$work.commit" 2>/dev/null)" != "$commit" ] || return 0
  rm -rf --one-file-system "$work" "$work.commit" "$work.built"
  cp -a --reflink=auto "$base" "$work"
  git clone -q --no-hardlinks "file://$tree" "$work/twinbus" && git -C "$work/twinbus" checkout -q --detach "$commit" || return 1
  enter "$work" shared apt-get -q update >"$work.log" 2>&1 || {
    [ $? -ne 124 ] || return 124
    skip "apt reaches no mirror in the root: $(tail -1 "$work.log")"
  }
  echo "$commit" >"$work.commit"
}

# ./twinbus installs what the list names and configures before it builds.
install_and_build() {
  [ ! -e "$work.built" ] || return 0
  local status=0
  rm -f "$work.log"
  enter "$work" shared ./twinbus env 2>&1 >/dev/null | tee "$work.said" || status=$?
  [ $status -ne 0 ] || enter "$work" shared cmake --build build/release --target unit_programs >"$work.log" || status=$?
  case $status in
    0) touch "$work.built" ;;
    124) ;;
    *)
      ! grep -q '^E: Failed to fetch' "$work.said" || skip "the mirror did not give all packages: $(grep '^E: Failed to fetch' "$work.said" | head -1)"
      [ ! -e "$work.log" ] || grep -A20 -m5 'FAILED\|error:' "$work.log" || tail -30 "$work.log"
      ;;
  esac
  return $status
}

# How far a build came that was ended.
how_far() { [ -e "$work.built" ] || grep -ho '^\[[0-9]*/[0-9]*\]' "$work.log" "$work/twinbus/build/release.log" 2>/dev/null | tail -1; }

end() {
  if [ $keep = yes ]; then
    say "left behind: $work"
  else
    rm -rf --one-file-system "$work" "$work.commit" "$work.built" "$work.log" "$work.said"
  fi
  say "Debian $release$1"
}

summary=
# step NAME COMMAND...: says how long it took; ends all when it fails, or when the time is up.
step() {
  local name=$1 start=$SECONDS status=0 far
  shift
  "$@" || status=$?
  if [ $status -eq 124 ] && [ -n "$within" ]; then
    far=$(how_far || true)
    # What a missing line would break first: that the build was configured shows most, and this test the rest.
    if [ -e "$work/twinbus/build/release/build.ninja" ]; then
      within=
      step "list of packages" enter "$work" shared python3 test/structure/packages_test.py
    fi
    end "$summary, $name${far:+ until $far} and what follows left out after $SECONDS s; the next time goes faster if the caches are kept"
    exit 0
  fi
  if [ $status -ne 0 ]; then
    say "$name failed after $((SECONDS - start)) s; the root is $work"
    exit 1
  fi
  summary+=", $name $((SECONDS - start)) s"
}

step debootstrap make_base
step "new root" make_work
if [ $# -gt 0 ]; then
  enter "$work" shared "$@"
  exit
fi
step "packages and build" install_and_build
[ $only_build = no ] || exit 0
up_stand() { enter "$work" own ./twinbus up stand --for 5 --no-viewer; }
try_thrice() { "$@" || "$@" || "$@"; }  # a run is judged, and this machine may be busy
step "up stand" try_thrice up_stand
if [ "$release" = trixie ]; then  # what the Dockerfile starts from
  step container in_time python3 "$tree/test/clean_root/dockerfile_test.py" "$base" "$work" "$tree/test/clean_root/clean_root.sh" --enter
fi
step "unit tests" enter "$work" shared ./twinbus test --quick
end "$summary"
