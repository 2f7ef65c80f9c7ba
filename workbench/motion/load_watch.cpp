#include "workbench/motion/load_watch.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "compiler/model/auxiliary_states.hpp"
#include "compiler/model/element_access.hpp"

namespace mbgen {

LoadWatch::LoadWatch(const Model& model) {
  const auto first = static_cast<std::size_t>(first_sampled_value(model));
  each_friction(model, [&](const FrictionLaw& friction) {
    if (friction.load >= 0) loads_.push_back({&model.sampled[friction.load], first + friction.load});
  });
}

void LoadWatch::add(const Sample& sample) {
  for (Load& load : loads_) {
    const double now = sample.state.x[load.place], jump = std::abs(now - load.last);
    // Before the second row a load has its start value.
    if (load.rows > 1 && jump > load.jump) {
      load.jump = jump;
      load.time = sample.state.t;
    }
    load.scale = std::max(load.scale, std::abs(now));
    load.last = now;
    ++load.rows;
  }
}

void LoadWatch::judge(const SimulationSummary&, StepVerdict& verdict) const {
  for (const Load& load : loads_) {
    if (!(load.jump > kLoadJump * load.scale)) continue;
    verdict.warnings.push_back(fmt::format(
        "x.{} jumps by {:.3g} {} before t = {:.6g} s, {:.0f} % of its largest value: what it presses follows up to "
        "{:g} s late; give it a shorter \"period\" and step, or see docs/use/friction.md",
        load.value->name, load.jump, load.value->unit, load.time, 100 * load.jump / load.scale, load.value->period));
  }
}

}  // namespace mbgen
