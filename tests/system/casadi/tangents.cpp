// The functions for CasADi of models/sensitivities/four_bar.json against its solver with derivatives.

#include <cmath>
#include <cstdio>
#include <vector>

#include "sensitive_four_bar_tangents.hpp"

namespace solver = sensitive_four_bar_tangents;

extern "C" {
int jac_sensitive_four_bar_f(const double** arg, double** res, long long* iw, double* w, int mem);
int sensitive_four_bar_f(const double** arg, double** res, long long* iw, double* w, int mem);
int jac_sensitive_four_bar_f_work(long long* sz_arg, long long* sz_res, long long* sz_iw, long long* sz_w);
const long long* jac_sensitive_four_bar_f_sparsity_out(long long i);
}

namespace {

constexpr int kStates = 3, kParameters = 8, kColumns = kStates + kParameters;
constexpr solver::Real solver::Parameters::*kMembers[kParameters] = {
    &solver::Parameters::k,  &solver::Parameters::c,  &solver::Parameters::L0, &solver::Parameters::m2,
    &solver::Parameters::I2, &solver::Parameters::l2, &solver::Parameters::l3, &solver::Parameters::g};
constexpr int kHeld = static_cast<int>(solver::Coordinate::coupler_pin);

struct Rates {
  double value[kStates] = {}, by[kStates][kColumns] = {};
};

/// Rates of the states and their derivatives by the solver with derivatives, some columns at a time.
bool find(const double* x, Rates& rates) {
  for (int first = 0; first < kColumns; first += 8) {
    const auto along = [&](double value, int column) {
      return column >= first && column < first + 8 ? solver::Real::along(value, column - first) : solver::Real(value);
    };
    solver::Parameters parameters;
    for (int p = 0; p < kParameters; ++p) parameters.*kMembers[p] = along((parameters.*kMembers[p]).value, kStates + p);
    solver::State state = solver::initial_state();
    const solver::Tuned tuned(parameters);
    unsigned char held[solver::kCoordinates] = {};
    held[kHeld] = 1;
    const double from = state.z[kHeld].value;
    for (int part = 1; part <= 9; ++part) {
      // Newton from 1e-5 beside ends at rounding; from farther away it may end at the tolerance of 1e-12.
      for (int c = 0; c < solver::kCoordinates && part == 9; ++c) state.z[c] += 1e-5;
      state.z[kHeld] = along(part < 8 ? from + part / 8.0 * (x[0] - from) : x[0], 0);
      state.zd[kHeld] = along(x[1], 1);
      if (!solver::assemble_holding(tuned, {}, held, state).ok()) return false;
    }
    state.x[0] = along(x[2], 2);
    solver::Derivative derivative;
    const solver::Real none[solver::kCoordinates] = {};
    if (!solver::accelerations(tuned, {}, state, none, derivative).ok()) return false;
    const solver::Real found[kStates] = {state.zd[kHeld], derivative.zdd[kHeld], derivative.xd[0]};
    for (int i = 0; i < kStates; ++i) {
      rates.value[i] = found[i].value;
      for (int j = first; j < kColumns && j < first + 8; ++j) rates.by[i][j] = found[i].tangent[j - first];
    }
  }
  return true;
}

}  // namespace

int main() {
  const double p[kParameters] = {200, 3, 0.5, 2, 0.15, 0.9, 0.6, 9.81};
  long long sizes[4];
  jac_sensitive_four_bar_f_work(&sizes[0], &sizes[1], &sizes[2], &sizes[3]);
  std::vector<double> w(static_cast<std::size_t>(sizes[3]));
  double worst_value = 0, worst_slope = 0;
  for (int k = 0; k < 12; ++k) {
    const double x[kStates] = {-1.4883257 + 0.08 * (k - 6), 3 * std::sin(k + 1.0), 0.1 * k};
    Rates exact;
    if (!find(x, exact)) return std::printf("the solver has no accelerations at %g\n", x[0]), 1;
    double xdot[kStates], of_x[kStates * kStates], of_p[kStates * kParameters];
    const double* arg[4] = {x, nullptr, p, nullptr};
    double *value[1] = {xdot}, *slopes[3] = {of_x, nullptr, of_p};
    if (sensitive_four_bar_f(arg, value, nullptr, w.data(), 0) != 0 ||
        jac_sensitive_four_bar_f(arg, slopes, nullptr, w.data(), 0) != 0)
      return std::printf("f has no value at %g\n", x[0]), 1;
    for (int i = 0; i < kStates; ++i)
      worst_value =
          std::fmax(worst_value, std::fabs(xdot[i] - exact.value[i]) / std::fmax(1, std::fabs(exact.value[i])));
    double found[kStates][kColumns] = {};
    for (int block = 0; block < 3; block += 2) {
      const long long* sp = jac_sensitive_four_bar_f_sparsity_out(block);
      for (int j = 0; j < sp[1]; ++j)
        for (long long e = sp[2 + j]; e < sp[3 + j]; ++e)
          found[sp[3 + sp[1] + e]][(block == 0 ? 0 : kStates) + j] = slopes[block][e];
    }
    for (int i = 0; i < kStates; ++i)
      for (int j = 0; j < kColumns; ++j)
        worst_slope =
            std::fmax(worst_slope, std::fabs(found[i][j] - exact.by[i][j]) / std::fmax(1, std::fabs(exact.by[i][j])));
  }
  std::printf("sensitive_four_bar: f within %.1e of the solver, Jacobian within %.1e\n", worst_value, worst_slope);
  return worst_value < 1e-12 && worst_slope < 1e-9 ? 0 : 1;
}
