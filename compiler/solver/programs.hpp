#pragma once
// The door of the solver room: the programs of a solver, with the inputs and outputs of each. Trace makes them,
// passes rewrite them, emit writes them, linearisation and FMUs differentiate them.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "compiler/program/program.hpp"

namespace mbgen {

/// Forms of the equations of motion.
enum class Form {
  matrix,    ///< the paper's nine steps: Rz' M Rz is formed
  recursive  ///< loop blocks and joints are eliminated into the inertia of the body that they move on
};

const char* name_of(Form form);
Form other_form(Form form);

/// The programs of a solver, in the order in which they are written.
enum class Role : std::uint8_t {
  accelerations,         ///< with the frozen partition of the loop blocks: the hot path
  closure,               ///< frozen Newton step and consistent velocities; only with loops or motions
  closure_terms,         ///< of every block, for the pivoting kernels; only with loops
  accelerations_chosen,  ///< with any partition and charts; only with loops or balls, and where it is chosen again
  multipliers,           ///< at given accelerations; only with loops or motions
  outputs,               ///< at given accelerations and, where the model looks at them, multipliers
  sampled,               ///< values that hold, after the instants that are due; only with sampled values
  ground_places,         ///< below the wheels on ground of a host; only with such wheels
  tangents,              ///< matrix of an implicit step, factorised; only for an implicit integrator
  changes,               ///< that solve the equations of an implicit step; only for an implicit integrator
  inverse_dynamics,      ///< forces of actuators at given accelerations; only where actuators move every direction
  actuators,             ///< positions and directions of actuators; only where their maps are functions
  required_forces,       ///< of the tree at given accelerations; only where inverse dynamics may choose other pivots
  derived_constants      ///< constants of the others that depend on tunable parameters; only with such constants
};

/// Inputs and outputs of a program.
struct ProgramSpec {
  Role role;
  const char* name;  ///< of the program, and its key in the manifest
  std::vector<Array> inputs, outputs;
};

/// One spec per role, in the order of the roles. Emitted programs use only the arrays of their specs.
const std::vector<ProgramSpec>& program_specs();

const ProgramSpec& spec_of(Role role);
const char* name_of(Role role);

/// Argument of a law, taken from its elements.
struct LawArgument {
  std::string name;
  bool is_common = false;            ///< one value for all elements
  std::vector<double> numbers = {};  ///< an element, where they are known before anything runs
};

/// A force law that several elements share: a separate program, which is written in lanes, one element in each. It
/// takes Array::law_argument and gives Array::law_result, one number per argument or result. The accelerations around
/// it give those arguments of law k that are not numbers as of_block(Array::law_argument, k), see argument_place, and
/// take its results as of_block(Array::law_result, k), number result * elements + element.
struct SharedLaw {
  Program program;
  std::vector<int> tyres;  ///< the elements: indices into Model::tyres
  std::vector<LawArgument> arguments;
  std::vector<std::string> results;
};

/// Place of an element's argument among the arguments that the accelerations give; a common argument has a single
/// place.
int argument_place(const SharedLaw& law, std::size_t argument, std::size_t element);

/// Mirror image of an input: in the mirrored mechanism its value is sign times the value of the image, and conversely.
struct MirroredInput {
  Slot slot, image;
  int sign = 1;
};

/// An input, and the input of an equal part of the mechanism that is not its mirror image.
struct TwinInput {
  Slot slot, twin;
};

/// Inputs of the accelerations that belong to parts of the mechanism which are alike.
struct AlikeInputs {
  /// Images of inputs under a mirror of the mechanism; empty if it has none.
  std::vector<MirroredInput> mirror;
  std::vector<TwinInput> twins;  ///< inputs of parts that are equal, each pair once
};

/// One program per role; a program that the model does not need is empty.
struct Programs {
  Program accelerations, closure, closure_terms, accelerations_chosen, multipliers, outputs, sampled, ground_places,
      tangents, changes, inverse_dynamics, actuators, required_forces, derived_constants;
  Form form = Form::recursive;  ///< of `accelerations` and `accelerations_chosen`

  // Defined in programs.cpp: every file that holds a set of programs would compile copies of all its lists.
  Programs();
  Programs(const Programs& other);
  Programs(Programs&& other) noexcept;
  Programs& operator=(const Programs& other);
  Programs& operator=(Programs&& other) noexcept;
  ~Programs();
};

/// Accelerations without the laws that elements share, and these laws.
struct AroundLaws {
  Program program;
  std::vector<SharedLaw> laws;
};

/// Accelerations with left and right, or twins, or both, as pairs.
struct PairedAccelerations {
  Program program;
  bool holds_twins = false, holds_sides = false;  ///< what its lanes hold: one of them, or both
};

/// Programs in which every value follows from the inputs, and other spellings of the accelerations for the text.
struct WholePrograms {
  Programs programs;
  std::optional<AroundLaws> around_laws;        ///< where elements share laws
  std::optional<PairedAccelerations> in_pairs;  ///< of accelerations_of_text, if it pays

  /// The accelerations as a text has them, number by number.
  const Program& accelerations_of_text() const { return around_laws ? around_laws->program : programs.accelerations; }
};

/// Programs as they are written: without values of tunable parameters alone, which are the derived constants.
struct WrittenPrograms {
  Programs programs;                 ///< of numbers; the accelerations around the laws
  std::vector<SharedLaw> laws = {};  ///< that elements share
  std::optional<PairedAccelerations> in_pairs = {};
};

Program& program_of(Programs& programs, Role role);
const Program& program_of(const Programs& programs, Role role);

/// The programs that a solver runs: all but the derived constants.
std::vector<Program*> solver_programs(Programs& programs);
/// The same with all other spellings of the accelerations and the laws.
std::vector<Program*> solver_programs(WholePrograms& whole);
/// The programs of a text: the accelerations in pairs if there are any, and the laws.
std::vector<Program*> solver_programs(WrittenPrograms& written);

/// The programs as a text has them, their accelerations without pairs that do not pay.
WrittenPrograms written(const WholePrograms& whole);

/// Sets the accelerations number by number from the pairs, if there are any.
WrittenPrograms with_numbers_of_pairs(WrittenPrograms written);

/// Every program with outputs, one a role, then the laws that elements share.
std::vector<const Program*> all_programs(const Programs& programs, const std::vector<SharedLaw>& laws = {});
std::vector<const Program*> all_programs(const WholePrograms& whole);
std::vector<const Program*> all_programs(const WrittenPrograms& written);

/// The programs themselves if they conform to their specs. Fails: std::logic_error with program and slot.
WrittenPrograms verified(WrittenPrograms written);

}  // namespace mbgen
