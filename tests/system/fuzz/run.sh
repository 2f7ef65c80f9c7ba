#!/bin/sh
# Builds the libFuzzer targets with clang++ and runs them.
#   tests/system/fuzz/run.sh BUILD                            build
#   tests/system/fuzz/run.sh BUILD short TARGET RUNS          so many inputs from a fixed seed, nothing kept
#   tests/system/fuzz/run.sh BUILD long SECONDS [TARGET...]   each target so long; what it learns stays in BUILD/corpus, what
#                                                      breaks it in BUILD/crash-*; the last lines count
# Targets: model expression states input_table, and in long runs mechanism, the whole compiler.
# Exit code 77 where clang++ or its libFuzzer (Debian: clang, libclang-rt-14-dev) is not installed.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
build=$1
mode=${2:-build}
mkdir -p "$build"
build=$(cd "$build" && pwd)

printf 'extern "C" int LLVMFuzzerTestOneInput(const unsigned char*, unsigned long) { return 0; }\n' > "$build/probe.cpp"
if ! clang++ -fsanitize=fuzzer,address "$build/probe.cpp" -o "$build/probe" 2> "$build/probe.log"; then
  echo "skipped: clang++ with libFuzzer is not installed (apt-get install clang libclang-rt-14-dev)"
  exit 77
fi

# Inputs to start from, besides those kept here.
seeds() {
  case $1 in
    model) echo "$here/../../../models $here/../../errors" ;;
    mechanism) echo "$here/../../../models" ;;
  esac
}

dictionary() {
  case $1 in mechanism) echo "$here/model.dict" ;; *) echo "$here/$1.dict" ;; esac
}

# compile FLAGS OPTIONS..
compile() {
  flags=$1
  shift
  cmake -S "$here/targets" -B "$build" -G Ninja -DCMAKE_CXX_COMPILER=clang++ -DCMAKE_BUILD_TYPE= \
    -DCMAKE_CXX_FLAGS="$flags" "$@" > "$build/cmake.log"
  cmake --build "$build" > "$build/build.log" || { tail -n 40 "$build/build.log"; exit 1; }
}

case $mode in
  build) compile -O0 ;; # half the time of -O1 to build, and short runs do not miss it
  short)
    scratch=$(mktemp -d)
    trap 'rm -rf "$scratch"' EXIT
    # shellcheck disable=SC2046  # one word a directory
    "$build/fuzz_$3" -seed=1 -runs="$4" -max_len=4096 -timeout=60 -verbosity=0 -artifact_prefix="$build/crash-$3-" \
      -dict="$(dictionary "$3")" "$scratch" "$here/corpus/$3" $(seeds "$3")
    echo "fuzz $3: $4 inputs, none broke it"
    ;;
  long)
    seconds=$3
    shift 3
    [ $# -gt 0 ] || set -- model expression states input_table mechanism
    compile -O1 -DMBGEN_FUZZ_COMPILER=ON
    for target in "$@"; do
      mkdir -p "$build/corpus/$target"
      # shellcheck disable=SC2046
      "$build/fuzz_$target" -max_total_time="$seconds" -timeout=60 -rss_limit_mb=4096 -print_final_stats=1 \
        -artifact_prefix="$build/crash-$target-" -dict="$(dictionary "$target")" \
        "$build/corpus/$target" "$here/corpus/$target" $(seeds "$target") > "$build/$target.log" 2>&1 || true
      echo "$target: $(grep -E 'number_of_executed_units' "$build/$target.log" | awk '{print $2}') inputs," \
        "$(find "$build" -maxdepth 1 -name "crash-$target-*" | wc -l) kept that broke it (see $build/$target.log)"
    done
    ;;
esac
