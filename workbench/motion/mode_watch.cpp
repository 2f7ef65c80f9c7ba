#include "workbench/motion/mode_watch.hpp"

#include <algorithm>
#include <cmath>

#include "compiler/algebra/dense.hpp"
#include "workbench/motion/step_verdict.hpp"

namespace mbgen {
namespace {

/// Relative distance below which two eigenvalues belong together.
constexpr double kSameEigenvalue = 1e-6;

/// Left eigenvector: its product with the states of a mode is 1, with the states of the other modes 0.
Eigen::VectorXcd left_vector(const EigenVectors& rows, const Mode& mode) {
  const Eigen::Map<const Eigen::VectorXcd> right(mode.states.data(), static_cast<Eigen::Index>(mode.states.size()));
  Eigen::VectorXcd best = Eigen::VectorXcd::Zero(right.size());
  double most = 0;
  for (Eigen::Index i = 0; i < rows.values.size(); ++i) {
    if (std::abs(rows.values[i] - mode.eigenvalue) > kSameEigenvalue * std::abs(mode.eigenvalue)) continue;
    const std::complex<double> product = (rows.vectors.col(i).transpose() * right)(0, 0);
    if (std::abs(product) <= most) continue;
    most = std::abs(product);
    best = rows.vectors.col(i) / product;
  }
  return best;
}

/// Kinetic energy of velocities at the positions of a state, J.
double kinetic_energy(const Compilation& compilation, GenericSolver& solver, GenericState state,
                      const std::vector<double>& free_velocities) {
  std::fill(state.zd.begin(), state.zd.end(), 0.0);
  const std::vector<int> free = free_coordinates(compilation.topology, compilation.analysis);
  for (std::size_t i = 0; i < free.size(); ++i) state.zd[free[i]] = free_velocities[i];
  if (!solver.project(state).ok()) return 0;
  double sum = 0;
  for (const double energy : solver.exchanges(state).kinetic) sum += energy;
  return sum;
}

}  // namespace

ModeWatch::ModeWatch(const Compilation& compilation, const Engine& engine, const GenericState& start,
                     const std::vector<double>& inputs, SolverSettings::Integrator integrator,
                     const SimulationSettings& settings)
    : compilation_(compilation), start_(start) {
  const LinearSystem system = system_near(compilation, engine, start, inputs);
  modes_ = mbgen::modes(system);
  energies_.assign(modes_.size(), 0.0);
  const double duration = static_cast<double>(settings.steps) * settings.step;
  std::optional<GenericSolver> solver;
  std::optional<EigenVectors> rows;
  for (std::size_t m = 0; m < modes_.size(); ++m) {
    const Mode& mode = modes_[m];
    if (!mode.oscillates()) continue;
    if (robbed_share(integrator, mode, settings.step, duration) <= kRobbed &&
        turned_phase(integrator, mode, settings.step, duration) <= kTurnedPhase)
      continue;
    if (!rows) {
      rows = eigenvectors(system.A.transpose());
      solver.emplace(compilation.model, compilation.topology, compilation.analysis);
      solver->set_inputs(inputs);
    }
    std::vector<double> real, imaginary;
    const std::size_t count = free_coordinates(compilation.topology, compilation.analysis).size();
    for (std::size_t i = 0; i < count; ++i) {
      real.push_back(mode.states[count + i].real());
      imaginary.push_back(mode.states[count + i].imag());
    }
    // A share q makes velocities of 2 Re(q shape): the largest kinetic energy is the energy of the mode.
    const double energy = 4 * (kinetic_energy(compilation, *solver, start, real) +
                               kinetic_energy(compilation, *solver, start, imaginary));
    const double sine = std::sin(std::min(mode.eigenvalue.imag() * settings.step, 3.1) / 2);
    watched_.push_back({m, left_vector(*rows, mode), energy, std::min(1.0, 4 * sine * sine)});
  }
}

void ModeWatch::add(const Sample& sample) {
  if (watched_.empty() || largest_absolute(sample.moving.charts) > 0) return;
  const std::vector<double> deviations = deviations_from(compilation_, start_, sample.moving);
  const Eigen::Map<const Eigen::VectorXd> states(deviations.data(), static_cast<Eigen::Index>(deviations.size()));
  for (Watched& watched : watched_) {
    const std::complex<double> share = (watched.left.transpose() * states.cast<std::complex<double>>())(0, 0);
    if (samples_ >= 2) {
      const double size = std::abs(share - 2.0 * watched.last[0] + watched.last[1]) / watched.gain;
      energies_[watched.mode] = std::max(energies_[watched.mode], watched.energy * size * size);
    }
    watched.last[1] = watched.last[0];
    watched.last[0] = share;
  }
  ++samples_;
}

}  // namespace mbgen
