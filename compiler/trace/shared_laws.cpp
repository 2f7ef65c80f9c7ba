#include "compiler/trace/shared_laws.hpp"

#include <algorithm>
#include <limits>
#include <optional>
#include <utility>

#include "compiler/formulation/tyre_road.hpp"
#include "compiler/trace/each_program.hpp"

namespace mbgen {
namespace {

/// A law of one tyre alone saves nothing.
constexpr std::size_t kFewestTyres = 2;

/// Numbers of a tyre's contact, of its properties and of its result, by name.
template <class Struct>
struct ByName {
  const char* name;
  Expr Struct::*member;
};
using Contact = TyreContact<Expr>;
using Properties = TyreProperties<Expr>;
using Forces = TyreResult<Expr>;

constexpr ByName<Contact> kContact[] = {{"deflection", &Contact::deflection},
                                        {"deflection_rate", &Contact::deflection_rate},
                                        {"vx", &Contact::vx},
                                        {"vy", &Contact::vy},
                                        {"spin", &Contact::spin},
                                        {"camber", &Contact::camber},
                                        {"u", &Contact::u},
                                        {"v", &Contact::v}};
/// A property, also where it is known before anything is traced.
struct Property : ByName<Properties> {
  double TyreProperties<double>::*number;
};
constexpr Property kProperties[] = {
    {{"radius", &Properties::radius}, &TyreProperties<double>::radius},
    {{"stiffness", &Properties::stiffness}, &TyreProperties<double>::stiffness},
    {{"damping", &Properties::damping}, &TyreProperties<double>::damping},
    {{"friction", &Properties::friction}, &TyreProperties<double>::friction},
    {{"rolling_resistance", &Properties::rolling_resistance}, &TyreProperties<double>::rolling_resistance},
    {{"relaxation_x", &Properties::relaxation_x}, &TyreProperties<double>::relaxation_x},
    {{"relaxation_y", &Properties::relaxation_y}, &TyreProperties<double>::relaxation_y},
    {{"low_speed", &Properties::low_speed}, &TyreProperties<double>::low_speed},
    {{"side", &Properties::side}, &TyreProperties<double>::side},
    {{"count", &Properties::count}, &TyreProperties<double>::count}};
constexpr ByName<Forces> kResult[] = {{"load", &Forces::load}, {"fx", &Forces::fx}, {"fy", &Forces::fy},
                                      {"mx", &Forces::mx},     {"my", &Forces::my}, {"mz", &Forces::mz},
                                      {"du", &Forces::du},     {"dv", &Forces::dv}};

bool is_number(const Quantity& quantity) { return quantity.expression < 0; }

/// One law: the same formula with the same numbers.
bool share_a_law(const Tyre& a, const Tyre& b) {
  const auto same = [](const Quantity& p, const Quantity& q) {
    return is_number(p) && is_number(q) && p.value == q.value;
  };
  return a.model == b.model && std::ranges::equal(a.coefficients, b.coefficients, same);
}

/// Groups of tyres that share a law, in the order of their first tyres.
std::vector<std::vector<int>> tyres_of_laws(const Model& model) {
  std::vector<std::vector<int>> groups;
  for (std::size_t i = 0; i < model.tyres.size(); ++i) {
    const auto group = std::ranges::find_if(
        groups, [&](const auto& tyres) { return share_a_law(model.tyres[tyres.front()], model.tyres[i]); });
    (group == groups.end() ? groups.emplace_back() : *group).push_back(static_cast<int>(i));
  }
  std::erase_if(groups, [](const auto& tyres) { return tyres.size() < kFewestTyres; });
  return groups;
}

/// A property that is the same number for all tyres of a law; none for one that is its argument.
std::optional<double> common_number(const Model& model, const std::vector<int>& tyres, const Property& property) {
  constexpr double kLater = std::numeric_limits<double>::quiet_NaN();
  const auto number = [&](int tyre) {
    return detail::tyre_properties<double>(
               model.tyres[tyre], [&](const Quantity& q, const char*) { return is_number(q) ? q.value : kLater; }).*
           property.number;
  };
  const double first = number(tyres.front());
  if (std::ranges::all_of(tyres, [&](int tyre) { return number(tyre) == first; })) return first;
  return {};
}

SharedLaw traced_law(const Model& model, std::vector<int> tyres) {
  ProgramBuilder builder("tyres");
  Scribe<Expr> scribe{builder};
  const auto step = scribe.step(Step::forces);
  SharedLaw law;
  const auto argument = [&](const char* name) {
    law.arguments.emplace_back(name);
    return Expr(builder, builder.input(Array::law_argument, static_cast<int>(law.arguments.size()) - 1));
  };
  Contact contact;
  for (const auto& [name, member] : kContact) contact.*member = argument(name);
  Properties properties;
  for (const Property& property : kProperties) {
    const std::optional<double> number = common_number(model, tyres, property);
    properties.*property.member = number ? Expr(*number) : argument(property.name);
  }
  const Tyre& first = model.tyres[tyres.front()];
  std::vector<Expr> coefficients;
  for (const Quantity& q : first.coefficients) coefficients.emplace_back(q.value);
  const Forces result = detail::tyre_law(first.model, coefficients, properties, contact);
  for (const auto& [name, member] : kResult) {
    if (is_zero(result.*member)) continue;  // the overturning moment of most sets
    scribe.name(result.*member, name);
    builder.output(Array::law_result, static_cast<int>(law.results.size()), (result.*member).value(builder));
    law.results.emplace_back(name);
  }
  law.program = builder.finish_in_canonical_order();
  law.tyres = std::move(tyres);
  return law;
}

}  // namespace

std::vector<SharedLaw> trace_shared_laws(const Model& model) {
  std::vector<SharedLaw> laws;
  for (std::vector<int>& tyres : tyres_of_laws(model)) laws.push_back(traced_law(model, std::move(tyres)));
  return laws;
}

detail::SharedTyreLaw<Expr> shared_tyre_law(Tracing& tracing, const std::vector<SharedLaw>& laws) {
  return [&](std::size_t tyre, const Properties& properties, const Contact& contact) -> std::optional<Forces> {
    for (std::size_t k = 0; k < laws.size(); ++k) {
      const SharedLaw& law = laws[k];
      const auto place = std::ranges::find(law.tyres, static_cast<int>(tyre));
      if (place == law.tyres.end()) continue;
      const int elements = static_cast<int>(law.tyres.size()), element = static_cast<int>(place - law.tyres.begin());
      const auto slot = [&](const std::vector<std::string>& names, const char* name) -> std::optional<int> {
        const auto found = std::ranges::find(names, name);
        if (found == names.end()) return {};
        return static_cast<int>(found - names.begin()) * elements + element;
      };
      const auto give = [&](const char* name, const Expr& value) {
        if (const auto at = slot(law.arguments, name)) tracing.output(of_block(Array::law_argument, k), *at, value);
      };
      for (const auto& [name, member] : kContact) give(name, contact.*member);
      for (const Property& property : kProperties) give(property.name, properties.*property.member);
      Forces result;
      for (const auto& [name, member] : kResult)
        if (const auto at = slot(law.results, name))
          result.*member = tracing.input(of_block(Array::law_result, k), *at);
      return result;
    }
    return {};
  };
}

}  // namespace mbgen
