// MJCF: equalities that relate coordinates and fixed tendons.
#include <fmt/format.h>

#include <array>
#include <cmath>

#include "workbench/import/mjcf.hpp"

namespace mbgen::importing {
namespace {

/// The sum of coordinates that a joint or tendon names; nothing with a problem where there is none. Nothing without the
/// attribute.
std::optional<MjcfLength> length_by(Mjcf& mjcf, const Element& element, std::string_view name, bool is_tendon) {
  const Attribute* named = attribute(element, name);
  if (!named) return std::nullopt;
  if (is_tendon) {
    const auto found = mjcf.tendon_of.find(named->value);
    if (found != mjcf.tendon_of.end()) return found->second;
    problem(mjcf.reading, named->spot, "no fixed tendon is named " + quoted_text(named->value));
    return std::nullopt;
  }
  const auto found = mjcf.joint_of.find(named->value);
  if (found == mjcf.joint_of.end()) {
    problem(mjcf.reading, named->spot, "no joint is named " + quoted_text(named->value));
  } else if (found->second.type != JointType::revolute && found->second.type != JointType::prismatic) {
    problem(mjcf.reading, named->spot, fmt::format("joint {} has not one coordinate", quoted_text(named->value)));
  } else {
    return MjcfLength{{{1.0, found->second}}};
  }
  return std::nullopt;
}

/// y - y0 = polycoef of (x - x0), of joints or fixed tendons, where y0 and x0 are at the reference as written: the
/// model's zeros, but for what closing its loops has moved.
void add_relation(Mjcf& mjcf, const Element& equality) {
  const bool is_tendon = equality.name == "tendon";
  const std::string name = equality.name;
  if (!required_text(mjcf.reading, equality, name + "1")) return;
  const std::optional<MjcfLength> follower = length_by(mjcf, equality, name + "1", is_tendon);
  const std::optional<MjcfLength> leader = length_by(mjcf, equality, name + "2", is_tendon);
  if (!follower || (attribute(equality, name + "2") && !leader)) return;
  const std::vector<double> factors = polynomial_of(mjcf, equality);
  std::vector<Term> terms = terms_of(*follower, 1, "z.");
  terms.push_back({follower->moved() - factors[0] - (leader ? factors[1] * leader->moved() : 0)});
  if (leader) {
    for (const Term& term : terms_of(*leader, -factors[1], "z.")) terms.push_back(term);
    std::vector<Term> sum = terms_of(*leader, 1, "z.");
    sum.push_back({leader->moved()});
    const std::string x = sum_text(sum);
    const bool is_one = leader->parts.size() == 1 && leader->parts.front().first == 1 && leader->moved() == 0;
    for (std::size_t power = 2; power < factors.size(); ++power)
      terms.push_back({-factors[power], fmt::format("{}^{}", is_one ? x : "(" + x + ")", power)});
  }
  const std::string written = text_of(equality, "name");
  const std::string shown = written.empty() ? "equality_" + text_of(equality, name + "1") : written;
  mjcf.assembly.couplings.push_back({unique_name(shown, mjcf.assembly.coupling_names), sum_text(terms)});
}

/// Whether an equality holds.
bool is_active(const Mjcf& mjcf, const Element& equality) {
  const Attribute* active = inherited_as(mjcf, equality, "equality", "active");
  return !active || active->value != "false";
}

void add_equality(Mjcf& mjcf, const Element& equality) {
  static constexpr std::array<std::string_view, 4> known = {"connect", "weld", "joint", "tendon"};
  if (std::find(known.begin(), known.end(), equality.name) == known.end()) return;
  require_class(mjcf, equality, "class");
  if (!is_active(mjcf, equality))
    return note(mjcf.reading, equality.spot, fmt::format("<{}> is not active: it is left out", equality.name));
  if (equality.name == "joint" || equality.name == "tendon") add_relation(mjcf, equality);
}

}  // namespace

std::vector<Term> terms_of(const MjcfLength& length, double factor, std::string_view prefix) {
  std::vector<Term> terms;
  for (const auto& [part, joint] : length.parts)
    terms.push_back({factor * part, fmt::format("{}{}", prefix, joint.coordinate)});
  return terms;
}

std::vector<double> polynomial_of(Mjcf& mjcf, const Element& equality) {
  std::vector<double> factors = {0, 1};
  if (const Attribute* written = attribute(equality, "polycoef"))
    factors = numbers(mjcf.reading, *written, 1, 5).value_or(factors);
  // MuJoCo keeps the defaults of missing factors.
  if (factors.size() < 2) factors.push_back(1);
  return factors;
}

void for_equalities(const Mjcf& mjcf, const Element& root, const std::function<void(const Element&)>& visit) {
  if (!mjcf.settings.has_equalities) return;
  for (const Element& section : root.children) {
    for (const Element& equality : section.children)
      if (section.name == "equality" && is_active(mjcf, equality)) visit(equality);
  }
}

void read_equalities(Mjcf& mjcf, const Element& section) {
  for (const Element& equality : section.children) add_equality(mjcf, equality);
}

}  // namespace mbgen::importing
