#include "compiler/expressions/parse_expression.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <numbers>
#include <optional>

#include "compiler/expressions/evaluate.hpp"
#include "compiler/expressions/expression_names.hpp"
#include "compiler/expressions/expression_text.hpp"
#include "compiler/expressions/named_functions.hpp"
#include "compiler/text/document.hpp"

namespace mbgen::reading {
namespace {

/// Recursive descent.
class ExpressionParser : ExpressionText {
 public:
  ExpressionParser(std::string_view text, const ExpressionScope& scope) : ExpressionText(text), scope_(scope) {}

  ParsedExpression run() {
    skip_space();
    if (at_ == text_.size()) {
      fail(at_, "expression is empty");
    } else if (sum() >= 0) {
      skip_space();
      if (at_ < text_.size()) fail_after_value();
    }
    return {{std::string(text_), std::move(nodes_)}, std::move(problems_), std::move(reductions_), std::move(outputs_)};
  }

 private:
  static constexpr int kMaximumDepth = 200;  ///< of sums and powers; each costs five calls on the stack

  int fail_unexpected() {
    skip_space();
    if (at_ == text_.size()) return fail(at_, "expression ends where a value is expected");
    std::size_t end = at_ + 1;
    while (end < text_.size() && (static_cast<unsigned char>(text_[end]) & 0xC0u) == 0x80u)
      ++end;  // rest of a UTF-8 character
    const bool stars = text_[at_] == '*' && at_ > 0 && text_[at_ - 1] == '*';
    return fail(at_, fmt::format("unexpected {} in expression", in_quotes(text_.substr(at_, end - at_))),
                stars ? "powers are written x^y" : "");
  }

  /// Complains about text after a whole expression.
  int fail_after_value() {
    const std::size_t start = at_;
    if (!is_letter(text_[at_]) && !is_digit(text_[at_]) && text_[at_] != '(') return fail_unexpected();
    const std::string_view next = text_[at_] == '(' ? "(" : word();
    return fail(start, fmt::format("unexpected {} in expression", in_quotes(next)), hint_after_value(next));
  }

  int sum() {
    if (++depth_ > kMaximumDepth) return fail(at_, "expression is nested too deeply");
    int value = product();
    while (value >= 0) {
      skip_space();
      const std::size_t offset = at_;
      const bool plus = accept('+');
      if (!plus && !accept('-')) break;
      const int second = product();
      value = second < 0 ? -1 : push_call(plus ? Function::add : Function::subtract, offset, value, second);
    }
    --depth_;
    return value;
  }

  int product() {
    int value = unary();
    while (value >= 0) {
      skip_space();
      const std::size_t offset = at_;
      const bool times = accept('*');
      if (!times && !accept('/')) break;
      const int second = unary();
      value = second < 0 ? -1 : push_call(times ? Function::multiply : Function::divide, offset, value, second);
    }
    return value;
  }

  int unary() {
    bool negative = false;
    skip_space();
    const std::size_t offset = at_;
    for (bool more = true; more;) {
      more = accept('-');
      if (more) {
        negative = !negative;
      } else {
        more = accept('+');
      }
    }
    const int value = power();
    return value >= 0 && negative ? push_call(Function::negate, offset, value) : value;
  }

  int power() {
    if (++depth_ > kMaximumDepth) return fail(at_, "expression is nested too deeply");
    int value = atom();
    skip_space();
    const std::size_t offset = at_;
    if (value >= 0 && accept('^')) {
      const int exponent = unary();
      value = exponent < 0 ? -1 : push_call(Function::power, offset, value, exponent);
    }
    --depth_;
    return value;
  }

  int atom() {
    skip_space();
    if (at_ == text_.size()) return fail_unexpected();
    const std::size_t start = at_;
    if (accept('(')) {
      const int value = sum();
      if (value < 0 || accept(')')) return value;
      return fail_closing(start);
    }
    if (is_digit(text_[at_]) || text_[at_] == '.') return number();
    if (!is_letter(text_[at_])) return fail_unexpected();
    const std::string_view name = word();
    if (accept('(')) return name == "table" ? table(start) : call(name, start);
    if (at_ < text_.size() && text_[at_] == '.') {
      if (name == "z" || name == "zd") return coordinate(name, start);
      if (name == "length" || name == "rate") return length(name == "rate" ? Kind::rate : Kind::length, start);
      if (name == "zdd") return fail_acceleration(start);
      if (name == "out") return output(start);
    }
    return value_of_name(name, start);
  }

  int fail_closing(std::size_t opened) {
    skip_space();
    return fail(at_, fmt::format("')' is missing for the '(' at column {} of the expression", opened + 1));
  }

  int number() {
    double value = 0;
    const std::string_view rest = text_.substr(at_);
    const auto [end, error] = std::from_chars(rest.data(), rest.data() + rest.size(), value);
    const std::size_t length = static_cast<std::size_t>(end - rest.data());
    if (error == std::errc::invalid_argument) return fail_unexpected();
    const std::string_view shown = rest.substr(0, length);
    if (error == std::errc::result_out_of_range) return fail(at_, "number " + in_quotes(shown) + " is out of range");
    at_ += length;
    if (at_ < text_.size() && is_letter(text_[at_])) {
      const std::size_t offset = at_;
      const std::string_view next = word();
      return fail(offset, fmt::format("unexpected {} after number {}", in_quotes(next), shown), hint_after_value(next));
    }
    return push_number(value);
  }

  int call(std::string_view name, std::size_t start) {
    const NamedFunction* entry = find_function(name);
    const ReductionName* reduction = find_reduction(scope_, name);
    if (!entry && !reduction) {
      std::vector<std::string_view> others;
      for (const ReductionName& one : scope_.reductions) others.push_back(one.name);
      return fail(start, "unknown function " + in_quotes(name), hint_of_functions(name, std::move(others)));
    }
    const std::size_t first_node = nodes_.size();
    int arguments[3] = {-1, -1, -1};
    int count = 0;
    if (!accept(')')) {
      do {
        const int value = sum();
        if (value < 0) return -1;
        if (count < 3) arguments[count] = value;
        ++count;
      } while (accept(','));
      if (!accept(')')) return fail_closing(start + name.size());
    }
    if (reduction && count == reduction->arity) return push_reduction(*reduction, first_node, arguments[0], start);
    const int arity = entry ? entry->arity : reduction->arity;
    if (count != arity) {
      return fail(start, fmt::format("{} takes {} argument{}, got {}", name, arity, arity == 1 ? "" : "s", count));
    }
    return push_call(entry->function, start, arguments[0], arguments[1], arguments[2]);
  }

  /// The value of a table or a map.
  int table(std::size_t start) {
    const std::string_view name = quoted_name();
    if (!problems_.empty() && name.empty()) return -1;
    const auto found = find_visible(scope_.names.tables, name, scope_.visible);
    const bool is_known = found != scope_.names.tables.end();
    if (!is_known)
      fail(start, "unknown table " + in_quotes(name),
           scope_.suggest ? did_you_mean(name, scope_.names.tables, scope_.visible) : "");
    int arguments[2] = {-1, -1};
    int count = 0;
    while (accept(',')) {
      const int value = sum();
      if (value < 0) return -1;
      if (count < 2) arguments[count] = value;
      ++count;
    }
    if (!accept(')')) return fail_closing(start + 5);
    if (!is_known || !found->second) return stand_in();
    const int arity = found->second->arity();
    if (count == arity) return push_table(found->second, arguments[0], arguments[1]);
    return fail(start, fmt::format("table {} takes {}, got {}", in_quotes(name),
                                   arity == 1 ? "one argument" : "two arguments", count));
  }

  /// Takes the nodes of the arguments, from `first_node` on, into a call of their own. first: node of the first one.
  int push_reduction(const ReductionName& reduction, std::size_t first_node, int first, std::size_t start) {
    ReductionCall call;
    call.reduction = static_cast<int>(&reduction - scope_.reductions.data());
    auto operand = nodes_.begin() + static_cast<std::ptrdiff_t>(first_node);
    if (reduction.arity == 2) {
      if (!is_number(first)) {
        return fail(start, fmt::format("{} takes a number first, {}(1.5, x)", reduction.name, reduction.name));
      }
      call.constant = number_at(first);
      ++operand;
    }
    const int offset = static_cast<int>(operand - nodes_.begin());
    call.operand.nodes.assign(operand, nodes_.end());
    for (ExpressionNode& node : call.operand.nodes) {
      for (int* place : {&node.first, &node.second, &node.third}) *place -= *place < 0 ? 0 : offset;
    }
    call.operand.text = std::string(text_.substr(start, at_ - start));
    nodes_.resize(first_node);
    reductions_.push_back(std::move(call));
    return push_indexed(Kind::local, static_cast<int>(scope_.locals.size() + reductions_.size()) - 1);
  }

  /// A stand-in for a name that was complained about, so that the rest is read, too.
  int stand_in() { return push_number(1); }

  int forbidden(std::size_t start, const std::string& what) {
    fail(start, fmt::format("{}, depends on {}", limit_of(scope_.depends), what));
    return stand_in();
  }

  int coordinate(std::string_view prefix, std::size_t start) {
    ++at_;
    const std::string_view name = word();
    const std::string shown = fmt::format("{}.{}", prefix, name);
    const bool is_allowed = scope_.depends == Depends::all || (scope_.depends == Depends::positions && prefix == "z");
    if (!is_allowed) return forbidden(start, "coordinate " + shown);
    const CoordinateReference* found = find_coordinate(scope_.names, name, scope_.visible);
    if (!found) {
      if (name.empty()) return fail(at_, shown + " needs the name of a coordinate");
      if (!may_be_unreadable(scope_.names, name)) {
        const auto& coordinates = scope_.names.coordinates[scope_.visible.front().scope];
        fail(start, "unknown coordinate " + in_quotes(name), scope_.suggest ? did_you_mean(name, coordinates) : "");
      }
      return stand_in();
    }
    const auto& reversed = scope_.names.reversed;
    if (scope_.refuse_reversed && std::find(reversed.begin(), reversed.end(), *found) != reversed.end())
      fail(start, reversed_message(name), std::string(kReversedHint));
    ExpressionNode node;
    node.kind = prefix == "z" ? Kind::position : Kind::velocity;
    node.coordinate = *found;
    return push(node);
  }

  /// Accelerations follow from what expressions say, so that they cannot stand in these.
  int fail_acceleration(std::size_t start) {
    ++at_;
    const std::string_view name = word();
    fail(start, fmt::format("acceleration zdd.{} cannot stand in an expression: forces and states decide it", name),
         hint_of_acceleration(name));
    return stand_in();
  }

  /// The length of a spring, an air spring or a rod, or its rate.
  int length(Kind kind, std::size_t start) {
    ++at_;
    const std::string_view name = word();
    if (scope_.depends != Depends::all) return forbidden(start, "length of " + in_quotes(name));
    FoundLength found = find_length(scope_, name);
    if (!found.problem.empty()) fail(start, std::move(found.problem), std::move(found.hint));
    return found.index < 0 ? stand_in() : push_indexed(kind, found.index);
  }

  /// The value of an output.
  int output(std::size_t start) {
    ++at_;
    const std::string_view name = word();
    if (scope_.depends != Depends::all) return forbidden(start, "output " + in_quotes(name));
    const NameMap<int>& outputs = scope_.names.outputs;
    const auto found = find_visible(outputs, name, scope_.visible);
    if (found == outputs.end()) {
      fail(start, "unknown output " + in_quotes(name),
           scope_.suggest ? did_you_mean(name, outputs, scope_.visible) : "");
      return stand_in();
    }
    outputs_.push_back({start, found->second});
    return push_indexed(Kind::observed, found->second);
  }

  /// A copy of the expression under a name.
  int named_value(int expression, std::string_view name, std::size_t start) {
    const std::vector<ExpressionNode>& nodes = scope_.expressions[static_cast<std::size_t>(expression)].nodes;
    if (std::any_of(nodes.begin(), nodes.end(), [this](const ExpressionNode& node) { return !allows(node.kind); }))
      return forbidden(start, "value " + in_quotes(name));
    for (const ExpressionNode& node : nodes)
      if (node.kind == Kind::observed) outputs_.push_back({start, node.index});
    return push_copy(nodes);
  }

  /// Whether nodes of this kind may stand in the expression.
  bool allows(Kind kind) const {
    if (kind == Kind::number || kind == Kind::call) return true;
    if (kind == Kind::parameter) return scope_.depends >= Depends::parameters;
    if (kind == Kind::time || kind == Kind::input) return scope_.depends >= Depends::motion;
    return scope_.depends == Depends::all || (kind == Kind::position && scope_.depends == Depends::positions);
  }

  int value_of_name(std::string_view name, std::size_t start) {
    const Names& names = scope_.names;
    const auto parameter = find_visible(names.parameters, name, scope_.visible);
    const auto input = find_visible(names.inputs, name, scope_.visible);
    const auto value = find_visible(names.values, name, scope_.visible);
    const auto local = std::find(scope_.locals.begin(), scope_.locals.end(), name);
    if (local != scope_.locals.end()) {
      if (parameter != names.parameters.end() || input != names.inputs.end()) {
        fail(start, in_quotes(name) + " is a variable of this expression and also a parameter or input",
             "rename the parameter or input");
      } else if (value != names.values.end()) {
        fail(start, in_quotes(name) + " is a variable of this expression and also a state", "rename the state");
      } else if (find_visible(names.named_values, name, scope_.visible) != names.named_values.end()) {
        fail(start, in_quotes(name) + " is a variable of this expression and also a named value", "rename the value");
      }
      return push_indexed(Kind::local, static_cast<int>(local - scope_.locals.begin()));
    }
    if (name == "pi") return push_number(std::numbers::pi);
    if (name == "t") return scope_.depends < Depends::motion ? forbidden(start, "t") : push_indexed(Kind::time, -1);
    if (parameter != names.parameters.end()) {
      const Parameter& found = scope_.parameters[static_cast<std::size_t>(parameter->second)];
      const bool follows = found.expression >= 0;
      if (found.at_start) {
        if (scope_.at_start) return push_indexed(Kind::parameter, parameter->second);
        fail(start, fmt::format("parameter {} acts at the start only", in_quotes(name)),
             "use it in velocities of \"initial\" alone, or leave out \"at_start\"");
        return stand_in();
      }
      if (scope_.folds_tunable || (!found.tunable && !follows)) return push_number(found.value);
      if (scope_.depends < Depends::parameters) {
        return forbidden(start, follows ? "parameter " + in_quotes(name) + ", which follows from tunable ones"
                                        : "tunable parameter " + in_quotes(name));
      }
      if (follows) return push_copy(scope_.expressions[static_cast<std::size_t>(found.expression)].nodes);
      return push_indexed(Kind::parameter, parameter->second);
    }
    if (input != names.inputs.end()) {
      if (scope_.depends < Depends::motion) return forbidden(start, "input " + in_quotes(name));
      return push_indexed(Kind::input, input->second);
    }
    if (value != names.values.end()) {
      if (scope_.depends != Depends::all) return forbidden(start, "state " + in_quotes(name));
      return push_indexed(Kind::state, value->second);
    }
    const auto named = find_visible(names.named_values, name, scope_.visible);
    if (named != names.named_values.end()) return named_value(named->second, name, start);
    fail(start, "unknown name " + in_quotes(name) + " in expression", hint_of_unknown_name(scope_, name));
    return stand_in();
  }

  const ExpressionScope& scope_;
  int depth_ = 0;
  std::vector<ReductionCall> reductions_;
  std::vector<OutputUse> outputs_;
};

}  // namespace

ParsedExpression parse_expression(std::string_view text, const ExpressionScope& scope) {
  return ExpressionParser(text, scope).run();
}

}  // namespace mbgen::reading
