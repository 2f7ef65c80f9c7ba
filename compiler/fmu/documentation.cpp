#include "compiler/emit/context_values.hpp"
#include "compiler/emit/mapped.hpp"
#include "compiler/emit/text.hpp"
#include "compiler/fmu/texts.hpp"
#include "compiler/text/characters.hpp"

namespace mbgen {
namespace {

using Causality = FmuVariable::Causality;
using Cells = std::vector<std::string>;

FrameRows cell_rows(const Cells& cells) {
  return mapped(cells, [](const std::string& cell) { return FrameValues{{"cell", xml_text(cell)}}; });
}

FrameRows table_rows(const std::vector<Cells>& rows) {
  return mapped(rows, [](const Cells& cells) { return FrameValues{{"cells", cell_rows(cells)}}; });
}

/// Author and so on, what the model says of itself.
std::vector<Cells> about_cells(const About& about) {
  std::vector<Cells> rows;
  for (const auto& [name, value] :
       {std::pair{"author", &about.author}, {"copyright", &about.copyright}, {"licence", &about.licence}}) {
    if (!value->empty()) rows.push_back({name, *value});
  }
  return rows;
}

std::vector<Cells> variable_cells(const FmuLayout& fmu, Causality causality) {
  std::vector<Cells> rows;
  for (const FmuVariable& variable : fmu.variables) {
    if (variable.causality != causality) continue;
    const bool has_start = causality == Causality::parameter || causality == Causality::input;
    rows.push_back({variable.name, variable.unit, has_start ? number_text(variable.value) : "",
                    number_or_none(variable.shown.min), number_or_none(variable.shown.max), variable.description});
  }
  return rows;
}

std::vector<Cells> body_cells(const Model& model) {
  std::vector<Cells> rows;
  for (std::size_t i = 0; i < model.bodies.size(); ++i) {
    const Body& body = model.bodies[i];
    if (static_cast<int>(i) != model.ground)
      rows.push_back({body.name, number_text(body.mass.value), body.description});
  }
  return rows;
}

std::vector<Cells> joint_cells(const Model& model) {
  const auto body_of = [&](const Attachment& at) { return model.bodies[static_cast<std::size_t>(at.body)].name; };
  return mapped(model.joints, [&](const Joint& joint) {
    return Cells{joint.name, name_of(joint.type), body_of(joint.from), body_of(joint.to), joint.description};
  });
}

/// The tables that have rows.
FrameRows tables(const Model& model, const FmuLayout& fmu) {
  const Cells of_variables = {"name", "unit", "start", "min", "max", "description"};
  FrameRows all;
  const auto add = [&](const char* heading, const Cells& columns, const std::vector<Cells>& rows) {
    if (rows.empty()) return;
    all.push_back({{"heading", heading}, {"columns", cell_rows(columns)}, {"rows", table_rows(rows)}});
  };
  add("Inputs", of_variables, variable_cells(fmu, Causality::input));
  add("Parameters", of_variables, variable_cells(fmu, Causality::parameter));
  add("Outputs", of_variables, variable_cells(fmu, Causality::output));
  add("Bodies", {"name", "mass, kg", "description"}, body_cells(model));
  add("Joints", {"name", "type", "from", "to", "description"}, joint_cells(model));
  return all;
}

/// A bus of the variables of this causality; none without any.
void add_terminal(const FmuLayout& fmu, const char* name, Causality causality, FrameRows& terminals) {
  FrameRows members;
  for (const FmuVariable& variable : fmu.variables) {
    if (variable.causality == causality) members.push_back({{"member", xml_text(variable.name)}});
  }
  if (!members.empty()) terminals.push_back({{"name", name}, {"members", members}});
}

}  // namespace

std::string documentation(const EmitContext& context, const FmuLayout& fmu, FmiVersion version) {
  const Model& model = context.model;
  const std::vector<Cells> about = about_cells(model.about);
  return fill_template(context, "fmu_documentation.html.in",
                       {{"name", xml_text(model.name)},
                        {"fmi", static_cast<int>(version)},
                        {"version", kMbgenVersion},
                        {"icon", version == FmiVersion::two ? "../model.png" : "../terminalsAndIcons/icon.png"},
                        {"description", xml_text(model.about.description)},
                        {"is_described", !about.empty()},
                        {"about", table_rows(about)},
                        {"step", number_text(model.solver.step)},
                        {"duration", number_text(model.solver.duration)},
                        {"tables", tables(model, fmu)}});
}

std::string terminals_and_icons(const FmuLayout& fmu) {
  FrameRows terminals;
  add_terminal(fmu, "inputs", Causality::input, terminals);
  add_terminal(fmu, "outputs", Causality::output, terminals);
  return fill_template("fmi3_terminals.xml.in", {{"terminals", terminals}});
}

}  // namespace mbgen
