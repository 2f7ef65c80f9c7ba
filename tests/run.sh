#!/bin/sh
# Installs what is missing (Debian 12, as root), builds everything, runs all tests, counts their cases.
set -eu
cd "$(dirname "$0")/.."

.ci/install g++ clang binutils cmake make ninja-build libeigen3-dev libfmt-dev nlohmann-json3-dev libcli11-dev libpugixml-dev \
  libopenblas-serial-dev libsuitesparse-dev libgtest-dev libbenchmark-dev libsimbody-dev libmujoco-dev \
  libclang-rt-14-dev locales python3-numpy python3-scipy dpkg-dev pkg-config libxml2-utils g++-aarch64-linux-gnu qemu-user \
  openmpi-bin chromium nodejs npm
cmake --preset release -DMBGEN_TESTS=ON -DMBGEN_BENCH=OFF
cmake --build --preset release
status=0
ctest --preset release --parallel "$(nproc)" || status=$?
awk -f tests/cases.awk build/release/Testing/Temporary/LastTest.log
exit "$status"
