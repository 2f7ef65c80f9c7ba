#include "compiler/casadi/c_functions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "compiler/emit/text.hpp"
#include "compiler/schedule/schedule.hpp"

namespace mbgen {
namespace {

/// The operation on the texts of its operands.
std::string operation_text(Op op, const std::string& a, const std::string& b, const std::string& c,
                           const std::string& sample) {
  const auto call = [&](const std::string& function) { return fmt::format("{}({})", function, a); };
  switch (op) {
    case Op::add:
      return a + " + " + b;
    case Op::subtract:
      return a + " - " + b;
    case Op::multiply:
      return a + "*" + b;
    case Op::divide:
      return a + "/" + b;
    case Op::negate:
      return "-" + a;
    case Op::atan2:
      return fmt::format("atan2({}, {})", a, b);
    case Op::pow:
      return fmt::format("pow({}, {})", a, b);
    case Op::abs:
      return call("fabs");
    case Op::min:
      return fmt::format("{1} < {0} ? {1} : {0}", a, b);
    case Op::max:
      return fmt::format("{0} < {1} ? {1} : {0}", a, b);
    case Op::select:
      return fmt::format("{} >= 0 ? {} : {}", a, b, c);
    case Op::multiply_add:
      return fmt::format("{}*{} + {}", a, b, c);
    case Op::multiply_subtract:
      return fmt::format("{}*{} - {}", a, b, c);
    case Op::subtract_product:
      return fmt::format("{} - {}*{}", a, b, c);
    case Op::sample:
      return call(sample);
    default:
      return call(op_name(op));  // of the other functions math.h has the names of dumps
  }
}

/// Writes the parts of a schedule one after another.
class CWriter {
 public:
  CWriter(const Program& program, const CPlaces& places)
      : program_(program),
        places_(places),
        schedule_(schedule(program)),
        part_of_(program.nodes.size(), -1),
        last_part_(program.nodes.size(), -1),
        place_(program.nodes.size(), -1),
        written_in_(program.nodes.size(), -1) {
    for (int p = 0; p < part_count(); ++p)
      for (const ValueId v : values_of(p)) part_of_[v] = p;
    for (ValueId v = 0; v < program.nodes.size(); ++v)
      for (int k = 0; k < arity(program.nodes[v].op) && part_of_[v] >= 0; ++k)
        last_part_[program.nodes[v].operands[k]] = std::max(last_part_[program.nodes[v].operands[k]], part_of_[v]);
    for (const auto& [slot, value] : program.outputs) outputs_.insert({value, slot});
  }

  CFunctions functions() {
    CFunctions all{places_.name};
    for (int p = 0; p < part_count(); ++p) {
      body_.clear();
      part_ = p;
      free_places_of_ended_values();
      if (p == 0) write_plain_outputs();
      for (const ValueId v : values_of(p)) write(v);
      const std::string name = fmt::format("{}_{}", places_.name, p + 1);
      all.parts.push_back({name,
                           c_signature(name, places_.point) + " {\n  (void)at, (void)w, (void)r;\n" + body_ + "}\n",
                           values_of(p).size()});
    }
    all.work = work_;
    return all;
  }

 private:
  int part_count() const { return static_cast<int>(schedule_.parts.size()); }

  std::span<const ValueId> values_of(int part) const {
    const PlaceRange& range = schedule_.parts[static_cast<std::size_t>(part)];
    return std::span(schedule_.order).subspan(range.first, range.last - range.first);
  }

  bool crosses(ValueId v) const { return part_of_[v] >= 0 && last_part_[v] > part_of_[v]; }

  void add_line(const std::string& statement) { body_ += wrapped_statement("  " + statement) + "\n"; }

  void free_places_of_ended_values() {
    for (ValueId v = 0; v < program_.nodes.size() && part_ > 0; ++v)
      if (crosses(v) && last_part_[v] == part_ - 1) free_.push_back(place_[v]);
  }

  int new_place() {
    if (free_.empty()) return work_++;
    const int place = free_.back();
    free_.pop_back();
    return place;
  }

  /// The text of an operand; inputs and values of other parts become local variables at their first use.
  std::string operand(ValueId v) {
    const Node& node = program_.nodes[v];
    if (node.op == Op::constant) {
      const std::string text = number_text(node.constant);
      return text.front() == '-' ? "(" + text + ")" : text;
    }
    const std::string name = fmt::format("v{}", v);
    if (written_in_[v] == part_) return name;
    written_in_[v] = part_;
    add_line(fmt::format("const double {} = {};", name,
                         node.op == Op::input ? places_.input(program_.inputs[static_cast<std::size_t>(node.input)])
                                              : fmt::format("w[{}]", place_[v])));
    return name;
  }

  void give(ValueId v, const std::string& text) {
    const auto [first, last] = outputs_.equal_range(v);
    for (auto output = first; output != last; ++output)
      add_line(fmt::format("r[{}] = {};", places_.output(output->second), text));
  }

  void write(ValueId v) {
    const Node& node = program_.nodes[v];
    std::string texts[3];
    for (int k = 0; k < arity(node.op); ++k) texts[k] = operand(node.operands[k]);
    add_line(fmt::format("const double v{} = {};", v,
                         operation_text(node.op, texts[0], texts[1], texts[2], places_.sample)));
    written_in_[v] = part_;
    if (crosses(v)) {
      place_[v] = new_place();
      add_line(fmt::format("w[{}] = v{};", place_[v], v));
    }
    give(v, fmt::format("v{}", v));
  }

  /// Outputs that are constants or inputs.
  void write_plain_outputs() {
    for (ValueId v = 0; v < program_.nodes.size(); ++v)
      if (part_of_[v] < 0 && outputs_.contains(v)) give(v, operand(v));
  }

  const Program& program_;
  const CPlaces& places_;
  Schedule schedule_;
  std::vector<int> part_of_;     ///< per value, -1: no operation
  std::vector<int> last_part_;   ///< that reads it
  std::vector<int> place_;       ///< in w, where it crosses
  std::vector<int> written_in_;  ///< the last part that has it as a local variable
  std::multimap<ValueId, Slot> outputs_;
  std::vector<int> free_;
  std::string body_;
  int part_ = 0, work_ = 0;
};

}  // namespace

std::string c_signature(const std::string& name, const std::string& point) {
  return fmt::format("void {}(const struct {}* at, double* w, double* r)", name, point);
}

CFunctions c_functions(const Program& program, const CPlaces& places) { return CWriter(program, places).functions(); }

}  // namespace mbgen
