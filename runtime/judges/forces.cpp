// Force elements of the model as wrenches on bodies and generalised forces on coordinates. The laws are the runtime's.

#include <algorithm>
#include <utility>

#include "compiler/model/auxiliary_states.hpp"
#include "compiler/model/element_access.hpp"
#include "mbgen/sampling.hpp"
#include "runtime/judges/elements/every_kind.hpp"

namespace mbgen {

using namespace cartesian;

Values CartesianMechanism::complete(Values values, const std::vector<Moving>& bodies,
                                    const std::vector<double>& x) const {
  values.states.assign(x.begin() + first_user_state(model), x.end());
  values.observed.assign(model.observed.size(), 0.0);
  const auto add = [&](const Place& from, const Place& to) {
    const Line at = line_between(from, to, bodies);
    values.lengths.push_back(at.length);
    values.rates.push_back(at.rate);
  };
  each_kind([&]<class Kind>(KindOf<Kind> kind) {
    if (!kind.has_length) return;
    for (const ElementPart& part : parts.elements[kKindIndex<Kind>]) add(part.from, part.to);
  });
  for (const PartRod& rod : parts.rods) add(rod.from, rod.to);
  return values;
}

Forces CartesianMechanism::forces(const std::vector<Moving>& bodies, const std::vector<double>& x,
                                  const Values& given) const {
  Values values = complete(given, bodies, x);
  Forces forces;
  forces.springs.resize(model.springs.size());
  forces.tyres.resize(model.tyres.size());
  forces.joints.resize(topology.bodies.size());
  forces.xd.resize(x.size());  // sampled values hold
  const AtWork at{*this, bodies, x, values};
  const int last = last_round(model);
  observe(bodies, x, forces, kBeforeForces, values);
  for (int round = 0; round <= last; ++round) {
    each_element(model, [&](const auto& element) {
      if (round_of(model, element) == round) apply(at, element, forces);
    });
    observe(bodies, x, forces, round, values);
  }
  auto place = static_cast<std::size_t>(first_user_state(model));
  for (const UserState& state : model.states) forces.xd[place++] = values(state.derivative);
  forces.observed = std::move(values.observed);
  return forces;
}

Status CartesianMechanism::sample(const std::vector<Moving>& bodies, const Values& given,
                                  const std::vector<double>& loads, std::vector<double> observed, double h, bool& any,
                                  std::vector<double>& x) const {
  any = false;
  Values values = complete(given, bodies, x);
  values.observed = std::move(observed);
  const int first = first_user_state(model) + static_cast<int>(model.states.size());
  std::size_t place = model.states.size(), queue = place + model.sampled.size();
  for (const SampledValue& sampled : model.sampled) {
    double due = 0;
    bool is_due = false;
    const int index = first + static_cast<int>(place - model.states.size());
    const Status status = find_due(&sampled.period, 1, index, given.t, h, &due, is_due);
    if (!status.ok()) return status;
    any = any || is_due;
    const auto waiting = values.states.begin() + static_cast<std::ptrdiff_t>(queue);
    if (is_due) {
      // A queue: the newest value enters at the front, the oldest is the result.
      std::vector<double> line(waiting, waiting + sampled.delay);
      line.insert(line.begin(), sampled.load ? loads[place - model.states.size()] : values(sampled.value));
      values.states[place] = line.back();
      std::copy(line.begin(), line.end() - 1, waiting);
    }
    queue += static_cast<std::size_t>(sampled.delay);
    ++place;
  }
  const std::size_t states = model.states.size();
  return take_held(values.states.data() + states, held_state_count(model), first, x.data());
}

}  // namespace mbgen
