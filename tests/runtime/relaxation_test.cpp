// Relaxation lengths over the load.

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

#include "mbgen/tyres/tyre.hpp"

namespace mbgen {
namespace {

template <class Set, std::size_t N>
Set set_of(const TyreField (&fields)[N], std::initializer_list<TyreField> given) {
  double values[N];
  for (std::size_t i = 0; i < N; ++i) {
    values[i] = fields[i].default_value;
    for (const TyreField& field : given)
      if (std::strcmp(field.name, fields[i].name) == 0) values[i] = field.default_value;
  }
  return Set::from_fields(values);
}

const auto kMf52 = set_of<Pac2002<double>>(kPac2002Fields, {{"UNLOADED_RADIUS", 0.3},
                                                            {"FNOMIN", 4000},
                                                            {"PCX1", 1.6},
                                                            {"PDX1", 1},
                                                            {"PKX1", 20},
                                                            {"PCY1", 1.3},
                                                            {"PDY1", 1},
                                                            {"PKY1", -15},
                                                            {"PKY2", 1.5},
                                                            {"PKY3", 0.5},
                                                            {"PTX1", 1.5},
                                                            {"PTX2", 0.6},
                                                            {"PTX3", 0.2},
                                                            {"PTY1", 2.1},
                                                            {"PTY2", 1.8},
                                                            {"LSGKP", 1.1},
                                                            {"LSGAL", 0.9},
                                                            {"LFZO", 1.05}});
const auto kMf61 = set_of<MagicFormula61<double>>(kMf61Fields, {{"UNLOADED_RADIUS", 0.3},
                                                                {"FNOMIN", 4000},
                                                                {"NOMPRES", 2e5},
                                                                {"PCX1", 1.6},
                                                                {"PDX1", 1},
                                                                {"PKX1", 20},
                                                                {"PKX3", 0.2},
                                                                {"PPX1", -0.3},
                                                                {"PCY1", 1.3},
                                                                {"PDY1", 1},
                                                                {"PKY1", -15},
                                                                {"PKY2", 1.5},
                                                                {"PPY1", 0.1},
                                                                {"LONGITUDINAL_STIFFNESS", 3e5},
                                                                {"PCFX1", 0.2},
                                                                {"PCFX2", -0.1},
                                                                {"PCFX3", 0.3},
                                                                {"LATERAL_STIFFNESS", 1e5},
                                                                {"PCFY1", 0.1},
                                                                {"PCFY2", 0.05},
                                                                {"PCFY3", 0.4}});

TyreProperties<double> following() {
  TyreProperties<double> tyre{0.3, 2e5, 0, 1, 0, 0.4, 0.5, 2};
  tyre.pressure = 2.4e5;
  tyre.over_load_x = tyre.over_load_y = 1;
  return tyre;
}

/// Under a load of 2e5 N/m.
TyreContact<double> under(double load, double camber = 0) { return {load / 2e5, 0, 20, 0, 0, camber, 0, 0}; }

TEST(Relaxation, FollowsTheLoadAsMf52HasIt) {
  for (const double load : {1500.0, 4000.0, 6000.0}) {
    const auto sigma = tyre_law::relaxation(kMf52, following(), under(load, 0.1));
    const double dfz = load / 4200 - 1;
    EXPECT_NEAR(sigma.x, load / 4000 * (1.5 + 0.6 * dfz) * std::exp(-0.2 * dfz) * 0.3 * 1.1, 1e-14);
    EXPECT_NEAR(sigma.y, 2.1 * std::sin(2 * std::atan(load / (1.8 * 4200))) * (1 - 0.5 * 0.1) * 0.3 * 1.05 * 0.9,
                1e-14);
  }
}

TEST(Relaxation, IsSlipStiffnessOverCarcassOfMf61) {
  for (const double load : {1500.0, 4000.0, 6000.0}) {
    const auto sigma = tyre_law::relaxation(kMf61, following(), under(load));
    const double dfz = load / 4000 - 1, dpi = 0.2;
    const double carcass_x = 3e5 * (1 + 0.2 * dfz - 0.1 * dfz * dfz) * (1 + 0.3 * dpi);
    EXPECT_NEAR(sigma.x, load * 20 * std::exp(0.2 * dfz) * (1 - 0.3 * dpi) / carcass_x, 1e-13);
    const double carcass_y = 1e5 * (1 + 0.1 * dfz + 0.05 * dfz * dfz) * (1 + 0.4 * dpi);
    const double cornering = 15 * 4000 * std::sin(2 * std::atan(load / (1.5 * 4000))) * (1 + 0.1 * dpi);
    EXPECT_NEAR(sigma.y, cornering / carcass_y, 1e-13);
  }
}

TEST(Relaxation, IsThePropertyUnlessTheSetGivesItAndKeepsItsLimits) {
  TyreProperties<double> tyre = following();
  tyre.over_load_y = 0;
  EXPECT_EQ(tyre_law::relaxation(kMf52, tyre, under(6000)).y, 0.5);
  EXPECT_EQ(tyre_law::relaxation(kMf61, tyre, under(6000)).y, 0.5);
  EXPECT_NEAR(tyre_law::relaxation(kMf52, tyre, under(-100)).x, 0.08, 1e-15) << "off the road a fifth";
}

TEST(Relaxation, ASmallSlipBuildsUpOverIt) {
  const TyreProperties<double> tyre = following();
  for (const double load : {2000.0, 6000.0}) {
    TyreContact<double> contact = under(load);
    contact.vy = 20 * 1e-4;
    contact.spin = 20 / tyre_law::rolling_radius(kMf61, tyre, contact);
    const double step = 1e-5, length = tyre_law::relaxation(kMf61, tyre, contact).y;
    for (int i = 0; i * step * 20 < length; ++i) contact.v += step * tyre_forces(kMf61, tyre, contact).dv;
    EXPECT_NEAR(tyre_forces(kMf61, tyre, contact).alpha, 1e-4 * (1 - std::exp(-1.0)), 1e-7);
  }
}

}  // namespace
}  // namespace mbgen
