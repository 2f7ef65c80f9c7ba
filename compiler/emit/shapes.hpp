#pragma once
// Shape of a program's text: its function, and the place of each slot in emitted code.

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "compiler/emit/context.hpp"
#include "compiler/emit/local_names.hpp"
#include "compiler/emit/text.hpp"
#include "compiler/schedule/schedule.hpp"

namespace mbgen {

/// Places of the slots of one group.
struct GroupPlace {
  std::string argument;                  ///< function parameter that holds them, "result" for outputs
  std::vector<std::string> texts;        ///< expression of each index, for example "state.z[Coordinate::crank_pin]"
  std::vector<std::string> locals = {};  ///< name of a local copy of each index, "" or no list: never copied
  std::string missing = "0.0";           ///< value of an output that the program does not give; empty: nobody reads it
  std::string array = {};  ///< array whose places from `first` on hold the slots in order; empty: they are no array
  int first = 0;
  std::string member = {};        ///< of the array's entries that holds the number: ".value"
  std::string element = {};       ///< another parameter that the texts look at
  bool local_tells_more = false;  ///< copies are made at the first use: their names say more than the texts
};

using Places = std::map<SlotGroup, GroupPlace>;

/// The places of an array from `first` on: "result.y[3]", ...
std::vector<std::string> indexed(const std::string& array, int size, int first = 0);

/// Inputs that every program may use; a program's signature lists those it gets.
Places input_places(const EmitContext& context);

/// A struct member that holds an array: name, size, comment.
struct ArrayMember {
  std::string name;
  int size = 0;
  std::string comment;
};

/// A shared law, for the program around it: the struct that they exchange.
struct LawShape {
  std::string argument, type;  ///< "tyres", "Tyres"
  std::string lanes;           ///< name of the number of elements that one call computes
  int elements = 0;
  std::string home = {};    ///< where the struct is, empty: the program makes it
  std::string beside = {};  ///< second argument of the function, empty: none

  std::string function() const { return "compute_" + argument; }
};

/// The names of law k of the emitted programs.
LawShape law_shape(const EmitContext& context, std::size_t k);

/// How a function takes an argument.
enum class Passing {
  value,
  reference,
  sole_reference,  ///< nothing else reaches it: without the promise a store would make the compiler read others again
  pointer,
  sole_pointer
};

/// Type of an argument that holds numbers of the program's own scalar, which it reads.
constexpr const char* kOfScalar = "";

struct Argument {
  std::string name;
  std::string type;  ///< in C++, or kOfScalar
  Passing passing = Passing::reference;
};

/// Of a function, in order.
using Arguments = std::vector<Argument>;

/// Arguments of a program by its spec, except arguments that hold `unused` arrays.
Arguments arguments_of(Role role, const std::vector<Array>& unused = {});

/// All properties of one program except its values.
struct ProgramShape {
  std::string title;                 ///< sentence for the comment
  std::string name;                  ///< "accelerations"
  std::string function;              ///< "compute_accelerations"
  std::string result;                ///< name of the result struct
  std::vector<ArrayMember> members;  ///< of the result struct
  Arguments arguments;
  Places inputs, outputs;
  std::vector<LawShape> laws = {};  ///< that the program leaves to others
  Titles titles = {};               ///< of sections and owners
  Scalar scalar = Scalar::doubles;  ///< of every value but pairs
  std::string elements = {};        ///< type of the elements that vectors of Scalar::elements hold: "Tyres"
  /// The function takes an array of structs for each argument, one per group of instances, and computes part by part.
  bool in_groups = false;
  /// Argument that receives the number of every section at its end, "" for none: then the parts follow the sections.
  std::string clock;
  /// Names of the model's numbers in the target file, null: numbers are written as literals.
  ConstantNames* constants = nullptr;
  /// Values after which mbgen::read_back() is called, 0: never.
  std::size_t read_back_after = 0;
  /// Order of its values.
  ValueOrder order = ValueOrder::by_section;
  /// Characters from which a statement is taken apart.
  std::size_t longest_statement = kLineWidth;
  /// Start of the names of structs of values that cross its parts, empty: the result's name.
  std::string work = {};
  /// Part of the file that defines the function, see EmittedFile::rare_parts.
  int file_part = 0;
};

/// Name of the type of its values: double, LanesTyres.
std::string type_text(const ProgramShape& shape);

/// Text of a constant: its name if it has one.
std::string constant_text(const Program& program, const Node& node, const ProgramShape& shape);

/// Options for scheduling a program of this shape. roll_above: see ScheduleOptions.
ScheduleOptions schedule_options(const ProgramShape& shape, std::size_t roll_above);

/// A program with everything that its text needs.
struct ShapedProgram {
  const Program* program = nullptr;
  Role role;
  ProgramShape shape;
  Schedule schedule = {};
};

/// Size of an array, including arrays whose size depends on the programs.
int size_in(const EmitContext& context, Array array);

/// Number of constants that follow from tunable parameters.
int derived_constant_count(const Programs& programs);

/// Number of entries of the implicit equations.
int tangent_count(const Programs& programs);

/// Identifier of each derived constant, after its body or element; empty if it belongs to none.
std::vector<std::string> derived_constant_names(const Programs& programs);

/// Whether a program reads an array.
bool takes(const Program& program, Array array);

/// Whether a program reads multipliers or driving forces.
bool takes_multipliers(const Program& program);

/// The programs of a solver; programs of closures are left out when there is nothing to close.
std::vector<ShapedProgram> shaped_programs(const EmitContext& context);

/// The program of accelerations with a clock that receives the end of each step.
ShapedProgram clocked_accelerations(const EmitContext& context);

}  // namespace mbgen
