#!/bin/sh
# Writes a model of any size for the tables of docs/growth.md, always the same bytes.
#
#   bench/growth_model.sh four-bar N > n_four_bar_N.json   IFToMM benchmark A02: N parallelograms side by side, N >= 1
#   bench/growth_model.sh chain N > chain_N.json           N revolute joints one after the other, N >= 1
set -eu

usage() {
  sed -n '2,5s/^# \{0,1\}//p' "$0" >&2
  exit 1
}

[ $# -eq 2 ] && [ "$2" -ge 1 ] 2> /dev/null || usage

four_bar() {
  awk -v n="$1" 'BEGIN {
    printf "// IFToMM benchmark A02 with N = %d: %d slender bars of 1 m and 1 kg. Made by bench/growth_model.sh.\n{\n", n, 2 * n + 1
    printf "  \"mbgen\": 1, \"name\": \"n_four_bar_%d\", \"gravity\": [0, -9.81, 0],\n  \"bodies\": {\n", n
    printf "    \"ground\": { \"points\": { "
    for (k = 0; k <= n; ++k) printf "%s\"A%d\": [%d, 0, 0]", (k ? ", " : ""), k, k
    printf " } }"
    for (k = 0; k <= n; ++k) {
      printf ",\n    \"up%d\": { \"mass\": 1, \"com\": [%d, 0.5, 0], \"inertia\": [\"1/12\", 0, \"1/12\"],\n", k, k
      printf "      \"points\": { \"A%d\": [%d, 0, 0], \"B%d\": [%d, 1, 0] } }", k, k, k, k
    }
    for (k = 1; k <= n; ++k) {
      printf ",\n    \"over%d\": { \"mass\": 1, \"com\": [%.1f, 1, 0], \"inertia\": [0, \"1/12\", \"1/12\"],\n", k, k - 0.5
      printf "      \"points\": { \"B%d\": [%d, 1, 0], \"B%d\": [%d, 1, 0] } }", k - 1, k - 1, k, k
    }
    printf "\n  },\n  \"joints\": {\n"
    for (k = 0; k <= n; ++k) {
      printf "    \"A%d\": { \"type\": \"revolute\", \"from\": \"ground.A%d\", \"to\": \"up%d.A%d\", \"axis\": \"z\" }", k, k, k, k
      if (k > 0) printf ",\n    \"C%d\": { \"type\": \"revolute\", \"from\": \"over%d.B%d\", \"to\": \"up%d.B%d\", \"axis\": \"z\", \"cut\": true }", k, k, k, k, k
      if (k < n) printf ",\n    \"B%d\": { \"type\": \"revolute\", \"from\": \"up%d.B%d\", \"to\": \"over%d.B%d\", \"axis\": \"z\" },\n", k, k, k, k + 1, k
    }
    printf "\n  },\n  \"outputs\": {\n"
    printf "    \"x\": { \"unit\": \"m\", \"point\": \"up0.B0\", \"quantity\": \"position\", \"axis\": \"x\" },\n"
    printf "    \"y\": { \"unit\": \"m\", \"point\": \"up0.B0\", \"quantity\": \"position\", \"axis\": \"y\" }\n  },\n"
    printf "  \"initial\": { \"velocities\": { "
    for (k = 0; k <= n; ++k) printf "%s\"A%d\": -1%s", (k ? ", " : ""), k, (k < n ? sprintf(", \"B%d\": 1", k) : "")
    printf " } },\n  \"solver\": { \"step\": 1e-3, \"duration\": 0.7 }\n}\n"
  }'
}

# Axes z, y, x in turns, links of 0.25 m with all six inertias, like the arm of tests/data/models/chain_7.json.
chain() {
  awk -v n="$1" 'BEGIN {
    printf "// An arm of %d revolute joints. Made by bench/growth_model.sh.\n{\n", n
    printf "  \"mbgen\": 1, \"name\": \"chain_%d\", \"gravity\": [0, 0, -9.81],\n  \"bodies\": {\n", n
    printf "    \"ground\": { \"points\": { \"j1\": [0, 0, 0] } }"
    for (k = 1; k <= n; ++k) {
      x = 0.03 * (k - 1); y = 0.02 * (k - 1); z = 0.25 * (k - 1)
      printf ",\n    \"link%d\": { \"mass\": 2, \"com\": [%.3f, %.3f, %.3f],\n", k, x + 0.02, y - 0.01, z + 0.1
      printf "      \"inertia\": [0.02, 0.018, 0.008, 0.0006, 0.0003, -0.0004],\n"
      printf "      \"points\": { \"j%d\": [%.2f, %.2f, %.2f], \"j%d\": [%.2f, %.2f, %.2f] } }", k, x, y, z, k + 1, x + 0.03, y + 0.02, z + 0.25
    }
    printf "\n  },\n  \"joints\": {\n"
    for (k = 1; k <= n; ++k) {
      from = k == 1 ? "ground" : sprintf("link%d", k - 1)
      axis = k % 3 == 1 ? "z" : k % 3 == 2 ? "y" : "x"
      printf "%s    \"j%d\": { \"type\": \"revolute\", \"from\": \"%s.j%d\", \"to\": \"link%d.j%d\", \"axis\": \"%s\" }", (k > 1 ? ",\n" : ""), k, from, k, k, k, axis
    }
    printf "\n  }\n}\n"
  }'
}

case "$1" in
  four-bar) four_bar "$2" ;;
  chain) chain "$2" ;;
  *) usage ;;
esac
