#pragma once
// Poses of bodies as the page reads them: numbers of 32 bits, little-endian, in base64.

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "compiler/model/model.hpp"

namespace mbgen {

/// Origin (m) and unit quaternion x y z w of a body.
constexpr std::size_t kPoseNumbers = 7;

using Quaternion = std::array<double, 4>;  ///< x y z w

/// RFC 4648, of the numbers' bytes.
std::string base64(const std::vector<float>& numbers);

/// Adds the numbers of some poses, a body after the other. Of the two quaternions of a turn it takes the one that is
/// nearer to `before`, which then has those taken; empty it stands for no turns.
void add_poses(const std::vector<Pose>& poses, std::vector<Quaternion>& before, std::vector<float>& numbers);

}  // namespace mbgen
