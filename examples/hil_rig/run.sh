#!/bin/sh
# Builds everything and drives the coach through a double lane change in real time: examples/hil_rig/run.sh [SECONDS]
# The plant sends motion to the driver and gets commands back, both by UDP on this machine; half-way the front anti-roll
# bar becomes stiffer. Privileges are used where there are any.
set -eu
cd "$(dirname "$0")/../.."
seconds=${1:-10}
result=build/hil_rig

if [ -z "${MBGEN:-}" ]; then
  .ci/install g++ cmake ninja-build libeigen3-dev libfmt-dev nlohmann-json3-dev libcli11-dev libpugixml-dev \
    libopenblas-serial-dev libsuitesparse-dev
  cmake --preset release -DMBGEN_TESTS=OFF -DMBGEN_BENCH=OFF --log-level=NOTICE
  cmake --build --preset release --target mbgen
  MBGEN=$PWD/build/release/mbgen
fi
mkdir -p $result
cmake -S examples/hil_rig -B $result -DMBGEN="$MBGEN" >$result/build.log
cmake --build $result -j "$(nproc)" >>$result/build.log

$result/hil_driver >$result/driver.txt &
driver=$!
(sleep "$((seconds / 2))" && $result/hil_tune --name bar_front --value 12000 >$result/tune.txt 2>&1) &
tune=$!
trap 'kill $driver $tune 2>/dev/null || true' EXIT
$result/hil_plant --duration "$seconds" --cpu "$(($(nproc) - 1))" --histogram $result/histogram.txt
wait $driver $tune
cat $result/driver.txt $result/tune.txt
echo "histograms: $result/histogram.txt (wake-up latency, step time)"
