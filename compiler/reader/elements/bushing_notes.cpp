// Bushings that pull away from the reference or add energy.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "compiler/reader/elements/sections.hpp"
#include "compiler/reader/reader.hpp"

namespace mbgen::reading {
namespace {

constexpr double kLeastPivot = 1e-12;  ///< of a matrix with ones on its diagonal
constexpr double kCoupling = 1e-6;     ///< of freedoms of which one has no stiffness left

/// Whether a symmetric matrix with a constant part of each freedom's own has a negative value in some direction: by
/// elimination, with the largest pivots first.
bool is_negative_somewhere(const BushingMatrix& quantities, const std::array<double, kBushingFreedoms>& own) {
  std::array<double, kBushingFreedoms * kBushingFreedoms> a{};
  std::transform(quantities.begin(), quantities.end(), a.begin(), [](const Quantity& q) { return q.value; });
  const auto at = [&](std::size_t row, std::size_t column) -> double& { return a[kBushingFreedoms * row + column]; };
  // Lengths and angles have other units: each freedom counts by its own stiffness.
  std::array<double, kBushingFreedoms> scale{};
  for (std::size_t i = 0; i < kBushingFreedoms; ++i) {
    at(i, i) += own[i];
    if (at(i, i) < 0) return true;
    scale[i] = at(i, i) > 0 ? 1 / std::sqrt(at(i, i)) : 0;
    for (std::size_t j = 0; j < kBushingFreedoms; ++j)
      if (at(i, i) == 0 && at(i, j) != 0) return true;
  }
  for (std::size_t i = 0; i < kBushingFreedoms; ++i)
    for (std::size_t j = 0; j < kBushingFreedoms; ++j) at(i, j) *= scale[i] * scale[j];
  std::array<bool, kBushingFreedoms> taken{};
  for (std::size_t step = 0; step < kBushingFreedoms; ++step) {
    std::size_t pivot = kBushingFreedoms;
    for (std::size_t i = 0; i < kBushingFreedoms; ++i)
      if (!taken[i] && (pivot == kBushingFreedoms || at(i, i) > at(pivot, pivot))) pivot = i;
    taken[pivot] = true;
    const bool has_pivot = at(pivot, pivot) > kLeastPivot;
    if (at(pivot, pivot) < -kLeastPivot) return true;
    for (std::size_t i = 0; i < kBushingFreedoms; ++i) {
      if (taken[i]) continue;
      if (!has_pivot && std::abs(at(i, pivot)) > kCoupling) return true;
      const double factor = has_pivot ? at(i, pivot) / at(pivot, pivot) : 0;
      for (std::size_t j = 0; j < kBushingFreedoms; ++j)
        if (!taken[j]) at(i, j) -= factor * at(pivot, j);
    }
  }
  return false;
}

/// The same of a bushing's matrix with what its freedoms add, where those are constants.
bool is_negative_somewhere(const Bushing& bushing, const std::optional<BushingMatrix>& matrix,
                           std::optional<Law> BushingFreedom::*law) {
  if (!matrix) return false;
  std::array<double, kBushingFreedoms> own{};
  for (std::size_t i = 0; i < kBushingFreedoms; ++i) {
    if (!bushing.freedoms[i]) continue;
    const BushingFreedom& freedom = *bushing.freedoms[i];
    const std::optional<Law>& added = freedom.*law;
    if (freedom.force || (added && std::holds_alternative<Table>(*added))) return false;
    if (added) own[i] = std::get<Quantity>(*added).value;
  }
  return is_negative_somewhere(*matrix, own);
}

/// Whether a law acts in the direction of its argument somewhere.
bool is_negative(const std::optional<Law>& law) {
  if (!law) return false;
  if (const auto* factor = std::get_if<Quantity>(&*law)) return factor->value < 0;
  const Table& table = std::get<Table>(*law);
  for (std::size_t i = 0; i < table.x.size(); ++i)
    if (table.x[i] * table.y[i] < 0) return true;
  return false;
}

}  // namespace

void note_bushings(Reader& reader) {
  constexpr const char* kStiffnessHint = "positive stiffness pulls back to the reference";
  constexpr const char* kDampingHint = "positive damping acts against the motion";
  for (const Bushing& bushing : reader.model.bushings) {
    const std::string name = in_quotes(bushing.name);
    for (std::size_t i = 0; i < kBushingFreedoms; ++i) {
      if (!bushing.freedoms[i]) continue;
      const std::string of = fmt::format("{} of bushing {}", kBushingFreedomNames[i], name);
      if (is_negative(bushing.freedoms[i]->stiffness))
        note_at(reader, bushing.where, fmt::format("stiffness {} is negative: it pushes away", of), kStiffnessHint);
      if (is_negative(bushing.freedoms[i]->damping))
        note_at(reader, bushing.where, fmt::format("damping {} is negative: it adds energy", of), kDampingHint);
    }
    if (is_negative_somewhere(bushing, bushing.stiffness, &BushingFreedom::stiffness))
      note_at(reader, bushing.where,
              fmt::format("stiffness of bushing {} is negative in some direction: it pushes away", name),
              kStiffnessHint);
    if (is_negative_somewhere(bushing, bushing.damping, &BushingFreedom::damping))
      note_at(reader, bushing.where,
              fmt::format("damping of bushing {} is negative in some direction: it adds energy", name), kDampingHint);
  }
}

}  // namespace mbgen::reading
