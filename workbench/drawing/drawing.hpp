#pragma once
// The door of the drawing room: pictures as SVG text or PNG bytes, the same for the same arguments.

#include <string>
#include <vector>

#include "compiler/analysis/analysis.hpp"
#include "compiler/model/model.hpp"
#include "compiler/topology/topology.hpp"

namespace mbgen {

/// The topology of a model: a row a body, indented by its depth from ground, its tree joint on the line to its parent
/// with a mark a coordinate (independent, dependent, driven); cut joints and rods as brackets at the right between the
/// bodies that they close; the bodies of a loop block on a ground of one colour. Massless bodies are dashed.
std::string topology_svg(const Model& model, const Topology& topology, const Analysis& analysis);

/// One curve of a plot.
struct Curve {
  enum class Style { line, dashed, dotted, points };
  std::string label;
  std::vector<double> x, y;  ///< of one length; points that are not finite are left out
  Style style = Style::line;
  int colour = -1;  ///< number of its colour; -1: its place in the panel
};

/// The abscissa of a plot.
struct Abscissa {
  std::string title = "time", unit = "s";
  bool is_logarithmic = false;  ///< this axis and those of all panels; points that are not positive are left out
};

/// One frame of a plot.
struct Panel {
  std::string
      unit;  ///< of all its curves, "" for none: the label of the axis; N, N m, Pa, J and W take a prefix k or M
  std::vector<Curve> curves;
  bool is_linear = false;  ///< its own axis, beside a logarithmic abscissa
};

/// Size of a plot, in pixels.
struct PlotSize {
  int width = 960;
  int panel_height = 200;
};

/// Curves over time or something else, panels below each other with one axis; ticks at 1, 2 or 5 times a power of ten;
/// a legend that is too wide goes on in further lines.
/// Curves of many points are drawn with the points that show at this size: curves whose x increases by the extremes of
/// each column of pixels.
std::string plot_svg(const Abscissa& abscissa, const std::vector<Panel>& panels, const PlotSize& size = {});

/// A mechanism at its reference configuration, seen along the axis in which it is thinnest: a grey PNG of 128 x 128.
std::string icon_png(const Model& model);

}  // namespace mbgen
