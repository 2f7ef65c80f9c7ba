#!/bin/sh
# Drives the coach through its slalom and draws docs/coach_slalom.svg: docs/coach_slalom.sh [MBGEN]
# The summary that mbgen prints is the table in docs/coach_slalom.md.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
mbgen=${1:-$here/../build/release/mbgen}
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

"$mbgen" simulate "$here/../models/coach.json" --duration 5 --step 1e-3 --out "$scratch/coach.csv" | tee "$scratch/summary"

# One panel a group of columns, drawn by awk: no plotting program is needed.
awk -F, '
  BEGIN {
    panels = 4; width = 860; panel = 150; left = 70; top = 20; gap = 34
    title[1] = "lateral acceleration, m/s^2"; columns[1] = "lateral_acceleration [m/s^2]"
    title[2] = "roll, degrees";               columns[2] = "roll [rad]"; scale[2] = 57.29577951308232
    title[3] = "yaw rate, degrees/s";         columns[3] = "yaw_rate [rad/s]"; scale[3] = 57.29577951308232
    title[4] = "wheel loads, kN: front left, front right, rear left, rear right (twin)"
    columns[4] = "load_front_left [N];load_front_right [N];load_rear_left [N];load_rear_right [N]"; scale[4] = 1e-3
    split("#1b6ca8 #c2452d #4a8f3c #8a5fb0", colour, " ")
  }
  NR == 1 { for (c = 1; c <= NF; ++c) place[$c] = c; next }
  (NR - 2) % 10 == 0 {
    t[++rows] = $1
    for (p = 1; p <= panels; ++p) {
      count[p] = split(columns[p], names, ";")
      for (k = 1; k <= count[p]; ++k) {
        v = $place[names[k]] * (scale[p] ? scale[p] : 1); value[p, k, rows] = v
        if (rows == 1 && k == 1) low[p] = high[p] = v
        if (v < low[p]) low[p] = v
        if (v > high[p]) high[p] = v
      }
    }
  }
  END {
    height = top + panels * (panel + gap) + 20
    printf "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 %d %d\" font-family=\"sans-serif\" font-size=\"12\">\n", width + left + 20, height
    print "<rect width=\"100%\" height=\"100%\" fill=\"white\"/>"
    for (p = 1; p <= panels; ++p) {
      y0 = top + (p - 1) * (panel + gap)
      printf "<text x=\"%d\" y=\"%d\">%s</text>\n", left, y0 + 10, title[p]
      y0 += 16
      span = high[p] - low[p]; bottom = low[p] - 0.05 * span; range = 1.1 * span
      printf "<rect x=\"%d\" y=\"%d\" width=\"%d\" height=\"%d\" fill=\"none\" stroke=\"#888\"/>\n", left, y0, width, panel
      for (s = 0; s <= 4; ++s) {
        y = y0 + panel * (1 - s / 4)
        printf "<text x=\"%d\" y=\"%.1f\" text-anchor=\"end\">%.3g</text>\n", left - 6, y + 4, bottom + range * s / 4
        printf "<line x1=\"%d\" x2=\"%d\" y1=\"%.1f\" y2=\"%.1f\" stroke=\"#ddd\"/>\n", left, left + width, y, y
      }
      for (s = 0; s <= 5; ++s) {
        x = left + width * s / 5
        printf "<text x=\"%.1f\" y=\"%d\" text-anchor=\"middle\">%g s</text>\n", x, y0 + panel + 14, t[rows] * s / 5
      }
      for (k = 1; k <= count[p]; ++k) {
        printf "<polyline fill=\"none\" stroke=\"%s\" stroke-width=\"1.5\" points=\"", colour[k]
        for (r = 1; r <= rows; ++r)
          printf "%.1f,%.1f ", left + width * t[r] / t[rows], y0 + panel * (1 - (value[p, k, r] - bottom) / range)
        print "\"/>"
      }
    }
    print "</svg>"
  }' "$scratch/coach.csv" > "$here/coach_slalom.svg"
