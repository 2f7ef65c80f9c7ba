// The drift of a step put back in lanes: a body on a rod all around its circle, where the frozen choice of the
// dependent coordinate is fair, poor, and none.

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <numbers>

#include "mbgen/lanes/batch.hpp"

namespace mbgen {
namespace {

constexpr double kLength = 0.5;         // m
constexpr double kUsualPivot = 0.9;     // where the choice was made
constexpr double kDrift = 1e-7;         // m and m/s, far above the closure tolerance
constexpr double kSecondOrder = 1e-13;  // m and m/s: the drift squared over the length

struct Parameters {
  double unused;
};
struct NoInputs {
  double unused;
};
template <class T>
struct StateOf {
  T z[2], zd[2], x[1], t;
};
template <class T>
struct ClosureOf {
  T residual[1], dz[2], zd[2], pivot[1], Rz[2];
};

/// (x^2 + z^2 - l^2) / 2l = 0 solved for z.
template <class T>
void close(const StateOf<T>& state, ClosureOf<T>& values) noexcept {
  const T along_x = state.z[0] / kLength, along_z = state.z[1] / kLength;
  values.residual[0] = (state.z[0] * along_x + state.z[1] * along_z - kLength) * 0.5;
  values.dz[0] = T{};
  values.dz[1] = T{} - values.residual[0] / along_z;
  values.Rz[0] = T{} + 1.0;
  values.Rz[1] = T{} - along_x / along_z;
  values.zd[0] = state.zd[0];
  values.zd[1] = values.Rz[1] * state.zd[0];
  values.pivot[0] = mbgen::abs(along_z) / kUsualPivot;
}

/// Common part of the solvers of one body and of lanes.
struct Rod {
  using Parameters = ::mbgen::Parameters;
  using Inputs = NoInputs;
  static constexpr int kCoordinates = 2, kAuxiliaryStates = 0, kBlocks = 1, kEquations = 1, kDrives = 0;
  static constexpr int kBlockCoordinates = 2;
  static constexpr bool kHasClosure = true;
  static constexpr double kClosureTolerance = 1e-12;
  static constexpr unsigned char kDriven[] = {0, 0}, kRedundant[] = {0}, kBlockDriven[] = {0, 0};
  static constexpr int kDriveCoordinate[] = {0}, kBlockCoordinate[] = {0, 1};
  static constexpr BlockLayout kBlockLayout[] = {{1, 2, 1, 1, 0, 0, 0, 0, kUsualPivot}};
};

struct One : Rod {
  using State = StateOf<double>;
  using Closure = ClosureOf<double>;
  struct ClosureTerms {
    double Phi[1], Jz[2];
  };
  struct Projection {
    double Rz[2];
  };
  static constexpr double Parameters::*kParameterMember[] = {nullptr};
  static constexpr double Inputs::*kInputMember[] = {nullptr};
  static double argument_sum(const Parameters&, const Inputs&) noexcept { return 0; }
  static void closure(const Parameters&, const Inputs&, const State& state, Closure& result) noexcept {
    close(state, result);
  }
  static void closure_terms(const Parameters&, const Inputs&, const State& state, ClosureTerms& result) noexcept {
    Closure closed;
    close(state, closed);
    result = {{closed.residual[0]}, {state.z[0] / kLength, state.z[1] / kLength}};
  }
};

struct Lanes : Rod {
  static constexpr int kLanes = 8, kGroups = kLanes / lanes_of_vectors(kLanes);
  using Vector = LaneTypes<kLanes / kGroups>::Lanes;
  using Row = RowOf<Vector, kGroups>;
  using Mask = MaskOf<Row>;
  using State = StateOf<Row>;
  using Closure = ClosureOf<Row>;
  struct JointForces {
    Row tau[2];
  };
  static Vector argument_sum(const Parameters&, const Inputs&) noexcept { return Vector{}; }
  static void closure(const Parameters*, const Inputs*, const StateOf<Vector>* state,
                      ClosureOf<Vector>* result) noexcept {
    for (int g = 0; g < kGroups; ++g) close(state[g], result[g]);
  }
};

/// The body at an angle from the lowest point, by its drift too far out and too fast outwards.
One::State drifted(double angle) {
  const double s = std::sin(angle), c = std::cos(angle), speed = 3;
  return {{(kLength + kDrift) * s, -(kLength + kDrift) * c}, {speed * c + kDrift * s, speed * s - kDrift * c}, {0}, 0};
}

void set_lane(Lanes::State& all, int lane, const One::State& one) {
  for (int i = 0; i < 2; ++i) {
    all.z[i][lane] = one.z[i];
    all.zd[i][lane] = one.zd[i];
  }
  all.x[0][lane] = all.t[lane] = 0;
}

bool has_bits(double a, double b) { return std::memcmp(&a, &b, sizeof a) == 0; }

/// Expects what project_motion does of a lane that came through.
void expect_as_alone(const Lanes::State& all, int lane, double angle) {
  One::State one = drifted(angle);
  const One::State start = one;
  ASSERT_TRUE(project_motion<One>({}, {}, one).ok()) << angle;
  for (int i = 0; i < 2; ++i) {
    EXPECT_TRUE(has_bits(all.z[i][lane], one.z[i])) << angle;
    EXPECT_TRUE(has_bits(all.zd[i][lane], one.zd[i])) << angle;
  }
  if (std::abs(std::cos(angle)) / kUsualPivot >= kFairPivot<double>) return;
  // Shortest: nothing along the circle, though dependents alone would move by the drift times the tangent.
  const double s = std::sin(angle), c = std::cos(angle);
  EXPECT_NEAR(c * (one.z[0] - start.z[0]) + s * (one.z[1] - start.z[1]), 0, kSecondOrder) << angle;
  EXPECT_NEAR(c * (one.zd[0] - start.zd[0]) + s * (one.zd[1] - start.zd[1]), 0, kSecondOrder) << angle;
}

TEST(LaneCorrections, ArePutBackTogetherDownToNearlySingularPivotsWithTheBitsOfOne) {
  constexpr int kAngles = 720;
  int poor = 0;
  for (int first = 0; first < kAngles; first += Lanes::kLanes) {
    const auto angle = [&](int lane) { return (first + lane + 0.5) * 2 * std::numbers::pi / kAngles; };
    Lanes::State all{};
    for (int lane = 0; lane < Lanes::kLanes; ++lane) set_lane(all, lane, drifted(angle(lane)));
    const unsigned good = bits_of(project_lanes_in_motion<Lanes>({}, {}, all));
    for (int lane = 0; lane < Lanes::kLanes; ++lane) {
      const double pivot = std::abs(std::cos(angle(lane))) / kUsualPivot;
      EXPECT_EQ((good >> lane & 1u) != 0, pivot >= kNearSingular<double>) << angle(lane);
      if ((good >> lane & 1u) != 0) expect_as_alone(all, lane, angle(lane));
      poor += pivot >= kNearSingular<double> && pivot < kFairPivot<double> ? 1 : 0;
    }
  }
  EXPECT_GT(poor, kAngles / 4);
}

}  // namespace
}  // namespace mbgen
