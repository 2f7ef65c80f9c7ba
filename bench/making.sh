#!/bin/sh
# Time and memory of mbgen itself over the size of a model: the table of docs/evidence/growth.md, section "Making".
#
#   bench/making.sh [MBGEN] [DIRECTORY]
#
# MBGEN: the binary, default build/release/mbgen, else build/mbgen. DIRECTORY: for the models and what is generated,
# default build/making. Prints one table of Markdown. CHECKED and GENERATED choose the models, as kind:size. Needs
# Python 3.
set -eu

root=$(cd "$(dirname "$0")/.." && pwd)
mbgen=${1:-$root/build/release/mbgen}
[ -x "$mbgen" ] || mbgen=$root/build/mbgen
out=${2:-$root/build/making}
checked=${CHECKED-chain:100 chain:300 chain:1000 chain:5000 star:1000 separate:1000 separate:2000 \
  ring:50 ring:100 ring:200 ring:1000 \
  spatial-ring:50 spatial-ring:200 spatial-ring:1000 four-bar:100 four-bar:1000 grid:4 grid:6 grid:10}
generated=${GENERATED-chain:100 chain:300 chain:1000 chain:5000 star:1000 separate:1000 ring:50 ring:100 ring:200 ring:1000 \
  spatial-ring:50 spatial-ring:200 four-bar:100 four-bar:1000}
mkdir -p "$out"

# measured COMMAND...: "seconds | megabytes" of a run, or "refused".
measured() {
  python3 - "$@" << 'END'
import os, subprocess, sys
process = subprocess.Popen(sys.argv[1:], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
_, status, used = os.wait4(process.pid, 0)
print(f"{used.ru_utime + used.ru_stime:.2f} | {used.ru_maxrss / 1024:.0f}" if status == 0 else "refused | ")
END
}

echo "| model | size | check, s | check, MB | generate, s | generate, MB |"
echo "|---|---|---|---|---|---|"
for model in $checked; do
  kind=${model%:*} size=${model#*:}
  "$root/bench/growth_model.sh" "$kind" "$size" > "$out/$kind-$size.json"
  made=" | "
  case " $generated " in
    *" $model "*) made=$(measured "$mbgen" generate "$out/$kind-$size.json" --out "$out/$kind-$size") ;;
  esac
  echo "| $kind | $size | $(measured "$mbgen" check "$out/$kind-$size.json") | $made |"
done
