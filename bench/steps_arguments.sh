# shellcheck shell=sh disable=SC2034,SC2154
# Read by scripts that time whole steps, after they set `steps` and `turns`: takes their options from the arguments, which
# are the models then, makes a scratch directory, and knows where a model starts.
root=$(cd "$here/.." && pwd)
binary=$root/build/release/mbgen
[ -x "$binary" ] || binary=$root/build/mbgen
while getopts b:n:t: option; do
  case $option in
    b) binary=$OPTARG ;;
    n) steps=$OPTARG ;;
    t) turns=$OPTARG ;;
    *) exit 2 ;;
  esac
done
shift $((OPTIND - 1))

scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

# write_start MODEL: its coordinates and velocities at the start, a line each, to $scratch/state
write_start() {
  "$binary" simulate "$1" --duration 1e-3 --step 1e-3 --engine generic --out "$scratch/start.csv" >/dev/null
  awk -F, 'NR == 1 { for (i = 1; i <= NF; ++i) is_state[i] = $i ~ /^zd?\./ }
           NR == 2 { for (i = 1; i <= NF; ++i) if (is_state[i]) print $i }' "$scratch/start.csv" >"$scratch/state"
}
