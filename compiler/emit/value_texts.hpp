#pragma once
// Text of the values of a scheduled program: names, places in memory, expressions.

#include <set>
#include <string>
#include <unordered_map>
#include <vector>

#include "compiler/emit/expression_text.hpp"
#include "compiler/emit/function_text.hpp"
#include "compiler/emit/local_names.hpp"
#include "compiler/emit/slice_text.hpp"

namespace mbgen {

/// Arrays of one call for many arguments.
struct CallNames {
  std::string function, arguments, exponents;  ///< exponents: of powers, else empty
  std::vector<std::string> results;
  std::string declaration;     ///< of the results, empty when they cross parts
  std::set<std::string> work;  ///< arguments whose members they are
};

/// Texts of values, part by part. A value represents the values at its place in all slices of a loop; callers pass the
/// first of them. Fails: throws std::logic_error when a slot has no place in the shape.
class ValueTexts {
 public:
  using Slices = std::vector<ValueId>;  ///< one value a slice

  ValueTexts(const Program& program, const Schedule& schedule, const ProgramShape& shape);

  /// Begins a part: copies of inputs and tables of other parts are not visible.
  void start_part(const PlaceRange& range);

  /// The type of a value, and its name.
  Scalar scalar_of(ValueId v) const { return widths_[v] == 2 ? Scalar::pairs : shape_.scalar; }
  std::string type_of(ValueId v) const { return widths_[v] == 2 ? mbgen::name_of(Scalar::pairs) : type_text(shape_); }
  const ScheduledValue& facts(ValueId v) const { return schedule_.value[v]; }
  const ArrayPlace& place_in_call(ValueId v) const { return schedule_.calls.place[v]; }
  const CallNames& call_names(int call) const { return call_names_[static_cast<std::size_t>(call)]; }
  /// The values at the place of this one in all slices of its unit.
  Slices slices_of(ValueId v) const;

  /// The operation on its operands as an expression.
  Phrase compose(const ScheduledUnit& unit, ValueId v, PartText& part);
  /// An operand in every slice of the unit that uses it.
  Phrase phrase_of(const ScheduledUnit& unit, const Slices& values, PartText& part);
  /// Text of an operation where it is used.
  Phrase& phrase(ValueId v) { return phrases_[v]; }
  /// A result of a call for many arguments.
  Phrase result_phrase(ValueId v, PartText& part);
  Phrase constants_phrase(const Slices& values);
  /// A number for a place that expects a value.
  std::string number(const std::string& text) const;

  /// The common label of the value in all slices, or its section and a number.
  std::string name_of(ValueId v);
  /// The place in memory of a value that crosses parts, in programs without loops.
  std::string crossing_place(ValueId v, const std::string& name, PartText& part);
  /// Place of values in the array of a program with loops.
  std::string stored_place(const Slices& values, PartText& part);
  /// Place of one slot per slice, all of one group.
  std::string slots_text(const Places& places, const std::vector<Slot>& slots, PartText& part);
  const GroupPlace& place_of(const Places& places, const Slot& slot) const;
  std::size_t output_count(ValueId v) const { return outputs_[v].size(); }
  /// Places of the result that receive a value.
  std::vector<std::string> output_texts(ValueId v, PartText& part);

  /// Declarations of the tables of the next loop.
  std::string table_declarations() { return tables_.declarations(); }
  const CrossingStructs& crossing() const { return crossing_; }

 private:
  void reserve_names();
  /// Per value the name of the result that it is, as a word; "" for none.
  std::vector<std::string> result_names() const;
  /// Names the results of calls for many arguments: in a struct if another part needs one of them.
  void name_calls();
  /// Adds a struct of values that cross parts.
  CrossingStruct& add_crossing();
  /// Declares the structs of single values, or the struct of a program with loops.
  void declare_crossing();
  Phrase input_phrase(const Slices& values, PartText& part);
  /// Local copy of a value in memory that this part reads often.
  Phrase copied(ValueId v, const std::string& local, const std::string& place, PartText& part);

  const Program& program_;
  const Schedule& schedule_;
  const ProgramShape& shape_;
  std::vector<int> widths_;  ///< see widths_of
  std::vector<Phrase> phrases_;
  std::vector<std::vector<Slot>> outputs_;  ///< per value
  LocalNames names_;
  SliceTables tables_;
  CrossingStructs crossing_;
  std::unordered_map<ValueId, std::string> work_of_;  ///< arguments that hold the values that cross
  std::vector<CallNames> call_names_;
  std::unordered_map<ValueId, std::string> local_of_;  ///< of results of calls for many arguments
  std::unordered_map<ValueId, int> uses_in_part_;      ///< of straight code; the angles of one call are written once
  std::set<ValueId> copied_in_part_;
};

}  // namespace mbgen
