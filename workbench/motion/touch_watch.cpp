#include "workbench/motion/touch_watch.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "compiler/model/element_access.hpp"
#include "compiler/text/number.hpp"

namespace mbgen {
namespace {

constexpr double kGoodSteps = 20;  // of a touch: its load errs by less than 0.5 %
enum Reading : std::size_t { kDeflection, kLoad, kReadings };

}  // namespace

TouchWatch::TouchWatch(const Compilation& compilation, const SimulationSettings& settings) : step_(settings.step) {
  const std::vector<SurfaceContact>& all = compilation.model.contacts;
  if (all.empty() || settings.is_error_controlled) return;
  Model model = compilation.model;
  model.outputs.clear();
  for (std::size_t i = 0; i < all.size(); ++i) {
    contacts_.push_back({&all[i].name});
    for (const char* quantity : {"deflection", "load"})
      model.outputs.push_back({"", {}, "", output_of<SurfaceContact>(quantity, i)});
  }
  solver_.emplace(model, compilation.topology, compilation.analysis);
}

void TouchWatch::end_touch(Contact& contact, double time) {
  ++contact.touches;
  if (contact.steps < kStepsOfTouch) {
    contact.fewest = contact.brief == 0 ? contact.steps : std::min(contact.fewest, contact.steps);
    ++contact.brief;
    if (contact.load > contact.hardest) contact.hardest = contact.load, contact.time = time;
  }
  contact.steps = 0;
  contact.load = 0;
}

void TouchWatch::add(const Sample& sample) {
  if (!solver_) return;
  solver_->set_inputs(sample.inputs);
  const GenericDerivative none{std::vector<double>(sample.state.z.size(), 0.0),
                               std::vector<double>(sample.state.x.size(), 0.0)};
  const std::vector<double> readings = solver_->outputs(sample.state, none.zdd, none).y;
  for (std::size_t i = 0; i < contacts_.size(); ++i) {
    Contact& contact = contacts_[i];
    const double deflection = readings[kReadings * i + kDeflection], load = readings[kReadings * i + kLoad];
    const bool touches = deflection > 0;
    if (!touches && contact.steps > 0) end_touch(contact, sample.state.t);
    if (!touches) contact.steps = 0;
    if (!touches) continue;
    const bool began_before = sample.step == 0 || contact.steps < 0;
    contact.steps = began_before ? -1 : contact.steps + 1;
    contact.load = std::max(contact.load, load);
    contact.most = std::max(contact.most, load);
  }
}

void TouchWatch::judge(const SimulationSummary&, StepVerdict& verdict) const {
  const Contact* worst = nullptr;
  int others = -1;
  for (const Contact& contact : contacts_) {
    if (contact.brief == 0 || !(contact.hardest >= kGrazing * contact.most)) continue;
    ++others;
    if (!worst || contact.hardest > worst->hardest) worst = &contact;
  }
  if (!worst) return;
  const double fitting = round_number_below(step_ * static_cast<double>(worst->fewest) / kGoodSteps);
  verdict.warnings.push_back(fmt::format(
      "contact \"{}\"{} lets go after touches of too few steps, {} of {}, the briefest of {}, the hardest with "
      "{:.4g} N before t = {:.6g} s: its loads and what bounces back are not to be trusted; --step {:.3g} would do, or "
      "a softer contact or more \"damping\" of it",
      *worst->name, others > 0 ? fmt::format(" and {} more", others) : "", worst->brief, worst->touches, worst->fewest,
      worst->hardest, worst->time, fitting));
  if (verdict.fitting_step == 0 || fitting < verdict.fitting_step) verdict.fitting_step = fitting;
}

}  // namespace mbgen
