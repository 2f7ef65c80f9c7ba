#!/bin/sh
# A step of the generic engine over the size of a model: a table of docs/evidence/growth.md, section "The generic engine".
#
#   bench/generic_steps.sh [MBGEN] [DIRECTORY]
#
# MBGEN: the binary, default build/release/mbgen, else build/mbgen. DIRECTORY: for the models and results, default
# build/generic_steps. MODELS chooses the models, as kind:size. Processor time of 110 steps of 1 ms with their table less
# that of 10, over 100. Needs Python 3.
set -eu

root=$(cd "$(dirname "$0")/.." && pwd)
mbgen=${1:-$root/build/release/mbgen}
[ -x "$mbgen" ] || mbgen=$root/build/mbgen
out=${2:-$root/build/generic_steps}
models=${MODELS-crank:10 crank:40 crank:160 four-bar:10 four-bar:100 chain:30 chain:100 chain:300 chain:1000 \
  chain:5000 ring:50 ring:100 ring:200}
mkdir -p "$out"

# seconds DURATION MODEL: processor time of a motion.
seconds() {
  python3 - "$mbgen" simulate "$2" --engine generic --step 1e-3 --duration "$1" --out "$out/table.csv" << 'END'
import os, subprocess, sys
process = subprocess.Popen(sys.argv[1:], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
_, status, used = os.wait4(process.pid, 0)
print(used.ru_utime + used.ru_stime if status == 0 else "nan")
END
}

echo "| model | size | one step, ms |"
echo "|---|---|---|"
for model in $models; do
  kind=${model%:*} size=${model#*:}
  "$root/bench/growth_model.sh" "$kind" "$size" > "$out/$kind-$size.json"
  few=$(seconds 0.01 "$out/$kind-$size.json") many=$(seconds 0.11 "$out/$kind-$size.json")
  awk -v k="$kind" -v n="$size" -v a="$few" -v b="$many" 'BEGIN { printf "| %s | %d | %.3g |\n", k, n, (b - a) / 100 * 1000 }'
done
