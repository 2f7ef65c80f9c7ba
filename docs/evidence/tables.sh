#!/bin/sh
# Measures the paper's tables 1 and 2 on this machine: docs/evidence/tables.sh [MBGEN]
# docs/evidence/tables.md holds its output. The machine should have nothing else to do.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
mbgen=${1:-$here/../../build/release/mbgen}
for model in coach truck; do
  "$mbgen" bench "$here/../../models/$model.json" --form matrix
  echo
done
