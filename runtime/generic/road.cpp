#include "compiler/formulation/roads/road.hpp"

#include "runtime/generic/equations.hpp"
#include "runtime/generic/generic.hpp"

namespace mbgen {

std::vector<RoadBelow> GenericSolver::road_below(const GenericState& state, std::size_t tyre,
                                                 const std::vector<std::array<double, 2>>& places) const {
  System<double>& system = equations_->system(state);
  const Kinematics<double> k = kinematics(system);
  const Velocities<double> v = velocities(system, k);
  see_states_and_lengths(system, k, v);  // heights may be expressions over them
  AppliedForces<double> none;
  const detail::ForceWork<double> work{system, k, v, none};
  const Tyre& wheel = equations_->model.tyres[tyre];
  const double base = work.value(wheel.road_height);
  std::vector<RoadBelow> below;
  for (const auto& [x, y] : places) {
    below.push_back({base, 1});
    if (wheel.road < 0) continue;
    const Road& road = equations_->model.roads[static_cast<std::size_t>(wheel.road)];
    const auto [along, across] = detail::on_road(road, x, y);
    below.back() = {base + road.origin[2] + detail::height_of_road(work, road, along, across).z,
                    detail::friction_of_road(work, road, along, across)};
  }
  return below;
}

}  // namespace mbgen
