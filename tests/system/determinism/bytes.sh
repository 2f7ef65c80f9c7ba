#!/bin/sh
# The same bytes from mbgen, wherever it runs: every file it emits for the models, the schema and the report.
#   tests/system/determinism/bytes.sh [MBGEN]   under different locales, directories and environments; default: build/mbgen
#   tests/system/determinism/bytes.sh --long    from four mbgen: g++ and clang++, -O0 and -O3, built in build/determinism; all models
set -eu
here=$(cd "$(dirname "$0")" && pwd)
root=$(cd "$here/../../.." && pwd)
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
failures=0
first=

# emit_all DIRECTORY MODEL...: everything that $mbgen says of the models, with the words of $environment before it.
emit_all() {
  target=$1
  shift
  mkdir -p "$target"
  for each in "$@"; do
    name=$(basename "$each" .json)
    # shellcheck disable=SC2086  # several words
    {
      env $environment "$mbgen" generate "$each" --out "$target/$name" >/dev/null
      env $environment "$mbgen" generate "$each" --batch 8 --out "$target/$name-batch" >/dev/null
      env $environment "$mbgen" generate "$each" --a2l --out "$target/$name-a2l" >/dev/null
      env $environment "$mbgen" inspect "$each" --json >"$target/$name.inspect"
    }
  done
  # shellcheck disable=SC2086
  env $environment "$mbgen" schema >"$target/schema"
}

# compare TAG DIRECTORY: its bytes with those of the first directory.
compare() {
  (cd "$2" && find . -type f -print0 | LC_ALL=C sort -z | xargs -0 sha256sum) >"$2.sums"
  sum=$(sha256sum <"$2.sums" | cut -c1-16)
  if [ -z "$first" ]; then
    first=$2
    echo "bytes: $1: $(wc -l <"$2.sums") files, $sum"
  elif cmp -s "$first.sums" "$2.sums"; then
    echo "bytes: $1: the same"
  else
    echo "bytes: $1: DIFFERS in $(diff "$first.sums" "$2.sums" | awk '/^>/ { print $3 }' | tr '\n' ' ')"
    failures=$((failures + 1))
  fi
}

# Locales of our own making: de_DE has a decimal comma, tr_TR an i without dot.
make_locales() {
  locales=$scratch/locales
  mkdir -p "$locales"
  for locale in de_DE tr_TR; do
    if ! localedef -i "$locale" -f UTF-8 "$locales/$locale.UTF-8" >/dev/null 2>&1; then
      echo "bytes: locale $locale: skipped, cannot be made (apt-get install locales)"
      rm -rf "$locales/$locale.UTF-8"
    fi
  done
}

check_environments() {
  model=$root/models/slider_crank.json
  environment="-i"
  emit_all "$scratch/empty" "$model"
  compare "empty environment" "$scratch/empty"
  make_locales
  mkdir -p "$scratch/temporary" "$scratch/elsewhere"
  count=0
  while IFS='|' read -r title environment; do
    case $environment in
      *LC_*) locale=${environment##*=}; [ -d "$locales/$locale" ] || [ "$locale" = C ] || continue ;;
    esac
    count=$((count + 1))
    emit_all "$scratch/$count" "$model"
    compare "$title" "$scratch/$count"
  done <<LIST
as it is|TERM=dumb
LC_ALL=C|LC_ALL=C
LC_ALL=de_DE.UTF-8|LOCPATH=$locales LANG=de_DE.UTF-8 LC_ALL=de_DE.UTF-8
LC_NUMERIC=de_DE.UTF-8|-u LC_ALL LOCPATH=$locales LC_NUMERIC=de_DE.UTF-8
LC_ALL=tr_TR.UTF-8|LOCPATH=$locales LANG=tr_TR.UTF-8 LC_ALL=tr_TR.UTF-8
no HOME, no cache|-u HOME -u XDG_CACHE_HOME
another time zone and TMPDIR|TZ=Pacific/Kiritimati TMPDIR=$scratch/temporary SOURCE_DATE_EPOCH=1
LIST
  # From elsewhere, by another path.
  cp "$model" "$scratch/elsewhere"
  cd "$scratch/elsewhere"
  environment="COLUMNS=20"
  emit_all ../there ./slider_crank.json
  compare "another directory, relative paths" "$scratch/there"
}

check_builds() {
  environment="LC_ALL=C"
  for compiler in g++ clang++; do
    for level in O0 O3; do
      build=$root/build/determinism/$compiler-$level
      cmake -S "$root" -B "$build" -G Ninja -DCMAKE_CXX_COMPILER="$compiler" -DCMAKE_BUILD_TYPE=None \
        -DCMAKE_CXX_FLAGS="-$level" -DMBGEN_UNITY=ON -DMBGEN_TESTS=OFF -DMBGEN_BENCH=OFF >/dev/null
      cmake --build "$build" --target mbgen >/dev/null
      mbgen=$build/mbgen
      emit_all "$scratch/$compiler-$level" "$root"/models/*.json "$root"/models/iftomm/*.json \
        "$root"/models/published/*.json "$root"/tests/data/models/*.json
      compare "$compiler -$level" "$scratch/$compiler-$level"
    done
  done
}

if [ "${1:-}" = --long ]; then
  check_builds
else
  mbgen=$(realpath "${1:-$root/build/mbgen}")
  check_environments
fi
[ "$failures" -eq 0 ]
