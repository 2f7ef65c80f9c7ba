#include "workbench/operating/tyre_law_text.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "compiler/formulation/elements/tyre.hpp"
#include "compiler/model/tyres.hpp"
#include "compiler/text/user_error.hpp"
#include "workbench/host/assignments.hpp"
#include "workbench/operating/operating_point.hpp"
#include "workbench/start/equilibrium_trouble.hpp"
#include "workbench/start/initial_state.hpp"

namespace mbgen {
namespace {

constexpr double kDegree = 3.14159265358979323846 / 180;
constexpr std::size_t kWidth = 100;

/// Force law of a tyre at default parameters, in contact axes.
class TyreCurves {
 public:
  explicit TyreCurves(const Tyre& tyre)
      : tyre_(tyre),
        properties_(detail::tyre_properties<double>(tyre, [](const Quantity& q, const char*) { return q.value; })) {
    for (const Quantity& q : tyre.coefficients) coefficients_.push_back(q.value);
  }

  /// Forces of one tyre that rolls forward under a load, N; slips 1, rad, rad.
  TyreForces<double> operator()(double load, double kappa, double alpha, double camber) const {
    const double side = tyre_.side;
    const TyreForces<double> f = detail::with_tyre_set(tyre_.model, coefficients_, [&](const auto& set) {
      return tyre_law::formula<double>(set, load, kappa, side * alpha, side * camber, properties_, 1);
    });
    return {f.fx, side * f.fy, side * f.mz, side * f.mx};
  }

  /// Forces of the mounted tyre in motion.
  TyreResult<double> moving(const TyreContact<double>& contact) const {
    return detail::tyre_law(tyre_.model, coefficients_, properties_, contact);
  }

  /// Static deflection under a load, m, and its rolling radius, m.
  std::pair<double, double> under(double load) const {
    double low = 0, high = tyre_.radius.value;
    return detail::with_tyre_set(tyre_.model, coefficients_, [&](const auto& set) {
      TyreContact<double> contact{};
      for (int i = 0; i < 60; ++i) {
        contact.deflection = (low + high) / 2;
        (tyre_law::spring(set, properties_, contact) < load ? low : high) = contact.deflection;
      }
      return std::pair(contact.deflection, tyre_law::rolling_radius(set, properties_, contact));
    });
  }

 private:
  const Tyre& tyre_;
  TyreProperties<double> properties_;
  std::vector<double> coefficients_;
};

std::string coefficients_text(const Tyre& tyre) {
  std::string text, line = " ";
  const std::span<const TyreField> fields = tyre_fields(tyre.model);
  for (std::size_t i = 0; i < tyre.coefficients.size(); ++i) {
    const double value = tyre.coefficients[i].value;
    const bool is_factor = !fields.empty() && fields[i].default_value == 1;
    const bool idle = tyre.model == TyreModel::mf61 && !tyre.turn_slip && is_of_turn_slip(fields[i].name);
    if (idle || value == (is_factor ? 1 : 0)) continue;
    const std::size_t a = kPac89ACount, b = a + kPac89BCount;
    const std::string name = !fields.empty() ? fields[i].name
                             : i < a         ? fmt::format("a{}", i)
                             : i < b         ? fmt::format("b{}", i - a)
                                             : fmt::format("c{}", i - b);
    const std::string word = fmt::format(" {} {:.6g}", name, value);
    if (line.size() + word.size() > kWidth) {
      text += line + "\n";
      line = " ";
    }
    line += word + ",";
  }
  if (!line.empty() && line.back() == ',') line.pop_back();
  return "\nCoefficients that act\n" + text + line + "\n";
}

std::string properties_text(const Tyre& tyre) {
  constexpr const char* kModels[] = {"formula of 1989", "PAC2002", "MF 6.1"};
  std::string text = fmt::format("Tyre {}: {}{}{}\n\nProperties\n", tyre.name, kModels[static_cast<int>(tyre.model)],
                                 tyre.side < 0 ? ", mirrored" : "",
                                 tyre.count == 1 ? "" : fmt::format(", {} side by side; values of one", tyre.count));
  const auto row = [&](const char* name, const Quantity& q, const char* unit) {
    text += fmt::format("  {:<20}{:>12.6g} {}\n", name, q.value, unit);
  };
  row("radius", tyre.radius, "m");
  row("stiffness", tyre.stiffness, "N/m");
  row("damping", tyre.damping, "N s/m");
  row("friction", tyre.friction, "1");
  if (tyre.model == TyreModel::mf61) row("pressure", tyre.pressure, "Pa");
  row("rolling_resistance", tyre.rolling_resistance, "1");
  row("relaxation_x", tyre.relaxation_x, tyre.over_load_x ? "m at nominal load, follows the load" : "m");
  row("relaxation_y", tyre.relaxation_y, tyre.over_load_y ? "m at nominal load, follows the load" : "m");
  row("low_speed", tyre.low_speed, "m/s");
  if (tyre.parking) {
    row("parking stiffness", tyre.parking->stiffness, "N m/rad");
    row("parking radius", tyre.parking->radius, "m");
    row("parking load", tyre.parking->load, "N");
  }
  if (tyre.combined_slip == CombinedSlip::ellipse) text += "  combined slip by a friction ellipse\n";
  if (tyre.turn_slip) text += "  turn slip of the set acts\n";
  return tyre.envelope ? text + "\nContact\n  " + to_text(*tyre.envelope) + "\n" : text;
}

/// Largest ratio of force to load over one slip, and its slip.
template <class Force>
std::string peak_text(const Force& force, double load, double unit, const char* name) {
  constexpr int kSteps = 2000;
  double peak = 0, at = 0;
  for (int i = 1; i <= kSteps; ++i) {
    const double slip = i / static_cast<double>(kSteps);
    if (const double share = std::abs(force(slip)) / load; share > peak) peak = share, at = slip;
  }
  return fmt::format("{:.4g} at {:.3g} {}", peak, at / unit, name);
}

std::string stiffness_text(const TyreCurves& law, double load) {
  constexpr double kSmall = 1e-6;
  const auto slope = [&](const auto& value) { return (value(kSmall) - value(-kSmall)) / (2 * kSmall); };
  const double x = slope([&](double s) { return law(load, s, 0, 0).fx; });
  const double y = -slope([&](double s) { return law(load, 0, s, 0).fy; });
  const double camber = slope([&](double s) { return law(load, 0, 0, s).fy; });
  const double moment = slope([&](double s) { return law(load, 0, s, 0).mz; });
  const auto [deflection, radius] = law.under(load);
  std::string text;
  text += fmt::format("  deflection {:.4g} mm, rolling radius {:.5g} m\n", 1e3 * deflection, radius);
  text += fmt::format("  longitudinal {:.5g} N, lateral {:.5g} N/rad, {:.5g} N/deg\n", x, y, y * kDegree);
  text += fmt::format("  camber {:.5g} N/rad, aligning {:.5g} N m/rad\n", camber, moment);
  text += fmt::format("  peak of fx / load {}\n",
                      peak_text([&](double s) { return law(load, s, 0, 0).fx; }, load, 1, "slip"));
  return text + fmt::format("  peak of fy / load {}\n",
                            peak_text([&](double s) { return law(load, 0, s, 0).fy; }, load, kDegree, "deg"));
}

std::string slips_text(const TyreCurves& law, double load) {
  std::string text =
      fmt::format("\n  {:>7}{:>11}{:>11}{:>11}{:>11}{:>11}\n", "slip", "alpha deg", "fx N", "fy N", "mz N m", "mx N m");
  const auto row = [&](double kappa, double degrees) {
    const TyreForces<double> f = law(load, kappa, degrees * kDegree, 0);
    text += fmt::format("  {:>7.2f}{:>11.1f}{:>11.1f}{:>11.1f}{:>11.2f}{:>11.2f}\n", kappa, degrees, f.fx, f.fy, f.mz,
                        f.mx);
  };
  for (const double kappa : {-1.0, -0.5, -0.2, -0.1, -0.05, -0.02, 0.0, 0.02, 0.05, 0.1, 0.2, 0.5, 1.0}) row(kappa, 0);
  for (const double degrees : {-20., -12., -8., -5., -3., -1., 1., 3., 5., 8., 12., 20.}) row(0, degrees);
  for (const double kappa : {-0.1, 0.1})
    for (const double degrees : {-5., -2., 2., 5.}) row(kappa, degrees);
  return text;
}

/// Moment of a standing tyre that is turned slowly to one side and back.
std::string parking_text(const TyreCurves& law, const Tyre& tyre, double load) {
  constexpr double kRate = 1e-6;  // rad/s
  constexpr int kStepsOfDegree = 1000;
  constexpr int kDegrees[] = {0, 1, 2, 3, 5, 8, 12, 20, 30};
  TyreContact<double> contact{};
  contact.deflection = law.under(load).first;
  int degree = 0;
  const auto turned_to = [&](int degrees) {
    const int sense = degrees > degree ? 1 : -1;
    contact.turn_rate = sense * kRate;
    for (int i = 0; i < std::abs(degrees - degree) * kStepsOfDegree; ++i)
      contact.turn += kDegree / kStepsOfDegree / kRate * law.moving(contact).dturn;
    degree = degrees;
    return law.moving(contact).mz / tyre.count;
  };
  std::vector<double> out, back;
  for (const int degrees : kDegrees) out.push_back(turned_to(degrees));
  for (std::size_t i = out.size(); i-- > 0;) back.push_back(turned_to(kDegrees[i]));
  std::string text = fmt::format("\nTurned on the spot\n\n  {:>9}{:>11}{:>11}\n", "left deg", "mz N m", "back N m");
  for (std::size_t i = 0; i < out.size(); ++i)
    text += fmt::format("  {:>9}{:>11.2f}{:>11.2f}\n", kDegrees[i], out[i], back[out.size() - 1 - i]);
  return text;
}

/// Forces on circles to the left, upright and without slip.
std::string circles_text(const TyreCurves& law, const Tyre& tyre, double load) {
  constexpr double kSpeed = 10;  // m/s, steady for so long
  std::string text =
      fmt::format("\nRolling on a circle to the left\n\n  {:>9}{:>11}{:>11}\n", "radius m", "fy N", "mz N m");
  for (const double radius : {100., 50., 20., 10., 5., 2.}) {
    TyreContact<double> contact{};
    const auto [deflection, rolling_radius] = law.under(load);
    contact.deflection = deflection;
    contact.vx = kSpeed;
    contact.spin = kSpeed / rolling_radius;
    contact.turn_rate = kSpeed / radius;
    for (int i = 0; i < 4000; ++i) contact.turn += 1e-4 * law.moving(contact).dturn;
    const TyreResult<double> result = law.moving(contact);
    text += fmt::format("  {:>9}{:>11.1f}{:>11.2f}\n", radius, result.fy / tyre.count, result.mz / tyre.count);
  }
  return text;
}

/// Static load of one tyre and its origin.
std::pair<double, std::string> load_at_rest(const Compilation& compilation, std::size_t index) {
  const Tyre& tyre = compilation.model.tyres[index];
  const std::vector<double> inputs = input_values(compilation.model, {});
  const auto load = [&](const GenericState& state) {
    const std::vector<double> loads = tyre_loads(compilation, inputs, state);
    return loads.empty() ? 0 : loads[index] / tyre.count;
  };
  try {
    if (const double at_rest = load(equilibrium_state(compilation, inputs)); at_rest > 0)
      return {at_rest, "at the equilibrium"};
  } catch (const UserError&) {  // vehicles that roll at their start often have none
  }
  GenericState start = initial_state(compilation, inputs);
  std::ranges::fill(start.zd, 0.0);
  if (const double at_start = load(start); at_start > 0) return {at_start, "at the start"};
  if (tyre.model == TyreModel::pac89)
    throw UserError(fmt::format("tyre \"{}\" bears no load at the start\n", tyre.name));
  const std::size_t nominal = tyre_field_index(tyre_fields(tyre.model), "FNOMIN");
  return {tyre.coefficients[nominal].value, "nominal, it bears none at the start"};
}

}  // namespace

std::string tyre_law_text(const Compilation& compilation, const std::string& name) {
  const std::vector<Tyre>& tyres = compilation.model.tyres;
  const auto found = std::ranges::find(tyres, name, &Tyre::name);
  if (found == tyres.end()) {
    std::vector<std::string> names;
    for (const Tyre& tyre : tyres) names.push_back(tyre.name);
    throw UserError(fmt::format("no tyre \"{}\"; tyres of the model: {}\n", name,
                                names.empty() ? "none" : fmt::to_string(fmt::join(names, ", "))));
  }
  const auto [load, origin] = load_at_rest(compilation, static_cast<std::size_t>(found - tyres.begin()));
  const TyreCurves law(*found);
  return properties_text(*found) + coefficients_text(*found) +
         fmt::format("\nRolling upright under {:.6g} N ({})\n", load, origin) + stiffness_text(law, load) +
         slips_text(law, load) + (found->parking ? parking_text(law, *found, load) : "") +
         (found->turn_slip ? circles_text(law, *found, load) : "");
}

}  // namespace mbgen
