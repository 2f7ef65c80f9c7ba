#!/bin/sh
# A made-up kind of element, a damper that only pulls, as a patch on a copy of the sources.
#   ROOMS=BUILD tests/system/element_kind/check.sh  it applies, touches six files, these compile, and it brakes a sled
#   tests/system/element_kind/check.sh --build [JOBS]   mbgen is built with it: a sled that it brakes follows the closed form
set -eu
here=$(cd "$(dirname "$0")" && pwd)
root=$(cd "$here/../../.." && pwd)
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
patch=$here/one_way_damper.patch

for each in compiler runtime workbench templates models cmake CMakeLists.txt README.md LICENSE; do
  if [ -e "$root/$each" ]; then cp -R "$root/$each" "$scratch/"; fi
done
cd "$scratch"
patch -s -p1 <"$patch" || { echo "element_kind: the patch does not apply any more"; exit 1; }
files=$(grep -c '^+++ ' "$patch")
[ "$files" = 6 ] || { echo "element_kind: a kind of element takes $files files, not 6"; exit 1; }
echo "element_kind: $files files"

if [ "${1:-}" != --build ]; then
  cmake -DSOURCE="$scratch" -DOUTPUT="$scratch" -P compiler/model/every_kind.cmake
  compile() { ${CXX:-c++} -std=c++20 -I. -Iruntime/include -isystem "${EIGEN:-/usr/include/eigen3}" "$@"; }
  for source in compiler/reader/elements/one_way_damper.cpp runtime/judges/forces.cpp; do
    compile -fsyntax-only "$source"
    echo "element_kind: $source compiles"
  done
  # The rooms from the model to the formulation, each in one piece, on those before them, and a sled braked by the new
  # element.
  cp "$here/sled.cpp.in" sled.cpp
  for room in model topology formulation; do
    find "compiler/$room" -name '*.cpp' | LC_ALL=C sort | sed 's/.*/#include "&"/' >"$room.cpp"
  done
  compile -O0 model.cpp topology.cpp formulation.cpp sled.cpp "$ROOMS/libmbgen_expressions.a" "$ROOMS/libmbgen_text.a" \
    -lfmt -o sled
  ./sled
  exit
fi

cmake -S . -B build -DCMAKE_BUILD_TYPE=Release -DMBGEN_UNITY=ON -DMBGEN_TESTS=OFF -DMBGEN_BENCH=OFF -DMBGEN_REPORTS=OFF >/dev/null
cmake --build build -j "${2:-2}" --target mbgen >build.log 2>&1 || { tail -n 40 build.log; exit 1; }
# m dv/dt = -c v, v(0) = 1.5 m/s: v(0.4) = 1.5 exp(-0.6) m/s and c v = 4.5 exp(-0.6) N; the other way nothing brakes.
for engine in generated generic augmented; do
  for speed in 1.5 -1.5; do
    sed "s/\"slide\": 1.5/\"slide\": $speed/" "$here/sled.json" >sled.json
    integrator=rosenbrock  # by tangents of the new kind
    [ $engine = augmented ] && integrator=rk4
    build/mbgen simulate sled.json --engine $engine --integrator $integrator --out "$engine.csv" >/dev/null
    awk -F, -v engine=$engine -v speed=$speed '
      NR == 1 { for (i = 1; i <= NF; ++i) { if ($i ~ /pull/) pull = i; if ($i ~ /speed/) rate = i } }
      END {
        v = speed > 0 ? speed * exp(-0.6) : speed
        f = speed > 0 ? 3 * v : 0
        off = ($rate - v) ^ 2 + ($pull - f) ^ 2
        printf "element_kind: %s from %g m/s: %.9g m/s, %.9g N\n", engine, speed, $rate, $pull
        exit !(off < 1e-14)
      }' "$engine.csv" || { echo "element_kind: $engine is off the closed form"; exit 1; }
  done
done
