#!/bin/sh
# Makes the picture of docs/use/kc.md: docs/use/kc.sh [MBGEN]. Needs chromium.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
mbgen=${1:-$here/../../build/release/mbgen}
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

"$mbgen" kc "$here/../../models/axles/rubber_wishbone.json" -o "$scratch" > "$scratch/text"
chromium --headless --no-sandbox --disable-gpu --hide-scrollbars --window-size=1000,1900 --screenshot="$scratch/kc.png" \
  "file://$scratch/front.html"
mv "$scratch/kc.png" "$here"
