#!/bin/sh
# From nothing to a driving coach: installs what is missing (Debian 12, as root), builds mbgen, generates, compiles and
# runs the coach through a slalom of 5 s, prints a table of results, and makes a page that plays the motion.
set -eu
cd "$(dirname "$0")/.."
result=build/coach

.ci/install g++ cmake ninja-build libeigen3-dev libfmt-dev nlohmann-json3-dev libcli11-dev libpugixml-dev \
  libopenblas-serial-dev libsuitesparse-dev nodejs npm
cmake --preset release -DMBGEN_TESTS=OFF -DMBGEN_BENCH=OFF --log-level=NOTICE
cmake --build --preset release --target mbgen
mbgen=build/release/mbgen

echo
echo "the specialised solver of models/coach.json:"
$mbgen generate models/coach.json --out $result
echo
$mbgen simulate models/coach.json --duration 5 --step 1e-3 --out "$PWD/$result/slalom.csv"
echo
if $mbgen report $result/slalom.csv -o $result/slalom.html; then
  echo "the slalom as a page, open it in a browser: $PWD/$result/slalom.html"
fi
