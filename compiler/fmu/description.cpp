#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "compiler/emit/context_values.hpp"
#include "compiler/emit/mapped.hpp"
#include "compiler/emit/text.hpp"
#include "compiler/expressions/unit_exponents.hpp"
#include "compiler/fmu/texts.hpp"
#include "compiler/text/characters.hpp"

namespace mbgen {
namespace {

using Causality = FmuVariable::Causality;
using Start = FmuVariable::Start;

/// Attributes of an element, in this order; those without a text are left out.
FrameRows attributes(const std::vector<std::pair<std::string, std::string>>& all) {
  FrameRows rows;
  for (const auto& [name, value] : all) {
    if (!value.empty()) rows.push_back({{"name", name}, {"value", xml_text(value)}});
  }
  return rows;
}

FrameRows base_unit(const UnitExponents& unit) {
  constexpr const char* kNames[] = {"kg", "m", "s", "A", "K", "mol", "cd", "rad"};
  std::vector<std::pair<std::string, std::string>> all;
  for (std::size_t i = 0; i < unit.exponents.size(); ++i) {
    all.push_back({kNames[i], unit.exponents[i] == 0 ? "" : std::to_string(unit.exponents[i])});
  }
  all.push_back({"factor", unit.factor == 1 ? "" : number_text(unit.factor)});
  return attributes(all);
}

/// The decimal of 12 digits that a quotient of factors is, but for its rounding: 3.6 for km/h.
double decimal_near(double quotient) {
  constexpr double kRounding = 2 * std::numeric_limits<double>::epsilon();
  const double decimal = std::stod(fmt::format("{:.12g}", quotient));
  return std::abs(decimal - quotient) <= kRounding * quotient ? decimal : quotient;
}

/// Units that values are shown in, of this one: shown = value * factor.
FrameRows display_units(const UnitExponents& base, const std::set<std::string>& shown) {
  FrameRows rows;
  for (const std::string& name : shown) {
    const std::optional<UnitExponents> meaning = unit_exponents(name);
    if (meaning)
      rows.push_back({{"name", xml_text(name)}, {"factor", number_text(decimal_near(base.factor / meaning->factor))}});
  }
  return rows;
}

FrameRows unit_definitions(const FmuLayout& fmu) {
  std::map<std::string, std::set<std::string>> units;
  for (const FmuVariable& variable : fmu.variables) {
    if (variable.unit.empty()) continue;
    std::set<std::string>& shown = units[variable.unit];
    if (!variable.shown.display_unit.empty()) shown.insert(variable.shown.display_unit);
  }
  return mapped(units, [](const auto& unit) {
    const auto& [name, shown] = unit;
    const std::optional<UnitExponents> meaning = unit_exponents(name);
    return FrameValues{{"name", xml_text(name)},
                       {"is_known", meaning.has_value()},
                       {"base", meaning ? base_unit(*meaning) : FrameRows{}},
                       {"display_units", meaning ? display_units(*meaning, shown) : FrameRows{}}};
  });
}

/// First index of variables and unknowns where they refer to each other: FMI 2 has indices.
int first_index(FmiVersion version) { return version == FmiVersion::two ? 1 : 0; }

/// reference: the variable's value reference.
FrameValues variable_values(const FmuVariable& variable, std::size_t reference, FmiVersion version) {
  constexpr const char* kCausalities[] = {"independent", "parameter", "input", "output", "local"};
  constexpr const char* kInitial[] = {"", "exact", "approx", "calculated"};
  const Presentation& shown = variable.shown;
  const bool is_input = variable.causality == Causality::input;
  const bool is_exchanged = is_input || variable.causality == Causality::output;
  const bool has_start = is_input || variable.start == Start::exact || variable.start == Start::approx;
  const char* variability = variable.is_discrete                         ? "discrete"
                            : variable.causality != Causality::parameter ? "continuous"
                            : variable.is_fixed                          ? "fixed"
                                                                         : "tunable";
  const std::string derivative =
      variable.derivative_of < 0 ? "" : std::to_string(variable.derivative_of + first_index(version));
  return {
      {"attributes", attributes({{"name", variable.name},
                                 {"valueReference", std::to_string(reference)},
                                 {"description", variable.description},
                                 {"causality", kCausalities[static_cast<int>(variable.causality)]},
                                 {"variability", variability},
                                 {"initial", kInitial[static_cast<int>(variable.start)]},
                                 {"intermediateUpdate", is_exchanged && version == FmiVersion::three ? "true" : ""}})},
      {"number", attributes({{"unit", variable.unit},
                             {"displayUnit", shown.display_unit},
                             {"min", number_or_none(shown.min)},
                             {"max", number_or_none(shown.max)},
                             {"nominal", number_or_none(shown.nominal)},
                             {"start", has_start ? number_text(variable.value) : ""},
                             {"derivative", derivative},
                             {"reinit", variable.reinit ? "true" : ""}})}};
}

FrameRows unknowns(const std::vector<FmuUnknown>& all, FmiVersion version) {
  return mapped(all, [&](const FmuUnknown& unknown) {
    const auto text = [&](int variable) { return std::to_string(variable + first_index(version)); };
    return FrameValues{{"variable", text(unknown.variable)},
                       {"has_dependencies", true},
                       {"dependencies", joined(mapped(unknown.dependencies, text), " ")}};
  });
}

FrameRows indicators(const FmuLayout& fmu) {
  FrameRows rows;
  for (std::size_t i = fmu.variables.size() - fmu.indicator_blocks.size(); i < fmu.variables.size(); ++i)
    rows.push_back({{"variable", std::to_string(i)}, {"has_dependencies", false}, {"dependencies", ""}});
  return rows;
}

/// Lists of unknowns with the names that FMI 2 has for a list and FMI 3 for an element of it.
FrameRows structure(const FmuLayout& fmu, FmiVersion version) {
  FrameRows lists;
  const auto add = [&](const char* list, const char* element, const std::vector<FmuUnknown>& all) {
    if (all.empty()) return;
    lists.push_back({{"list", list}, {"element", element}, {"unknowns", unknowns(all, version)}});
  };
  add("Outputs", "Output", fmu.outputs);
  if (fmu.has_states) add("Derivatives", "ContinuousStateDerivative", fmu.derivatives);
  add("InitialUnknowns", "InitialUnknown", fmu.initial_unknowns);
  // FMI 3 lists event indicators, FMI 2 counts them. Each may depend on all there is.
  if (version == FmiVersion::three && !fmu.indicator_blocks.empty())
    lists.push_back({{"list", ""}, {"element", "EventIndicator"}, {"unknowns", indicators(fmu)}});
  return lists;
}

FrameRows file_rows(const std::vector<std::string>& sources) {
  return mapped(sources, [](const std::string& source) { return FrameValues{{"file", source}}; });
}

}  // namespace

std::string fmu_token(const Model& model) { return fmt::format("mbgen-{}-{}", kMbgenVersion, model.hash); }

std::string model_description(const EmitContext& context, const FmuLayout& fmu, FmiVersion version,
                              const std::vector<std::string>& sources) {
  const Model& model = context.model;
  FrameRows variables;
  for (std::size_t i = 0; i < fmu.variables.size(); ++i) {
    variables.push_back(variable_values(fmu.variables[i], i, version));
  }
  return fill_template(context, "fmi_description.xml.in",
                       {{"has_states", fmu.has_states},
                        {"indicators", fmu.indicator_blocks.size()},
                        {"has_derivatives", fmu.has_states ? "true" : "false"},
                        {"two", version == FmiVersion::two},
                        {"three", version == FmiVersion::three},
                        {"about", attributes({{"description", model.about.description},
                                              {"author", model.about.author},
                                              {"version", model.about.version},
                                              {"copyright", model.about.copyright},
                                              {"license", model.about.licence}})},
                        {"tolerance", number_text(model.solver.tolerance)},
                        {"model", xml_text(model.name)},
                        {"token", fmu_token(model)},
                        {"units", unit_definitions(fmu)},
                        {"stop", number_text(model.solver.duration)},
                        {"step", number_text(model.solver.step)},
                        {"variables", variables},
                        {"structure", structure(fmu, version)},
                        {"sources", file_rows(sources)}});
}

std::string build_description(const EmitContext& context, FmiVersion version, const std::vector<std::string>& sources) {
  return fill_template(
      context, "fmi_build.xml.in",
      {{"two", version == FmiVersion::two}, {"three", version == FmiVersion::three}, {"sources", file_rows(sources)}});
}

}  // namespace mbgen
