#!/bin/sh
# Measures anew what docs/evidence/performance.md holds and puts it between the markers there: docs/evidence/performance.sh [OPTION...]
# Options are those of mbgen_compare. Some minutes; the machine should have nothing else to do.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
page=$here/performance.md
table=$(mktemp)
trap 'rm -f "$table" "$table.md"' EXIT
"$here/../../bench/compare.sh" "$@" > "$table"
awk -v table="$table" '
  /^<!-- compare: end -->/ { inside = 0 }
  !inside { print }
  /^<!-- compare: begin -->/ {
    inside = 1
    print "```"
    while ((getline line < table) > 0) print line
    print "```"
  }' "$page" > "$table.md"
cat "$table.md" > "$page"
