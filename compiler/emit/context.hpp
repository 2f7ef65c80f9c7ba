#pragma once
// Source data of every emitted file.

#include <utility>

#include "compiler/emit/files.hpp"
#include "compiler/emit/names.hpp"
#include "compiler/solver/layout.hpp"
#include "compiler/solver/programs.hpp"
#include "compiler/solver/titles.hpp"

namespace mbgen {

struct EmitContext;
/// Whether the solver uses the accelerations in pairs: for doubles, unless loops are better.
bool takes_pairs(const EmitContext& context);

/// Source data of every emitted file. Requires: the referenced objects outlive it.
struct EmitContext {
  EmitContext(const WrittenPrograms& of_solver, const Model& of_model, const Topology& tree, const Analysis& decisions,
              EmitOptions chosen)
      : written(of_solver),
        programs(of_solver.programs),
        model(of_model),
        topology(tree),
        analysis(decisions),
        options(std::move(chosen)),
        names(solver_names(model, topology)),
        layout(solver_layout(model, topology, analysis)),
        titles(titles_of(programs.form, model, topology)),
        in_pairs(takes_pairs(*this)),
        regular_only(options.regular_only_from &&
                     programs.accelerations_chosen.nodes.size() >= *options.regular_only_from) {}

  const WrittenPrograms& written;
  const Programs& programs;  ///< one a role, of `written`
  const Model& model;
  const Topology& topology;
  const Analysis& analysis;
  EmitOptions options;
  SolverNames names;
  SolverLayout layout;
  Titles titles;
  bool in_pairs;      ///< see takes_pairs
  bool regular_only;  ///< see EmitOptions::regular_only_from
};

}  // namespace mbgen
