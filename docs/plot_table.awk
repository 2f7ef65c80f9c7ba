# Draws columns of a table that mbgen simulate wrote, over its first column, as SVG:
#   awk -F, -v panels='PANEL # PANEL ...' -f plot_table.awk TABLE.csv > PICTURE.svg
# A PANEL is 'title | factor | label = column; label = column ...'; factor multiplies the columns, labels may be empty.
# Every tenth row is drawn.
function trim(text) { gsub(/^[ \n]+|[ \n]+$/, "", text); return text }
function read_panels(    p, k, part, series, pair) {
  number = split(panels, panel, "#")
  for (p = 1; p <= number; ++p) {
    split(panel[p], part, "|")
    title[p] = trim(part[1]); factor[p] = trim(part[2])
    count[p] = split(part[3], series, ";")
    for (k = 1; k <= count[p]; ++k) {
      split(series[k], pair, "=")
      label[p, k] = trim(pair[1]); column[p, k] = trim(pair[2])
    }
  }
}
# Ticks at 1, 2 or 5 times a power of ten, about five of them; the frame ends on ticks.
function scale(p,    raw) {
  raw = (high[p] - low[p]) / 5; if (raw <= 0) raw = 1
  tick = exp(log(10) * floor(log(raw) / log(10)))
  if (raw > 5 * tick) tick *= 10; else if (raw > 2 * tick) tick *= 5; else if (raw > tick) tick *= 2
  first = floor(low[p] / tick); ticks = -floor(-high[p] / tick) - first; if (ticks < 1) ticks = 1
  bottom = first * tick; range = ticks * tick
}
function floor(x) { return int(x) - (x < int(x)) }
function frame(p, y,    s, line) {
  printf "<rect x=\"%d\" y=\"%d\" width=\"%d\" height=\"%d\" fill=\"none\" stroke=\"#888\"/>\n", left, y, width, height
  for (s = 0; s <= ticks; ++s) {
    line = y + height * (1 - s / ticks)
    printf "<text x=\"%d\" y=\"%.1f\" text-anchor=\"end\">%g</text>\n", left - 6, line + 4, (first + s) * tick
    printf "<line x1=\"%d\" x2=\"%d\" y1=\"%.1f\" y2=\"%.1f\" stroke=\"#ddd\"/>\n", left, left + width, line, line
  }
  for (s = 0; s <= 5; ++s)
    printf "<text x=\"%.1f\" y=\"%d\" text-anchor=\"middle\">%g s</text>\n",
      left + width * s / 5, y + height + 14, t[rows] * s / 5
}
function heading(p, y,    k) {
  printf "<text x=\"%d\" y=\"%d\">%s", left, y, title[p]
  for (k = 1; k <= count[p]; ++k)
    if (label[p, k] != "")
      printf "<tspan dx=\"14\" font-weight=\"bold\" fill=\"%s\">%s</tspan>", colour[k], label[p, k]
  print "</text>"
}
function curve(p, k, y,    r) {
  printf "<polyline fill=\"none\" stroke=\"%s\" stroke-width=\"1.5\" points=\"", colour[k]
  for (r = 1; r <= rows; ++r)
    printf "%.1f,%.1f ", left + width * t[r] / t[rows], y + height * (1 - (value[p, k, r] - bottom) / range)
  print "\"/>"
}
BEGIN {
  width = 860; height = 150; left = 70; top = 20; gap = 34
  split("#1b6ca8 #c2452d #4a8f3c #8a5fb0 #c08a1e", colour, " ")
  read_panels()
}
NR == 1 { for (c = 1; c <= NF; ++c) place[$c] = c; next }
(NR - 2) % 10 == 0 {
  t[++rows] = $1
  for (p = 1; p <= number; ++p)
    for (k = 1; k <= count[p]; ++k) {
      if (!(column[p, k] in place)) { print "no column " column[p, k] > "/dev/stderr"; exit 1 }
      v = $place[column[p, k]] * factor[p]; value[p, k, rows] = v
      if (rows == 1 && k == 1) low[p] = high[p] = v
      if (v < low[p]) low[p] = v
      if (v > high[p]) high[p] = v
    }
}
END {
  if (!rows) exit 1
  print "<svg xmlns=\"http://www.w3.org/2000/svg\" font-family=\"sans-serif\" font-size=\"12\""
  printf " viewBox=\"0 0 %d %d\">\n", width + left + 20, top + number * (height + gap) + 20
  print "<rect width=\"100%\" height=\"100%\" fill=\"white\"/>"
  for (p = 1; p <= number; ++p) {
    y0 = top + (p - 1) * (height + gap)
    scale(p)
    heading(p, y0 + 10)
    frame(p, y0 + 16)
    for (k = 1; k <= count[p]; ++k) curve(p, k, y0 + 16)
  }
  print "</svg>"
}
