#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "compiler/passes/passes.hpp"
#include "compiler/program/function_field.hpp"
#include "compiler/program/kinds.hpp"
#include "compiler/program/rewrite.hpp"
#include "compiler/program/rounded.hpp"

namespace mbgen {
namespace {

/// Number of nearest values that are tried below a value: 30 save 19 operations of the truck more than 10, 100 save
/// none in addition.
constexpr std::size_t kMostLeaves = 30;
constexpr std::size_t kMostFreed = 100;  ///< values that may be freed with one: more are not tried
constexpr std::size_t kTriedStates = 2;
/// Largest ratio of the rounding of another form to the rounding of the value: it excludes differences of large
/// numbers.
constexpr double kMoreRounding = 2;

/// An operation on values known earlier.
struct Form {
  Op op = Op::constant;  ///< add, subtract or multiply; constant: none
  ValueId first = kNoValue, second = kNoValue;
  bool negative = false;  ///< its negative
};

/// The values that a value is made of at once.
class Operands {
 public:
  void add(ValueId value) { values_[count_++] = value; }
  const ValueId* begin() const { return values_.data(); }
  const ValueId* end() const { return begin() + count_; }

 private:
  std::array<ValueId, 3> values_ = {};
  std::size_t count_ = 0;
};

int cost_of(Op op) {
  constexpr int kFunction = 10;  // a function takes more than ten operations
  if (op == Op::negate || op == Op::constant || op == Op::input) return 0;
  return op <= Op::divide ? 1 : kFunction;
}

class ShorterForms {
 public:
  explicit ShorterForms(const Program& program)
      : program_(program),
        uses_(program.nodes.size(), 0),
        operands_(program.nodes.size()),
        forms_(program.nodes.size()),
        leaf_of_(program.nodes.size(), kNoValue) {
    for (const auto& lanes : elements_of(program, field_, input_variables(program, field_)))
      elements_.push_back(lanes[0]);
    value_of_.assign(field_.size(), kNoValue);
    for (ValueId v = 0; v < elements_.size(); ++v) {
      const Node& node = program.nodes[v];
      ValueId& value = value_of_[static_cast<std::size_t>(elements_[v].number)];
      if (value == kNoValue && node.op != Op::negate) value = v;
      for (int k = 0; k < arity(node.op); ++k) operands_[v].add(node.operands[k]);
    }
    std::vector<ValueId> taken;
    for (const OutputValue& output : program.outputs) take(output.value, taken);
    for (std::size_t s = 0; s < kTriedStates; ++s)
      rounded_.push_back(rounded_values(program, ordinary_inputs(program, s)));
  }

  Program rewritten_program() {
    for (ValueId v = static_cast<ValueId>(forms_.size()); v-- > 0;)
      if (uses_[v] > 0 && cost_of(program_.nodes[v].op) == 1) shorten(v);
    return rewritten(program_, [&](ProgramBuilder& builder, ValueId v, std::span<const ValueId> renamed) {
      const Form& form = forms_[v];
      if (form.op == Op::constant) return kNoValue;
      const ValueId value = builder.append(form.op, renamed[form.first], renamed[form.second]);
      return form.negative ? builder.append(Op::negate, value) : value;
    });
  }

 private:
  /// Cost of one more use of a value; values that got a use are added to `changed`.
  int take(ValueId value, std::vector<ValueId>& changed) {
    int cost = 0;
    std::size_t next = changed.size();
    changed.push_back(value);
    for (; next < changed.size(); ++next) {
      const ValueId v = changed[next];
      if (uses_[v]++ > 0) continue;
      cost += cost_of(program_.nodes[v].op);
      for (const ValueId operand : operands_[v]) changed.push_back(operand);
    }
    return cost;
  }

  /// Cost of what goes with one use of each operand of `v`, the nearest `most` values of it; all that lost a use goes
  /// into `changed`.
  int leave_operands(ValueId v, std::size_t most, std::vector<ValueId>& changed) {
    int cost = 0;
    gone_.assign(1, v);
    for (std::size_t i = 0; i < gone_.size() && i < most; ++i) {
      cost += cost_of(program_.nodes[gone_[i]].op);
      for (const ValueId operand : operands_[gone_[i]]) {
        changed.push_back(operand);
        if (--uses_[operand] == 0) gone_.push_back(operand);
      }
    }
    return cost;
  }

  /// Finds values that `v` is made of, the nearest first.
  void find_leaves(ValueId v) {
    leaves_.clear();
    const auto add = [&](ValueId leaf) {
      leaf_of_[leaf] = v;
      leaves_.push_back(leaf);
    };
    for (const ValueId operand : operands_[v]) add(operand);
    for (std::size_t i = 0; i < leaves_.size() && leaves_.size() < kMostLeaves; ++i)
      for (const ValueId operand : operands_[leaves_[i]])
        if (leaf_of_[operand] != v) add(operand);
  }

  /// The value of a function that is known before v, in a program that is left without v.
  ValueId earlier(const std::optional<Element>& element, ValueId v) const {
    if (!element || element->number == 0) return kNoValue;
    const ValueId value = value_of_[static_cast<std::size_t>(element->number)];
    return value < v ? value : kNoValue;
  }

  /// Whether its rounding is at most twice the rounding of the value's present form.
  bool is_accurate(const Form& form, ValueId v) const {
    return std::ranges::all_of(rounded_, [&](const std::vector<Rounded>& all) {
      constexpr double kUnit = 0x1p-52;
      const auto [a, a_off] = all[form.first];
      const auto [b, b_off] = all[form.second];
      const double error = form.op == Op::multiply ? std::abs(a) * b_off + std::abs(b) * a_off : a_off + b_off;
      return error + kUnit * std::abs(all[v].value) <= kMoreRounding * all[v].error;
    });
  }

  /// Calls use(form) for forms of v with `leaf` as one operand.
  template <class Use>
  void with_forms(ValueId leaf, ValueId v, const Use& use) {
    const Element whole = elements_[v], part = elements_[leaf];
    if (part.number == 0) return;
    const auto add = [&](Op op, ValueId first, ValueId second, bool negative) {
      use(Form{op, first, second, negative});
    };
    const auto negative = [&](ValueId value, const Element& element) {
      return elements_[value].negative != element.negative;
    };
    // v - leaf = +-b; -v - leaf = +-b gives the same functions as v + leaf.
    if (const auto rest = field_.known_difference(whole, part))
      if (const ValueId b = earlier(rest, v); b != kNoValue)
        negative(b, *rest) ? add(Op::subtract, leaf, b, false) : add(Op::add, leaf, b, false);
    if (const auto rest = field_.known_difference(whole, with_sign(part, true)))
      if (const ValueId b = earlier(rest, v); b != kNoValue && !negative(b, *rest)) add(Op::subtract, b, leaf, false);
    if (const auto factor = field_.known_quotient(whole, part))
      if (const ValueId b = earlier(factor, v); b != kNoValue) add(Op::multiply, leaf, b, negative(b, *factor));
  }

  /// Additional cost of the operands of a form.
  int cost_of_operands(const Form& form) {
    taken_.clear();
    const int cost = take(form.first, taken_) + take(form.second, taken_);
    for (const ValueId value : taken_) --uses_[value];
    return cost;
  }

  /// Gives v the form that saves most.
  void shorten(ValueId v) {
    left_.clear();
    const int freed = leave_operands(v, kMostFreed, left_);
    int most = 0;
    Form best;
    leaves_.clear();
    if (freed > 1) find_leaves(v);
    for (const ValueId leaf : leaves_)
      with_forms(leaf, v, [&](const Form& form) {
        const int saved = freed - cost_of(form.op) - cost_of_operands(form);
        if (saved <= most || !is_accurate(form, v)) return;
        most = saved;
        best = form;
      });
    for (const ValueId value : left_) ++uses_[value];
    if (most == 0) return;
    leave_operands(v, program_.nodes.size(), left_);
    operands_[v] = {};
    for (const ValueId operand : {best.first, best.second}) {
      operands_[v].add(operand);
      take(operand, left_);
    }
    forms_[v] = best;
  }

  const Program& program_;
  FunctionField field_;
  std::vector<Element> elements_;
  std::vector<ValueId> value_of_;  ///< the first of each function
  std::vector<int> uses_;          ///< by values that are needed and by outputs
  std::vector<Operands> operands_;
  std::vector<Form> forms_;
  std::vector<std::vector<Rounded>> rounded_;
  std::vector<ValueId> leaf_of_;                       ///< the value whose leaves were found last among those with it
  std::vector<ValueId> leaves_, left_, taken_, gone_;  ///< of the value in hand
};

}  // namespace

Program write_shorter_forms(const Program& program) {
  return has_pairs(program) ? program : ShorterForms(program).rewritten_program();
}

}  // namespace mbgen
