#include <algorithm>
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
        forms_(program.nodes.size()) {
    for (const auto& lanes : elements_of(program, field_, input_variables(program, field_)))
      elements_.push_back(lanes[0]);
    value_of_.assign(field_.size(), kNoValue);
    for (ValueId v = 0; v < elements_.size(); ++v) {
      const Node& node = program.nodes[v];
      ValueId& value = value_of_[static_cast<std::size_t>(elements_[v].number)];
      if (value == kNoValue && node.op != Op::negate) value = v;
      for (int k = 0; k < arity(node.op); ++k) operands_[v].push_back(node.operands[k]);
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
      changed.insert(changed.end(), operands_[v].begin(), operands_[v].end());
    }
    return cost;
  }

  /// Cost of what goes with one use of each operand of `v`, the nearest `most` values of it; all that lost a use goes
  /// into `changed`.
  int leave_operands(ValueId v, std::size_t most, std::vector<ValueId>& changed) {
    int cost = 0;
    std::vector<ValueId> gone{v};
    for (std::size_t i = 0; i < gone.size() && i < most; ++i) {
      cost += cost_of(program_.nodes[gone[i]].op);
      for (const ValueId operand : operands_[gone[i]]) {
        changed.push_back(operand);
        if (--uses_[operand] == 0) gone.push_back(operand);
      }
    }
    return cost;
  }

  /// Values that `v` is made of, the nearest first.
  std::vector<ValueId> leaves_of(ValueId v) const {
    std::vector<ValueId> leaves = operands_[v];
    for (std::size_t i = 0; i < leaves.size() && leaves.size() < kMostLeaves; ++i)
      for (const ValueId operand : operands_[leaves[i]])
        if (std::ranges::find(leaves, operand) == leaves.end()) leaves.push_back(operand);
    return leaves;
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

  /// Forms of v with `leaf` as one operand.
  std::vector<Form> forms_with(ValueId leaf, ValueId v) {
    std::vector<Form> forms;
    const Element whole = elements_[v], part = elements_[leaf];
    if (part.number == 0) return forms;
    const auto add = [&](Op op, ValueId first, ValueId second, bool negative) {
      forms.push_back({op, first, second, negative});
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
    return forms;
  }

  /// Additional cost of the operands of a form.
  int cost_of_operands(const Form& form) {
    std::vector<ValueId> taken;
    const int cost = take(form.first, taken) + take(form.second, taken);
    for (const ValueId value : taken) --uses_[value];
    return cost;
  }

  /// Gives v the form that saves most.
  void shorten(ValueId v) {
    std::vector<ValueId> left;
    const int freed = leave_operands(v, kMostFreed, left);
    int most = 0;
    Form best;
    for (const ValueId leaf : freed > 1 ? leaves_of(v) : std::vector<ValueId>{})
      for (const Form& form : forms_with(leaf, v)) {
        const int saved = freed - cost_of(form.op) - cost_of_operands(form);
        if (saved <= most || !is_accurate(form, v)) continue;
        most = saved;
        best = form;
      }
    for (const ValueId value : left) ++uses_[value];
    if (most == 0) return;
    leave_operands(v, program_.nodes.size(), left);
    operands_[v] = {best.first, best.second};
    for (const ValueId operand : operands_[v]) take(operand, left);
    forms_[v] = best;
  }

  const Program& program_;
  FunctionField field_;
  std::vector<Element> elements_;
  std::vector<ValueId> value_of_;  ///< the first of each function
  std::vector<int> uses_;          ///< by values that are needed and by outputs
  std::vector<std::vector<ValueId>> operands_;
  std::vector<Form> forms_;
  std::vector<std::vector<Rounded>> rounded_;
};

}  // namespace

Program write_shorter_forms(const Program& program) {
  return has_pairs(program) ? program : ShorterForms(program).rewritten_program();
}

}  // namespace mbgen
