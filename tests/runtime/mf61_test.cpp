// MF 6.1 against reference values that mbgen did not make (tests/data/tyre_mf61.json), against PAC2002 where the
// formulas coincide, and on the road.

#include "mbgen/mf61.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "mbgen/tyre.hpp"
#include "tests/runtime/mf61_sets.hpp"
#include "tests/runtime/mirrored_tyre.hpp"

namespace mbgen {
namespace {

using Set = MagicFormula61<double>;

const nlohmann::json& mf61_reference() {
  static const nlohmann::json data = reference_data("tyre_mf61.json");
  return data;
}

/// Sign that the reference has in (4.E24) over that of the book: it takes it from alpha, 0 at 0, in place of alpha_y.
double sign_of_reference(const Set& set, double fz, double alpha, double sine, double pressure) {
  if (alpha == 0) return 0;
  const magic::Mf61State<double> at = magic::mf61_state<double>(set, fz, pressure, 1, 1);
  const double thrust = set.lmuy * fz * (set.pvy3 + set.pvy4 * at.dfz) * sine * set.lkyc;
  const double force = set.lmuy * fz * (set.pvy1 + set.pvy2 * at.dfz) * set.lvy + thrust;
  const magic::PureLateral<double> lateral = magic::mf61_lateral<double>(set, at, alpha, sine);
  const double shift = lateral.slip_shift - force / lateral.stiffness;  // S_Hy of (4.E38)
  return std::signbit(alpha) == std::signbit(alpha + shift) ? 1 : -1;
}

TEST(Mf61Reference, EveryForceOfEveryRow) {
  for (const auto& [name, value] : mf61_reference()["parameters"].items()) {
    EXPECT_TRUE(std::ranges::any_of(kMf61Fields, [&](const TyreField& f) { return name == f.name; })) << name;
  }
  const Set set = passenger_car();
  double error[5] = {}, scale[5] = {};
  int turned = 0;
  for (const std::vector<double> row : mf61_reference()["rows"]) {
    const double kappa = row[0], alpha = row[1], fz = row[2], pressure = row[3], gamma = row[4], vx = row[5];
    // SSZ3 and SSZ4 of (4.E76) meet no camber in the reference.
    Set read = set;
    read.ssz3 = read.ssz4 = 0;
    const double sign = sign_of_reference(set, fz, alpha, std::sin(gamma), pressure);
    turned += sign < 0;
    read.pey3 *= sign;
    read.pey4 *= sign;
    const TyreForces<double> f = magic_formula_61<double>(read, fz, {kappa, alpha, gamma}, pressure);
    const double my = -mf61_rolling_resistance<double>(set, fz, f.fx, vx, gamma, pressure);
    const double computed[5] = {f.fx, f.fy, f.mz, my, f.mx};
    for (std::size_t i = 0; i < 5; ++i) {
      error[i] = std::max(error[i], std::abs(computed[i] - row[6 + i]) / std::abs(row[6 + i]));
      scale[i] = std::max(scale[i], std::abs(row[6 + i]));
    }
  }
  ASSERT_EQ(mf61_reference()["rows"].size(), 120u);
  EXPECT_EQ(turned, 1) << "rows whose slip lies between zero and the shift";
  for (std::size_t i = 0; i < 5; ++i) {
    EXPECT_LT(error[i], 1e-11) << i;
    EXPECT_GT(scale[i], 10) << i;
  }
}

TEST(Mf61, CamberMovesTheArmOfTheLongitudinalForce) {
  Set set = passenger_car(), without = set;
  without.ssz3 = without.ssz4 = 0;
  const magic::Mf61Slips<double> slips{0.05, 0.03, 0.06};
  const TyreForces<double> f = magic_formula_61<double>(set, 5000, slips, kNominalPressure);
  const double arm = set.unloaded_radius * (set.ssz3 + set.ssz4 * (5000 / 4100.0 - 1)) * std::sin(0.06);  // (4.E76)
  EXPECT_NEAR(f.mz - magic_formula_61<double>(without, 5000, slips, kNominalPressure).mz, arm * f.fx, 1e-9);
}

TEST(Mf61, IsPac2002WhereItsExtrasAreZero) {
  const auto data = nlohmann::json::parse(std::ifstream(MBGEN_SOURCE_DIR "/tests/data/tyre_magic_formula.json"));
  const nlohmann::json& numbers = data["citybus_315_80_R22.5"]["parameters"];
  std::vector<double> values;
  for (const TyreField& field : kPac2002Fields) values.push_back(numbers.value(field.name, field.default_value));
  const auto older = Pac2002<double>::from_fields(values.data());
  const Set set = mf61_set([&](const TyreField& f) {
    return std::string(f.name) == "NOMPRES" ? 8e5 : numbers.value(f.name, f.default_value);
  });
  for (const double fz : {5e3, 20e3, 35e3, 60e3}) {
    for (double slip = -0.4; slip < 0.41; slip += 0.05) {
      const TyreForces<double> along = magic_formula_61<double>(set, fz, {slip, 0, 0}, 8e5);
      EXPECT_NEAR(along.fx, magic_formula_pac2002<double>(older, fz, slip, 0, 0).fx, 1e-9);
      const TyreForces<double> across = magic_formula_61<double>(set, fz, {0, slip, 0}, 8e5);
      EXPECT_NEAR(across.fy, magic_formula_pac2002<double>(older, fz, 0, slip, 0).fy, 1e-9);
    }
    // The book's tangents stand where PAC2002 has angles: of second order and more.
    const TyreForces<double> both = magic_formula_61<double>(set, fz, {0.02, 1e-3, 0}, 8e5);
    const TyreForces<double> before = magic_formula_pac2002<double>(older, fz, 0.02, 1e-3, 0);
    EXPECT_NEAR(both.fx, before.fx, 1e-6 * fz);
    EXPECT_NEAR(both.fy, before.fy, 1e-6 * fz);
    EXPECT_NEAR(both.mz, before.mz, 1e-3 * std::abs(before.mz));
  }
}

TEST(Mf61, PressureActsOnEveryForceAndMoment) {
  const Set set = passenger_car();
  const magic::Mf61Slips<double> slips{0.04, 0.05, 0.03};
  const TyreForces<double> soft = magic_formula_61<double>(set, 4000, slips, 160e3);
  const TyreForces<double> hard = magic_formula_61<double>(set, 4000, slips, 260e3);
  EXPECT_NE(soft.fx, hard.fx);
  EXPECT_NE(soft.fy, hard.fy);
  EXPECT_NE(soft.mz, hard.mz);
  EXPECT_NE(soft.mx, hard.mx);
  EXPECT_GT(mf61_rolling_resistance<double>(set, 4000, 0, 20, 0, 160e3),
            mf61_rolling_resistance<double>(set, 4000, 0, 20, 0, 260e3));
}

TEST(Mf61, WithoutLoadIsExactlyZeroAndNeverNaN) {
  const Set set = passenger_car();
  for (const double kappa : {-100.0, -1.0, 0.0, 0.3, 100.0}) {
    for (const double alpha : {-1.57, -0.2, 0.0, 0.2, 1.57}) {
      for (const double gamma : {-0.3, 0.0, 0.3}) {
        for (const double fz : {0.0, -1000.0, 1e-300, 1e-3, 1.0, 4e3, 1e5}) {
          for (const double friction : {0.0, 1e-3, 1.0}) {
            const TyreForces<double> f =
                magic_formula_61<double>(set, fz, {kappa, alpha, gamma}, kNominalPressure, friction);
            ASSERT_TRUE(std::isfinite(f.fx + f.fy + f.mz + f.mx)) << fz << " " << kappa << " " << alpha << " " << gamma;
            EXPECT_TRUE(fz > 0 || (f.fx == 0 && f.fy == 0 && f.mz == 0 && f.mx == 0));
          }
        }
      }
    }
  }
}

TyreProperties<double> car_properties() { return {0.317, 2.1e5, 50, 1, 0.01, 0.2, 0.4, 2, 1, 1, kNominalPressure}; }

TEST(Mf61OnTheRoad, LoadAndRadiusFollowTheirCoefficients) {
  Set set = passenger_car();
  const TyreProperties<double> tyre = car_properties();
  TyreContact<double> contact{0.02, 0, 25, 0, 80, 0.05, 0, 0};
  EXPECT_NEAR(tyre_forces(set, tyre, contact).load, 2.1e5 * 0.02, 1e-9) << "linear without coefficients";
  EXPECT_NEAR(tyre_law::rolling_radius(set, tyre, contact), 0.317 - 0.02 / 3, 1e-15) << "Rill's without BREFF";
  set.q_re0 = 0.998;
  set.q_v1 = 6e-4;
  set.q_v2 = 0.04;
  set.q_fz2 = 13;
  set.q_fz3 = 3;
  set.pfz1 = 0.7;
  set.breff = 8.4;
  set.dreff = 0.25;
  set.freff = 0.07;
  TyreProperties<double> soft = tyre;
  soft.pressure = 200e3;
  // (4.E68) by hand, q_Fz1 such that the slope at the nominal load is the stiffness.
  const double speed = 80 * 0.317 / 16.7, grown = 0.317 * (0.998 - 1 + 6e-4 * speed * speed);
  const double x = (0.02 + grown) / 0.317, slope = 2.1e5 * 0.317 / 4100, linear = std::sqrt(slope * slope - 4 * 13);
  const double by_pressure = 1 - 0.7 * 20 / 220;
  const double load = 4100 * ((linear + 3 * 0.05 * 0.05) * x + 13 * x * x) * (1 + 0.04 * speed) * by_pressure;
  EXPECT_NEAR(tyre_law::load(set, soft, contact), load, 1e-9 * load);
  const double radius =
      0.317 + grown - 4100 / (2.1e5 * by_pressure) * (0.25 * std::atan(8.4 * load / 4100) + 0.07 * load / 4100);
  EXPECT_NEAR(tyre_law::rolling_radius(set, soft, contact), radius, 1e-12);
  // At rest, upright and at nominal pressure the slope at the nominal load is the stiffness.
  set.q_re0 = 1;
  const double pressed = 0.317 * (-linear + std::sqrt(linear * linear + 4 * 13)) / (2 * 13);
  const auto at = [&](double deflection) {
    return tyre_law::load(set, tyre, TyreContact<double>{deflection, 0, 0, 0, 0, 0, 0, 0});
  };
  EXPECT_NEAR(at(pressed), 4100, 1e-8);
  EXPECT_NEAR((at(pressed + 1e-6) - at(pressed - 1e-6)) / 2e-6, 2.1e5, 1);
}

TEST(Mf61OnTheRoad, ForcesOpposeSlipMirrorAndResistRolling) {
  const Set set = passenger_car();
  TyreProperties<double> tyre = car_properties();
  TyreContact<double> contact{0.02, 0, 15, 0, 15 / 0.31, 0.03, 0.004, -0.03};
  const TyreResult<double> one = tyre_forces(set, tyre, contact);
  EXPECT_GT(one.fx, 500);
  EXPECT_LT(one.fy, -500);
  tyre.side = -1;
  contact.v = 0.03;
  contact.camber = -0.03;
  const TyreResult<double> mirrored = tyre_forces(set, tyre, contact);
  expect_mirrored(mirrored, one);
  tyre.rolling_resistance = 0.03;  // for QSY1 = 0.01
  const double share = 0.02 * 4200 * 0.317 * std::pow(4200 / 4100.0, set.qsy7) * set.lmy;
  const double rolling = contact.spin * tyre_law::rolling_radius(set, tyre, contact) / tyre.low_speed;
  EXPECT_NEAR(tyre_forces(set, tyre, contact).my - mirrored.my, -share * std::tanh(rolling), 1e-9);
}

}  // namespace
}  // namespace mbgen
