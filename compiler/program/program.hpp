#pragma once
// The door of the program room: the symbolic program, one straight-line SSA array with operands earlier than users.

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <set>
#include <span>
#include <string>
#include <unordered_map>
#include <vector>

#include "compiler/origin/origin.hpp"
#include "compiler/program/number_table.hpp"
#include "compiler/program/slot.hpp"

namespace mbgen {

using ValueId = std::uint32_t;
constexpr ValueId kNoValue = 0xffffffffu;

enum class Op : std::uint8_t {
  constant,
  input,
  add,
  subtract,
  multiply,
  divide,
  negate,
  sqrt,
  sin,
  cos,
  tan,
  asin,
  acos,
  atan,
  atan2,
  exp,
  log,
  pow,
  tanh,
  abs,
  min,
  max,
  select,  ///< select(x, a, b): a where x >= 0, else b (b for NaN); min and max are std::min and std::max
  // Rounded once; only the pass `contract` makes these.
  multiply_add,       ///< multiply_add(a, b, c): a b + c
  multiply_subtract,  ///< multiply_subtract(a, b, c): a b - c
  subtract_product,   ///< subtract_product(c, a, b): c - a b
  floor,              ///< the largest whole number not above it; no derivative
  sample,             ///< sample(i): number i of Program::samples, the first or last one outside; no derivative
  // Pairs: values of two lanes, see widths_of. Only the pass `pairs` makes these.
  pack,        ///< pack(a, b): the pair of two numbers
  first_lane,  ///< first_lane(p): the first number of a pair
  second_lane  ///< second_lane(p): the other one
};

/// A table that programs take numbers from; empty: none.
using Samples = std::shared_ptr<const std::vector<double>>;

/// One value. `operands` beyond the arity of `op` are kNoValue.
struct Node {
  Op op = Op::constant;
  ValueId operands[3] = {kNoValue, kNoValue, kNoValue};
  double constant = 0;               ///< for Op::constant
  std::int32_t input = -1;           ///< for Op::input: index into Program::inputs
  std::int32_t label = -1;           ///< index into Program::labels, of a constant into Program::constants, or -1
  Section section = {};              ///< one of Program::sections; inputs and constants have none
  Owner owner = {};                  ///< part of the mechanism that the value belongs to
  Owner mirrored = {};               ///< of a pair: the owner of its second lane
  std::int32_t mirrored_label = -1;  ///< of a pair: likewise, index into Program::labels
};

/// For whom a program is written.
enum class Spelling : std::uint8_t {
  fast,    ///< for machines: few names, and folded numbers forget what they follow from
  reading  ///< for people: names for all that has one, and folded numbers keep their operations
};

/// A number of the model as the formulation takes it: a mass, a coordinate of a point. In programs for reading also a
/// number that was folded from such numbers.
struct NamedConstant {
  std::string name;  ///< of a fold without a name of its own: its operation as text, "m_a + m_b"
  double value = 0;
  /// The operation of a fold, Op::constant for numbers that follow from nothing.
  Op op = Op::constant;
  double operands[2] = {0, 0};
  std::int32_t labels[2] = {-1, -1};  ///< indices into Program::constants, of which operands may be negatives
  bool is_anonymous = false;          ///< a fold that nobody has named
  std::string note = {};              ///< words for its definition

  bool is_fold() const { return op != Op::constant; }
};

struct OutputValue {
  Slot slot;
  ValueId value = kNoValue;
};

/// A straight-line program. Invariants (see verify): operands earlier than users and exactly as many as the arity,
/// indices in range, constants finite, no duplicate inputs, outputs or sections, at most one value per input, no output
/// without value.
struct Program {
  std::string name;  ///< name of the emitted function
  std::vector<Node> nodes;
  std::vector<Slot> inputs;
  std::vector<OutputValue> outputs;
  std::vector<Section> sections;         ///< in the order in which the formulation comes to them, the one of no step
                                         ///< first; nodes of one section need not be contiguous
  std::vector<std::string> labels;       ///< names given by the formulation, for example "R_carrier_left_xz"
  std::vector<NamedConstant> constants;  ///< numbers of the model: a constant with a label is one of these, or its
                                         ///< negative
  Samples samples = {};                  ///< of Op::sample
};

/// Number of operands.
[[gnu::always_inline]] constexpr int arity(Op op) {
  switch (op) {
    case Op::constant:
    case Op::input:
      return 0;
    case Op::add:
    case Op::subtract:
    case Op::multiply:
    case Op::divide:
    case Op::atan2:
    case Op::pow:
    case Op::min:
    case Op::max:
    case Op::pack:
      return 2;
    case Op::select:
    case Op::multiply_add:
    case Op::multiply_subtract:
    case Op::subtract_product:
      return 3;
    default:
      return 1;
  }
}
const char* op_name(Op op);

/// Appends with the rules fold, look up, push. One builder per program under construction.
/// Rules (one way only): constants fold; x+0, x-0, x*1, x/1 -> x; x*0 -> 0; 0/x -> 0; x*-1, x/-1, 0-x -> -x; --x -> x;
/// x+(-y) -> x-y; x-(-y) -> x+y; (-x)+y -> y-x; x-x -> 0; (-x)*y -> -(x*y), (-x)*(-y) -> x*y, likewise /; (-x)-y ->
/// -(x+y); x/constant -> x*(1/constant) only when 1/constant is exact; commuted operands are ordered; equal nodes are
/// shared; sin(-x) -> -sin x and the other odd functions, cos(-x) -> cos x, abs(-x) -> abs x, select with constant x
/// folds, select(x, a, a) -> a; a negative constant counts as -c in the rules of + - * /; pow(x, 0) -> 1, pow(x, 1) ->
/// x, pow(x, 2) -> x*x. A node that would fold to NaN or infinity stays. The constant -0 is stored as 0.
class ProgramBuilder {
 public:
  explicit ProgramBuilder(std::string name, Spelling spelling = Spelling::fast);
  /// A builder with the name, inputs, sections and named constants of `program`, but none of its values: the
  /// start of a rewritten program.
  static ProgramBuilder like(const Program& program);

  /// name: of name_constant, -1 for none. Nodes of one value under several names stay apart, but operations on them are
  /// shared: a number never bears the name of another one.
  ValueId constant(double value, std::int32_t name = -1);
  /// A name for a number of the model: index into Program::constants. 0, 1 and -1 are structure and get none: -1.
  std::int32_t name_constant(double value, const std::string& name);
  /// The label of a number that was folded from named ones, in programs for reading; -1 in others and for structure.
  std::int32_t label_fold(double value, NamedConstant operation);
  /// Names the fold of a label, unless it has a name. note: see NamedConstant.
  void name_fold(std::int32_t label, const std::string& name);
  /// From now on a fold that nobody has named is another one of equal value.
  void equate_folds(std::int32_t label, std::int32_t other);
  void explain_constant(std::int32_t label, const std::string& note);
  bool is_for_reading() const { return spelling_ == Spelling::reading; }
  const std::vector<NamedConstant>& constants() const { return program_.constants; }
  void set_samples(Samples samples) { program_.samples = std::move(samples); }
  /// A constant of another program under the same name. constants: of that program.
  ValueId constant_like(const Node& node, std::span<const NamedConstant> constants);
  /// The input of this slot; created at first use.
  ValueId input(SlotGroup group, int index);
  /// Requires: as many operands as arity(op), all of this builder; neither constant nor input. Fails: std::logic_error
  /// otherwise.
  ValueId append(Op op, ValueId first, ValueId second = kNoValue, ValueId third = kNoValue);
  /// Fails: std::logic_error when the slot has a value already (at finish).
  void output(SlotGroup group, int index, ValueId value);
  /// Appends `node` of `source` in the same section, of the same owner, under the same label. renamed: new value of
  /// each older one of `source`.
  ValueId copy(const Program& source, const Node& node, std::span<const ValueId> renamed);

  /// Values appended from now on belong to this section / this part of the mechanism / where `node` does.
  void set_section(const Section& section);
  void set_owner(const Owner& owner, const Owner& mirrored = {});
  void set_origin(const Node& node);
  const Section& section() const { return section_; }
  const Owner& owner() const { return owner_; }
  /// Names a value; the first name given to a value stays. Constants and inputs are not named here.
  void label(ValueId value, const std::string& name, const std::string& of_second_lane = "");
  /// The names of a value of `source`, where it has them.
  void label_like(ValueId value, const Program& source, const Node& node);

  const Node& node(ValueId value) const { return program_.nodes[value]; }
  bool is_constant(ValueId value) const { return node(value).op == Op::constant; }
  bool is_constant(ValueId value, double constant) const;

  /// The finished program, verified, its values in the order in which they were appended. The builder is empty
  /// afterwards. Fails: std::logic_error with the text of verify.
  Program finish();
  /// The same for a program whose values come from C++ expressions, which compilers evaluate in orders of their own:
  /// its order does not depend on them.
  Program finish_in_canonical_order();

 private:
  ValueId share_or_push(const Node& node);
  std::uint64_t hash_of(const Node& node) const;
  bool computes_same(const Node& a, const Node& b) const;
  ValueId input(std::size_t index);
  ValueId push(const Node& node);
  /// Enters constants that are not in named_ yet: most rewritten programs never look a name up.
  void find_names();
  /// The program as it stands; the builder is empty afterwards.
  Program taken();
  Program program_;
  Spelling spelling_ = Spelling::fast;
  std::vector<std::uint32_t> moments_;  ///< per node, the statements before it: sections, owners, labels, outputs
  std::uint32_t moment_ = 0;
  std::map<Slot, std::size_t> input_index_;
  std::vector<ValueId> input_value_;  ///< per input, kNoValue before its first use
  NumberTable shared_;                ///< values by hash
  /// Operations that their statement has made already, with constants of other names: compilers evaluate the operands
  /// of an expression in orders of their own, so which of two is the first tells nothing.
  std::vector<std::pair<ValueId, Node>> repeats_;
  std::set<Section> known_sections_;
  Section section_;
  bool knows_section_ = false;  ///< section_ is among known_sections_
  Owner owner_, mirrored_;
  std::unordered_map<std::string, std::int32_t> named_;  ///< index into Program::constants by name, last of each
  std::size_t indexed_ = 0;                              ///< number of constants in named_
};

/// Text of the first broken invariant, empty when the program is sound. Always on: called by finish, so after every
/// pass that makes values.
std::string verify(const Program& program);

/// The program itself when it is sound. Fails: std::logic_error "program <name>: <broken invariant>".
Program verified(Program program);

/// Values of all outputs. inputs: in the order of program.inputs; result in the order of program.outputs.
/// Fails: std::invalid_argument when the number of inputs differs.
std::vector<double> interpret(const Program& program, std::span<const double> inputs);

/// The same at several sets of inputs, with the same bits. inputs: each input of all sets, one after another. Result:
/// each output of all sets likewise. Values that do not depend on an input that differs are computed once.
std::vector<double> interpret(const Program& program, std::span<const double> inputs, std::size_t sets);

/// "step 4, block 0", "" for no step.
std::string text_of(const Section& section);
/// "tree_body 3", "" for none.
std::string text_of(const Owner& owner);

/// Sections and owners as people read them; these know no names.
struct Titles {
  std::function<std::string(const Section&)> section = [](const Section& s) { return text_of(s); };
  std::function<std::string(const Owner&)> owner = [](const Owner& o) { return text_of(o); };
};

/// Text form, one value a line: `%12 = mul %3 %7  ; R_crank_xz`, sections and owners as comment lines where they change
/// (constants and inputs belong to none). Exact: constants shortest-round-trip, on any locale.
std::string dump(const Program& program, const Titles& titles = {});

/// Numbers in each value: 2 of a pair, 1 of a number, 0 of a constant, which counts for every lane. An operation on a
/// pair is done in each of its lanes; with a number it is none before that is packed.
std::vector<int> widths_of(const Program& program);

/// Whether a value of the program is a pair.
bool has_pairs(const Program& program);

/// The same values to the bit, each lane of a pair a number of its own.
///   %2 = pack %0 %1; %3 = mul %2 %2; %4 = second_lane %3   =>   %3 = mul %1 %1
Program unfolded(const Program& program);

/// Which values some output needs, one flag per node.
std::vector<bool> needed_values(const Program& program);

/// Numbers of operations after dead values are gone, those on pairs twice.
struct OperationCount {
  long add = 0, multiply = 0, divide = 0, sqrt = 0, trigonometric = 0, other = 0;
  long total() const {
    return add + multiply + divide;
  }  ///< floating-point operations (add, subtract, multiply, divide); negations are free
};
OperationCount count_operations(const Program& program);
/// Places of the sections in program.sections.
std::map<Section, std::size_t> places_of_sections(const Program& program);
/// One count per section, in the order of program.sections.
std::vector<OperationCount> count_operations_by_section(const Program& program);

/// A part of a direction: rates of change of a group of inputs.
struct DirectionGroup {
  SlotGroup group;
  int size = 0;
};

/// Place of each input of a program in a direction that holds these groups one after another, -1 for inputs that are in
/// none of them: the seeds for `differentiate`.
std::vector<int> seeds_of(const Program& program, std::span<const DirectionGroup> groups);

/// Forward derivatives: for every output y, dy = sum over inputs of (dy/dinput) * seed.
/// seed_of_input: for each program input, index of its seed in Array::seed, or -1 for a zero seed.
/// Result: the same program plus the derivative of every output at the same index; an output that has its derivative
/// already keeps it, so that a second application adds second derivatives only. Each derivative has the section and
/// the owner of its value. Fails: std::invalid_argument when the number of seeds differs. At the kinks of abs, min,
/// max, select the side that is taken counts.
Program differentiate(const Program& program, std::span<const int> seed_of_input);

/// A scalar that records. Constants need no builder; mixing with a recorded value takes that value's builder.
/// Two constants fold as the decimals that people typed, see decimal.hpp. Fails: std::logic_error when values of two
/// builders are mixed.
class Expr {
 public:
  Expr() = default;
  Expr(double constant) : constant_(constant) {}
  Expr(ProgramBuilder& builder, ValueId value);

  bool is_constant() const { return builder_ == nullptr; }  ///< known at trace time
  double constant() const { return constant_; }             ///< Requires: is_constant()
  std::int32_t name() const { return name_; }               ///< of a constant, see ProgramBuilder::name_constant
  /// Requires: is_constant(). builder: of the name, where folds of the number have names too.
  Expr named(std::int32_t name, ProgramBuilder* builder = nullptr) const;
  ProgramBuilder* builder_of_name() const { return builder_of_name_; }
  ValueId value(ProgramBuilder& builder) const;
  ProgramBuilder* builder() const { return builder_; }

 private:
  ProgramBuilder* builder_ = nullptr;
  ProgramBuilder* builder_of_name_ = nullptr;  ///< of a constant, in programs for reading alone
  double constant_ = 0;
  ValueId value_ = kNoValue;
  std::int32_t name_ = -1;
};

Expr operator+(const Expr& a, const Expr& b);
Expr operator-(const Expr& a, const Expr& b);
Expr operator*(const Expr& a, const Expr& b);
Expr operator/(const Expr& a, const Expr& b);
Expr operator-(const Expr& a);
inline Expr& operator+=(Expr& a, const Expr& b) { return a = a + b; }
inline Expr& operator-=(Expr& a, const Expr& b) { return a = a - b; }
inline Expr& operator*=(Expr& a, const Expr& b) { return a = a * b; }
Expr sqrt(const Expr& a);
Expr sin(const Expr& a);
Expr cos(const Expr& a);
Expr tan(const Expr& a);
Expr asin(const Expr& a);
Expr acos(const Expr& a);
Expr atan(const Expr& a);
Expr atan2(const Expr& y, const Expr& x);
Expr exp(const Expr& a);
Expr log(const Expr& a);
Expr pow(const Expr& a, const Expr& b);
Expr tanh(const Expr& a);
Expr floor(const Expr& a);
/// samples: those of the program.
Expr sample(const std::vector<double>& samples, const Expr& index);
Expr abs(const Expr& a);
Expr min(const Expr& a, const Expr& b);
Expr max(const Expr& a, const Expr& b);
/// a where condition >= 0, else b. Comparison operators do not exist for Expr: they would decide at trace time.
Expr select(const Expr& condition, const Expr& a, const Expr& b);

}  // namespace mbgen
