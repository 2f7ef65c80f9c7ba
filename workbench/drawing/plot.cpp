// Curves over time, or over another column.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "workbench/drawing/drawing.hpp"
#include "workbench/drawing/svg.hpp"

namespace mbgen {
namespace {

constexpr double kLeft = 78, kRight = 18, kTop = 34, kGap = 44, kPlotFont = 12, kLegendStep = 16;
/// Apart for people who see colours otherwise too (Okabe and Ito, darkened for thin lines on white).
constexpr std::array<const char*, 8> kCurveColours = {"#0b63a5", "#c8501e", "#00805d", "#a0447f",
                                                      "#a87900", "#2b8fbf", "#4d4d4d", "#7a3fb0"};

/// Ticks of an axis: from `first` times `step`, `count` intervals.
struct Ticks {
  double step = 1, first = 0;
  int count = 1;
  bool is_logarithmic = false;  ///< values are decimal logarithms
  double low() const { return first * step; }
  double high() const { return (first + count) * step; }
};

/// At 1, 2 or 5 times a power of ten, about `wanted` of them, around all of [low, high].
Ticks ticks_around(double low, double high, int wanted) {
  double width = high - low;
  const double size = std::max(std::abs(low), std::abs(high));
  if (!(width > 1e-12 * size)) {  // a constant stands in the middle
    width = size > 0 ? 0.1 * size : 1;
    low -= width / 2;
    high += width / 2;
  }
  const double raw = width / wanted, power = std::pow(10.0, std::floor(std::log10(raw)));
  const double ratio = raw / power;
  Ticks ticks;
  ticks.step = power * (ratio <= 1 ? 1 : ratio <= 2 ? 2 : ratio <= 5 ? 5 : 10);
  constexpr double kSlack = 1e-9;  // a limit that is a tick but for rounding needs no further interval
  ticks.first = std::floor(low / ticks.step + kSlack);
  ticks.count = std::max(1, static_cast<int>(std::ceil(high / ticks.step - kSlack) - ticks.first));
  return ticks;
}

/// Powers of ten around logarithms, at most so many decades below the highest.
Ticks decades_around(double low, double high, int most) {
  Ticks ticks{1, std::floor(low + 1e-9), 1, true};
  const double end = std::max(std::ceil(high - 1e-9), ticks.first + 1);
  ticks.first = std::max(ticks.first, end - most);
  ticks.count = static_cast<int>(end - ticks.first);
  return ticks;
}

Curve empty_like(const Curve& curve) { return {curve.label, {}, {}, curve.style, curve.colour}; }

/// Logarithms of a curve, of its abscissa alone for a linear one.
Curve logarithmic(const Curve& curve, bool is_linear) {
  Curve result = empty_like(curve);
  for (std::size_t i = 0; i < curve.x.size(); ++i) {
    result.x.push_back(std::log10(curve.x[i]));
    result.y.push_back(is_linear ? curve.y[i] : std::log10(curve.y[i]));
  }
  return result;
}

/// A prefix for large values of units that engineers write with one.
struct Scale {
  double factor = 1;
  std::string unit;
};

Scale scale_of(const std::string& unit, double largest) {
  constexpr std::array<std::string_view, 7> kWithPrefix = {"N", "N m", "Nm", "Pa", "J", "W", "V"};
  if (std::find(kWithPrefix.begin(), kWithPrefix.end(), unit) == kWithPrefix.end()) return {1, unit};
  constexpr double kKilo = 1e3, kMega = 1e6, kOften = 2;  // 1500 N stays, 2000 N are 2 kN
  if (largest >= kOften * kMega) return {1 / kMega, "M" + unit};
  if (largest >= kOften * kKilo) return {1 / kKilo, "k" + unit};
  return {1, unit};
}

/// The curve's points that are numbers.
Curve finite(const Curve& curve) {
  Curve result = empty_like(curve);
  for (std::size_t i = 0; i < curve.x.size(); ++i) {
    if (!std::isfinite(curve.x[i]) || !std::isfinite(curve.y[i])) continue;
    result.x.push_back(curve.x[i]);
    result.y.push_back(curve.y[i]);
  }
  return result;
}

/// Extent of all panels along x.
std::pair<double, double> extent(const std::vector<Panel>& panels) {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const Panel& panel : panels) {
    for (const Curve& curve : panel.curves) {
      for (const double x : curve.x) {
        low = std::min(low, x);
        high = std::max(high, x);
      }
    }
  }
  return low <= high ? std::pair(low, high) : std::pair(0.0, 1.0);
}

/// Extent of all curves of a panel.
std::pair<double, double> extent(const Panel& panel) {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const Curve& curve : panel.curves) {
    for (const double value : curve.y) {
      low = std::min(low, value);
      high = std::max(high, value);
    }
  }
  return low <= high ? std::pair(low, high) : std::pair(0.0, 1.0);
}

/// Visible points of a curve: where x increases the first, lowest, highest and last point of each column of pixels.
std::vector<std::size_t> shown(const std::vector<double>& time, const std::vector<double>& values, int columns) {
  std::vector<std::size_t> points;
  if (time.empty()) return points;
  if (!std::is_sorted(time.begin(), time.end())) {
    points.resize(time.size());
    std::iota(points.begin(), points.end(), std::size_t{0});
    return points;
  }
  const double width = time.back() - time.front();
  const auto column = [&](std::size_t i) {
    return width > 0 ? static_cast<int>((time[i] - time.front()) / width * columns) : 0;
  };
  for (std::size_t begin = 0; begin < time.size();) {
    std::size_t end = begin, low = begin, high = begin;
    for (; end < time.size() && column(end) == column(begin); ++end) {
      if (values[end] < values[low]) low = end;
      if (values[end] > values[high]) high = end;
    }
    std::array<std::size_t, 4> four = {begin, std::min(low, high), std::max(low, high), end - 1};
    points.insert(points.end(), four.begin(), std::unique(four.begin(), four.end()));
    begin = end;
  }
  return points;
}

/// A place in the picture, px.
struct Spot {
  double x, y;
};

/// Distance of a place from the line through two others, or from the first where they are one.
double off_line(const Spot& spot, const Spot& from, const Spot& to) {
  const double dx = to.x - from.x, dy = to.y - from.y, length = std::hypot(dx, dy);
  if (!(length > 0)) return std::hypot(spot.x - from.x, spot.y - from.y);
  return std::abs((spot.x - from.x) * dy - (spot.y - from.y) * dx) / length;
}

/// A line of fewer places that leaves none of these by more than what an eye sees.
/// Source: D. Douglas, T. Peucker, "Algorithms for the reduction of the number of points", Cartographica 10(2), 1973.
std::vector<Spot> simplified(const std::vector<Spot>& spots) {
  constexpr double kSeen = 0.1;  // px
  if (spots.empty()) return {};
  std::vector<bool> is_kept(spots.size(), false);
  is_kept.front() = is_kept.back() = true;
  std::vector<std::pair<std::size_t, std::size_t>> spans = {{0, spots.size() - 1}};
  while (!spans.empty()) {
    const auto [first, last] = spans.back();
    spans.pop_back();
    std::size_t furthest = first;
    double distance = kSeen;
    for (std::size_t i = first + 1; i < last; ++i) {
      const double off = off_line(spots[i], spots[first], spots[last]);
      if (off <= distance) continue;
      furthest = i;
      distance = off;
    }
    if (furthest == first) continue;
    is_kept[furthest] = true;
    spans.emplace_back(first, furthest);
    spans.emplace_back(furthest, last);
  }
  std::vector<Spot> kept;
  for (std::size_t i = 0; i < spots.size(); ++i) {
    if (is_kept[i]) kept.push_back(spots[i]);
  }
  return kept;
}

/// A number of a tick, with as many decimals as the step needs.
std::string tick_text(const Ticks& ticks, int i) {
  const double value = (ticks.first + i) * ticks.step;
  if (ticks.is_logarithmic) return fmt::format("{:g}", std::pow(10, value));
  const double largest = std::max(std::abs(ticks.low()), std::abs(ticks.high()));
  constexpr double kLargest = 1e6, kSmallest = 1e-4;
  if (largest >= kLargest || ticks.step < kSmallest) return fmt::format("{:g}", value);
  const int decimals = std::max(0, -static_cast<int>(std::floor(std::log10(ticks.step) + 1e-9)));
  return fmt::format("{:.{}f}", value == 0 ? 0.0 : value, decimals);
}

/// Where a panel stands, px.
struct Frame {
  double left, top, width, height;
};

/// The axis of x: where it ends, and its ticks, at the first of which it begins.
struct Axis {
  Ticks ticks;
  double end = 1;
  double start() const { return ticks.low(); }
  double part(double x) const { return end > start() ? (x - start()) / (end - start()) : 0; }
};

std::string grid(const Frame& frame, const Ticks& vertical, const Axis& axis, bool is_last) {
  std::string text;
  for (int i = 0; i <= vertical.count; ++i) {
    const double y = frame.top + frame.height * (1 - static_cast<double>(i) / vertical.count);
    text += fmt::format("<path class=\"grid\" d=\"M{} {}h{}\"/>\n", svg::number(frame.left), svg::number(y),
                        svg::number(frame.width));
    text += svg::text_at(frame.left - 7, y + 4, tick_text(vertical, i), " text-anchor=\"end\"");
  }
  for (int i = 0; i <= axis.ticks.count; ++i) {
    const double at = (axis.ticks.first + i) * axis.ticks.step;
    if (at > axis.end + 1e-9 * std::abs(axis.end)) continue;
    const double x = frame.left + axis.part(at) * frame.width;
    text += fmt::format("<path class=\"grid\" d=\"M{} {}v{}\"/>\n", svg::number(x), svg::number(frame.top),
                        svg::number(frame.height));
    if (is_last)
      text += svg::text_at(x, frame.top + frame.height + 17, tick_text(axis.ticks, i), " text-anchor=\"middle\"");
  }
  return text;
}

const char* colour_of(const Panel& panel, std::size_t c) {
  const int chosen = panel.curves[c].colour;
  return kCurveColours[(chosen < 0 ? c : static_cast<std::size_t>(chosen)) % kCurveColours.size()];
}

/// Attributes of a line of this style, with a blank in front.
const char* dashes_of(Curve::Style style) {
  constexpr std::array<const char*, 4> kDashes = {"", " stroke-dasharray=\"7 4\"", " stroke-dasharray=\"2 3\"", ""};
  return kDashes[static_cast<std::size_t>(style)];
}

/// A measured point.
std::string dot_at(double x, double y, const char* colour) {
  return fmt::format("<circle fill=\"{}\" cx=\"{}\" cy=\"{}\" r=\"2.5\"/>\n", colour, svg::number(x), svg::number(y));
}

/// Where the names of a panel's curves stand over its frame: px from its left, and lines of the legend.
struct Legend {
  std::vector<double> x;
  std::vector<int> line;
  int lines = 1;
};

Legend legend_of(const Panel& panel, double width) {
  Legend legend;
  double x = 0;
  for (const Curve& curve : panel.curves) {
    const double entry = 40 + svg::text_width(curve.label, kPlotFont);
    if (x > 0 && x + entry > width) {
      x = 0;
      ++legend.lines;
    }
    legend.x.push_back(x);
    legend.line.push_back(legend.lines - 1);
    x += entry;
  }
  return legend;
}

/// The unit over the axis, then the names of the curves in their colours.
std::string legend(const Frame& frame, const Panel& panel, const std::string& unit) {
  std::string text = svg::text_at(frame.left - 7, frame.top - 13, unit, " text-anchor=\"end\"");
  const Legend places = legend_of(panel, frame.width);
  for (std::size_t c = 0; c < panel.curves.size(); ++c) {
    const Curve& curve = panel.curves[c];
    const double x = frame.left + places.x[c], up = kLegendStep * (places.lines - 1 - places.line[c]);
    const double y = frame.top - 17 - up;
    text += curve.style == Curve::Style::points
                ? dot_at(x + 8, y, colour_of(panel, c))
                : fmt::format("<path stroke=\"{}\" stroke-width=\"3\"{} d=\"M{} {}h16\"/>\n", colour_of(panel, c),
                              dashes_of(curve.style), svg::number(x), svg::number(y));
    text += svg::text_at(x + 21, frame.top - 13 - up, curve.label);
  }
  return text;
}

/// A curve by its places in the picture.
std::string curve_text(const std::vector<Spot>& spots, Curve::Style style, const char* colour) {
  std::string text;
  if (style == Curve::Style::points) {
    for (const Spot& spot : spots) text += dot_at(spot.x, spot.y, colour);
    return text;
  }
  for (const Spot& spot : simplified(spots))
    text += fmt::format("{}{:.1f} {:.1f}", text.empty() ? "M" : "L", spot.x, spot.y);
  return fmt::format("<path class=\"curve\" stroke=\"{}\"{} d=\"{}\"/>\n", colour, dashes_of(style), text);
}

std::string panel_text(const Panel& panel, const Frame& frame, const Axis& axis, bool is_last) {
  const auto [low, high] = extent(panel);
  const bool is_logarithmic = axis.ticks.is_logarithmic && !panel.is_linear;
  const Scale scale =
      is_logarithmic ? Scale{1, panel.unit} : scale_of(panel.unit, std::max(std::abs(low), std::abs(high)));
  constexpr int kVerticalTicks = 4, kMostDecades = 8;
  const Ticks vertical = is_logarithmic ? decades_around(low, high, kMostDecades)
                                        : ticks_around(low * scale.factor, high * scale.factor, kVerticalTicks);
  std::string text = grid(frame, vertical, axis, is_last) + legend(frame, panel, scale.unit);
  for (std::size_t c = 0; c < panel.curves.size(); ++c) {
    const Curve& curve = panel.curves[c];
    std::vector<Spot> spots;
    for (const std::size_t i : shown(curve.x, curve.y, static_cast<int>(frame.width))) {
      const double part = (curve.y[i] * scale.factor - vertical.low()) / (vertical.high() - vertical.low());
      const double y = is_logarithmic ? std::max(part, 0.0) : part;
      spots.push_back({frame.left + axis.part(curve.x[i]) * frame.width, frame.top + (1 - y) * frame.height});
    }
    text += curve_text(spots, curve.style, colour_of(panel, c));
  }
  return text + fmt::format("<rect class=\"frame\" x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\"/>\n",
                            svg::number(frame.left), svg::number(frame.top), svg::number(frame.width),
                            svg::number(frame.height));
}

}  // namespace

std::string plot_svg(const Abscissa& abscissa, const std::vector<Panel>& asked, const PlotSize& size) {
  std::vector<Panel> panels = asked;
  for (Panel& panel : panels) {
    for (Curve& curve : panel.curves)
      curve = finite(abscissa.is_logarithmic ? logarithmic(curve, panel.is_linear) : curve);
  }
  const double width = size.width - kLeft - kRight;
  // Lines of a legend beyond its first one stand over the panel.
  const auto above = [&](const Panel& panel) { return kLegendStep * (legend_of(panel, width).lines - 1); };
  double height = kTop + static_cast<double>(panels.size()) * (size.panel_height + kGap);
  for (const Panel& panel : panels) height += above(panel);
  std::string text = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" font-family=\"sans-serif\" font-size=\"{}\" width=\"{}\" "
      "height=\"{}\" viewBox=\"0 0 {} {}\">\n<style>.grid{{stroke:#e2e2e2;fill:none}}.frame{{stroke:#888;fill:none}}"
      ".curve{{fill:none;stroke-width:1.5;stroke-linejoin:round}}</style>\n<rect width=\"100%\" height=\"100%\" "
      "fill=\"white\"/>\n",
      kPlotFont, size.width, svg::number(height), size.width, svg::number(height));
  constexpr int kTicks = 8;
  const auto [low, high] = extent(panels);
  constexpr int kMostDecades = 12;
  const Axis axis{abscissa.is_logarithmic ? decades_around(low, high, kMostDecades) : ticks_around(low, high, kTicks),
                  high};
  Frame frame{kLeft, kTop, width, static_cast<double>(size.panel_height)};
  for (std::size_t p = 0; p < panels.size(); ++p, frame.top += size.panel_height + kGap) {
    frame.top += above(panels[p]);
    text += panel_text(panels[p], frame, axis, p + 1 == panels.size());
  }
  const double bottom = frame.top - kGap;
  const std::string title = abscissa.unit.empty() ? abscissa.title : abscissa.title + ", " + abscissa.unit;
  text += svg::text_at(frame.left + frame.width, bottom + 33, title, " text-anchor=\"end\"");
  return text + "</svg>\n";
}

}  // namespace mbgen
