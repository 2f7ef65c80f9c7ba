#include "compiler/emit/legend.hpp"

#include <fmt/format.h>

#include "compiler/emit/text.hpp"

namespace mbgen {
namespace {

std::string line(const std::string& words, const std::string& indent = "") {
  return wrapped_words(comment_text(words), "// " + indent) + "\n";
}

std::string body_text(const Topology& topology, int body) {
  return body == kGround ? "ground" : topology.bodies[static_cast<std::size_t>(body)].name;
}

std::string tree_text(const EmitContext& context) {
  const Topology& topology = context.topology;
  std::string text = line("Tree, each body with its coordinate, on the body before it:");
  for (const TreeBody& body : topology.bodies) {
    text += line(fmt::format("{}: {}, {}, on {}", body.name, body.coordinate, name_of(body.kind),
                             body_text(topology, body.parent)),
                 "  ");
  }
  return text;
}

std::string coordinates_of(const Topology& topology, const LoopBlock& block, const std::vector<int>& columns) {
  std::string text;
  for (const int c : columns)
    text += (text.empty() ? "" : ", ") + topology.bodies[static_cast<std::size_t>(block.joints[c])].coordinate;
  return text.empty() ? "none" : text;
}

std::string loops_text(const EmitContext& context) {
  const Topology& topology = context.topology;
  std::string text;
  for (std::size_t b = 0; b < topology.blocks.size(); ++b) {
    const LoopBlock& block = topology.blocks[b];
    text += line(fmt::format("Loop block {}, on {}:", b, body_text(topology, block.base)));
    for (const int l : block.loops) {
      const Loop& loop = topology.loops[static_cast<std::size_t>(l)];
      text += line(fmt::format("{}: {} between {} and {}", loop.name, name_of(loop.kind),
                               body_text(topology, loop.body_from), body_text(topology, loop.body_to)),
                   "  ");
    }
    const BlockAnalysis& found = context.analysis.blocks[b];
    text += line("independent: " + coordinates_of(topology, block, found.independent), "  ");
    if (context.programs.form == Form::recursive && found.quasi.independent != found.independent)
      text += line("in the accelerations: " + coordinates_of(topology, block, found.quasi.independent), "  ");
  }
  return text;
}

constexpr const char* kFrames[] = {
    "Frames: a body of a loop block is seen in the axes of the body that its block moves on, about that body's origin;",
    "every other body in its own axes. The origin of a body is the point of its joint."};

constexpr const char* kNames[] = {
    "Names, followed by body, coordinate, loop or element:",
    "  m mass, h first moments, K second moments about the origin; c centre of mass, I inertia about it",
    "  p_<coordinate> origin of a body from that of the body before it; p_<body>_<point> a point from its body's",
    "    origin; l length, g gravity: numbers of the model, or what its parameters make of them",
    "  l0 z0 free length, free coordinate, k stiffness, d damping, f0 preload of an element; its other numbers by "
    "their",
    "    fields, as area_<element>",
    "  z zd zdd coordinate, rate, acceleration; R_<body>_x_z component z of the body's axis x; r origin; u joint axis",
    "  v velocity of the origin, w angular velocity, a acceleration of the origin, alpha angular acceleration",
    "  f n force and moment that a body needs, Q force of a joint that its closures and drives must give",
    "  pivot of a coordinate: of its column of the closure Jacobian (60), or of its free direction (63)",
    "  J entry of the closure Jacobian; Rz projection (61); zdd_star accelerations at zero free ones (62)",
    "  s8_12 the 12th value without a name of step 8"};

}  // namespace

std::string legend_text(const EmitContext& context) {
  std::string text = "\n//\n" + tree_text(context) + loops_text(context) + "//\n";
  for (const char* words : kFrames) text += std::string("// ") + words + "\n";
  text += "//\n";
  for (const char* words : kNames) text += std::string("// ") + words + "\n";
  return text;
}

}  // namespace mbgen
