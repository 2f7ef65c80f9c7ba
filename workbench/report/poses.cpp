#include "workbench/report/poses.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>

namespace mbgen {
namespace {

static_assert(std::endian::native == std::endian::little, "the page reads little-endian numbers");

/// Source: S. W. Shepperd, "Quaternion from rotation matrix", J. Guidance and Control 1(3), 1978: divides by the
/// largest component.
Quaternion quaternion_of(const Matrix3& r) {
  const double trace = r[0] + r[4] + r[8];
  const std::array<double, 4> squares = {1 + 2 * r[0] - trace, 1 + 2 * r[4] - trace, 1 + 2 * r[8] - trace, 1 + trace};
  const auto largest = std::max_element(squares.begin(), squares.end()) - squares.begin();
  const double twice = std::sqrt(std::max(0.0, squares[largest]));
  const double part = 0.5 / twice;
  const std::array<double, 3> off = {r[7] - r[5], r[2] - r[6], r[3] - r[1]};  // 4 w (x, y, z)
  const std::array<double, 3> sum = {r[5] + r[7], r[2] + r[6], r[1] + r[3]};  // 4 (yz, xz, xy)
  Quaternion q{};
  q[largest] = 0.5 * twice;
  if (largest == 3) {
    for (int i = 0; i < 3; ++i) q[i] = off[i] * part;
    return q;
  }
  q[3] = off[largest] * part;
  for (int i = 0; i < 3; ++i) {
    if (i != largest) q[i] = sum[3 - i - largest] * part;
  }
  return q;
}

}  // namespace

std::string base64(const std::vector<float>& numbers) {
  constexpr const char* kLetters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::vector<unsigned char> bytes(numbers.size() * sizeof(float));
  if (!bytes.empty()) std::memcpy(bytes.data(), numbers.data(), bytes.size());
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const std::size_t left = std::min<std::size_t>(3, bytes.size() - i);
    unsigned long three = 0;
    for (std::size_t k = 0; k < 3; ++k) three = three << 8 | (k < left ? bytes[i + k] : 0);
    for (std::size_t k = 0; k < 4; ++k) text += k <= left ? kLetters[three >> (18 - 6 * k) & 63] : '=';
  }
  return text;
}

void add_poses(const std::vector<Pose>& poses, std::vector<Quaternion>& before, std::vector<float>& numbers) {
  before.resize(poses.size(), Quaternion{0, 0, 0, 1});
  for (std::size_t b = 0; b < poses.size(); ++b) {
    Quaternion q = quaternion_of(poses[b].rotation);
    double along = 0;
    for (int i = 0; i < 4; ++i) along += q[i] * before[b][i];
    for (double& component : q) component = along < 0 ? -component : component;
    before[b] = q;
    for (const double x : poses[b].origin) numbers.push_back(static_cast<float>(x));
    for (const double x : q) numbers.push_back(static_cast<float>(x));
  }
}

}  // namespace mbgen
