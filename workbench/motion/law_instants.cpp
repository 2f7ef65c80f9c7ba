#include "workbench/motion/law_instants.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "compiler/expressions/evaluate.hpp"

namespace mbgen {
namespace {

using Kind = ExpressionNode::Kind;

/// Distance of a part from an instant, in parts of the step, and in roundings of the time.
constexpr double kBeside = 1e-11, kRoundings = 32;
/// Instants in one step beyond which it stays whole: points of a table that are denser than the steps.
constexpr std::size_t kMostInStep = 4;

/// The values of an expression of time and parameters.
struct TimeEnvironment {
  const std::vector<double>& parameters;
  double t;

  double parameter(int index) const { return parameters[static_cast<std::size_t>(index)]; }
  double time() const { return t; }
  // Never called: conditions have none of these.
  double input(int) const { return 0; }
  double position(const CoordinateReference&) const { return 0; }
  double velocity(const CoordinateReference&) const { return 0; }
  double local(int) const { return 0; }
};

/// Quantities on which a node of an expression depends.
struct Dependence {
  bool on_time = false, on_others = false;
};

/// Per node: whether it depends on time, and on nothing else that moves.
std::vector<bool> nodes_of_time(const Expression& expression) {
  std::vector<Dependence> of;
  for (const ExpressionNode& node : expression.nodes) {
    Dependence own{node.kind == Kind::time, node.kind != Kind::time && node.kind != Kind::number &&
                                                node.kind != Kind::parameter && node.kind != Kind::call};
    for (const int operand : {node.first, node.second, node.third}) {
      if (node.kind != Kind::call || operand < 0) continue;
      own.on_time = own.on_time || of[static_cast<std::size_t>(operand)].on_time;
      own.on_others = own.on_others || of[static_cast<std::size_t>(operand)].on_others;
    }
    of.push_back(own);
  }
  std::vector<bool> result;
  for (const Dependence& own : of) result.push_back(own.on_time && !own.on_others);
  return result;
}

/// Appends a node of another expression with all that it is made of. Result: its place.
int copy_node(const Expression& from, int index, Expression& to) {
  ExpressionNode node = from.nodes[static_cast<std::size_t>(index)];
  if (node.kind == Kind::call)
    for (int* operand : {&node.first, &node.second, &node.third})
      if (*operand >= 0) *operand = copy_node(from, *operand, to);
  to.nodes.push_back(std::move(node));
  return static_cast<int>(to.nodes.size()) - 1;
}

/// Number of the piece of a table at x; of a smooth one whether x is before, within or behind its points.
double piece_of(const NamedTable& named, double x) {
  const Table& table = std::get<Table>(named.table);
  const double first = table.x.front(), period = table.x.back() - first;
  if (!has_straight_pieces(named)) return x < first ? -1 : x < table.x.back() ? 0 : 1;
  const double periods = table.periodic ? std::floor((x - first) / period) : 0;
  const auto piece = std::upper_bound(table.x.begin(), table.x.end(), x - periods * period) - table.x.begin();
  return periods * static_cast<double>(table.x.size() - 1) + static_cast<double>(piece);
}

/// Whether one of ascending instants lies between two.
bool has_any(const std::vector<double>& instants, double from, double to) {
  const auto next = std::ranges::upper_bound(instants, from);
  return next != instants.end() && *next < to;
}

/// Whether the slope of a table jumps somewhere.
bool has_corners(const NamedTable& named) {
  const auto* curve = std::get_if<Table>(&named.table);
  return curve != nullptr && (has_straight_pieces(named) || named.holds);
}

}  // namespace

LawInstants::LawInstants(const Model& model) {
  for (const Expression& expression : model.expressions) add(expression, nodes_of_time(expression));
  for (const Parameter& parameter : model.parameters) parameters_.push_back(parameter.value);
}

void LawInstants::add(const Expression& expression, const std::vector<bool>& of_time) {
  for (const ExpressionNode& node : expression.nodes) {
    if (node.kind != Kind::call) continue;
    const bool of_two = node.function == Function::min || node.function == Function::max;
    const bool of_sign = node.function == Function::abs || node.function == Function::sign ||
                         node.function == Function::step || node.function == Function::select;
    const bool of_table = node.table && has_corners(*node.table);
    if (!of_two && !of_sign && !of_table && node.function != Function::floor) continue;
    Condition condition;
    condition.is_whole = node.function == Function::floor;
    if (of_table) condition.table = node.table;
    ExpressionNode difference;
    difference.kind = Kind::call;
    difference.function = Function::subtract;
    difference.first = copy_node(expression, node.first, condition.value);
    if (of_two) {
      difference.second = copy_node(expression, node.second, condition.value);
      condition.value.nodes.push_back(difference);
    }
    const std::vector<bool> own = of_two ? nodes_of_time(condition.value) : std::vector<bool>{};
    if (of_two ? own.back() : of_time[static_cast<std::size_t>(node.first)])
      conditions_.push_back(std::move(condition));
  }
}

double LawInstants::side(const Condition& condition, double t) const {
  const auto value = evaluate<double>(condition.value, TimeEnvironment{parameters_, t});
  if (condition.table) return piece_of(*condition.table, value);
  return condition.is_whole ? std::floor(value) : value >= 0 ? 1 : 0;
}

std::vector<double> LawInstants::sides(double t) const {
  std::vector<double> result;
  for (const Condition& condition : conditions_) result.push_back(side(condition, t));
  return result;
}

bool LawInstants::changes(const std::array<double, 4>& times) const {
  return std::ranges::any_of(conditions_, [&](const Condition& condition) {
    const double first = side(condition, times.front());
    return std::any_of(times.begin() + 1, times.end(), [&](double t) { return side(condition, t) != first; });
  });
}

std::vector<StepPart> LawInstants::parts(double start, double end, const std::vector<double>& jumps) const {
  const double rounding = kRoundings * (std::nextafter(std::abs(end), HUGE_VAL) - std::abs(end));
  const double beside = std::max(kBeside * (end - start), rounding);
  const double from = start + beside, to = end - beside;
  if (!changes({start - beside, from, to, end + beside}) && !has_any(jumps, from, to)) return {};
  std::vector<StepPart> cuts;  // from just before an instant to just after it
  std::vector<double> now = sides(from);
  const std::vector<double> last = sides(to);
  for (double after = from; now != last && cuts.size() <= kMostInStep;) {
    StepPart cut{after, to};
    while (cut.end - cut.start > beside) {
      const double middle = (cut.start + cut.end) / 2;
      (sides(middle) == now ? cut.start : cut.end) = middle;
    }
    cuts.push_back(cut);
    after = cut.end;
    now = sides(after);
  }
  for (auto jump = std::upper_bound(jumps.begin(), jumps.end(), from);
       jump != jumps.end() && *jump < to && cuts.size() <= kMostInStep; ++jump)
    cuts.push_back({*jump - beside, *jump + beside});
  const bool begins_there = sides(start - beside) != sides(from), ends_there = last != sides(end + beside);
  if ((cuts.empty() && !begins_there && !ends_there) || cuts.size() > kMostInStep) return {};
  std::ranges::sort(cuts, {}, &StepPart::start);
  std::vector<StepPart> parts = {{begins_there ? from : start, ends_there ? to : end}};
  for (const StepPart& cut : cuts) {
    const double stop = std::exchange(parts.back().end, cut.start);
    parts.push_back({cut.end, stop});
  }
  std::erase_if(parts, [&](const StepPart& part) { return !(part.end - part.start > 2 * beside); });
  return parts;
}

}  // namespace mbgen
