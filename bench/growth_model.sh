#!/bin/sh
# Writes a model of any size for the tables of docs/evidence/growth.md, always the same bytes.
#
#   bench/growth_model.sh four-bar N > n_four_bar_N.json   IFToMM benchmark A02: N parallelograms side by side, N >= 1
#   bench/growth_model.sh chain N > chain_N.json           N revolute joints one after the other, N >= 1
#   bench/growth_model.sh star N > star_N.json             N pendulums on ground
#   bench/growth_model.sh ring N > ring_N.json             one loop of N revolute joints about z, N >= 4
#   bench/growth_model.sh spatial-ring N > ring_N.json     the same with joints about axes of all directions, N >= 7
#   bench/growth_model.sh separate N > separate_N.json     N four-bars that share nothing but ground
#   bench/growth_model.sh grid N > grid_N.json             N rows of N four-bars, each on top of the one before
#   bench/growth_model.sh crank N > crank_N.json           N four-bars on one crank that turns
#   bench/growth_model.sh walker N > walker_N.json         N legs of Theo Jansen's proportions on one crank that turns
set -eu

usage() {
  sed -n '2,13s/^# \{0,1\}//p' "$0" >&2
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

star() {
  awk -v n="$1" 'BEGIN {
    printf "// %d pendulums. Made by bench/growth_model.sh.\n{\n", n
    printf "  \"mbgen\": 1, \"name\": \"star_%d\", \"gravity\": [0, -9.81, 0],\n  \"bodies\": {\n    \"ground\": { \"points\": { ", n
    for (k = 1; k <= n; ++k) printf "%s\"P%d\": [%d, 0, 0]", (k > 1 ? ", " : ""), k, k
    printf " } }"
    for (k = 1; k <= n; ++k) {
      printf ",\n    \"bob%d\": { \"mass\": 1, \"com\": [%d.3, -0.4, 0], \"inertia\": [0.01, 0.01, 0.01],\n", k, k
      printf "      \"points\": { \"P\": [%d, 0, 0] } }", k
    }
    printf "\n  },\n  \"joints\": {\n"
    for (k = 1; k <= n; ++k)
      printf "%s    \"P%d\": { \"type\": \"revolute\", \"from\": \"ground.P%d\", \"to\": \"bob%d.P\", \"axis\": \"z\" }", (k > 1 ? ",\n" : ""), k, k, k
    printf "\n  }\n}\n"
  }'
}

# An oval with waves, links of about 0.1 m; the last joint closes it on ground. spatial: out of the plane as well.
ring() {
  awk -v n="$1" -v spatial="$2" 'BEGIN {
    turn = 8 * atan2(1, 1); radius = n * 0.1 / turn
    for (k = 0; k < n; ++k) {
      a = turn * k / n; r = radius * (1 + 0.1 * sin(3 * a))
      x[k] = r * cos(a); y[k] = r * sin(a); z[k] = spatial ? 0.3 * radius * sin(2 * a) : 0
      p[k] = sprintf("[%.6f, %.6f, %.6f]", x[k], y[k], z[k])
    }
    printf "// One loop of %d revolute joints. Made by bench/growth_model.sh.\n{\n", n
    printf "  \"mbgen\": 1, \"name\": \"ring_%d\", \"gravity\": [0, -9.81, 0],\n  \"bodies\": {\n", n
    printf "    \"ground\": { \"points\": { \"J0\": %s, \"J%d\": %s } }", p[0], n - 1, p[n - 1]
    for (k = 1; k < n; ++k) {
      printf ",\n    \"link%d\": { \"mass\": 1, \"com\": [%.6f, %.6f, %.6f], \"inertia\": [0.002, 0.002, 0.002],\n", k, (x[k - 1] + x[k]) / 2, (y[k - 1] + y[k]) / 2, (z[k - 1] + z[k]) / 2
      printf "      \"points\": { \"J%d\": %s, \"J%d\": %s } }", k - 1, p[k - 1], k, p[k]
    }
    printf "\n  },\n  \"joints\": {\n"
    for (k = 0; k < n; ++k) {
      axis = spatial ? sprintf("[%.3f, %.3f, %.3f]", sin(1.7 * k), cos(2.3 * k), sin(0.9 * k + 1)) : "\"z\""
      from = k == 0 ? "ground" : sprintf("link%d", k); to = k == n - 1 ? "ground" : sprintf("link%d", k + 1)
      printf "%s    \"J%d\": { \"type\": \"revolute\", \"from\": \"%s.J%d\", \"to\": \"%s.J%d\", \"axis\": %s }", (k > 0 ? ",\n" : ""), k, from, k, to, k, axis
    }
    printf "\n  }\n}\n"
  }'
}

separate() {
  awk -v n="$1" 'BEGIN {
    printf "// %d four-bars. Made by bench/growth_model.sh.\n{\n", n
    printf "  \"mbgen\": 1, \"name\": \"separate_%d\", \"gravity\": [0, -9.81, 0],\n  \"bodies\": {\n    \"ground\": { \"points\": { ", n
    for (k = 0; k < n; ++k) printf "%s\"A%d\": [%d, 0, 0], \"D%d\": [%.1f, 0, 0]", (k ? ", " : ""), k, 3 * k, k, 3 * k + 1.2
    printf " } }"
    for (k = 0; k < n; ++k) {
      x = 3 * k
      printf ",\n    \"crank%d\": { \"mass\": 1, \"com\": [%d, 0.2, 0], \"inertia\": [0.01, 0.001, 0.01],\n", k, x
      printf "      \"points\": { \"A\": [%d, 0, 0], \"B\": [%d, 0.4, 0] } }", x, x
      printf ",\n    \"coupler%d\": { \"mass\": 1, \"com\": [%.1f, 0.65, 0], \"inertia\": [0.01, 0.05, 0.05],\n", k, x + 0.5
      printf "      \"points\": { \"B\": [%d, 0.4, 0], \"C\": [%d, 0.9, 0] } }", x, x + 1
      printf ",\n    \"rocker%d\": { \"mass\": 1, \"com\": [%.1f, 0.45, 0], \"inertia\": [0.05, 0.005, 0.05],\n", k, x + 1.1
      printf "      \"points\": { \"D\": [%.1f, 0, 0], \"C\": [%d, 0.9, 0] } }", x + 1.2, x + 1
    }
    printf "\n  },\n  \"joints\": {\n"
    for (k = 0; k < n; ++k) {
      printf "%s    \"A%d\": { \"type\": \"revolute\", \"from\": \"ground.A%d\", \"to\": \"crank%d.A\", \"axis\": \"z\" },\n", (k ? ",\n" : ""), k, k, k
      printf "    \"B%d\": { \"type\": \"revolute\", \"from\": \"crank%d.B\", \"to\": \"coupler%d.B\", \"axis\": \"z\" },\n", k, k, k
      printf "    \"D%d\": { \"type\": \"revolute\", \"from\": \"ground.D%d\", \"to\": \"rocker%d.D\", \"axis\": \"z\" },\n", k, k, k
      printf "    \"C%d\": { \"type\": \"revolute\", \"from\": \"coupler%d.C\", \"to\": \"rocker%d.C\", \"axis\": \"z\" }", k, k, k
    }
    printf "\n  }\n}\n"
  }'
}

# Every row swings by itself: N freedoms.
grid() {
  awk -v n="$1" 'BEGIN {
    printf "// %d rows of %d four-bars. Made by bench/growth_model.sh.\n{\n", n, n
    printf "  \"mbgen\": 1, \"name\": \"grid_%d\", \"gravity\": [0, -9.81, 0],\n  \"bodies\": {\n    \"ground\": { \"points\": { ", n
    for (i = 0; i <= n; ++i) printf "%s\"N%d_0\": [%d, 0, 0]", (i ? ", " : ""), i, i
    printf " } }"
    for (j = 0; j < n; ++j) for (i = 0; i <= n; ++i) {
      printf ",\n    \"up%d_%d\": { \"mass\": 1, \"com\": [%d, %.1f, 0], \"inertia\": [\"1/12\", 0, \"1/12\"],\n", i, j, i, j + 0.5
      printf "      \"points\": { \"N%d_%d\": [%d, %d, 0], \"N%d_%d\": [%d, %d, 0] } }", i, j, i, j, i, j + 1, i, j + 1
      if (i == 0) continue
      printf ",\n    \"over%d_%d\": { \"mass\": 1, \"com\": [%.1f, %d, 0], \"inertia\": [0, \"1/12\", \"1/12\"],\n", i, j, i - 0.5, j + 1
      printf "      \"points\": { \"N%d_%d\": [%d, %d, 0], \"N%d_%d\": [%d, %d, 0] } }", i - 1, j + 1, i - 1, j + 1, i, j + 1, i, j + 1
    }
    printf "\n  },\n  \"joints\": {\n"
    for (j = 0; j < n; ++j) for (i = 0; i <= n; ++i) {
      from = j == 0 ? "ground" : sprintf("up%d_%d", i, j - 1)
      printf "%s    \"A%d_%d\": { \"type\": \"revolute\", \"from\": \"%s.N%d_%d\", \"to\": \"up%d_%d.N%d_%d\", \"axis\": \"z\" }", (i + j > 0 ? ",\n" : ""), i, j, from, i, j, i, j, i, j
      if (i == 0) continue
      printf ",\n    \"B%d_%d\": { \"type\": \"revolute\", \"from\": \"up%d_%d.N%d_%d\", \"to\": \"over%d_%d.N%d_%d\", \"axis\": \"z\" }", i, j, i - 1, j, i - 1, j + 1, i, j, i - 1, j + 1
      printf ",\n    \"C%d_%d\": { \"type\": \"revolute\", \"from\": \"over%d_%d.N%d_%d\", \"to\": \"up%d_%d.N%d_%d\", \"axis\": \"z\" }", i, j, i, j, i, j + 1, i, j, i, j + 1
    }
    printf "\n  }\n}\n"
  }'
}

# Pins around the crank, rockers on one pivot, each four-bar in a plane of its own.
crank() {
  awk -v n="$1" 'BEGIN {
    turn = 8 * atan2(1, 1)
    for (k = 0; k < n; ++k) {
      ax = 0.1 * cos(turn * k / n); ay = 0.1 * sin(turn * k / n)
      dx = 0.4 - ax; dy = -ay; d = sqrt(dx * dx + dy * dy)
      along = (0.42 ^ 2 - 0.25 ^ 2 + d * d) / (2 * d); across = sqrt(0.42 ^ 2 - along * along)
      cx = ax + (along * dx - across * dy) / d; cy = ay + (along * dy + across * dx) / d; z = 0.05 * (k + 1)
      a[k] = sprintf("[%.12f, %.12f, %.2f]", ax, ay, z); c[k] = sprintf("[%.12f, %.12f, %.2f]", cx, cy, z); at[k] = sprintf("[0.4, 0, %.2f]", z)
      m[k] = sprintf("[%.9f, %.9f, %.2f]", (ax + cx) / 2, (ay + cy) / 2, z); r[k] = sprintf("[%.9f, %.9f, %.2f]", (0.4 + cx) / 2, cy / 2, z)
    }
    printf "// %d four-bars on one crank. Made by bench/growth_model.sh.\n{\n", n
    printf "  \"mbgen\": 1, \"name\": \"crank_%d\", \"gravity\": [0, -9.81, 0],\n  \"bodies\": {\n    \"ground\": { \"points\": { \"O\": [0, 0, 0]", n
    for (k = 0; k < n; ++k) printf ", \"D%d\": %s", k, at[k]
    printf " } },\n    \"crank\": { \"mass\": 1.5, \"com\": [0, 0, 0], \"inertia\": [0.03, 0.03, 0.03],\n      \"points\": { \"O\": [0, 0, 0]"
    for (k = 0; k < n; ++k) printf ", \"A%d\": %s", k, a[k]
    printf " } }"
    for (k = 0; k < n; ++k) {
      printf ",\n    \"coupler%d\": { \"mass\": 0.5, \"com\": %s, \"inertia\": [0.007, 0.007, 0.007],\n", k, m[k]
      printf "      \"points\": { \"A\": %s, \"C\": %s } }", a[k], c[k]
      printf ",\n    \"rocker%d\": { \"mass\": 0.3, \"com\": %s, \"inertia\": [0.002, 0.002, 0.002],\n", k, r[k]
      printf "      \"points\": { \"D\": %s, \"C\": %s } }", at[k], c[k]
    }
    printf "\n  },\n  \"joints\": {\n    \"crank\": { \"type\": \"revolute\", \"from\": \"ground.O\", \"to\": \"crank.O\", \"axis\": \"z\" }"
    for (k = 0; k < n; ++k) {
      printf ",\n    \"A%d\": { \"type\": \"revolute\", \"from\": \"crank.A%d\", \"to\": \"coupler%d.A\", \"axis\": \"z\" },\n", k, k, k
      printf "    \"D%d\": { \"type\": \"revolute\", \"from\": \"ground.D%d\", \"to\": \"rocker%d.D\", \"axis\": \"z\" },\n", k, k, k
      printf "    \"C%d\": { \"type\": \"revolute\", \"from\": \"coupler%d.C\", \"to\": \"rocker%d.C\", \"axis\": \"z\" }", k, k, k
    }
    printf "\n  },\n  \"outputs\": { \"angle\": { \"unit\": \"rad\", \"expression\": \"z.crank\" } },\n"
    printf "  \"initial\": { \"velocities\": { \"crank\": 6 } },\n  \"solver\": { \"step\": 1e-3, \"duration\": 1 }\n}\n"
  }'
}

# Legs to both sides in turns, pins around the crank, each leg in a plane of its own. Lengths a to m are Jansen's, dm.
walker() {
  awk -v n="$1" '
  # Where circles of radius r about (px, pz) and s about (qx, qz) meet, on one side of the line between them.
  function meet(px, pz, r, qx, qz, s, side,   dx, dz, d, along, across) {
    dx = qx - px; dz = qz - pz; d = sqrt(dx * dx + dz * dz)
    along = (r * r - s * s + d * d) / (2 * d); across = sqrt(r * r - along * along) * side
    mx = px + (along * dx - across * dz) / d; mz = pz + (along * dz + across * dx) / d
  }
  function place(point) { x[point] = mx; z[point] = mz }
  function at(point) { return sprintf("[%.12f, %.2f, %.12f]", x[point], y, z[point]) }
  function body(name, points,   p, m, k, cx, cz, r, far, mass) {
    m = split(points, p, " "); cx = cz = r = 0
    for (k = 1; k <= m; ++k) { cx += x[p[k]] / m; cz += z[p[k]] / m }
    for (k = 1; k <= m; ++k) { far = sqrt((x[p[k]] - cx) ^ 2 + (z[p[k]] - cz) ^ 2); r = far > r ? far : r }
    mass = 1.2 * r
    bodies = bodies sprintf(",\n    \"%s%d\": { \"mass\": %.6f, \"com\": [%.9f, %.2f, %.9f], \"inertia\": [%.9f, %.9f, %.9f],\n      \"points\": {", name, q, mass, cx, y, cz, mass * r * r / 3, mass * r * r / 3, mass * r * r / 3)
    for (k = 1; k <= m; ++k) bodies = bodies sprintf("%s\"%s\": %s", (k > 1 ? ", " : " "), p[k], at(p[k]))
    bodies = bodies " } }"
  }
  function pin(name, from, to) {
    joints = joints sprintf(",\n    \"%s%d\": { \"type\": \"revolute\", \"from\": \"%s\", \"to\": \"%s\", \"axis\": \"y\" }", name, q, from, to)
  }
  BEGIN {
    turn = 8 * atan2(1, 1); pairs = n < 2 ? 1 : int(n / 2)
    for (q = 0; q < n; ++q) {
      side = q % 2 == 0 ? 1 : -1; y = 0.06 * (q + 1); angle = turn * int(q / 2) / pairs + 0.4
      x["M"] = 0.15 * cos(angle); z["M"] = 0.15 * sin(angle); x["B"] = -0.38 * side; z["B"] = -0.078
      meet(x["M"], z["M"], 0.5, x["B"], z["B"], 0.415, -side); place("P1")
      meet(x["B"], z["B"], 0.401, x["P1"], z["P1"], 0.558, side); place("P2")
      meet(x["M"], z["M"], 0.619, x["B"], z["B"], 0.393, side); place("P3")
      meet(x["P2"], z["P2"], 0.394, x["P3"], z["P3"], 0.367, side); place("P4")
      meet(x["P4"], z["P4"], 0.657, x["P3"], z["P3"], 0.49, side); place("P5")
      on_ground = on_ground sprintf(", \"B%d\": %s", q, at("B")); on_crank = on_crank sprintf(", \"M%d\": %s", q, at("M"))
      body("j", "M P1"); body("k", "M P3"); body("bde", "B P1 P2"); body("c", "B P3"); body("f", "P2 P4"); body("ghi", "P3 P4 P5")
      pin("m_j", "crank.M" q, "j" q ".M"); pin("m_k", "crank.M" q, "k" q ".M")
      pin("b_bde", "ground.B" q, "bde" q ".B"); pin("b_c", "ground.B" q, "c" q ".B")
      pin("bde_f", "bde" q ".P2", "f" q ".P2"); pin("c_ghi", "c" q ".P3", "ghi" q ".P3")
      pin("j_bde", "j" q ".P1", "bde" q ".P1"); pin("k_c", "k" q ".P3", "c" q ".P3"); pin("f_ghi", "f" q ".P4", "ghi" q ".P4")
    }
    printf "// A walking machine of %d legs on one crank. Made by bench/growth_model.sh.\n{\n", n
    printf "  \"mbgen\": 1, \"name\": \"walker_%d\", \"gravity\": [0, 0, -9.81],\n  \"bodies\": {\n    \"ground\": { \"points\": { \"O\": [0, 0, 0]%s } },\n", n, on_ground
    printf "    \"crank\": { \"mass\": 1.5, \"com\": [0, 0, 0], \"inertia\": [0.03, 0.03, 0.03],\n      \"points\": { \"O\": [0, 0, 0]%s } }%s\n  },\n", on_crank, bodies
    printf "  \"joints\": {\n    \"crank\": { \"type\": \"revolute\", \"from\": \"ground.O\", \"to\": \"crank.O\", \"axis\": \"y\" }%s\n  },\n", joints
    printf "  \"outputs\": { \"angle\": { \"unit\": \"rad\", \"expression\": \"z.crank\" } },\n"
    printf "  \"initial\": { \"velocities\": { \"crank\": 6 } },\n  \"solver\": { \"step\": 1e-3, \"duration\": 1 }\n}\n"
  }'
}

case "$1" in
  walker) walker "$2" ;;
  crank) crank "$2" ;;
  four-bar) four_bar "$2" ;;
  chain) chain "$2" ;;
  star) star "$2" ;;
  ring) ring "$2" 0 ;;
  spatial-ring) ring "$2" 1 ;;
  separate) separate "$2" ;;
  grid) grid "$2" ;;
  *) usage ;;
esac
