#pragma once
// Statuses of a call for several instances, lane by lane.

#include "mbgen/status.hpp"

namespace mbgen {

/// Status of every lane.
template <int W>
struct LaneStatuses {
  Status lane[W];

  constexpr const Status& operator[](int index) const noexcept { return lane[index]; }
  constexpr Status& operator[](int index) noexcept { return lane[index]; }

  /// True when every lane is ok.
  constexpr bool ok() const noexcept {
    bool all = true;
    for (const Status& status : lane) all = all && status.ok();
    return all;
  }
};

}  // namespace mbgen
