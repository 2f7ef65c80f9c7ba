#include "compiler/passes/derivative_sums.hpp"

#include <algorithm>
#include <utility>

namespace mbgen {
namespace {

bool is_lane(const Node& node) { return node.op == Op::first_lane || node.op == Op::second_lane; }

auto term_from(std::vector<DerivativeTerm>& terms, std::size_t from) {
  return std::ranges::find(terms, from, &DerivativeTerm::from);
}

}  // namespace

// --- slopes ---

bool SlopeArithmetic::share_lane(std::span<const ValueId> slopes) const {
  Op lane = Op::constant;
  for (const ValueId slope : slopes) {
    if (slope == kNoValue || is_constant(slope)) continue;
    const Node& node = values_.node(slope);
    if (!is_lane(node) || (lane != Op::constant && lane != node.op)) return false;
    lane = node.op;
  }
  return lane != Op::constant;
}

ValueId SlopeArithmetic::append(Op op, ValueId a, ValueId b, ValueId c) {
  std::array<ValueId, 3> operands{a, b, c};
  if (!share_lane(operands)) return values_.append(op, a, b, c);
  Op lane = Op::first_lane;
  for (ValueId& operand : operands) {
    if (operand == kNoValue || is_constant(operand)) continue;
    const Node node = values_.node(operand);
    lane = node.op;
    operand = node.operands[0];
  }
  return values_.append(lane, values_.append(op, operands[0], operands[1], operands[2]));
}

ValueId SlopeArithmetic::product(ValueId a, ValueId b) {
  if (is_one(a)) return b;
  return is_one(b) ? a : append(Op::multiply, a, b);
}

double SlopeArithmetic::cost_of_product(ValueId a, ValueId b) const {
  return is_one(a) || is_one(b) ? 0 : cost_of_sum(a, b);
}

double SlopeArithmetic::cost_of_sum(ValueId a, ValueId b) const {
  if (is_constant(a) && is_constant(b)) return 0;
  const std::array<ValueId, 2> both{a, b};
  return share_lane(both) ? 0.5 : 1;
}

SlopeArithmetic::Signed SlopeArithmetic::without_sign(ValueId slope) {
  const Node node = values_.node(slope);
  if (node.op == Op::negate) return {node.operands[0], true};
  if (node.op == Op::constant && node.constant < 0) return {values_.constant(-node.constant), true};
  return {slope, false};
}

// --- sums ---

DerivativeSums::DerivativeSums(const Program& linear, std::span<const ValueId> slope_of, SlopeArithmetic& slopes)
    : linear_(linear), slope_of_(slope_of), slopes_(slopes), derivative_of_(linear.nodes.size(), kNone) {
  for (ValueId v = 0; v < linear.nodes.size(); ++v)
    if (slope_of[v] == kNoValue) read(v);
  for (const OutputValue& output : linear.outputs)
    if (derivative_of_[output.value] != kNone) ++derivatives_[derivative_of_[output.value]].other_users;
}

void DerivativeSums::read(ValueId v) {
  const Node& node = linear_.nodes[v];
  const std::size_t d = derivatives_.size();
  derivative_of_[v] = d;
  derivatives_.push_back({v, false, {}, {}, 0});
  const auto from = [&](int k) { return derivative_of_[node.operands[k]]; };
  const auto slope = [&](int k) { return slope_of_[node.operands[k]]; };
  const bool adds = node.op == Op::add || node.op == Op::subtract;
  derivatives_[d].is_sum = (adds && from(0) != kNone && from(1) != kNone) || node.op == Op::negate ||
                           (node.op == Op::multiply && (from(0) == kNone || from(1) == kNone));
  if (adds && derivatives_[d].is_sum) {
    add_term(d, {from(0), slopes_.one(), false});
    add_term(d, {from(1), slopes_.one(), node.op == Op::subtract});
  } else if (node.op == Op::multiply && derivatives_[d].is_sum) {
    const int factor = from(0) == kNone ? 0 : 1;
    add_term(d, {from(1 - factor), slope(factor), false});
  } else if (node.op == Op::negate) {
    add_term(d, {from(0), slopes_.one(), true});
  } else {
    for (int k = 0; k < arity(node.op); ++k)
      if (from(k) != kNone) ++derivatives_[from(k)].other_users;
  }
}

/// Terms from one derivative are one term, none where their slopes cancel.
void DerivativeSums::add_term(std::size_t sum, DerivativeTerm term) {
  const auto [slope, changes] = slopes_.without_sign(term.slope);
  term = {term.from, slope, term.is_negative != changes};
  std::vector<DerivativeTerm>& terms = derivatives_[sum].terms;
  const auto known = term_from(terms, term.from);
  if (known == terms.end()) {
    terms.push_back(term);
    derivatives_[term.from].users.insert(sum);
    return;
  }
  const Op op = known->is_negative == term.is_negative ? Op::add : Op::subtract;
  const auto [both, is_other] = slopes_.without_sign(slopes_.append(op, known->slope, term.slope));
  *known = {term.from, both, known->is_negative != is_other};
  if (!slopes_.is_zero(both)) return;
  terms.erase(known);
  derivatives_[term.from].users.erase(sum);
}

/// Operations on derivatives: the first term without slope takes none.
double DerivativeSums::length(std::span<const DerivativeTerm> terms) const {
  const bool starts = std::ranges::any_of(
      terms, [&](const DerivativeTerm& term) { return !term.is_negative && slopes_.is_one(term.slope); });
  return static_cast<double>(terms.size()) - (starts ? 1 : 0);
}

/// Operations that a user has fewer when a derivative is passed over in it.
double DerivativeSums::gain_in(std::size_t user, const Derivative& passed, const DerivativeTerm& term,
                               double slope_cost) const {
  std::vector<DerivativeTerm> after = derivatives_[user].terms;
  const double before = length(after);
  after.erase(term_from(after, term.from));
  double slopes = 0;
  for (const auto& [from, slope, is_negative] : passed.terms) {
    const double product = slopes_.cost_of_product(slope, term.slope);
    const auto known = term_from(after, from);
    slopes += product;
    if (known == after.end()) {
      const ValueId new_slope = slopes_.is_one(slope) ? term.slope : slope;
      after.push_back({from, new_slope, is_negative != term.is_negative});
    } else if (product == 0) {  // else one operation with the product
      slopes += slopes_.cost_of_sum(known->slope, slopes_.is_one(slope) ? term.slope : slope);
    }
  }
  return before - length(after) - slope_cost * slopes;
}

double DerivativeSums::gain(std::size_t d, double slope_cost) const {
  const Derivative& passed = derivatives_[d];
  double sum = length(passed.terms);
  for (const std::size_t user : passed.users) {
    const std::vector<DerivativeTerm>& terms = derivatives_[user].terms;
    sum += gain_in(user, passed, *std::ranges::find(terms, d, &DerivativeTerm::from), slope_cost);
  }
  return sum;
}

bool DerivativeSums::passes_over(std::size_t d, double slope_cost, double least_gain) {
  const Derivative& candidate = derivatives_[d];
  if (!candidate.is_sum || candidate.other_users > 0 || candidate.users.empty()) return false;
  if (gain(d, slope_cost) < least_gain) return false;
  const Derivative passed = std::exchange(derivatives_[d], {candidate.node, true, {}, {}, 0});
  for (const DerivativeTerm& term : passed.terms) derivatives_[term.from].users.erase(d);
  for (const std::size_t user : passed.users) {
    const auto known = term_from(derivatives_[user].terms, d);
    const DerivativeTerm term = *known;
    derivatives_[user].terms.erase(known);
    slopes_.set_origin(linear_.nodes[derivatives_[user].node]);
    for (const auto& [from, slope, is_negative] : passed.terms)
      add_term(user, {from, slopes_.product(slope, term.slope), is_negative != term.is_negative});
  }
  return true;
}

DerivativeSums::Multiple DerivativeSums::multiple(ValueId operand) {
  const std::size_t d = derivative_of_[operand];
  if (d == kNone) return {kNone, slope_of_[operand]};
  if (!derivatives_[d].is_sum || derivatives_[d].terms.size() != 1) return {d, slopes_.one()};
  const DerivativeTerm& term = derivatives_[d].terms[0];
  return {term.from, term.is_negative ? slopes_.negative(term.slope) : term.slope};
}

/// A choice between multiples of one derivative is its product with the slope that is chosen.
bool DerivativeSums::choose_slopes() {
  bool changes = false;
  for (std::size_t d = 0; d < derivatives_.size(); ++d) {
    const Node& node = linear_.nodes[derivatives_[d].node];
    if (derivatives_[d].is_sum || node.op != Op::select || slope_of_[node.operands[0]] == kNoValue) continue;
    const Multiple a = multiple(node.operands[1]), b = multiple(node.operands[2]);
    if (a.of != b.of && !(a.of == kNone && slopes_.is_zero(a.slope)) && !(b.of == kNone && slopes_.is_zero(b.slope)))
      continue;
    slopes_.set_origin(node);
    derivatives_[d].is_sum = changes = true;
    const ValueId chosen = slopes_.append(Op::select, slope_of_[node.operands[0]], a.slope, b.slope);
    add_term(d, {a.of == kNone ? b.of : a.of, chosen, false});
    for (const int k : {1, 2})
      if (derivative_of_[node.operands[k]] != kNone) --derivatives_[derivative_of_[node.operands[k]]].other_users;
  }
  return changes;
}

void DerivativeSums::shorten(double slope_cost) {
  constexpr double kRoundingOfCosts = 1e-6;
  bool changes = true;
  while (changes) {
    changes = choose_slopes();
    for (const double least_gain : {2.0, 1.0, kRoundingOfCosts})
      for (std::size_t d = 0; d < derivatives_.size(); ++d) changes |= passes_over(d, slope_cost, least_gain);
  }
}

// --- program ---

ValueId DerivativeSums::written_sum(ProgramBuilder& builder, const Derivative& sum, std::span<const ValueId> written,
                                    const std::function<ValueId(ProgramBuilder&, ValueId)>& taken) const {
  std::vector<DerivativeTerm> terms = sum.terms;
  std::ranges::sort(terms, {}, &DerivativeTerm::from);
  // The start of a sum takes no operation without slope, and one more with a sign.
  const auto price = [&](const DerivativeTerm& term) {
    return term.is_negative ? 2 : slopes_.is_one(term.slope) ? 0 : 1;
  };
  const auto start = std::ranges::min_element(terms, {}, price);
  if (start != terms.end()) std::rotate(terms.begin(), start, start + 1);
  ValueId total = kNoValue;
  for (const auto& [from, slope, is_negative] : terms) {
    ValueId term = written[from];
    if (!slopes_.is_one(slope)) {
      const ValueId factor = taken(builder, slope);
      term = builder.append(Op::multiply, factor, term);
    }
    if (total == kNoValue)
      total = is_negative ? builder.append(Op::negate, term) : term;
    else
      total = builder.append(is_negative ? Op::subtract : Op::add, total, term);
  }
  return total == kNoValue ? builder.constant(0) : total;
}

Program DerivativeSums::program(const std::function<ValueId(ProgramBuilder&, ValueId)>& taken) const {
  ProgramBuilder builder = ProgramBuilder::like(linear_);
  std::vector<ValueId> written, values(linear_.nodes.size(), kNoValue);
  for (const Derivative& derivative : derivatives_) {
    const Node& node = linear_.nodes[derivative.node];
    builder.set_origin(node);
    for (int k = 0; !derivative.is_sum && k < arity(node.op); ++k)
      if (derivative_of_[node.operands[k]] == kNone)
        values[node.operands[k]] = taken(builder, slope_of_[node.operands[k]]);
    written.push_back(derivative.is_sum ? written_sum(builder, derivative, written, taken)
                                        : builder.copy(linear_, node, values));
    values[derivative.node] = written.back();
  }
  for (const auto& [slot, value] : linear_.outputs)
    if (derivative_of_[value] != kNone && !builder.is_constant(values[value], 0))
      builder.output(slot.group, slot.index, values[value]);
  return builder.finish();
}

}  // namespace mbgen
