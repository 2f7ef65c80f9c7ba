// Outputs that expressions look at: the order in which they become known, and uses that come before this.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "compiler/model/element_access.hpp"
#include "compiler/reader/reader.hpp"

namespace mbgen::reading {
namespace {

/// Whether a source follows from accelerations or multipliers.
bool needs_accelerations(const PointOutput& output) { return output.what == PointOutput::What::acceleration; }
bool needs_accelerations(const CoordinateOutput& output) { return output.what == CoordinateOutput::What::acceleration; }
bool needs_accelerations(const RotationOutput& output) {
  return output.what == RotationOutput::What::angular_acceleration;
}
bool needs_accelerations(const ReactionOutput&) { return true; }
bool needs_accelerations(const MultiplierOutput&) { return true; }
bool needs_accelerations(const DriveOutput&) { return true; }
template <class Source>
bool needs_accelerations(const Source&) {
  return false;
}

/// Puts the outputs that expressions look at into order, depth first.
class ObservedOrder {
 public:
  explicit ObservedOrder(Reader& reader) : reader_(reader), model_(reader.model) {}

  /// Index into Model::observed of an output that was visited.
  int place_of(int output) const { return place_.at(output); }

  /// The same, after it has been put into order; -1 in a circle.
  int visit(int output) {
    if (const auto done = place_.find(output); done != place_.end()) {
      if (done->second < 0) tell_circle(output);
      return done->second;
    }
    place_[output] = -1;
    way_.push_back(output);
    ObservedOutput observed{model_.outputs[static_cast<std::size_t>(output)]};
    if (const auto length = as_length(observed.output.source)) observed.output.source = *length;
    std::visit([&](const auto& source) { observed.round = round_of_source(source); }, observed.output.source);
    way_.pop_back();
    model_.observed.push_back(std::move(observed));
    return place_[output] = static_cast<int>(model_.observed.size()) - 1;
  }

 private:
  /// The length of a spring or its rate as an expression, which is known before the spring's force.
  std::optional<ExpressionOutput> as_length(const decltype(Output::source)& source) {
    const auto* output = std::get_if<ElementOutput>(&source);
    if (!output || output->element < 0) return {};
    std::optional<ExpressionOutput> result;
    int before = 0, place = 0;
    each_kind([&](auto kind) {
      if constexpr (kind.has_length) {
        const std::string_view quantity = kind.quantities[static_cast<std::size_t>(output->quantity)].name;
        const bool is_length = quantity == std::string_view("length");
        if (place == output->kind && (is_length || quantity == std::string_view("rate"))) {
          ExpressionNode node;
          node.kind = is_length ? ExpressionNode::Kind::length : ExpressionNode::Kind::rate;
          node.index = before + output->element;
          result.emplace();
          result->value.expression = static_cast<int>(model_.expressions.size());
          model_.expressions.push_back({std::string(quantity), {node}});
        }
        before += static_cast<int>(kind.list(model_).size());
      }
      ++place;
    });
    return result;
  }

  template <class Source>
  int round_of_source(const Source& source) {
    if (needs_accelerations(source)) return kAfterForces;
    if constexpr (std::is_same_v<Source, ExpressionOutput>) return round_of_expression(source);
    if constexpr (std::is_same_v<Source, ElementOutput>) return round_of_element(source);
    if constexpr (std::is_same_v<Source, StoredEnergyOutput>) return round_of_stored_energy();
    return kBeforeForces;
  }

  /// Puts the outputs of an expression into order. Result: the latest of their rounds, kBeforeForces without any.
  int latest(Expression expression) {  // a copy: a visit may add expressions
    int round = kBeforeForces;
    for (const ExpressionNode& node : expression.nodes) {
      if (node.kind != ExpressionNode::Kind::observed) continue;
      const int known = visit(node.index);
      if (known >= 0) round = std::max(round, model_.observed[static_cast<std::size_t>(known)].round);
    }
    return round;
  }

  int round_of_expression(const ExpressionOutput& output) {
    if (output.value.expression < 0) return kBeforeForces;
    return latest(model_.expressions[static_cast<std::size_t>(output.value.expression)]);
  }

  template <class Element>
  int round_of_law(const Element& element) {
    return round_of(model_, element, [&](const Expression& expression) {
      const int round = latest(expression);
      return round == kAfterForces ? round : round + 1;
    });
  }

  int round_of_element(const ElementOutput& output) {
    int round = 0;
    with_kind(output.kind, [&]<class Kind>(KindOf<Kind> kind) {
      if (output.element < 0) return;
      round = round_of_law(kind.list(model_)[static_cast<std::size_t>(output.element)]);
      if constexpr (std::is_same_v<Kind, PointSpring>)
        for (const SpringFriction& friction : model_.spring_frictions)  // which adds to the spring's force
          if (friction.spring == output.element) round = std::max(round, round_of_law(friction));
    });
    return round;
  }

  int round_of_stored_energy() {
    int round = 0;
    each_element(model_, [&](const auto& element) {
      if constexpr (KindOf<std::decay_t<decltype(element)>>::is_elastic) round = std::max(round, round_of_law(element));
    });
    return round;
  }

  void tell_circle(int output) {
    std::vector<std::string> names;
    for (auto at = std::find(way_.begin(), way_.end(), output); at != way_.end(); ++at)
      names.push_back("out." + model_.outputs[static_cast<std::size_t>(*at)].name);
    names.push_back(names.front());
    const auto use = std::find_if(reader_.output_uses.begin(), reader_.output_uses.end(),
                                  [&](const WrittenOutputUse& one) { return one.output == output; });
    const InScope in_scope(reader_, use->scope);
    report(reader_, use->place, fmt::format("output depends on itself: {}", fmt::join(names, " <- ")),
           "break the circle with a state that follows the value, or with a sampled value");
  }

  Reader& reader_;
  Model& model_;
  std::map<int, int> place_;  ///< output -> place in Model::observed, -1 while on the way
  std::vector<int> way_;
};

/// Reports a coordinate that counts the other way in the mirrored instance that looks at its output.
void check_direction(Reader& reader, const WrittenOutputUse& use, const Output& output) {
  const auto* source = std::get_if<CoordinateOutput>(&output.source);
  const std::vector<CoordinateReference>& reversed = reader.names.reversed;
  if (!source || !reader.scopes[use.scope].keeps_direction) return;
  if (std::find(reversed.begin(), reversed.end(), source->coordinate) == reversed.end()) return;
  const InScope in_scope(reader, use.scope);
  report(reader, use.place, reversed_message(coordinate_name(reader.model, source->coordinate)), kReversedHint);
}

/// Reports outputs over accelerations where forces and states, from which these follow, look at them.
void check_uses(Reader& reader, const ObservedOrder& order) {
  for (const WrittenOutputUse& use : reader.output_uses) {
    const ObservedOutput& observed = reader.model.observed[static_cast<std::size_t>(order.place_of(use.output))];
    check_direction(reader, use, observed.output);
    if (use.sees_accelerations || observed.round != kAfterForces) continue;
    const InScope in_scope(reader, use.scope);
    report(reader, use.place,
           fmt::format("output {} follows from accelerations, and these from forces and states",
                       in_quotes(observed.output.name)),
           fmt::format("sample it: \"sampled\": {{\"measured\": {{\"period\": ..., \"value\": \"out.{}\"}}}}, and "
                       "write measured here",
                       observed.output.name));
  }
}

}  // namespace

void name_outputs(Reader& reader, const Entries& entries) {
  for (const Entry& entry : entries)
    reader.names.outputs.emplace(entry.name, static_cast<int>(reader.names.outputs.size()));
}

void observe_outputs(Reader& reader) {
  Model& model = reader.model;
  ObservedOrder order(reader);
  for (const WrittenOutputUse& use : reader.output_uses) order.visit(use.output);
  check_uses(reader, order);
  for (Expression& expression : model.expressions)
    for (ExpressionNode& node : expression.nodes)
      if (node.kind == ExpressionNode::Kind::observed) node.index = order.place_of(node.index);
}

}  // namespace mbgen::reading
