#pragma once
// Helpers of the tests of pages: models, and the numbers of a page.

#include <cstring>
#include <string>
#include <vector>

#include "compiler/model/model.hpp"
#include "compiler/reader/read_model.hpp"

namespace mbgen {

inline Model model_of(const std::string& file) {
  return *read_model_file(std::string(MBGEN_SOURCE_DIR) + "/models/" + file);
}

/// The numbers of a text in base64, decoded letter by letter.
inline std::vector<float> decoded(const std::string& text) {
  const std::string letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string bytes;
  int bits = 0, held = 0;
  for (const char letter : text) {
    if (letter == '=') break;
    held = held << 6 | static_cast<int>(letters.find(letter));
    bits += 6;
    if (bits < 8) continue;
    bits -= 8;
    bytes += static_cast<char>(held >> bits & 255);
    held &= (1 << bits) - 1;
  }
  std::vector<float> numbers(bytes.size() / sizeof(float));
  std::memcpy(numbers.data(), bytes.data(), numbers.size() * sizeof(float));
  return numbers;
}

/// A place of a body's frame in the global frame, by the pose's seven numbers.
inline Vector3 placed(const float* pose, const Vector3& p) {
  const double x = pose[3], y = pose[4], z = pose[5], w = pose[6];
  const Vector3 t = {2 * (y * p[2] - z * p[1]), 2 * (z * p[0] - x * p[2]), 2 * (x * p[1] - y * p[0])};
  return {pose[0] + p[0] + w * t[0] + y * t[2] - z * t[1], pose[1] + p[1] + w * t[1] + z * t[0] - x * t[2],
          pose[2] + p[2] + w * t[2] + x * t[1] - y * t[0]};
}

}  // namespace mbgen
