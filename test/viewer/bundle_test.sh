#!/bin/sh
# The committed page is what a fresh build of its sources gives, with the locked libraries.
#
#   bundle_test.sh viewer_log/web
#
# Exit 77 (skipped) where npm or the package registry is not there.
set -eu
web=$(cd "$1" && pwd)
if grep -q '"resolved"\|://[^"]*registry' "$web/package-lock.json"; then
  echo "package-lock.json names a registry: run npm install with viewer_log/web/.npmrc" >&2
  exit 1
fi
size=$(cat "$web"/dist/* | wc -c)
[ "$size" -le 1048576 ] || { echo "dist is $size bytes, more than 1 MB" >&2; exit 1; }
[ -s "$web/dist/LICENSES.txt" ] || { echo "dist/LICENSES.txt is missing" >&2; exit 1; }
command -v npm >/dev/null || { echo "no npm: skipped"; exit 77; }
copy=$(mktemp -d)
trap 'rm -rf "$copy"' EXIT
cp -R "$web/src" "$web/dist" "$web/licenses" "$web/build.mjs" "$web/package.json" \
  "$web/package-lock.json" "$web/.npmrc" "$copy"
cd "$copy"
npm ci --silent --prefer-offline >npm.log 2>&1 || { tail -3 npm.log; echo "npm cannot fetch: skipped"; exit 77; }
node build.mjs --check
