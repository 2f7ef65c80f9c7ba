// Turn slip of MF 6.1 against values that mbgen did not make (tests/data/tyre_mf61_turn_slip.json), and its limits.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "mbgen/tyres/tyre.hpp"
#include "tests/runtime/mf61_book.hpp"
#include "tests/runtime/mf61_sets.hpp"

namespace mbgen {
namespace {

using Set = MagicFormula61<double>;

const nlohmann::json& reference() {
  static const nlohmann::json data = reference_data("tyre_mf61_turn_slip.json");
  return data;
}

double limit_of(const Set& set, double load, double friction) {
  return set.qcrp1 * friction * set.unloaded_radius * load * std::sqrt(load / set.fnomin) * set.lmp;  // (4.95)
}

/// The readings of the transcription that made the reference data, see its `source`.
constexpr book::Readings kOfTurnedReference{false, false, false, true, true, true};

TEST(TurnSlip, EveryForceOfEveryRow) {
  const Set set = turning_car();
  double error[4] = {}, of_book[4] = {}, scale[4] = {};
  for (const std::vector<double> row : reference()["rows"]) {
    const double kappa = row[0], alpha = row[1], fz = row[2], pressure = row[3], gamma = row[4];
    const auto at = magic::mf61_state<double>(set, fz, pressure, 1, 1);
    const double friction = magic::mf61_lateral<double>(set, at, 0, std::sin(gamma)).friction;
    const magic::Mf61Turn<double> turn{set.unloaded_radius * row[5], set.unloaded_radius * row[6], 1,
                                       limit_of(set, fz, friction), true};
    const Mf61Forces<double> f = mf61_forces<double>(set, fz, {kappa, alpha, gamma}, pressure, 1, 1, turn);
    const double computed[4] = {f.forces.fx, f.forces.fy, f.forces.mz, f.turning};
    const book::Point point{kappa, alpha, fz, pressure, gamma, row[5], row[6], true};
    const book::Forces read = book::forces(turning_numbers(), point, kOfTurnedReference);
    const book::Forces meant = book::forces(turning_numbers(), point);
    const double transcribed[4] = {read.fx, read.fy, read.mz, read.spin_moment};
    const double expected[4] = {meant.fx, meant.fy, meant.mz, meant.spin_moment};
    for (std::size_t i = 0; i < 4; ++i) {
      of_book[i] = std::max(of_book[i], std::abs(transcribed[i] - row[7 + i]) / std::abs(row[7 + i]));
      error[i] = std::max(error[i], std::abs(computed[i] - expected[i]) / std::abs(expected[i]));
      scale[i] = std::max(scale[i], std::abs(row[7 + i]));
    }
  }
  ASSERT_EQ(reference()["rows"].size(), 60u);
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_LT(of_book[i], 1e-10) << i << ": the transcription of the tests, in the readings of the data";
    EXPECT_LT(error[i], 1e-10) << i;
    EXPECT_GT(scale[i], 50) << i;
  }
}

TyreProperties<double> on_the_road(Turning turning) {
  TyreProperties<double> tyre{0.317, 2.1e5, 50, 1, 0.01, 0.2, 0.4, 2, 1, 1, kNominalPressure};
  const Set& set = turning_car();
  tyre.turn_stiffness = 2500;
  tyre.turn_radius = set.qcrp1 * set.unloaded_radius * set.lmp;
  tyre.turn_load = set.fnomin;
  tyre.turning = turning;
  return tyre;
}

/// A contact in steady rolling on a circle to the left, its deflections settled.
TyreContact<double> on_circle(const Set& set, const TyreProperties<double>& tyre, double vx, double radius,
                              double camber = 0) {
  TyreContact<double> contact{0.02, 0, vx, 0, 0, camber, 0, 0, vx / radius, 0};
  contact.spin = vx / tyre_law::rolling_radius(set, tyre, contact);
  for (int i = 0; i < 40000; ++i) contact.turn += 1e-4 * tyre_forces(set, tyre, contact).dturn;
  return contact;
}

TEST(TurnSlip, SteadyRollingIsTheFormulaAtItsCurvature) {
  const Set& set = turning_car();
  const TyreProperties<double> tyre = on_the_road(Turning::turn_slip);
  for (const double radius : {200.0, 20.0, 3.0, -5.0}) {
    const TyreContact<double> contact = on_circle(set, tyre, 5, radius, 0.02);
    const TyreResult<double> result = tyre_forces(set, tyre, contact);
    const double load = 4200, sine = std::sin(0.02), dfz = load / set.fnomin - 1;
    const double of_camber = -(1 - set.pecp1 * (1 + set.pecp2 * dfz)) * (contact.spin - 5 / radius * sine) * sine / 5;
    const auto at = magic::mf61_state<double>(set, load, kNominalPressure, 1, 1);
    const double limit = limit_of(set, load, magic::mf61_lateral<double>(set, at, 0, sine).friction);
    const double r0 = set.unloaded_radius;
    const Mf61Forces<double> formula =
        mf61_forces<double>(set, load, {result.kappa, result.alpha, 0.02}, kNominalPressure, 1, 1,
                            {r0 * (of_camber - 1 / radius), -r0 / radius, 1, limit, true});
    EXPECT_NEAR(result.fx, formula.forces.fx, 1e-8);
    EXPECT_NEAR(result.fy, formula.forces.fy, 1e-6);
    EXPECT_NEAR(result.mz, formula.forces.mz * std::tanh(2.5) + formula.turning, 1e-6);
  }
}

TEST(TurnSlip, CamberAloneIsTheCamberThrustOfTheFormulaWithoutIt) {
  // (4.89), (4.98): spin by camber has the stiffness of camber, so that both laws agree where it is small.
  Set set = symmetric_car();
  set.lmuy = 1;  // which the residual moment has and (4.99) has not
  const double camber = 1e-5, load = 4200, sine = std::sin(camber), dfz = load / set.fnomin - 1;
  const auto at = magic::mf61_state<double>(set, load, kNominalPressure, 1, 1);
  const double spin = -(1 - set.pecp1 * (1 + set.pecp2 * dfz)) * sine;
  const Mf61Forces<double> with = mf61_forces<double>(
      set, load, {0, 0, camber}, kNominalPressure, 1, 1,
      {spin, 0, 1, limit_of(set, load, magic::mf61_lateral<double>(set, at, 0, sine).friction), true});
  const TyreForces<double> without = magic_formula_61<double>(set, load, {0, 0, camber}, kNominalPressure);
  EXPECT_GT(std::abs(without.fy), 1e-2);
  EXPECT_NEAR(with.forces.fy, without.fy, 2e-3 * std::abs(without.fy));
  EXPECT_NEAR(with.forces.mz + with.turning, without.mz, 5e-3 * std::abs(without.mz));
}

TEST(TurnSlip, AllFactorsAreOneWhereItDoesNotAct) {
  const Set &with = turning_car(), without = passenger_car();
  for (const double alpha : {-0.2, 0.0, 0.07}) {
    const magic::Mf61Slips<double> slips{0.03, alpha, 0.05};
    const TyreForces<double> a = magic_formula_61<double>(with, 5000, slips, 2e5);
    const TyreForces<double> b = magic_formula_61<double>(without, 5000, slips, 2e5);
    EXPECT_TRUE(a.fx == b.fx && a.fy == b.fy && a.mz == b.mz && a.mx == b.mx);
  }
  const Mf61Forces<double> straight =
      mf61_forces<double>(symmetric_car(), 5000, {0.02, 0.05, 0}, 2e5, 1, 1, {0, 0, 1, 100, true});
  const TyreForces<double> same = magic_formula_61<double>(symmetric_car(), 5000, {0.02, 0.05, 0}, 2e5);
  EXPECT_DOUBLE_EQ(straight.forces.fx, same.fx) << "straight ahead";
  EXPECT_DOUBLE_EQ(straight.forces.fy, same.fy);
  EXPECT_DOUBLE_EQ(straight.forces.mz, same.mz);
  EXPECT_EQ(straight.turning, 0);
}

TEST(TurnSlip, ATightBendTakesSideForceAndResistsTurning) {
  const Set set = symmetric_car();
  const TyreProperties<double> tyre = on_the_road(Turning::turn_slip);
  double before = 0;
  for (const double radius : {100.0, 20.0, 5.0, 1.0, 0.2}) {
    const TyreResult<double> result = tyre_forces(set, tyre, on_circle(set, tyre, 3, radius));
    EXPECT_LT(result.mz, before) << radius << ": against the turn, the more the tighter";
    before = result.mz;
  }
  EXPECT_GT(before, -limit_of(set, 4200, 1.1)) << "never beyond that of turning on the spot";
  const auto peak = [&](double spin) {
    return std::abs(
        mf61_forces<double>(set, 4200, {0, 0.25, 0}, kNominalPressure, 1, 1, {spin, spin, 1, 200, true}).forces.fy);
  };
  EXPECT_GT(peak(0), peak(0.5));
  EXPECT_GT(peak(0.5), peak(3));
}

TEST(TurnSlip, IsFiniteWhateverTheMotion) {
  const Set& set = turning_car();
  const TyreProperties<double> tyre = on_the_road(Turning::turn_slip);
  for (const double vx : {-30.0, -0.01, 0.0, 1e-9, 1.0, 60.0})
    for (const double rate : {-20.0, 0.0, 1e-12, 3.0})
      for (const double turn : {-0.5, -0.02, 0.0, 1e-200, 0.1})
        for (const double camber : {-0.2, 0.0, 0.1})
          for (const double deflection : {-0.1, 0.0, 1e-9, 0.02}) {
            const TyreResult<double> r =
                tyre_forces(set, tyre, {deflection, 0, vx, 0.1 * rate, 5, camber, 0.01, -0.01, rate, turn});
            ASSERT_TRUE(std::isfinite(r.fx + r.fy + r.mx + r.my + r.mz + r.du + r.dv + r.dturn));
            EXPECT_TRUE(deflection > 0 || r.mz == 0);
          }
}

}  // namespace
}  // namespace mbgen
