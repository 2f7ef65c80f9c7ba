#include "runtime/judges/stored_energy.hpp"

#include <algorithm>
#include <cmath>

#include "runtime/judges/bump_stops.hpp"
#include "runtime/judges/bushings.hpp"
#include "runtime/judges/laws.hpp"

namespace mbgen::cartesian {
namespace {

/// Integral over an interval by Gauss's rule with five places, exact for polynomials up to the ninth degree.
template <class Function>
double integral(double from, double to, const Function& function) {
  const double inner = std::sqrt(5 - 2 * std::sqrt(10.0 / 7)) / 3, outer = std::sqrt(5 + 2 * std::sqrt(10.0 / 7)) / 3;
  const double inner_weight = (322 + 13 * std::sqrt(70.0)) / 900, outer_weight = (322 - 13 * std::sqrt(70.0)) / 900;
  const double middle = (from + to) / 2, half = (to - from) / 2;
  double sum = 128.0 / 225 * function(middle);
  for (const double side : {-half, half})
    sum += inner_weight * function(middle + side * inner) + outer_weight * function(middle + side * outer);
  return half * sum;
}

/// Places between zero and `to` where a table changes its polynomial, and both ends.
std::vector<double> corners(const Table& table, double to) {
  const double width = table.x.back() - table.x.front(), low = std::min(0.0, to), high = std::max(0.0, to);
  const double first = table.periodic ? std::floor((low - table.x.front()) / width) : 0;
  const double last = table.periodic ? std::ceil((high - table.x.front()) / width) : 0;
  std::vector<double> places{low, high};
  for (double period = first; period <= last; ++period)
    for (const double x : table.x)
      if (x + period * width > low && x + period * width < high) places.push_back(x + period * width);
  std::sort(places.begin(), places.end());
  if (to < 0) std::reverse(places.begin(), places.end());
  return places;
}

/// Work of a law from zero to the argument.
double work_of(const std::optional<Law>& characteristic, const Values& value, double to) {
  const auto force = [&](double at) { return law(characteristic, value, at); };
  const Table* table = characteristic ? std::get_if<Table>(&*characteristic) : nullptr;
  if (!table) return integral(0, to, force);
  const std::vector<double> places = corners(*table, to);
  double work = 0;
  for (std::size_t i = 0; i + 1 < places.size(); ++i) work += integral(places[i], places[i + 1], force);
  return work;
}

double energy_of(const PointSpring& spring, const PartLine& line, const std::vector<Moving>& bodies,
                 const Values& value) {
  const double length = (end_of(bodies, line.to).position - end_of(bodies, line.from).position).norm();
  const double extension = length - (spring.free_length ? value(*spring.free_length) : line.reference);
  return work_of(spring.stiffness, value, extension) + value(spring.preload) * extension;
}

double energy_of(const JointSpring& spring, const Values& value) {
  double deflection = value.position(spring.joint) - value(spring.free);
  if (spring.relative_to) deflection -= value.position(*spring.relative_to);
  return work_of(spring.stiffness, value, deflection) + value(spring.preload) * deflection;
}

double energy_of(const Bushing& bushing, const Vector6d& q, const double* extensions, const Values& value) {
  Eigen::Matrix<double, kBushingFreedoms, kBushingFreedoms> stiffness;
  stiffness.setZero();
  double energy = 0;
  for (int i = 0; i < kBushingFreedoms; ++i) {
    for (int j = 0; bushing.stiffness && j < kBushingFreedoms; ++j)
      stiffness(i, j) = value((*bushing.stiffness)[kBushingFreedoms * i + j]);
    const std::optional<BushingFreedom>& own = bushing.freedoms[i];
    if (!own) continue;
    energy += work_of(own->stiffness, value, q[i]) + value(own->preload) * q[i];
    if (!own->maxwell_stiffness) continue;
    energy += value(*own->maxwell_stiffness) * *extensions * *extensions / 2;
    ++extensions;
  }
  return energy + q.dot(stiffness * q) / 2;
}

double energy_of(const BumpStop& stop, double penetration, const Values& value) {
  if (penetration <= 0) return 0;
  if (std::holds_alternative<Table>(*stop.stiffness)) return work_of(stop.stiffness, value, penetration);
  // Force at the end times the way, over the power of the way that the work has.
  const double force = law(stop.stiffness, value, std::pow(penetration, stop.exponent));
  return force * penetration / (stop.exponent + 1);
}

}  // namespace

double stored_energy(const CartesianMechanism& c, const StoredEnergyOutput& output, const std::vector<Moving>& bodies,
                     const std::vector<double>& x, const Values& values) {
  using Of = StoredEnergyOutput::Of;
  double sum = 0;
  const auto is_asked = [&](Of of, std::size_t i) {
    return output.of == Of::all || (output.of == of && output.element == static_cast<int>(i));
  };
  for (std::size_t s = 0; s < c.model.springs.size(); ++s)
    if (is_asked(Of::spring, s)) sum += energy_of(c.model.springs[s], c.parts.springs[s], bodies, values);
  for (std::size_t s = 0; s < c.model.joint_springs.size(); ++s)
    if (is_asked(Of::joint_spring, s)) sum += energy_of(c.model.joint_springs[s], values);
  for (std::size_t b = 0; b < c.model.bushings.size(); ++b) {
    if (!is_asked(Of::bushing, b)) continue;
    const Bushing& bushing = c.model.bushings[b];
    const double* extensions = x.data() + first_extension(c.model, b);
    const BushingAtWork at_work = bushing_at_work(bushing, c.parts.bushings[b], bodies, extensions, values);
    sum += energy_of(bushing, at_work.deflection, extensions, values);
  }
  for (std::size_t s = 0; s < c.model.bump_stops.size(); ++s) {
    const BumpStop& stop = c.model.bump_stops[s];
    if (!is_asked(Of::bump_stop, s)) continue;
    sum += energy_of(stop, stop_at_work(stop, c.parts.bump_stops[s], bodies, values).penetration, values);
  }
  return sum;
}

}  // namespace mbgen::cartesian
