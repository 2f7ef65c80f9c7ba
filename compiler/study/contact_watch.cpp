#include "compiler/study/contact_watch.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace mbgen {
namespace {

constexpr double kRoundingOfForce = 1e-9;  // of the largest: a contact without load pulls by rounding

}  // namespace

ContactWatch::ContactWatch(const Compilation& compilation) {
  std::size_t row = 0;
  for (const Loop& loop : compilation.topology.loops) {
    if (loop.kind == ClosureKind::rolling_disc || loop.kind == ClosureKind::rolling_ball)
      contacts_.push_back({&loop, row});
    row += static_cast<std::size_t>(loop.equations);
  }
}

void ContactWatch::add(const Sample& sample) {
  for (Contact& contact : contacts_) {
    const double force = sample.multipliers[contact.row];
    contact.scale = std::max(contact.scale, std::abs(force));
    if (!(-force > contact.largest)) continue;
    if (contact.largest == 0) contact.since = sample.state.t;
    contact.largest = -force;
  }
}

std::vector<std::string> ContactWatch::warnings() const {
  std::vector<std::string> texts;
  for (const Contact& contact : contacts_) {
    if (!(contact.largest > kRoundingOfForce * contact.scale)) continue;
    texts.push_back(
        fmt::format("{} \"{}\" pulls from t = {:.6g} s on, by up to {:.4g} N: {} would lift off there, which is not "
                    "computed",
                    name_of(contact.loop->kind), contact.loop->name, contact.since, contact.largest,
                    contact.loop->kind == ClosureKind::rolling_disc ? "the disc" : "the ball"));
  }
  return texts;
}

}  // namespace mbgen
