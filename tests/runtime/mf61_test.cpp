// MF 6.1 against reference values that mbgen did not make (tests/data/tyre_mf61.json), against PAC2002 where the
// formulas coincide, and on the road.

#include "mbgen/tyres/mf61.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "mbgen/tyres/tyre.hpp"
#include "tests/runtime/mf61_book.hpp"
#include "tests/runtime/mf61_sets.hpp"
#include "tests/runtime/mirrored_tyre.hpp"

namespace mbgen {
namespace {

using Set = MagicFormula61<double>;

const nlohmann::json& mf61_reference() {
  static const nlohmann::json data = reference_data("tyre_mf61.json");
  return data;
}

/// The readings of the library that made the reference data, see its `source`.
constexpr book::Readings kOfReference{false, false, false, false, false, false};

// The transcription of the tests gives the reference data with their readings: it is no misprint that it shares with
// mbgen.
TEST(Mf61Reference, ATranscriptionOfItsOwnGivesEveryRow) {
  double error[3] = {}, scale[3] = {};
  for (const std::vector<double> row : mf61_reference()["rows"]) {
    const book::Forces f =
        book::forces(mf61_reference()["parameters"], {row[0], row[1], row[2], row[3], row[4]}, kOfReference);
    const double computed[3] = {f.fx, f.fy, f.mz};
    for (std::size_t i = 0; i < 3; ++i) {
      error[i] = std::max(error[i], std::abs(computed[i] - row[6 + i]) / std::abs(row[6 + i]));
      scale[i] = std::max(scale[i], std::abs(row[6 + i]));
    }
  }
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_LT(error[i], 1e-11) << i;
    EXPECT_GT(scale[i], 10) << i;
  }
}

// Fx and the moments My and Mx of the reference have no reading of their own (Mx: with the square inside), Fy and Mz
// are those of the book.
TEST(Mf61Reference, EveryForceOfEveryRow) {
  for (const auto& parameter : mf61_reference()["parameters"].items()) {
    const std::string& name = parameter.key();
    EXPECT_TRUE(std::ranges::any_of(kMf61Fields, [&](const TyreField& f) { return name == f.name; })) << name;
  }
  const Set set = passenger_car();
  double error[5] = {}, scale[5] = {}, differs[2] = {};
  for (const std::vector<double> row : mf61_reference()["rows"]) {
    const double kappa = row[0], alpha = row[1], fz = row[2], pressure = row[3], gamma = row[4], vx = row[5];
    const book::Forces f = book::forces(mf61_reference()["parameters"], {kappa, alpha, fz, pressure, gamma});
    const TyreForces<double> own = magic_formula_61<double>(set, fz, {kappa, alpha, gamma}, pressure);
    const auto at = magic::mf61_state<double>(set, fz, pressure, 1, 1);
    const double computed[5] = {own.fx, own.fy, own.mz,
                                -mf61_rolling_resistance<double>(set, fz, row[6], vx, gamma, pressure),
                                magic::mf61_overturning<double>(set, at, row[7], gamma)};
    const double expected[5] = {row[6], f.fy, f.mz, row[9], row[11]};
    for (std::size_t i = 0; i < 5; ++i) {
      error[i] = std::max(error[i], std::abs(computed[i] - expected[i]) / std::abs(expected[i]));
      scale[i] = std::max(scale[i], std::abs(expected[i]));
    }
    EXPECT_DOUBLE_EQ(own.mx, magic::mf61_overturning<double>(set, at, own.fy, gamma));
    for (std::size_t i = 0; i < 2; ++i)
      differs[i] = std::max(differs[i], std::abs(expected[1 + i] - row[7 + i]) / std::abs(row[7 + i]));
  }
  ASSERT_EQ(mf61_reference()["rows"].size(), 120u);
  for (std::size_t i = 0; i < 5; ++i) {
    EXPECT_LT(error[i], 1e-11) << i;
    EXPECT_GT(scale[i], 10) << i;
  }
  for (const double difference : differs) EXPECT_GT(difference, 1e-3) << "readings matter in these rows";
}

// R0 LMX (Fy (QSX13 + QSX14 |gamma|) - Fz QSX12 gamma |gamma|) is what MF 6.2 adds.
TEST(Mf61, OverturningMomentOf62) {
  const Set set = passenger_car();
  Set newer = set;
  newer.qsx12 = 0.7;
  newer.qsx13 = 0.02;
  newer.qsx14 = 0.3;
  for (const double gamma : {-0.08, 0.0, 0.05}) {
    const magic::Mf61Slips<double> slips{0.03, 0.06, gamma};
    const TyreForces<double> before = magic_formula_61<double>(set, 5200, slips, kNominalPressure);
    const double mx = magic_formula_61<double>(newer, 5200, slips, kNominalPressure).mx;
    const double added = set.unloaded_radius * set.lmx *
                         (before.fy * (0.02 + 0.3 * std::abs(gamma)) - 5200 * 0.7 * gamma * std::abs(gamma));
    EXPECT_NEAR(mx - before.mx, added, 1e-10);
    EXPECT_GT(std::abs(added), 10);
  }
}

// Friction of a road that scales the tyre's acts as LMUX and LMUY do, on shifts by (4.E8) too.
TEST(Mf61, FrictionOfTheRoadIsAScalingFactor) {
  const Set set = passenger_car();
  Set scaled = set;
  scaled.lmux *= 0.4;
  scaled.lmuy *= 0.4;
  const magic::Mf61Slips<double> slips{0.02, -0.05, 0.04};
  const TyreForces<double> a = magic_formula_61<double>(set, 5000, slips, kNominalPressure, 0.4);
  const TyreForces<double> b = magic_formula_61<double>(scaled, 5000, slips, kNominalPressure);
  EXPECT_DOUBLE_EQ(a.fx, b.fx);
  EXPECT_DOUBLE_EQ(a.fy, b.fy);
  EXPECT_NEAR(a.mz, b.mz, 1e-12 * std::abs(b.mz));
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
      const TyreForces<double> across = magic_formula_61<double>(set, fz, {0, std::atan(slip), 0}, 8e5);
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
