#include "workbench/import/stl.hpp"

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <limits>
#include <vector>

namespace mbgen::importing {
namespace {

using Eigen::Vector3d;

constexpr std::size_t kHeader = 80, kTriangle = 50, kNormal = 12, kCorner = 12;  // bytes

MeshBox empty_box() {
  const double most = std::numeric_limits<double>::infinity();
  return {Vector3d::Constant(most), Vector3d::Constant(-most)};
}

void add(MeshBox& box, const Vector3d& corner) {
  // Eigen's minimum may ignore NaN.
  for (int i = 0; i < 3; ++i) {
    if (!(corner[i] >= box.least[i])) box.least[i] = corner[i];
    if (!(corner[i] <= box.most[i])) box.most[i] = corner[i];
  }
}

/// Number of triangles of a binary mesh; nothing if it does not match the size.
std::optional<std::size_t> binary_triangles(std::string_view bytes) {
  std::uint32_t count = 0;
  if (bytes.size() < kHeader + sizeof(count)) return std::nullopt;
  std::memcpy(&count, bytes.data() + kHeader, sizeof(count));
  if (bytes.size() != kHeader + sizeof(count) + kTriangle * std::size_t{count}) return std::nullopt;
  return count;
}

MeshBox binary_box(std::string_view bytes, std::size_t triangles) {
  MeshBox box = empty_box();
  const char* triangle = bytes.data() + kHeader + sizeof(std::uint32_t);
  for (std::size_t t = 0; t < triangles; ++t, triangle += kTriangle) {
    for (std::size_t c = 0; c < 3; ++c) {
      float corner[3];
      std::memcpy(corner, triangle + kNormal + c * kCorner, sizeof(corner));
      add(box, {corner[0], corner[1], corner[2]});
    }
  }
  return box;
}

/// Removes the first word of a text. Result: this word.
std::string_view take_word(std::string_view& rest) {
  constexpr std::string_view kBlanks = " \t\r\n";
  rest.remove_prefix(std::min(rest.find_first_not_of(kBlanks), rest.size()));
  const std::string_view word = rest.substr(0, rest.find_first_of(kBlanks));
  rest.remove_prefix(word.size());
  return word;
}

std::optional<MeshBox> ascii_box(std::string_view text) {
  if (take_word(text) != "solid") return std::nullopt;
  MeshBox box = empty_box();
  while (!text.empty()) {
    if (take_word(text) != "vertex") continue;
    Vector3d corner;
    for (double& value : corner) {
      const std::string_view word = take_word(text);
      const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
      if (error != std::errc() || end != word.data() + word.size()) return std::nullopt;
    }
    add(box, corner);
  }
  return box;
}

}  // namespace

std::optional<MeshBox> box_of_stl(std::string_view bytes) {
  const std::optional<std::size_t> triangles = binary_triangles(bytes);
  const std::optional<MeshBox> box = triangles ? binary_box(bytes, *triangles) : ascii_box(bytes);
  if (!box || !box->least.allFinite() || !box->most.allFinite()) return std::nullopt;
  return box;
}

std::optional<MeshBox> box_of_mesh(const ImportRequest& request, const std::string& file, const std::string& name) {
  if (!request.read) return std::nullopt;
  std::string path = name, inside;
  for (const std::string_view scheme : {"package://", "model://", "file://"}) {
    if (!path.starts_with(scheme)) continue;
    path = path.substr(scheme.size());
    if (scheme != "file://") inside = path.substr(path.find('/') + 1);
  }
  const std::filesystem::path last = std::filesystem::path(path).filename();
  if (last.empty() || last == "." || last == "..") return std::nullopt;
  const std::filesystem::path beside = std::filesystem::path(file).parent_path();
  std::vector<std::filesystem::path> places = {beside / path, beside / last};
  if (!inside.empty()) places = {beside / inside, beside / path, beside / ".." / path, beside / last};
  for (const std::filesystem::path& place : places) {
    const std::optional<std::string> bytes = request.read(place.string());
    if (bytes) return box_of_stl(*bytes);
  }
  return std::nullopt;
}

}  // namespace mbgen::importing
