#include "compiler/emit/fmu_description.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "compiler/emit/frame.hpp"
#include "compiler/emit/text.hpp"
#include "compiler/model/unit_exponents.hpp"

namespace mbgen {
namespace {

using Causality = FmuVariable::Causality;
using Start = FmuVariable::Start;

std::string base_unit(const UnitExponents& unit) {
  constexpr const char* kNames[] = {"kg", "m", "s", "A", "K", "mol", "cd", "rad"};
  std::string text = "      <BaseUnit";
  for (std::size_t i = 0; i < unit.exponents.size(); ++i) {
    if (unit.exponents[i] != 0) text += fmt::format(" {}=\"{}\"", kNames[i], unit.exponents[i]);
  }
  if (unit.factor != 1) text += fmt::format(" factor=\"{}\"", number_text(unit.factor));
  return text + "/>\n";
}

/// Units that values are shown in, of this one: shown = value * factor.
std::string display_units(const UnitExponents& base, const std::set<std::string>& shown) {
  std::string text;
  for (const std::string& name : shown) {
    const std::optional<UnitExponents> meaning = unit_exponents(name);
    if (!meaning) continue;
    text += fmt::format("      <DisplayUnit name=\"{}\" factor=\"{}\"/>\n", xml_text(name),
                        number_text(base.factor / meaning->factor));
  }
  return text;
}

std::string unit_definitions(const FmuLayout& fmu) {
  std::map<std::string, std::set<std::string>> units;
  for (const FmuVariable& variable : fmu.variables) {
    if (variable.unit.empty()) continue;
    std::set<std::string>& shown = units[variable.unit];
    if (!variable.shown.display_unit.empty()) shown.insert(variable.shown.display_unit);
  }
  std::string text;
  for (const auto& [unit, shown] : units) {
    const std::optional<UnitExponents> meaning = unit_exponents(unit);
    text += meaning ? fmt::format("    <Unit name=\"{}\">\n{}{}    </Unit>\n", xml_text(unit), base_unit(*meaning),
                                  display_units(*meaning, shown))
                    : fmt::format("    <Unit name=\"{}\"/>\n", xml_text(unit));
  }
  return text;
}

const char* name_of(Causality causality) {
  constexpr const char* kNames[] = {"independent", "parameter", "input", "output", "local"};
  return kNames[static_cast<int>(causality)];
}

/// ` variability="tunable" initial="exact"`, as the standard asks for it with this causality.
std::string initial_text(const FmuVariable& variable) {
  constexpr const char* kNames[] = {"", "exact", "approx", "calculated"};
  const char* variability = variable.causality != Causality::parameter ? "continuous"
                            : variable.is_fixed                        ? "fixed"
                                                                       : "tunable";
  const std::string initial =
      variable.start == Start::none ? "" : fmt::format(" initial=\"{}\"", kNames[static_cast<int>(variable.start)]);
  return fmt::format(" variability=\"{}\"{}", variability, initial);
}

std::string unit_and_start(const FmuVariable& variable) {
  const Presentation& shown = variable.shown;
  std::string text = variable.unit.empty() ? "" : fmt::format(" unit=\"{}\"", xml_text(variable.unit));
  if (!shown.display_unit.empty()) text += fmt::format(" displayUnit=\"{}\"", xml_text(shown.display_unit));
  if (shown.min) text += fmt::format(" min=\"{}\"", number_text(*shown.min));
  if (shown.max) text += fmt::format(" max=\"{}\"", number_text(*shown.max));
  if (shown.nominal) text += fmt::format(" nominal=\"{}\"", number_text(*shown.nominal));
  const bool has_start =
      variable.start == Start::exact || variable.start == Start::approx || variable.causality == Causality::input;
  if (has_start) text += fmt::format(" start=\"{}\"", number_text(variable.value));
  return text;
}

std::string variable_2(const FmuVariable& variable, std::size_t reference) {
  const std::string derivative =
      variable.derivative_of < 0 ? "" : fmt::format(" derivative=\"{}\"", variable.derivative_of + 1);
  const char* reinit = variable.reinit ? " reinit=\"true\"" : "";
  return fmt::format(
      "    <ScalarVariable name=\"{}\" valueReference=\"{}\" description=\"{}\" causality=\"{}\"{}>\n"
      "      <Real{}{}{}/>\n    </ScalarVariable>\n",
      xml_text(variable.name), reference, xml_text(variable.description), name_of(variable.causality),
      initial_text(variable), unit_and_start(variable), derivative, reinit);
}

std::string variable_3(const FmuVariable& variable, std::size_t reference) {
  const std::string derivative =
      variable.derivative_of < 0 ? "" : fmt::format(" derivative=\"{}\"", variable.derivative_of);
  const char* reinit = variable.reinit ? " reinit=\"true\"" : "";
  const bool is_exchanged = variable.causality == Causality::input || variable.causality == Causality::output;
  const char* intermediate = is_exchanged ? " intermediateUpdate=\"true\"" : "";
  return fmt::format("    <Float64 name=\"{}\" valueReference=\"{}\" description=\"{}\" causality=\"{}\"{}{}{}{}{}/>\n",
                     xml_text(variable.name), reference, xml_text(variable.description), name_of(variable.causality),
                     initial_text(variable), intermediate, unit_and_start(variable), derivative, reinit);
}

/// offset: between value references and what unknowns count by, 1 for the indices of FMI 2.
std::string unknowns_text(const std::vector<FmuUnknown>& unknowns, const std::string& element, int offset) {
  std::string text;
  for (const FmuUnknown& unknown : unknowns) {
    std::vector<int> known;
    for (const int dependency : unknown.dependencies) known.push_back(dependency + offset);
    text += fmt::format("{} {}=\"{}\" dependencies=\"{}\"/>\n", element, offset == 1 ? "index" : "valueReference",
                        unknown.variable + offset, fmt::join(known, " "));
  }
  return text;
}

std::string structure_2(const FmuLayout& fmu) {
  std::string text;
  const auto add = [&](const char* name, const std::vector<FmuUnknown>& unknowns) {
    if (unknowns.empty()) return;
    text += fmt::format("    <{0}>\n{1}    </{0}>\n", name, unknowns_text(unknowns, "      <Unknown", 1));
  };
  add("Outputs", fmu.outputs);
  add("Derivatives", fmu.derivatives);
  add("InitialUnknowns", fmu.initial_unknowns);
  return text;
}

std::string structure_3(const FmuLayout& fmu) {
  return unknowns_text(fmu.outputs, "    <Output", 0) +
         unknowns_text(fmu.derivatives, "    <ContinuousStateDerivative", 0) +
         unknowns_text(fmu.initial_unknowns, "    <InitialUnknown", 0);
}

/// ` author="Eve"` and so on, what the model says of itself.
std::string about_text(const About& about) {
  std::string text;
  for (const auto& [name, value] : {std::pair{"description", &about.description},
                                    {"author", &about.author},
                                    {"version", &about.version},
                                    {"copyright", &about.copyright},
                                    {"license", &about.licence}}) {
    if (!value->empty()) text += fmt::format("\n    {}=\"{}\"", name, xml_text(*value));
  }
  return text;
}

}  // namespace

std::string xml_text(std::string_view text) {
  std::string result;
  for (const char c : comment_text(text)) {
    const char* escaped = c == '&' ? "&amp;" : c == '<' ? "&lt;" : c == '>' ? "&gt;" : c == '"' ? "&quot;" : nullptr;
    result += escaped == nullptr ? std::string(1, c) : escaped;
  }
  return result;
}

std::string fmu_token(const Model& model) { return fmt::format("mbgen-{}-{}", kMbgenVersion, model.hash); }

std::string model_description(const EmitContext& context, const FmuLayout& fmu, FmiVersion version,
                              const std::vector<std::string>& sources) {
  const Model& model = context.model;
  const bool is_two = version == FmiVersion::two;
  std::string variables, files;
  for (std::size_t i = 0; i < fmu.variables.size(); ++i)
    variables += is_two ? variable_2(fmu.variables[i], i) : variable_3(fmu.variables[i], i);
  for (const std::string& source : sources) files += fmt::format("      <File name=\"{}\"/>\n", source);
  FrameValues values = {{"about", about_text(model.about)},
                        {"tolerance", number_text(model.solver.tolerance)},
                        {"name", xml_text(model.name)},
                        {"solver", context.names.solver},
                        {"token", fmu_token(model)},
                        {"version", kMbgenVersion},
                        {"units", unit_definitions(fmu)},
                        {"stop", number_text(model.solver.duration)},
                        {"step", number_text(model.solver.step)},
                        {"variables", variables},
                        {"structure", is_two ? structure_2(fmu) : structure_3(fmu)}};
  if (is_two) values.insert({"sources", files});
  return fill_template(is_two ? "fmi2_description.xml.in" : "fmi3_description.xml.in", values);
}

std::string build_description(const EmitContext& context, FmiVersion version, const std::vector<std::string>& sources) {
  std::string files;
  for (const std::string& source : sources) files += fmt::format("      <SourceFile name=\"{}\"/>\n", source);
  const std::string definition =
      version == FmiVersion::two
          ? "      <PreprocessorDefinition name=\"FMI2_OVERRIDE_FUNCTION_PREFIX\"\n"
            "          description=\"for a shared library: functions have the names of the standard\"/>\n"
          : fmt::format(
                "      <PreprocessorDefinition name=\"FMI3_FUNCTION_PREFIX\" optional=\"true\" value=\"{}_\"\n"
                "          description=\"for programs that hold several FMUs\"/>\n",
                context.names.solver);
  return fill_template("fmi_build.xml.in",
                       {{"solver", context.names.solver}, {"sources", files}, {"definition", definition}});
}

}  // namespace mbgen
