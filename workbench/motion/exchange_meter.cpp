#include "workbench/motion/exchange_meter.hpp"

#include <algorithm>
#include <cmath>

namespace mbgen {
namespace {

bool are_finite(const std::vector<double>& values) {
  return std::all_of(values.begin(), values.end(), [](double value) { return std::isfinite(value); });
}

}  // namespace

ExchangeMeter::ExchangeMeter(const Compilation& compilation, double step)
    : step_(step), solver_(compilation.model, compilation.topology, compilation.analysis) {}

void ExchangeMeter::add(const Sample& sample) {
  solver_.set_inputs(sample.inputs);
  GenericExchanges now = solver_.exchanges(sample.moving);
  now.powers.push_back(sample.outputs.applied_power - now.applied);  // of the drives
  if (!are_finite(now.powers) || !are_finite(now.kinetic)) return;
  if (now.powers.size() != powers_.size()) {
    powers_ = now.powers;
    works_.assign(powers_.size(), 0.0);
    ranges_.assign(powers_.size() + now.kinetic.size(), Span{});
  }
  for (std::size_t i = 0; i < works_.size(); ++i) {
    if (sample.step > 0) works_[i] += step_ / 2 * (powers_[i] + now.powers[i]);
    ranges_[i].add(works_[i]);
  }
  for (std::size_t i = 0; i < now.kinetic.size(); ++i) ranges_[works_.size() + i].add(now.kinetic[i]);
  powers_ = std::move(now.powers);
}

double ExchangeMeter::scale() const {
  double works = 0, kinetic = 0;
  for (std::size_t i = 0; i < ranges_.size(); ++i) (i < works_.size() ? works : kinetic) += ranges_[i].width();
  return std::max(works, kinetic);
}

}  // namespace mbgen
