#!/bin/sh
# The generated solvers beside Simbody, MuJoCo and a straightforward program on Eigen, on this machine:
#   bench/compare.sh [OPTION...]          options of mbgen_compare, for example --json or --massless-rods
# Installs what it needs (Debian 12, as root), builds, prints the tables of docs/evidence/performance.md; some minutes.
# The machine should have nothing else to do.
set -eu
cd "$(dirname "$0")/.."

.ci/install g++ cmake ninja-build binutils valgrind libeigen3-dev libfmt-dev nlohmann-json3-dev libcli11-dev libpugixml-dev \
  libopenblas-serial-dev libsuitesparse-dev libsimbody-dev libmujoco-dev >&2
build=${MBGEN_BUILD:-build/compare}
cmake -S . -B "$build" -G Ninja -DCMAKE_BUILD_TYPE=Release -DMBGEN_TESTS=OFF >&2
cmake --build "$build" --target mbgen_compare >&2

models=$(mktemp -d)
trap 'rm -rf "$models"' EXIT
for joints in 7 30; do
  bench/growth_model.sh chain "$joints" > "$models/chain_$joints.json"
done
"$build/bench/mbgen_compare" models/coach_mechanism.json models/truck_mechanism.json \
  "$models/chain_7.json" "$models/chain_30.json" "$@"
