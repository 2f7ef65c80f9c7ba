// The topology of a model: its tree as an indented list, its closures as brackets at the right.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>
#include <numeric>

#include "compiler/text/characters.hpp"
#include "compiler/topology/names.hpp"
#include "workbench/drawing/drawing.hpp"
#include "workbench/drawing/svg.hpp"

namespace mbgen {
namespace {

// px
constexpr double kMargin = 20, kIndent = 150, kSmallIndent = 80, kRow = 38, kRowGap = 8, kPort = 14, kTrack = 9;
constexpr double kFont = 12, kSmallFont = 10, kMark = 12, kLegendLine = 20;
/// Levels up to which each is indented by kIndent.
constexpr int kFewLevels = 10;
/// Grounds of the loop blocks, and the lines on them.
struct BlockColours {
  const char *ground, *line;
};
constexpr std::array<BlockColours, 6> kBlockColours = {{{"#e6f0fa", "#1f6fb2"},
                                                        {"#fdeee2", "#b8560f"},
                                                        {"#e5f4ea", "#1c7a43"},
                                                        {"#f5e8f4", "#93428c"},
                                                        {"#f8f3d8", "#80690a"},
                                                        {"#e8eaec", "#4a5560"}}};

const BlockColours& colours_of(int block) {
  return kBlockColours[static_cast<std::size_t>(block) % kBlockColours.size()];
}

/// A body and its place in the picture.
struct Row {
  int body = -1;
  int depth = 0;
  int joint = -1;   ///< index into Topology::tree_joints, -1 for ground
  int parent = -1;  ///< row
  int block = -1;   ///< loop block of its joint
  int ports = 0;    ///< ends of closures
  double x = 0, y = 0, width = 0, height = 0;
  double port(int i) const { return y + height / 2 + (i - (ports - 1) / 2.0) * kPort; }
  double right() const { return x + width; }
};

/// A closure between two rows, the upper one first.
struct Bracket {
  int loop = -1, block = -1;
  std::array<int, 2> row{}, port{};
  int track = 0;
};

struct Sheet {
  const Model& model;
  const Topology& topology;
  const Analysis& analysis;
  std::vector<Row> rows;
  std::vector<Bracket> brackets;
  double lane = 0, lane_end = 0;  ///< where the names of the closures stand
  double width = 0, height = 0;
  std::vector<bool> is_free;  ///< per tree coordinate
};

int block_of_body(const Topology& topology, int body) {
  const int tree = topology.tree_body[static_cast<std::size_t>(body)];
  return tree == kGround ? -1 : topology.groups[static_cast<std::size_t>(topology.group_of[tree])].block;
}

/// Bodies depth first, the bodies of one block together, else in the order of the tree.
void add_rows(Sheet& sheet, int body, int joint, int parent) {
  const int row = static_cast<int>(sheet.rows.size());
  const int depth = parent < 0 ? 0 : sheet.rows[parent].depth + 1;
  sheet.rows.push_back({body, depth, joint, parent, joint < 0 ? -1 : block_of_body(sheet.topology, body)});
  std::vector<int> joints;
  for (std::size_t j = 0; j < sheet.topology.tree_joints.size(); ++j) {
    if (sheet.topology.tree_joints[j].parent == body) joints.push_back(static_cast<int>(j));
  }
  const auto rank = [&](int j) {
    const int block = block_of_body(sheet.topology, sheet.topology.tree_joints[static_cast<std::size_t>(j)].child);
    return block < 0 ? std::numeric_limits<int>::max() : block;
  };
  std::stable_sort(joints.begin(), joints.end(), [&](int a, int b) { return rank(a) < rank(b); });
  for (const int j : joints) add_rows(sheet, sheet.topology.tree_joints[static_cast<std::size_t>(j)].child, j, row);
}

/// The bodies that a closure joins, indices into Model::bodies.
std::array<int, 2> ends_of(const Model& model, const Loop& loop) {
  if (loop.coupling >= 0) {
    const std::vector<CoordinateReference>& coupled = model.couplings[loop.coupling].coordinates;
    return {model.joints[coupled.front().joint].to.body, model.joints[coupled.back().joint].to.body};
  }
  if (loop.rod >= 0) return {model.rods[loop.rod].from.body, model.rods[loop.rod].to.body};
  return {model.joints[loop.joint].from.body, model.joints[loop.joint].to.body};
}

std::string label_of(const Topology& topology, const Bracket& bracket) {
  const Loop& loop = topology.loops[bracket.loop];
  return fmt::format("{} ({})", loop.name, name_of(loop.kind));
}

/// Tracks from the inside, short closures first, none over another.
void choose_tracks(std::vector<Bracket>& brackets) {
  std::vector<std::size_t> order(brackets.size());
  std::iota(order.begin(), order.end(), 0);
  const auto span = [&](std::size_t b) { return brackets[b].row[1] - brackets[b].row[0]; };
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return span(a) < span(b); });
  std::vector<std::vector<std::size_t>> taken;
  for (const std::size_t b : order) {
    const auto fits = [&](const std::vector<std::size_t>& track) {
      return std::none_of(track.begin(), track.end(), [&](std::size_t other) {
        return brackets[b].row[0] <= brackets[other].row[1] && brackets[other].row[0] <= brackets[b].row[1];
      });
    };
    const auto track = std::find_if(taken.begin(), taken.end(), fits);
    brackets[b].track = static_cast<int>(track - taken.begin());
    if (track == taken.end()) taken.emplace_back();
    taken[static_cast<std::size_t>(brackets[b].track)].push_back(b);
  }
}

void add_brackets(Sheet& sheet) {
  std::vector<int> row_of(sheet.model.bodies.size(), 0);
  for (std::size_t r = 0; r < sheet.rows.size(); ++r) {
    if (sheet.rows[r].body >= 0) row_of[static_cast<std::size_t>(sheet.rows[r].body)] = static_cast<int>(r);
  }
  for (std::size_t b = 0; b < sheet.topology.blocks.size(); ++b) {
    for (const int loop : sheet.topology.blocks[b].loops) {
      const auto [from, to] = ends_of(sheet.model, sheet.topology.loops[loop]);
      Bracket bracket{loop, static_cast<int>(b), {row_of[from], row_of[to]}, {}, 0};
      std::sort(bracket.row.begin(), bracket.row.end());
      sheet.brackets.push_back(bracket);
    }
  }
  // Ports from the top of a row down: closures from above first, then the closures to the nearest row.
  std::vector<std::pair<int, std::size_t>> ends;
  for (std::size_t r = 0; r < sheet.rows.size(); ++r) {
    ends.clear();
    for (std::size_t b = 0; b < sheet.brackets.size(); ++b) {
      const Bracket& bracket = sheet.brackets[b];
      if (bracket.row[1] == static_cast<int>(r)) ends.emplace_back(-1, b);
      if (bracket.row[0] == static_cast<int>(r)) ends.emplace_back(bracket.row[1], b);
    }
    std::stable_sort(ends.begin(), ends.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    for (const auto& [other, b] : ends) sheet.brackets[b].port[other < 0 ? 1 : 0] = sheet.rows[r].ports++;
  }
  choose_tracks(sheet.brackets);
}

const char* kind_at(const Sheet& sheet, const Row& row) {
  return name_of(sheet.model.joints[sheet.topology.tree_joints[row.joint].joint].type);
}

std::string body_label(const Sheet& sheet, const Row& row) {
  return row.body < 0 ? "ground" : sheet.model.bodies[row.body].name;
}

void arrange(Sheet& sheet) {
  int deepest = 0;
  for (const Row& row : sheet.rows) deepest = std::max(deepest, row.depth);
  const double indent = deepest <= kFewLevels ? kIndent : kSmallIndent;
  double y = kMargin;
  for (Row& row : sheet.rows) {
    row.x = kMargin + row.depth * indent;
    row.width = 22 + svg::text_width(body_label(sheet, row), kFont);
    row.height = std::max(kRow - kRowGap, row.ports * kPort + 4);
    row.y = y;
    y += row.height + kRowGap;
    sheet.lane = std::max(sheet.lane, row.right() + 12);
  }
  sheet.lane_end = sheet.lane;
  int tracks = 0;
  for (const Bracket& bracket : sheet.brackets) {
    sheet.lane_end =
        std::max(sheet.lane_end, sheet.lane + svg::text_width(label_of(sheet.topology, bracket), kSmallFont) + 6);
    tracks = std::max(tracks, bracket.track + 1);
  }
  constexpr double kLeastWidth = 640;
  sheet.width = std::max(kLeastWidth, sheet.lane_end + tracks * kTrack + 2 * kMargin);
  sheet.height = y + kMargin;
}

bool is_massless(const Body& body) { return body.mass.expression < 0 && body.mass.value == 0; }

std::string grounds(const Sheet& sheet) {
  std::string text;
  for (const Row& row : sheet.rows) {
    if (row.block < 0) continue;
    text += fmt::format("<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" fill=\"{}\"/>\n",
                        svg::number(sheet.rows[row.parent].x + 14), svg::number(row.y - kRowGap / 2),
                        svg::number(sheet.lane_end - sheet.rows[row.parent].x - 14), svg::number(row.height + kRowGap),
                        colours_of(row.block).ground);
  }
  return text;
}

/// A coordinate on the line of its joint: filled where it is independent, hollow where dependent, square where driven.
std::string mark(const Sheet& sheet, double x, double y, int coordinate) {
  const std::string& name = sheet.topology.bodies[coordinate].coordinate;
  if (sheet.analysis.driven[coordinate]) {
    return fmt::format(
        "<rect x=\"{}\" y=\"{}\" width=\"8\" height=\"8\" fill=\"#d9822b\" stroke=\"#fff\"><title>{}, "
        "driven</title></rect>\n",
        svg::number(x - 4), svg::number(y - 4), xml_text(name));
  }
  const bool is_free = sheet.is_free[coordinate];
  return fmt::format(
      "<circle cx=\"{}\" cy=\"{}\" r=\"4\" fill=\"{}\" stroke=\"#2d3742\" stroke-width=\"1.2\"><title>{}, "
      "{}</title></circle>\n",
      svg::number(x), svg::number(y), is_free ? "#2d3742" : "#fff", xml_text(name),
      is_free ? "independent" : "dependent");
}

/// The line from the parent, the joint's kind and its coordinates.
std::string tree_line(const Sheet& sheet, const Row& row) {
  const Row& parent = sheet.rows[row.parent];
  const TreeJoint& joint = sheet.topology.tree_joints[row.joint];
  const double trunk = parent.x + 14, y = row.y + row.height / 2;
  std::string text =
      fmt::format("<path d=\"M{} {}V{}H{}\" fill=\"none\" stroke=\"#7a8692\" stroke-width=\"1.4\"/>\n",
                  svg::number(trunk), svg::number(parent.y + parent.height), svg::number(y), svg::number(row.x));
  text += fmt::format("<g><title>joint {}{}</title>{}</g>\n", xml_text(sheet.model.joints[joint.joint].name),
                      joint.reversed ? ", held at its to side" : "",
                      svg::text_at(trunk + 8, y - 7, kind_at(sheet, row), " font-size=\"10\" fill=\"#4a5560\""));
  double x = trunk + 14;
  for (int i = 0; i < sheet.topology.size(); ++i) {
    if (sheet.topology.bodies[i].joint != joint.joint) continue;
    text += mark(sheet, x, y, i);
    x += kMark;
  }
  return text;
}

std::string body_box(const Sheet& sheet, const Row& row) {
  const bool is_ground = row.joint < 0;
  const bool dashed = !is_ground && is_massless(sheet.model.bodies[row.body]);
  std::string text = fmt::format(
      "<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" rx=\"5\" fill=\"{}\" stroke=\"#2d3742\" "
      "stroke-width=\"1.3\"{}/>\n",
      svg::number(row.x), svg::number(row.y), svg::number(row.width), svg::number(row.height),
      is_ground ? "#d5dade" : "#fff", dashed ? " stroke-dasharray=\"5 3\"" : "");
  return text + svg::text_at(row.x + row.width / 2, row.y + row.height / 2 + 4, body_label(sheet, row),
                             " text-anchor=\"middle\"");
}

/// A closure: its name at the upper end, thick for a cut joint, thin for a rod or coupling.
std::string bracket_text(const Sheet& sheet, const Bracket& bracket) {
  const Row &upper = sheet.rows[bracket.row[0]], &lower = sheet.rows[bracket.row[1]];
  const double from = upper.port(bracket.port[0]), to = lower.port(bracket.port[1]);
  const double track = sheet.lane_end + kTrack * (bracket.track + 1);
  const std::string label = label_of(sheet.topology, bracket);
  const char* colour = colours_of(bracket.block).line;
  const bool is_thick = sheet.topology.loops[bracket.loop].joint >= 0;
  std::string text = fmt::format(
      "<path d=\"M{} {}H{}M{} {}H{}V{}H{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"{}\" "
      "stroke-linejoin=\"round\"/>\n",
      svg::number(upper.right()), svg::number(from), svg::number(sheet.lane - 3),
      svg::number(sheet.lane + svg::text_width(label, kSmallFont) + 3), svg::number(from), svg::number(track),
      svg::number(to), svg::number(lower.right()), colour, is_thick ? "2.4" : "1");
  for (const auto& [x, y] : {std::pair(upper.right(), from), std::pair(lower.right(), to)}) {
    text +=
        fmt::format("<circle cx=\"{}\" cy=\"{}\" r=\"2.6\" fill=\"{}\"/>\n", svg::number(x), svg::number(y), colour);
  }
  return text + svg::text_at(sheet.lane, from + 3.5, label,
                             fmt::format(" font-size=\"10\" fill=\"{}\" stroke=\"none\"", colour));
}

/// Meaning of the marks, and a line a block.
std::string legend(Sheet& sheet) {
  double y = sheet.height + 4, x = kMargin;
  const auto word = [&](const char* mark_text, const char* meaning) {
    std::string text =
        fmt::format("<g transform=\"translate({} {})\">{}</g>\n", svg::number(x), svg::number(y), mark_text);
    text += svg::text_at(x + 26, y + 4, meaning, " font-size=\"11\"");
    x += 44 + svg::text_width(meaning, 11);
    return text;
  };
  std::string text = fmt::format("<path d=\"M{} {}H{}\" stroke=\"#c4cad0\"/>\n", svg::number(kMargin),
                                 svg::number(sheet.height - 14), svg::number(sheet.width - kMargin));
  text += word("<circle cx=\"10\" r=\"4\" fill=\"#2d3742\" stroke=\"#2d3742\"/>", "independent");
  text += word("<circle cx=\"10\" r=\"4\" fill=\"#fff\" stroke=\"#2d3742\"/>", "dependent");
  text += word("<rect x=\"6\" y=\"-4\" width=\"8\" height=\"8\" fill=\"#d9822b\"/>", "driven");
  text += word(
      "<rect y=\"-6\" width=\"20\" height=\"12\" rx=\"3\" fill=\"#fff\" stroke=\"#2d3742\" stroke-dasharray=\"5 3\"/>",
      "massless");
  text += word("<path d=\"M0 0H20\" stroke=\"#4a5560\" stroke-width=\"2.4\"/>", "cut joint");
  text += word("<path d=\"M0 0H20\" stroke=\"#4a5560\"/>", "rod");
  for (std::size_t b = 0; b < sheet.topology.blocks.size(); ++b) {
    y += kLegendLine;
    const LoopBlock& block = sheet.topology.blocks[b];
    const BlockAnalysis& decided = sheet.analysis.blocks[b];
    const std::string base = body_name(sheet.topology, block.base);
    text += fmt::format("<rect x=\"{}\" y=\"{}\" width=\"20\" height=\"12\" fill=\"{}\" stroke=\"{}\"/>\n",
                        svg::number(kMargin), svg::number(y - 6), colours_of(static_cast<int>(b)).ground,
                        colours_of(static_cast<int>(b)).line);
    text += svg::text_at(
        kMargin + 26, y + 4,
        fmt::format("loop block {} on {}: {} coordinates, {} equations of rank {}, {} independent, {} driven", b + 1,
                    base, block.joints.size(), block.equations, decided.rank, decided.independent.size(),
                    decided.driven.size()),
        " font-size=\"11\"");
  }
  sheet.height = y + kMargin;
  return text;
}

}  // namespace

std::string topology_svg(const Model& model, const Topology& topology, const Analysis& analysis) {
  Sheet sheet{model, topology, analysis, {}, {}, 0, 0, 0, 0, std::vector<bool>(topology.bodies.size(), false)};
  for (const int coordinate : free_coordinates(topology, analysis)) sheet.is_free[coordinate] = true;
  add_rows(sheet, model.ground, -1, -1);
  add_brackets(sheet);
  arrange(sheet);
  std::string text = grounds(sheet);
  for (const Row& row : sheet.rows) {
    if (row.joint >= 0) text += tree_line(sheet, row);
  }
  for (const Bracket& bracket : sheet.brackets) text += bracket_text(sheet, bracket);
  for (const Row& row : sheet.rows) text += body_box(sheet, row);
  text += legend(sheet);
  return fmt::format(
             "<svg xmlns=\"http://www.w3.org/2000/svg\" font-family=\"sans-serif\" font-size=\"{0}\" fill=\"#1b232b\" "
             "width=\"{1}\" height=\"{2}\" viewBox=\"0 0 {1} {2}\">\n<title>topology of {3}</title>\n"
             "<rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n",
             kFont, svg::number(sheet.width), svg::number(sheet.height), xml_text(model.name)) +
         text + "</svg>\n";
}

}  // namespace mbgen
