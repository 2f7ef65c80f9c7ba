#pragma once
// Singular positions of the loop blocks of a generated solver, where branches cross: positions, velocities and Rz of a
// block on its branch are smooth, though their equations divide by the smallest pivot. Nodes on both sides, clear of
// the singular position, give a polynomial for a whole step. `System` is described in blocks.hpp.
//
// Why it is exact enough: the free coordinates of a node lie on a straight line over time. Its closed position Z has
// the consistent velocity V = dZ/dt and, at zero free accelerations, the acceleration z* = dV/dt. So two nodes
// determine a polynomial of degree five; its second derivative, z*, has an error of the fourth power of the spacing,
// over 120.

#include "mbgen/number.hpp"
#include "mbgen/solver/passage_nodes.hpp"

namespace mbgen {

/// Largest share of the way that the polynomials of degree five and three may differ by in the middle: between nodes on
/// different branches they differ by a tenth.
template <class Real>
inline constexpr Real kPassageSmoothness = Real(1e-4);
template <>
inline constexpr float kPassageSmoothness<float> = 1e-2f;

namespace solver_detail {

/// Coefficients of every coordinate that crosses. Result: false where the nodes lie on different branches.
template <class System, class OfPassage>
bool interpolate_positions(const PassageWork<System>& work, OfPassage& passage) noexcept {
  using Real = RealOf<System>;
  const auto h = static_cast<Real>(passage.spacing);
  Real rough = 0, way = 0;
  for (int b = 0; b < System::kBlocks; ++b) {
    const BlockLayout& block = System::kBlockLayout[b];
    for (int c = 0; passage.crosses[b] != 0 && c < block.coordinates; ++c) {
      const int i = System::kBlockCoordinate[block.first_coordinate + c];
      const Real half = Real(0.5);
      const Real even = half * (work.z[0][i] + work.z[1][i]), odd = half * (work.z[0][i] - work.z[1][i]);
      const Real even_rate = half * h * (work.zd[0][i] - work.zd[1][i]);
      const Real odd_rate = half * h * (work.zd[0][i] + work.zd[1][i]);
      const Real even_bend = half * h * h * (work.zdd_star[0][i] + work.zdd_star[1][i]);
      const Real odd_bend = half * h * h * (work.zdd_star[0][i] - work.zdd_star[1][i]);
      const Real fourth = (even_bend - even_rate) / 8, second = half * (even_rate - 4 * fourth);
      const Real fifth = (odd_bend - 3 * (odd_rate - odd)) / 8, third = half * (odd_rate - odd - 4 * fifth);
      const Real terms[kPassageTerms] = {even - second - fourth, odd - third - fifth, second, third, fourth, fifth};
      for (int k = 0; k < kPassageTerms; ++k) passage.position[k][i] = terms[k];
      rough = magnitude(fourth) > rough ? magnitude(fourth) : rough;
      way = magnitude(odd) > way ? magnitude(odd) : way;
    }
  }
  return rough <= kPassageSmoothness<Real> * way;
}

/// Coefficients of Rz by the cubics through four nodes at 1, -1, 2, -2.
template <class System, class OfPassage>
void interpolate_directions(const PassageWork<System>& work, OfPassage& passage) noexcept {
  using Real = RealOf<System>;
  for (int b = 0; b < System::kBlocks; ++b) {
    if (passage.crosses[b] == 0 || passage.is_led[b]) continue;
    const BlockLayout& block = System::kBlockLayout[b];
    for (int k = block.first_projection; k < block.first_projection + block.coordinates * block.free; ++k) {
      const Real half = Real(0.5);
      const Real even = half * (work.rz[0][k] + work.rz[1][k]), odd = half * (work.rz[0][k] - work.rz[1][k]);
      const Real far_even = half * (work.rz[2][k] + work.rz[3][k]), far_odd = half * (work.rz[2][k] - work.rz[3][k]);
      const Real second = (far_even - even) / 3, third = (far_odd - 2 * odd) / 6;
      const Real terms[kPassageNodes] = {even - second, odd - third, second, third};
      for (int m = 0; m < kPassageNodes; ++m) passage.rz[m][k] = terms[m];
    }
  }
}

/// Parameters of the blocks that cross. Result: false if a block has free directions and rests.
template <class System, class OfPassage>
bool take_leads(const typename System::State& middle, const PassageWork<System>& work, OfPassage& passage) noexcept {
  for (unsigned char& is_free : passage.is_free) is_free = 0;
  for (int b = 0; b < System::kBlocks; ++b) {
    const BlockLayout& block = System::kBlockLayout[b];
    passage.lead[b] = -1;
    passage.lead_rate[b] = 0;
    passage.is_led[b] = block.free == 0 || (block.free == 1 && !has_motion<System>(b));
    if (passage.crosses[b] == 0 || block.free == 0) continue;
    for (int c = block.first_coordinate; c < block.first_coordinate + block.coordinates; ++c) {
      const int i = System::kBlockCoordinate[c];
      if (System::kBlockDriven[c] != 0 || work.fixed[c] == 0) continue;
      passage.is_free[i] = 1;
      const double rate = static_cast<double>(middle.zd[i]);
      if (passage.lead[b] >= 0 && magnitude(rate) <= magnitude(passage.lead_rate[b])) continue;
      passage.lead[b] = i;
      passage.lead_start[b] = static_cast<double>(middle.z[i]);
      passage.lead_rate[b] = rate;
    }
    if (passage.lead_rate[b] == 0) return false;
  }
  return true;
}

/// Way of a block's parameter at a state, see Passage.
template <class OfPassage, class State>
double parameter_at(const OfPassage& passage, int b, const State& state) noexcept {
  const int lead = passage.lead[b];
  const double time = lead < 0 ? state.t - passage.t
                               : (static_cast<double>(state.z[lead]) - passage.lead_start[b]) / passage.lead_rate[b];
  return time / passage.spacing;
}

/// Value, first and second derivative by the parameter of a coordinate's position.
template <class Real, class OfPassage>
void position_at(const OfPassage& passage, int i, Real at, Real (&values)[3]) noexcept {
  values[0] = values[1] = values[2] = 0;
  for (int k = kPassageTerms - 1; k >= 0; --k) {
    values[2] = values[2] * at + 2 * values[1];
    values[1] = values[1] * at + values[0];
    values[0] = values[0] * at + passage.position[k][i];
  }
}

/// Rz of block b, row by row, from block.first_projection on.
template <class System, class OfPassage>
void directions_at(const OfPassage& passage, int b, RealOf<System> at, RealOf<System>* rz) noexcept {
  using Real = RealOf<System>;
  const BlockLayout& block = System::kBlockLayout[b];
  if (block.free == 0) return;
  if (passage.is_led[b]) {
    const auto way = static_cast<Real>(passage.spacing * passage.lead_rate[b]);
    for (int c = 0; c < block.coordinates; ++c) {
      Real values[3];
      position_at(passage, System::kBlockCoordinate[block.first_coordinate + c], at, values);
      rz[block.first_projection + c] = values[1] / way;
    }
    return;
  }
  for (int k = block.first_projection; k < block.first_projection + block.coordinates * block.free; ++k) {
    const auto& terms = passage.rz;
    rz[k] = terms[0][k] + at * (terms[1][k] + at * (terms[2][k] + at * terms[3][k]));
  }
}

/// Positions and velocities of block b on its branch, at the parameter of a state. A coordinate across the way adds
/// what Rz says.
template <class System, class OfPassage>
void put_across(const OfPassage& passage, int b, typename System::State& state) noexcept {
  using Real = RealOf<System>;
  const BlockLayout& block = System::kBlockLayout[b];
  const int* coordinate = System::kBlockCoordinate + block.first_coordinate;
  const auto at = static_cast<Real>(parameter_at(passage, b, state));
  const auto h = static_cast<Real>(passage.spacing);
  Real rz[projection_entries<System>()];
  rz[0] = 0;  // of blocks without free directions g++ does not see that nothing is read
  directions_at<System>(passage, b, at, rz);
  Real off[System::kBlockCoordinates], off_rate[System::kBlockCoordinates];  // of free coordinates, by direction
  int free = 0;
  for (int c = 0; c < block.coordinates; ++c) {
    const int i = coordinate[c];
    if (passage.is_free[i] == 0) continue;
    Real values[3];
    position_at(passage, i, at, values);
    off[free] = state.z[i] - values[0];
    off_rate[free++] = state.zd[i] - values[1] / h;
  }
  for (int c = 0; c < block.coordinates; ++c) {
    const int i = coordinate[c];
    if (passage.is_free[i] != 0) continue;
    Real values[3];
    position_at(passage, i, at, values);
    state.z[i] = values[0];
    state.zd[i] = values[1] / h;
    for (int q = 0; q < free; ++q) {
      const Real entry = rz[block.first_projection + c * free + q];
      state.z[i] += entry * off[q];
      state.zd[i] += entry * off_rate[q];
    }
  }
}

/// z* and Rz of block b at a state on its branch.
template <class System, class OfPassage>
void project_across(const OfPassage& passage, int b, const typename System::State& state,
                    typename System::Projection& projection) noexcept {
  using Real = RealOf<System>;
  const BlockLayout& block = System::kBlockLayout[b];
  const auto at = static_cast<Real>(parameter_at(passage, b, state));
  directions_at<System>(passage, b, at, projection.Rz);
  const int lead = passage.lead[b];
  const bool scales = lead >= 0 && !has_motion<System>(b);
  const double rate = scales ? static_cast<double>(state.zd[lead]) / passage.lead_rate[b] : 1;
  const auto square = static_cast<Real>(rate * rate / (passage.spacing * passage.spacing));
  for (int c = 0; c < block.coordinates; ++c) {
    const int i = System::kBlockCoordinate[block.first_coordinate + c];
    Real values[3];
    position_at(passage, i, at, values);
    projection.zdd_star[block.first_coordinate + c] = passage.is_free[i] != 0 ? Real(0) : square * values[2];
  }
}

/// Largest rate of a coordinate of the blocks that cross.
template <class System, class OfPassage>
double fastest_across(const OfPassage& passage, const typename System::State& state) noexcept {
  double fastest = 0;
  for (int b = 0; b < System::kBlocks; ++b) {
    const BlockLayout& block = System::kBlockLayout[b];
    for (int c = 0; passage.crosses[b] != 0 && c < block.coordinates; ++c) {
      const int i = System::kBlockCoordinate[block.first_coordinate + c];
      const auto size = static_cast<double>(magnitude(state.zd[i]));
      fastest = size > fastest ? size : fastest;
    }
  }
  return fastest;
}

}  // namespace solver_detail

namespace solver_detail {

/// See look_across; with the evaluations of the closures that it may take.
template <class System, class InputsAt, class OfPassage>
[[gnu::noinline]] Status find_passage(const typename System::Parameters& parameters, const InputsAt& inputs_at,
                                      const typename System::State& state, double h, OfPassage& passage,
                                      int& closures) noexcept {
  PassageWork<System> work;
  double distance = 1;
  if (closures-- <= 0) return {};
  const int first = blocks_that_cross<System>(parameters, inputs_at(state.t), state, work, passage.crosses, distance);
  if (first < 0) return {};
  const Status stays = {Code::loop_singular, first};
  const double fastest = fastest_across<System>(passage, state);
  if (!(fastest > 0)) return stays;
  double spacing = passage_reach(distance, h * fastest) / fastest;
  Reached reached = reach_nodes<System>(parameters, inputs_at, state, spacing, passage, work, closures);
  for (int tries = 1; reached == Reached::not_clear && tries < kPassageTries && closures > 0; ++tries) {
    spacing *= 2;
    reached = reach_nodes<System>(parameters, inputs_at, state, spacing, passage, work, closures);
  }
  if (reached != Reached::all || !take_leads<System>(state, work, passage)) return stays;
  passage.spacing = spacing;
  passage.t = state.t;
  if (!interpolate_positions<System>(work, passage)) return stays;
  interpolate_directions<System>(work, passage);
  // Branches that come close and do not cross leave the loop open where the smallest pivot would vanish.
  const double at_singular = (work.clear[1] - work.clear[0]) / (work.clear[1] + work.clear[0]);
  guess_node<System>(state, at_singular * spacing, work);
  for (int b = 0; b < System::kBlocks; ++b) {
    if (passage.crosses[b] != 0) put_across<System>(passage, b, work.state);
  }
  double clearance = 0;
  if (!project_crossing<System>(parameters, inputs_at(work.state.t), work.state, clearance, closures).ok())
    return stays;
  passage.is_met = distance < static_cast<double>(kSingular<RealOf<System>>);
  return {passage.is_met ? Code::singular_met : Code::near_singular, first};
}

}  // namespace solver_detail

/// The motion through a singular position at or near a state: `passage` is known then, for the blocks whose frozen
/// partition is bad there. singular_met or near_singular with the first of them; ok if there is none, then without a
/// passage. Fails: loop_singular if the motion does not lead through, not smoothly, or if branches only come close
/// there. inputs_at: of a time. h: s, of the step. Cost: at most kLookClosures evaluations of the closures.
template <class System, class InputsAt, class OfPassage>
Status look_across(const typename System::Parameters& parameters, const InputsAt& inputs_at,
                   const typename System::State& state, double h, OfPassage& passage) noexcept {
  passage.spacing = 0;
  const int most = passage.closures < kLookClosures ? passage.closures : kLookClosures;
  int closures = most;
  const Status status = solver_detail::find_passage<System>(parameters, inputs_at, state, h, passage, closures);
  passage.closures -= most - (closures > 0 ? closures : 0);
  if (!status.ok()) passage.spacing = 0;
  return status;
}

/// Closes a state between the nodes of a passage: the blocks that cross by it, the others as in steps. Result: false,
/// and the state unchanged, where it does not reach.
template <class System, class OfPassage>
bool close_across(const typename System::Parameters& parameters, const typename System::Inputs& inputs,
                  OfPassage& passage, typename System::State& state) noexcept {
  using namespace solver_detail;
  if (!(passage.spacing > 0)) return false;
  typename System::State closed;
  copy_state<System>(state, closed);
  for (int b = 0; b < System::kBlocks; ++b) {
    if (passage.crosses[b] == 0) continue;
    if (!(magnitude(parameter_at(passage, b, state)) <= 1)) return false;
    put_across<System>(passage, b, closed);
  }
  if constexpr (System::kBlocks > 1 || System::kDrives > 0) {
    const auto correct = [&](typename System::Closure& closure) {
      for (int b = 0; b < System::kBlocks; ++b) {
        if (passage.crosses[b] == 0) continue;
        const BlockLayout& block = System::kBlockLayout[b];
        closure.pivot[b] = 1;
        for (int c = block.first_coordinate; c < block.first_coordinate + block.coordinates; ++c) {
          const int i = System::kBlockCoordinate[c];
          if (System::kDriven[i] != 0) continue;
          closure.dz[i] = 0;
          closure.zd[i] = closed.zd[i];
        }
      }
      return correct_closure<System, Correction::in_steps>(parameters, inputs, closed, closure);
    };
    if (passage.closures <= 0) return false;
    if (!close_loops<System>(parameters, inputs, closed, true, correct, passage.closures).ok()) return false;
  }
  if (moved_far<System>(state, closed) >= 0) return false;
  copy_state<System>(closed, state);
  return true;
}

/// Accelerations of a state that close_across closed. Fails: as solve_accelerations.
template <class System, class OfPassage>
Status rates_across(const typename System::Parameters& parameters, const typename System::Inputs& inputs,
                    const OfPassage& passage, const typename System::State& state,
                    typename System::Derivative& derivative) noexcept {
  using namespace solver_detail;
  static constexpr RealOf<System> kNoForces[System::kCoordinates] = {};
  const Status arguments = check_arguments<System>(parameters, inputs, state, nullptr);
  if (!arguments.ok()) return arguments;
  typename System::ClosureTerms terms;
  [[maybe_unused]] BlockFactors<System> factors;
  [[maybe_unused]] ByFineBlocks<System> fine;
  typename System::Projection projection;
  if constexpr (System::kBlocks > 1 || System::kDrives > 0) System::closure_terms(parameters, inputs, state, terms);
  for (int b = 0; b < System::kBlocks; ++b) {
    if (passage.crosses[b] != 0) {
      project_across<System>(passage, b, state, projection);
      for (int c = 0; System::kDrives > 0 && c < System::kBlockLayout[b].coordinates; ++c) {
        const int place = System::kBlockLayout[b].first_coordinate + c;
        if (System::kBlockDriven[place] != 0)
          projection.zdd_star[place] = terms.driven_acceleration[System::kBlockCoordinate[place]];
      }
      continue;
    }
    if constexpr (System::kBlocks > 1) {  // else the only block crosses
      const Status of_block =
          solve_block<System>(b, terms, RealOf<System>(1), factors, fine, nullptr,
                              [&](const auto& solution) { project_by<System>(b, solution, terms, projection); });
      if (!of_block.ok()) return of_block;
    }
  }
  typename System::ChosenAccelerations values;
  System::chosen_accelerations(parameters, inputs, state, kNoForces, projection, values);
  return deliver_sound<System>(values, derivative);
}

}  // namespace mbgen
