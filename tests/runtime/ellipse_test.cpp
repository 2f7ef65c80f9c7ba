// Combined slip by a friction ellipse, for sets of pure slip.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string_view>
#include <vector>

#include "mbgen/tyres/tyre.hpp"

namespace mbgen {
namespace {

template <class Set, class Fields>
Set set_of(const Fields& fields, const std::vector<std::pair<std::string_view, double>>& given) {
  std::vector<double> values;
  for (const TyreField& field : fields) {
    const auto found =
        std::ranges::find(given, std::string_view(field.name), [](const auto& row) { return row.first; });
    values.push_back(found == given.end() ? field.default_value : found->second);
  }
  return Set::from_fields(values.data());
}

const std::vector<std::pair<std::string_view, double>> kPure = {{"UNLOADED_RADIUS", 0.3},
                                                                {"FNOMIN", 4000},
                                                                {"NOMPRES", 2e5},
                                                                {"PCX1", 1.6},
                                                                {"PDX1", 1.2},
                                                                {"PKX1", 20},
                                                                {"PCY1", 1.3},
                                                                {"PDY1", 1.0},
                                                                {"PKY1", -15},
                                                                {"PKY2", 1.5},
                                                                {"QBZ1", 10},
                                                                {"QCZ1", 1.2},
                                                                {"QDZ1", 0.1}};

TyreForces<double> of(const Pac2002<double>& set, double kappa, double alpha, bool ellipse) {
  return magic_formula_pac2002<double>(set, 3924, kappa, alpha, 0, 1, 1, ellipse);
}
TyreForces<double> of(const MagicFormula61<double>& set, double kappa, double alpha, bool ellipse) {
  return magic_formula_61<double>(set, 3924, {kappa, alpha, 0}, 2e5, 1, 1, ellipse);
}

template <class Set>
void expect_ellipse(const Set& set) {
  double largest = 0, without = 0;
  for (double kappa = -1.5; kappa <= 1.5; kappa += 0.05)
    for (double alpha = -0.9; alpha <= 0.9; alpha += 0.05) {
      const TyreForces<double> f = of(set, kappa, alpha, true), free = of(set, kappa, alpha, false);
      largest = std::max(largest, std::hypot(f.fx / (1.2 * 3924), f.fy / 3924));
      without = std::max(without, std::hypot(free.fx / (1.2 * 3924), free.fy / 3924));
      EXPECT_GE(f.fx * kappa, -1e-9);
      EXPECT_LE(f.fy * alpha, 1e-9);
      EXPECT_TRUE(std::isfinite(f.mz));
    }
  EXPECT_LE(largest, 1 + 1e-12);
  EXPECT_GT(largest, 0.99) << "friction is used";
  EXPECT_GT(without, 1.35) << "the set alone goes beyond";
  for (const double slip : {-0.4, -0.05, 0.0, 0.02, 0.3}) {
    EXPECT_NEAR(of(set, slip, 0, true).fx, of(set, slip, 0, false).fx, 1e-9);
    EXPECT_NEAR(of(set, 0, slip, true).fy, of(set, 0, slip, false).fy, 1e-9);
    EXPECT_NEAR(of(set, 0, slip, true).mz, of(set, 0, slip, false).mz, 1e-9);
  }
}

TEST(FrictionEllipse, HoldsTheForceAndLeavesPureSlipAsItIs) {
  expect_ellipse(set_of<Pac2002<double>>(kPac2002Fields, kPure));
  expect_ellipse(set_of<MagicFormula61<double>>(kMf61Fields, kPure));
}

// outside3/friction_square.json: 5074 N at slip 0.1 and 5 degrees with mu Fz = 3924 N.
TEST(FrictionEllipse, FrictionSquare) {
  auto numbers = kPure;
  for (auto& [name, value] : numbers)
    if (name == "PDX1") value = 1;
  const auto set = set_of<Pac2002<double>>(kPac2002Fields, numbers);
  const double angle = 5 * std::acos(-1.0) / 180;
  const TyreForces<double> free = of(set, 0.1, angle, false), held = of(set, 0.1, angle, true);
  EXPECT_NEAR(std::hypot(free.fx, free.fy), 5074, 1);
  EXPECT_LE(std::hypot(held.fx, held.fy), 3924);
  EXPECT_GT(std::hypot(held.fx, held.fy), 3500);
}

// PKY2 of 0 is no side force, and no force that is not a number.
TEST(FrictionEllipse, ASetWithoutPky2HasNoSideForce) {
  auto numbers = kPure;
  std::erase_if(numbers, [](const auto& row) { return row.first == "PKY2"; });
  const TyreForces<double> f = of(set_of<Pac2002<double>>(kPac2002Fields, numbers), 0.02, 0.05, false);
  EXPECT_NEAR(f.fy, 0, 1e-3);
  EXPECT_GT(f.fx, 1000);
}

}  // namespace
}  // namespace mbgen
