#pragma once
// Texts of programs and of the emitted files, one function each.

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "compiler/emit/shapes.hpp"

namespace mbgen {

/// Definitions of one program: the struct of its result (if the shape has members), the struct of values that cross its
/// parts (if there are several), one static function per part and the function that calls them. Each section starts
/// with its title and ends with its operation count. Unlabelled values of one use are written into the expression that
/// uses them; other values are statements, named by their label or numbered in their section. Fails: throws
/// std::logic_error when a slot of the program has no place in the shape.
std::string program_text(const Program& program, const Schedule& schedule, const ProgramShape& shape);

/// `<model>.hpp`: the interface, which people read first.
std::string interface_text(const EmitContext& context);

/// Adds `<model>_samples.hpp`, the table of numbers for programs, if the model has one.
void add_samples(const EmitContext& context, std::vector<EmittedFile>& files);

/// `<model>.cpp`. for_importers: with the additional functions for an FMU.
EmittedFile solver_file(const EmitContext& context, std::vector<ShapedProgram> programs, bool for_importers);

/// 1 for every rotation on which accelerations or closures depend, else 0; "" if there is none. Nothing depends on the
/// rotation of axisymmetric wheels.
std::string turning_table(const EmitContext& context, Scalar scalar);

/// The legend below the banner: tree, loops and names, to read beside the equations.
std::string legend_text(const EmitContext& context);

/// The manifest: sizes, names, loop blocks, operation counts of every section of every program, worst case.
nlohmann::ordered_json manifest_json(const EmitContext& context, const std::vector<ShapedProgram>& programs);

/// `<model>.json`.
std::string manifest_text(const nlohmann::ordered_json& manifest);

/// The accelerations of the solver with derivatives: one program for values and slopes, in pairs and lanes as the plain
/// solver's, and one for derivatives, which takes the slopes. shaped: over numbers with derivatives.
std::string accelerations_apart_text(const EmitContext& context, const ShapedProgram& shaped);

/// `<model>_batch.hpp`: many instances in lanes. Requires: context.lanes > 0, as for the next.
std::string batch_interface_text(const EmitContext& context);

/// `<model>_batch.cpp`. scalars: the solver's programs. Loops over subsystems remain there: here all code is straight.
std::string batch_text(const EmitContext& context, const std::vector<ShapedProgram>& scalars);

/// `<model>_c.h`, C99.
std::string c_header_text(const EmitContext& context);

/// `<model>_c.cpp`. Requires: context.initial.
std::string c_source_text(const EmitContext& context);

/// `<model>.py`: ctypes and numpy over the shared library, without compilation.
std::string python_text(const EmitContext& context);

/// `<model>_tangents_c.h`, `.cpp` and `<model>_tangents.py`: the solver with derivatives in C and Python.
std::vector<EmittedFile> tangents_c_files(const EmitContext& context);

/// `<model>.a2l`: parameters as characteristics; inputs, outputs and state as measurements; each with its unit and its
/// place in a structure of the C interface. Source: ASAM MCD-2 MC (ASAP2), version 1.6.
std::string calibration_text(const EmitContext& context);

/// `<model>_a2l.h`, C99: the objects that its symbols link to.
std::string calibration_header_text(const EmitContext& context);

}  // namespace mbgen
