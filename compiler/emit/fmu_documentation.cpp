#include "compiler/emit/fmu_documentation.hpp"

#include <fmt/format.h>

#include "compiler/emit/frame.hpp"
#include "compiler/emit/text.hpp"

namespace mbgen {
namespace {

using Causality = FmuVariable::Causality;

std::string html_row(const std::vector<std::string>& cells) {
  std::string text = "<tr>";
  for (const std::string& cell : cells) text += "<td>" + xml_text(cell) + "</td>";
  return text + "</tr>\n";
}

/// A heading and a table under it; nothing without rows.
std::string html_table(const std::string& heading, const std::vector<std::string>& columns, const std::string& rows) {
  if (rows.empty()) return "";
  std::string head;
  for (const std::string& column : columns) head += "<th>" + column + "</th>";
  return fmt::format("<h2>{}</h2>\n<table>\n<tr>{}</tr>\n{}</table>\n", heading, head, rows);
}

std::string html_number(const std::optional<double>& value) { return value ? number_text(*value) : ""; }

std::string html_variables(const FmuLayout& fmu, const std::string& heading, Causality causality) {
  std::string rows;
  for (const FmuVariable& variable : fmu.variables) {
    if (variable.causality != causality) continue;
    const bool has_start = causality == Causality::parameter || causality == Causality::input;
    rows += html_row({variable.name, variable.unit, has_start ? number_text(variable.value) : "",
                      html_number(variable.shown.min), html_number(variable.shown.max), variable.description});
  }
  return html_table(heading, {"name", "unit", "start", "min", "max", "description"}, rows);
}

std::string html_about(const About& about) {
  std::string rows;
  for (const auto& [name, value] : {std::pair{"author", &about.author},
                                    {"version", &about.version},
                                    {"copyright", &about.copyright},
                                    {"licence", &about.licence}}) {
    if (!value->empty()) rows += html_row({name, *value});
  }
  return rows.empty() ? "" : "<table>\n" + rows + "</table>\n";
}

std::string html_mechanism(const Model& model) {
  std::string bodies, joints;
  for (std::size_t i = 0; i < model.bodies.size(); ++i) {
    const Body& body = model.bodies[i];
    if (static_cast<int>(i) != model.ground)
      bodies += html_row({body.name, number_text(body.mass.value), body.description});
  }
  const auto body_of = [&](const Attachment& at) { return model.bodies[static_cast<std::size_t>(at.body)].name; };
  for (const Joint& joint : model.joints)
    joints += html_row({joint.name, name_of(joint.type), body_of(joint.from), body_of(joint.to), joint.description});
  return html_table("Bodies", {"name", "mass, kg", "description"}, bodies) +
         html_table("Joints", {"name", "type", "from", "to", "description"}, joints);
}

std::string terminal_text(const FmuLayout& fmu, const std::string& name, Causality causality) {
  std::string members;
  for (const FmuVariable& variable : fmu.variables) {
    if (variable.causality != causality) continue;
    members +=
        fmt::format("      <TerminalMemberVariable variableName=\"{0}\" memberName=\"{0}\" variableKind=\"signal\"/>\n",
                    xml_text(variable.name));
  }
  if (members.empty()) return "";
  return fmt::format("    <Terminal name=\"{}\" matchingRule=\"bus\">\n{}    </Terminal>\n", name, members);
}

}  // namespace

std::string documentation(const EmitContext& context, const FmuLayout& fmu, FmiVersion version) {
  const Model& model = context.model;
  return fill_template("fmu_documentation.html.in",
                       {{"name", xml_text(model.name)},
                        {"fmi", std::to_string(static_cast<int>(version))},
                        {"version", kMbgenVersion},
                        {"icon", version == FmiVersion::two ? "../model.png" : "../terminalsAndIcons/icon.png"},
                        {"description", xml_text(model.about.description)},
                        {"about", html_about(model.about)},
                        {"step", number_text(model.solver.step)},
                        {"duration", number_text(model.solver.duration)},
                        {"tables", html_variables(fmu, "Inputs", Causality::input) +
                                       html_variables(fmu, "Parameters", Causality::parameter) +
                                       html_variables(fmu, "Outputs", Causality::output) + html_mechanism(model)}});
}

std::string terminals_and_icons(const FmuLayout& fmu) {
  return fill_template("fmi3_terminals.xml.in", {{"terminals", terminal_text(fmu, "inputs", Causality::input) +
                                                                   terminal_text(fmu, "outputs", Causality::output)}});
}

}  // namespace mbgen
