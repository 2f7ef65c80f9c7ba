#!/bin/sh
# Emitted solvers on a Cortex-M7 without an operating system, in double and in single precision, under QEMU (mps2-an500):
# trajectories against those of this machine, sizes, stack, and that nothing of a heap, of exceptions or of constructors
# is linked. docs/use/targets.md records what it says. Opt-in: its tools take 2.5 GB.
#   tests/system/bare_metal/check.sh [-b MBGEN] [-i] [MODEL.json...]      default: build/mbgen, the four-bar, the coach
# -i: installs the tools first (Debian, as root).
set -eu
here=$(cd "$(dirname "$0")" && pwd)
root=$here/../../..
mbgen=$root/build/mbgen
while getopts b:i option; do
  case $option in
    b) mbgen=$OPTARG ;;
    i)
      "$root/.ci/install" g++ gcc-arm-none-eabi libnewlib-arm-none-eabi libstdc++-arm-none-eabi-newlib qemu-system-arm
      ;;
    *) exit 2 ;;
  esac
done
shift $((OPTIND - 1))
[ $# -gt 0 ] || set -- "$root/models/four_bar.json" "$root/models/coach.json"
for tool in arm-none-eabi-g++ qemu-system-arm; do
  if ! command -v "$tool" >/dev/null 2>&1; then
    echo "bare metal: skipped, $tool is not installed (tests/system/bare_metal/check.sh -i)"
    exit 0
  fi
done
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

# As solver_compile_flags of mbgen has them, without what hosted systems have beyond it.
flags="-std=c++17 -O2 -ffreestanding -fbuiltin -fno-exceptions -fno-rtti -fno-unwind-tables -fno-math-errno -fno-trapping-math
  -ffp-contract=off -Wno-psabi -fno-tree-vectorize -fno-tree-loop-distribute-patterns"
hosted=$(echo "$flags" | sed "s/-ffreestanding//")
heap='malloc|calloc|realloc|free|sbrk|_Zn[wa]|_Zd[la]|__cxa_|_Unwind|__libc_init_array|_GLOBAL__sub_I|atexit'

failures=0
# check MODEL SCALAR FPU
check() {
  directory=$scratch/$2
  rm -rf "$directory"
  "$mbgen" generate "$1" --scalar "$2" --out "$directory" >/dev/null
  name=$(basename "$(ls "$directory"/*.json)" .json)
  processor="-mcpu=cortex-m7 -mthumb -mfloat-abi=hard -mfpu=$3"
  definitions="-DSOLVER=$name -DINTERFACE=<$name.hpp> -I $directory -I $here"
  echo "$name, $2 ($3):"
  # shellcheck disable=SC2086  # several words
  (
    cd "$directory"
    arm-none-eabi-g++ $processor $flags -fstack-usage -Wdouble-promotion -Werror=double-promotion -I . -c "$name.cpp" -o solver.o
    arm-none-eabi-g++ $processor $flags $definitions -c "$here/run.cpp" -o run.o
    arm-none-eabi-g++ $processor $flags $definitions -c "$here/cortex_m7.cpp" -o start.o
    arm-none-eabi-g++ $processor -nostartfiles -Wl,--gc-sections -T "$here/cortex_m7.ld" start.o run.o solver.o \
      -o image.elf
    g++ $hosted -march=x86-64-v3 $definitions "$here/run.cpp" "$here/host.cpp" "$name.cpp" -o host
    ./host >host.txt
    timeout 600 qemu-system-arm -M mps2-an500 -nographic -monitor none -serial none \
      -semihosting-config enable=on,target=native -kernel image.elf >target.txt 2>&1
    sed -n 's/^stack //p' target.txt >stack.txt
    sed -i '/^stack /d' target.txt
  )
  if cmp -s "$directory/host.txt" "$directory/target.txt"; then
    echo "  end state: the same bits as on this machine, $(grep -c . "$directory/host.txt") lines"
  else
    echo "  end state: DIFFERS from this machine"
    diff "$directory/host.txt" "$directory/target.txt" | cut -c1-120 | head -6
    failures=$((failures + 1))
  fi
  if ! grep -q '^steps ok$' "$directory/target.txt"; then
    echo "  steps: $(grep '^steps' "$directory/target.txt" || echo none)"
    failures=$((failures + 1))
  fi
  arm-none-eabi-size -A "$directory/solver.o" | awk '
    $1 ~ /^\.text/ { text += $2 } $1 ~ /^\.rodata/ { constants += $2 } $1 ~ /^\.(data|bss)/ { data += $2 }
    END { printf "  solver: %d bytes of code, %d of constants, %d of data\n", text, constants, data }'
  echo "  image: $(arm-none-eabi-size "$directory/image.elf" | awk 'END { print $1 }') bytes of code and constants"
  echo "  stack: $(cat "$directory/stack.txt") bytes used; largest frame $(awk -F'\t' '$2 > most { most = $2 }
    END { print most }' "$directory/solver.su")"
  if arm-none-eabi-nm "$directory/image.elf" | grep -E " [A-Za-z] _*($heap)"; then
    echo "  LINKED: the symbols above"
    failures=$((failures + 1))
  else
    echo "  no heap, exceptions, guards or constructors linked"
  fi
  soft=$(arm-none-eabi-nm "$directory/image.elf" | grep -cE ' T __(aeabi_d|.*df)' || true)
  echo "  double arithmetic in software: $soft functions"
}

for model in "$@"; do
  check "$model" double fpv5-d16
  check "$model" float fpv5-sp-d16
done
if [ "$failures" -gt 0 ]; then
  echo "bare metal: $failures failures"
  exit 1
fi
echo "bare metal: all is well"
