// The magic formulas against reference values that mbgen did not make (tests/data/tyre_magic_formula.json), and their
// behaviour at the edges.

#include "mbgen/tyres/tyre.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace mbgen {
namespace {

const double kDegree = std::acos(-1.0) / 180;
// The formulas are deterministic; the reference values carry rounding only.
constexpr double kReferenceTolerance = 1e-11;

const nlohmann::json& magic_formulas() {
  static const nlohmann::json data =
      nlohmann::json::parse(std::ifstream(MBGEN_SOURCE_DIR "/tests/data/tyre_magic_formula.json"));
  return data;
}

Pac2002<double> pac2002_set(const std::string& name) {
  const nlohmann::json& parameters = magic_formulas()[name]["parameters"];
  std::vector<double> values;
  for (const TyreField& field : kPac2002Fields) values.push_back(parameters.value(field.name, field.default_value));
  return Pac2002<double>::from_fields(values.data());
}

Pac89<double> pac89_set() {
  const nlohmann::json& entry = magic_formulas()["pac89_chrono_hmmwv_truck_characteristic"];
  std::vector<double> values;
  for (const char* group : {"a", "b", "c"}) {
    for (const double value : entry[group]) values.push_back(value);
  }
  return Pac89<double>::from_fields(values.data());
}

/// Largest difference of each column over the column's largest value.
class Comparison {
 public:
  void add(const std::string& column, double value, double expected) {
    Column& c = columns_[column];
    c.difference = std::max(c.difference, std::abs(value - expected));
    c.scale = std::max(c.scale, std::abs(expected));
  }
  void expect_within(double tolerance) const {
    for (const auto& [name, c] : columns_) {
      EXPECT_GT(c.scale, 0) << name;
      EXPECT_LT(c.difference, tolerance * c.scale) << name;
    }
  }

 private:
  struct Column {
    double difference = 0, scale = 0;
  };
  std::map<std::string, Column> columns_;
};

class Pac2002Reference : public testing::TestWithParam<const char*> {};

TEST_P(Pac2002Reference, EveryForceOfEveryRow) {
  const Pac2002<double> set = pac2002_set(GetParam());
  const nlohmann::json& rows = magic_formulas()[GetParam()]["rows"];
  ASSERT_EQ(rows.size(), 588u);
  Comparison comparison;
  for (const std::vector<double> row : rows) {
    const TyreForces<double> pure = magic_formula_pac2002_pure(set, row[0], row[1], row[2], row[3]);
    const TyreForces<double> combined = magic_formula_pac2002(set, row[0], row[1], row[2], row[3]);
    comparison.add("Fx0", pure.fx, row[4]);
    comparison.add("Fy0", pure.fy, row[5]);
    comparison.add("Mz0", pure.mz, row[6]);
    comparison.add("Fx", combined.fx, row[7]);
    comparison.add("Fy", combined.fy, row[8]);
    comparison.add("Mz", combined.mz, row[9]);
  }
  comparison.expect_within(kReferenceTolerance);
}

INSTANTIATE_TEST_SUITE_P(Sets, Pac2002Reference,
                         testing::Values("citybus_315_80_R22.5", "feda_335_65_R22.5_95psi", "mfeval_MF52_sample"),
                         [](const auto& set) { return std::string(set.param).substr(0, 4); });

TEST(Pac89Reference, EveryForceOfEveryRow) {
  const Pac89<double> set = pac89_set();
  const nlohmann::json& rows = magic_formulas()["pac89_chrono_hmmwv_truck_characteristic"]["rows"];
  ASSERT_EQ(rows.size(), 392u);
  Comparison comparison;
  for (const std::vector<double> row : rows) {
    const TyreForces<double> pure =
        magic_formula_pac89_pure(set, 1e3 * row[0], 0.01 * row[2], kDegree * row[1], kDegree * row[3]);
    comparison.add("Fx", pure.fx, row[4]);
    comparison.add("Fy", pure.fy, row[5]);
    comparison.add("Mz", pure.mz, row[6]);
  }
  comparison.expect_within(kReferenceTolerance);
}

TEST(Pac2002, SpotValueOfTheCityBus) {
  const Pac2002<double> set = pac2002_set("citybus_315_80_R22.5");
  const TyreForces<double> forces = magic_formula_pac2002(set, 35000.0, -0.1, 0.06, 0.0);
  EXPECT_NEAR(forces.fx, -24222.484474, 1e-6);
  EXPECT_NEAR(forces.fy, -8801.330815, 1e-6);
  EXPECT_NEAR(forces.mz, 362.671361, 1e-6);
  EXPECT_NEAR(magic_formula_pac2002_pure(set, 35000.0, -0.1, 0.06, 0.0).mz, 429.505392, 1e-6);
}

TEST(Pac2002, OverturningMomentIsTheFormula) {
  // R0 Fz (qSx1 - qSx2 gamma + qSx3 Fy / Fz0) with the numbers of the MF5.2 sample.
  const Pac2002<double> set = pac2002_set("mfeval_MF52_sample");
  const TyreForces<double> forces = magic_formula_pac2002(set, 6000.0, 0.02, 0.05, 0.03);
  EXPECT_NEAR(forces.mx, 0.4 * 6000 * (-0.003093 - 0.6038 * 0.03 + 0.025405 * forces.fy / 9416.6), 1e-10);
}

TEST(Pac2002, ScalingFactorsActWhereTheyShould) {
  const Pac2002<double> plain = pac2002_set("mfeval_MF52_sample");
  const auto at = [](const Pac2002<double>& set) { return magic_formula_pac2002_pure(set, 5000.0, 0.03, 0.04, 0.02); };
  // Friction and stiffness scaled together scale a pure force without changing its shape; so does the friction argument
  // on the sliding branch.
  Pac2002<double> scaled = plain;
  scaled.lmux = scaled.lkx = scaled.lmuy = scaled.lky = 0.5;
  EXPECT_NEAR(at(scaled).fx, 0.5 * at(plain).fx, 1e-9);
  EXPECT_NEAR(at(scaled).fy, 0.5 * at(plain).fy, 1e-9);
  // A nominal load scaled with the load leaves everything per nominal load alone.
  scaled = plain;
  scaled.lfzo = 2;
  const TyreForces<double> doubled = magic_formula_pac2002_pure(scaled, 10000.0, 0.03, 0.04, 0.02);
  EXPECT_NEAR(doubled.fx, 2 * at(plain).fx, 1e-9);
  EXPECT_NEAR(doubled.fy, 2 * at(plain).fy, 1e-9);
  EXPECT_NEAR(doubled.mz, 2 * at(plain).mz, 1e-10);
  // Every other factor changes something, and only for the forces it belongs to.
  struct Factor {
    double Pac2002<double>::*member;
    bool fx, fy, mz, mx;
  };
  using Set = Pac2002<double>;
  const Factor factors[] = {{&Set::lcx, true, false, true, false},   {&Set::lex, true, false, true, false},
                            {&Set::lhx, true, false, true, false},   {&Set::lvx, true, false, true, false},
                            {&Set::lgax, true, false, true, false},  {&Set::lcy, false, true, true, true},
                            {&Set::ley, false, true, true, true},    {&Set::lhy, false, true, true, true},
                            {&Set::lvy, false, true, true, true},    {&Set::lgay, false, true, true, true},
                            {&Set::ltr, false, false, true, false},  {&Set::lres, false, false, true, false},
                            {&Set::lgaz, false, false, true, false}, {&Set::lxal, true, false, true, false},
                            {&Set::lyka, false, true, true, true},   {&Set::lvyka, false, true, true, true},
                            {&Set::ls, false, false, true, false},   {&Set::lmx, false, false, false, true},
                            {&Set::lvmx, false, false, false, true}};
  const auto combined = [](const Set& set) { return magic_formula_pac2002(set, 5000.0, 0.03, 0.04, 0.02); };
  const TyreForces<double> before = combined(plain);
  for (const Factor& factor : factors) {
    Set set = plain;
    set.*factor.member = 1.1;
    const TyreForces<double> after = combined(set);
    const auto index = static_cast<int>(&factor - factors);
    EXPECT_EQ(after.fx != before.fx, factor.fx) << index;
    EXPECT_EQ(after.fy != before.fy, factor.fy) << index;
    EXPECT_EQ(after.mz != before.mz, factor.mz) << index;
    EXPECT_EQ(after.mx != before.mx, factor.mx) << index;
  }
}

TEST(Pac2002, FieldsAreNamedAndOrderedAsTheMembers) {
  std::vector<double> values(kPac2002Count);
  for (std::size_t i = 0; i < kPac2002Count; ++i) values[i] = static_cast<double>(i);
  const Pac2002<double> set = Pac2002<double>::from_fields(values.data());
  const auto value_named = [&](const std::string& name) {
    for (std::size_t i = 0; i < kPac2002Count; ++i) {
      if (name == kPac2002Fields[i].name) return values[i];
    }
    return -1.0;
  };
  EXPECT_EQ(set.unloaded_radius, value_named("UNLOADED_RADIUS"));
  EXPECT_EQ(set.lmy, value_named("LMY"));
  EXPECT_EQ(set.pkx3, value_named("PKX3"));
  EXPECT_EQ(set.rvy6, value_named("RVY6"));
  EXPECT_EQ(set.ssz4, value_named("SSZ4"));
  EXPECT_EQ(set.qsx3, value_named("QSX3"));
  for (const TyreField& field : kPac2002Fields) {
    const bool scaling = field.name[0] == 'L';
    EXPECT_EQ(field.default_value, scaling ? 1.0 : 0.0) << field.name;
  }
}

template <class Formula>
void expect_guarded(const Formula& formula) {
  for (const double kappa : {-100.0, -1.0, 0.0, 0.3, 100.0}) {
    for (const double alpha : {-1.57, -0.2, 0.0, 0.2, 1.57}) {
      for (const double gamma : {-0.3, 0.0, 0.3}) {
        for (const double load : {0.0, -1000.0}) {
          const TyreForces<double> none = formula(load, kappa, alpha, gamma, 1.0);
          EXPECT_TRUE(none.fx == 0 && none.fy == 0 && none.mz == 0 && none.mx == 0);
        }
        for (const double load : {1e-300, 1e-3, 1.0, 30000.0, 1e6}) {
          for (const double friction : {0.0, 1e-3, 1.0}) {
            const TyreForces<double> f = formula(load, kappa, alpha, gamma, friction);
            ASSERT_TRUE(std::isfinite(f.fx + f.fy + f.mz + f.mx))
                << load << " " << kappa << " " << alpha << " " << gamma << " " << friction;
          }
        }
      }
    }
  }
}

TEST(MagicFormula, WithoutLoadIsExactlyZeroAndNeverNaN) {
  for (const char* name : {"citybus_315_80_R22.5", "feda_335_65_R22.5_95psi", "mfeval_MF52_sample"}) {
    const Pac2002<double> set = pac2002_set(name);
    expect_guarded([&](double fz, double kappa, double alpha, double gamma, double friction) {
      return magic_formula_pac2002(set, fz, kappa, alpha, gamma, friction);
    });
  }
  const Pac89<double> set = pac89_set();
  expect_guarded([&](double fz, double kappa, double alpha, double gamma, double friction) {
    return magic_formula_pac89(set, fz, kappa, alpha, gamma, friction);
  });
}

TEST(Pac89, CombinedSlipIsPureAlongEachAxisAndStaysOnTheEllipse) {
  const Pac89<double> set = pac89_set();
  const double load = 20000;
  double peak_x = 0, peak_y = 0;
  for (double slip = 0; slip < 1; slip += 1e-3) {
    peak_x = std::max(peak_x, magic_formula_pac89_pure(set, load, slip, 0.0, 0.0).fx);
    peak_y = std::max(peak_y, magic_formula_pac89_pure(set, load, 0.0, slip, 0.0).fy);
  }
  for (const double slip : {-0.4, -0.05, 0.02, 0.1, 0.7}) {
    const TyreForces<double> along = magic_formula_pac89(set, load, slip, 0.0, 0.01);
    const TyreForces<double> across = magic_formula_pac89(set, load, 0.0, slip, 0.01);
    EXPECT_NEAR(along.fx, magic_formula_pac89_pure(set, load, slip, 0.0, 0.01).fx, 1e-9);
    EXPECT_NEAR(across.fy, magic_formula_pac89_pure(set, load, 0.0, slip, 0.01).fy, 1e-9);
    EXPECT_NEAR(across.mz, magic_formula_pac89_pure(set, load, 0.0, slip, 0.01).mz, 1e-9);
  }
  for (double kappa = -0.5; kappa <= 0.5; kappa += 0.05) {
    for (double alpha = -0.5; alpha <= 0.5; alpha += 0.05) {
      const TyreForces<double> f = magic_formula_pac89(set, load, kappa, alpha, 0.0);
      EXPECT_LE(std::hypot(f.fx / peak_x, f.fy / peak_y), 1 + 1e-6) << kappa << " " << alpha;
    }
  }
  EXPECT_LT(std::abs(magic_formula_pac89(set, load, 0.3, 0.05, 0.0).fy),
            0.5 * std::abs(magic_formula_pac89(set, load, 0.0, 0.05, 0.0).fy));
}

}  // namespace
}  // namespace mbgen
