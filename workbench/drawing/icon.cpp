// A small picture of a mechanism, as PNG bytes.

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "workbench/drawing/drawing.hpp"

namespace mbgen {
namespace {

constexpr int kIconSize = 128;      // pixels
constexpr double kIconMargin = 14;  // pixels
constexpr double kIconLine = 2.2;   // pixels, half a line's width
constexpr double kIconPin = 4;      // pixels, radius
constexpr std::size_t kMostOfPolygon = 4;

using Place = std::array<double, 2>;

struct Stroke {
  Place from, to;
  double half_width = kIconLine;
  int shade = 0;  ///< 0 black to 255 white
};

/// The two axes along which the model extends most, an upright one last.
std::array<std::size_t, 2> axes_of_view(const std::vector<Vector3>& points) {
  Vector3 extent{};
  for (std::size_t i = 0; i < 3; ++i) {
    const auto less = [&](const Vector3& a, const Vector3& b) { return a[i] < b[i]; };
    const auto [low, high] = std::minmax_element(points.begin(), points.end(), less);
    extent[i] = points.empty() ? 0 : (*high)[i] - (*low)[i];
  }
  const auto thinnest = static_cast<std::size_t>(std::min_element(extent.begin(), extent.end()) - extent.begin());
  return {thinnest == 0 ? 1u : 0u, thinnest == 2 ? 1u : 2u};
}

/// Strokes in the model's own metres.
std::vector<Stroke> strokes_of(const Model& model) {
  std::vector<std::vector<Vector3>> bodies(model.bodies.size());
  std::vector<Vector3> all;
  for (std::size_t b = 0; b < model.bodies.size(); ++b) {
    for (std::size_t p = 0; p < model.bodies[b].points.size(); ++p)
      bodies[b].push_back(reference_position(model, {static_cast<int>(b), static_cast<int>(p)}));
    all.insert(all.end(), bodies[b].begin(), bodies[b].end());
  }
  const auto [u, v] = axes_of_view(all);
  const auto seen = [u = u, v = v](const Vector3& point) { return Place{point[u], -point[v]}; };
  std::vector<Stroke> strokes;
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    const std::vector<Vector3>& points = bodies[b];
    if (static_cast<int>(b) == model.ground) continue;
    const std::size_t hubs = points.size() <= kMostOfPolygon ? points.size() : 1;
    for (std::size_t i = 0; i < hubs; ++i) {
      for (std::size_t k = i + 1; k < points.size(); ++k)
        strokes.push_back({seen(points[i]), seen(points[k]), kIconLine, 90});
    }
  }
  for (const Rod& rod : model.rods)
    strokes.push_back(
        {seen(reference_position(model, rod.from)), seen(reference_position(model, rod.to)), kIconLine, 90});
  for (const Joint& joint : model.joints) {
    const Place pin = seen(reference_position(model, joint.from));
    strokes.push_back({pin, pin, kIconPin, 20});
  }
  return strokes;
}

/// Moves strokes into the picture.
void fit(std::vector<Stroke>& strokes) {
  Place low{HUGE_VAL, HUGE_VAL}, high{-HUGE_VAL, -HUGE_VAL};
  for (const Stroke& stroke : strokes) {
    for (std::size_t i = 0; i < 2; ++i) {
      low[i] = std::min({low[i], stroke.from[i], stroke.to[i]});
      high[i] = std::max({high[i], stroke.from[i], stroke.to[i]});
    }
  }
  const double extent = std::max(high[0] - low[0], high[1] - low[1]);
  const double scale = extent > 0 ? (kIconSize - 2 * kIconMargin) / extent : 0;
  for (Stroke& stroke : strokes) {
    for (Place* place : {&stroke.from, &stroke.to}) {
      for (std::size_t i = 0; i < 2; ++i)
        (*place)[i] = kIconSize / 2.0 + scale * ((*place)[i] - (low[i] + high[i]) / 2);
    }
  }
}

double distance(const Stroke& stroke, const Place& place) {
  const Place along{stroke.to[0] - stroke.from[0], stroke.to[1] - stroke.from[1]};
  const Place off{place[0] - stroke.from[0], place[1] - stroke.from[1]};
  const double square = along[0] * along[0] + along[1] * along[1];
  const double part = square > 0 ? std::clamp((off[0] * along[0] + off[1] * along[1]) / square, 0.0, 1.0) : 0;
  return std::hypot(off[0] - part * along[0], off[1] - part * along[1]);
}

/// Rows of grey pixels, each after its filter's number, 0.
std::string pixels_of(const std::vector<Stroke>& strokes) {
  std::string rows;
  for (int y = 0; y < kIconSize; ++y) {
    rows += '\0';
    for (int x = 0; x < kIconSize; ++x) {
      double shade = 255;
      for (const Stroke& stroke : strokes) {
        const double cover = std::clamp(stroke.half_width + 0.5 - distance(stroke, {x + 0.5, y + 0.5}), 0.0, 1.0);
        shade += cover * (stroke.shade - shade);
      }
      rows += static_cast<char>(static_cast<unsigned char>(std::lround(shade)));
    }
  }
  return rows;
}

std::string big_endian(std::uint32_t value) {
  std::string bytes;
  for (int shift = 24; shift >= 0; shift -= 8) bytes += static_cast<char>(value >> shift & 255u);
  return bytes;
}

/// Source: PNG specification, annex D.
std::uint32_t cyclic_redundancy(const std::string& bytes) {
  std::uint32_t sum = ~0u;
  for (const char byte : bytes) {
    sum ^= static_cast<unsigned char>(byte);
    for (int bit = 0; bit < 8; ++bit) sum = (sum & 1u) != 0 ? 0xedb88320u ^ sum >> 1 : sum >> 1;
  }
  return ~sum;
}

std::string chunk(const std::string& kind, const std::string& data) {
  return big_endian(static_cast<std::uint32_t>(data.size())) + kind + data + big_endian(cyclic_redundancy(kind + data));
}

/// A zlib stream (RFC 1950) of one stored block (RFC 1951).
std::string stored(const std::string& data) {
  static_assert((kIconSize + 1) * kIconSize <= 0xffff);
  std::uint32_t a = 1, b = 0;
  for (const char byte : data) {
    a = (a + static_cast<unsigned char>(byte)) % 65521;
    b = (b + a) % 65521;
  }
  const auto size = static_cast<std::uint32_t>(data.size());
  std::string stream = "\x78\x01\x01";
  for (const std::uint32_t part : {size, size >> 8, ~size, ~size >> 8}) stream += static_cast<char>(part & 255u);
  return stream + data + big_endian(b << 16 | a);
}

}  // namespace

std::string icon_png(const Model& model) {
  std::vector<Stroke> strokes = strokes_of(model);
  fit(strokes);
  const std::string size = big_endian(kIconSize);
  const std::string head = size + size + std::string("\x08\x00\x00\x00\x00", 5);  // 8 bits of grey
  return "\x89PNG\r\n\x1a\n" + chunk("IHDR", head) + chunk("IDAT", stored(pixels_of(strokes))) + chunk("IEND", "");
}

}  // namespace mbgen
