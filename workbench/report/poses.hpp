#pragma once
// Poses of bodies for the page: 32-bit numbers, little-endian, in base64.

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "compiler/model/model.hpp"

namespace mbgen {

/// Origin (m) and unit quaternion x y z w of a body.
constexpr std::size_t kPoseNumbers = 7;

using Quaternion = std::array<double, 4>;  ///< x y z w

/// Base64 by RFC 4648 of the numbers' bytes.
std::string base64(const std::vector<float>& numbers);

/// Appends the numbers of poses, body by body. Of the two quaternions of a rotation it takes the one nearer to
/// `before`, which is then updated; empty stands for no rotation.
void add_poses(const std::vector<Pose>& poses, std::vector<Quaternion>& before, std::vector<float>& numbers);

}  // namespace mbgen
