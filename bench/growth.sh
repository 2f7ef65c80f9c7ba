#!/bin/sh
# How a solver grows with its model: one evaluation, code, and the time that it takes to make. Tables of docs/evidence/growth.md.
#
#   bench/growth.sh [MBGEN] [DIRECTORY]
#
# MBGEN: the binary, default build/release/mbgen, else build/mbgen. DIRECTORY: for everything that is made, default
# build/growth. Prints one table of Markdown; takes some minutes. FOUR_BARS and CHAINS choose the sizes.
set -eu

root=$(cd "$(dirname "$0")/.." && pwd)
mbgen=${1:-$root/build/release/mbgen}
[ -x "$mbgen" ] || mbgen=$root/build/mbgen
out=${2:-$root/build/growth}
four_bars=${FOUR_BARS-1 2 5 10 30 100 300 1000}
chains=${CHAINS-7 30 100}
mkdir -p "$out"

seconds() {
  start=$(date +%s.%N)
  "$@" > "$out/log.txt" 2>&1 || { cat "$out/log.txt" >&2; exit 1; }
  awk -v a="$start" -v b="$(date +%s.%N)" 'BEGIN { printf "%.2f", b - a }'
}

# One evaluation at the assembled start, the least of five runs of a tenth of a second each.
write_timer() {
  cat > "$1/timer.cpp" << END
#include <chrono>
#include <cstdio>
#include "$2.hpp"

int main() {
  using Clock = std::chrono::steady_clock;
  using namespace $2;
  static State state{};
  static Derivative derivative{};
  static double tau[kCoordinates] = {};
  for (int i = 0; i < kCoordinates; ++i) state.z[i] = $3;
  if (!assemble({}, {}, state).ok()) return 1;
  double best = 1e9;
  for (int run = 0; run < 5; ++run) {
    long calls = 0;
    const auto start = Clock::now();
    double time = 0;
    while (time < 0.1) {
      for (int k = 0; k < 8; ++k, ++calls) {
        state.zd[0] += 1e-12;
        if (!accelerations({}, {}, state, tau, derivative).ok()) return 1;
      }
      time = std::chrono::duration<double>(Clock::now() - start).count();
    }
    best = time / calls < best ? time / calls : best;
  }
  std::printf("%.3f\n", best * 1e6);
}
END
}

# row KIND N NAME START
row() {
  kind=$1 n=$2 name=$3
  "$root/bench/growth_model.sh" "$kind" "$n" > "$out/$name.json"
  rm -rf "$out/$name"
  made=$(seconds "$mbgen" generate "$out/$name.json" --out "$out/$name")
  cmake -S "$out/$name" -B "$out/$name/build" > "$out/log.txt" 2>&1
  compiled=$(seconds cmake --build "$out/$name/build")
  write_timer "$out/$name" "$name" "$4"
  c++ -std=c++17 -O2 -I "$out/$name" "$out/$name/timer.cpp" "$out/$name/build/lib$name.a" -o "$out/$name/timer"
  time=$("$out/$name/timer")
  code=$(nm -C -S -t d "$out/$name/build/lib$name.a" | awk '/compute_accelerations/ { bytes += $2 } END { print bytes }')
  all=$(size "$out/$name/build/lib$name.a" | awk 'NR == 2 { print $1 }')
  awk -v k="$kind" -v n="$n" -v t="$time" -v c="$code" -v a="$all" -v m="$made" -v g="$compiled" '
    /"key": "accelerations"/ || /"accelerations": \{/ { here = 1 }
    here && /"loops"/ { rolled = 1 }
    here && /"total"/ { gsub(/[^0-9]/, ""); operations = $0; here = 0 }
    END { printf "| %s | %d | %d | %s | %.2f | %.1f | %.0f | %s | %s |\n", k, n, operations, rolled ? "rolled" : "straight", t, c / 1024, a / 1024, m, g }
  ' "$out/$name/$name.json"
}

echo "| model | size | operations | code | one evaluation, us | of it, kB | whole solver, kB | generate, s | compile, s |"
echo "|---|---|---|---|---|---|---|---|---|"
for n in $chains; do row chain "$n" "chain_$n" "0.1 * (i % 5)"; done
for n in $four_bars; do row four-bar "$n" "n_four_bar_$n" "i % 2 == 0 || i + 1 == kCoordinates ? 0.2 : -0.2"; done
