#include "workbench/report/strip.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace mbgen {
namespace {

/// In radii: extension of a strip beyond its wheels, least distance of places along the way, finest grid, spacing of
/// offsets while rows are chosen, and least tolerance.
constexpr double kMargin = 3, kApart = 0.5, kFinest = 1 / 25.0, kCoarse = 1 / 3.0, kTolerance = 1 / 500.0;
constexpr std::size_t kMostLooks = 200'000, kMostChosen = 400;
/// Height equivalent to a friction of 1, in radii, and weight of a metre along the way relative to one of height.
constexpr double kFrictionHeight = 0.1, kWayHeight = 0.1;

/// Path of the wheels: places with their arc length, m.
struct Way {
  std::vector<Station> places;
  std::vector<double> at;
  double along = 0, across = 0;  ///< m: lateral distance of wheels from it

  double length() const { return at.back(); }
};

GroundPlace middle(const std::vector<GroundPlace>& wheels) {
  GroundPlace sum{};
  for (const GroundPlace& wheel : wheels)
    for (std::size_t i = 0; i < 2; ++i) sum[i] += wheel[i] / static_cast<double>(wheels.size());
  return sum;
}

/// Directions from neighbour to neighbour; for a single place the requested direction.
void head(const StripRequest& request, std::vector<Station>& places) {
  const std::vector<Station> old = places;
  for (std::size_t i = 0; i < places.size(); ++i) {
    const Station &before = old[i > 0 ? i - 1 : 0], &behind = old[std::min(i + 1, old.size() - 1)];
    const double dx = behind.x - before.x, dy = behind.y - before.y, length = std::hypot(dx, dy);
    places[i].cosine = length > 0 ? dx / length : std::cos(request.heading);
    places[i].sine = length > 0 ? dy / length : std::sin(request.heading);
  }
}

Way way_of(const StripRequest& request) {
  Way way;
  std::vector<std::size_t> nearest;  // place of each frame
  for (const std::vector<GroundPlace>& wheels : request.wheels) {
    const auto [x, y] = middle(wheels);
    const double moved = way.places.empty() ? 0 : std::hypot(x - way.places.back().x, y - way.places.back().y);
    if (way.places.empty() || moved >= kApart * request.radius) {
      way.at.push_back(way.places.empty() ? 0 : way.at.back() + moved);
      way.places.push_back({x, y});
    }
    nearest.push_back(way.places.size() - 1);
  }
  head(request, way.places);
  for (std::size_t frame = 0; frame < request.wheels.size(); ++frame)
    for (const auto& [x, y] : request.wheels[frame]) {
      const Station& place = way.places[nearest[frame]];
      const double dx = x - place.x, dy = y - place.y;
      way.along = std::max(way.along, std::abs(place.cosine * dx + place.sine * dy));
      way.across = std::max(way.across, std::abs(place.cosine * dy - place.sine * dx));
    }
  return way;
}

/// Station at a distance along the way, which is continued straight at both ends.
Station station_at(const Way& way, double s) {
  const std::size_t last = way.places.size() - 1;
  const auto behind = static_cast<std::size_t>(std::upper_bound(way.at.begin(), way.at.end(), s) - way.at.begin());
  const std::size_t from = std::clamp<std::size_t>(behind, 1, last + 1) - 1, to = std::min(from + 1, last);
  Station station = way.places[from];
  if (from == to || s < 0) {
    const double on = s - way.at[from];
    station.x += on * station.cosine;
    station.y += on * station.sine;
    return station;
  }
  const double share = (s - way.at[from]) / (way.at[to] - way.at[from]);
  const Station& next = way.places[to];
  station = {std::lerp(station.x, next.x, share), std::lerp(station.y, next.y, share),
             std::lerp(station.cosine, next.cosine, share), std::lerp(station.sine, next.sine, share)};
  const double length = std::hypot(station.cosine, station.sine);
  if (length > 0) station.cosine /= length, station.sine /= length;
  return station;
}

/// Equally spaced numbers from `first` to `last`.
std::vector<double> spaced(double first, double last, std::size_t count) {
  std::vector<double> places;
  for (std::size_t i = 0; i < count; ++i)
    places.push_back(std::lerp(first, last, static_cast<double>(i) / static_cast<double>(count - 1)));
  return places;
}

std::size_t count_of(double length, double spacing, std::size_t most) {
  return std::clamp<std::size_t>(static_cast<std::size_t>(std::ceil(length / spacing)) + 1, 2,
                                 std::max<std::size_t>(2, most));
}

/// Lines of numbers at equal distances.
struct Lines {
  std::size_t width = 0;
  std::vector<double> numbers;
  std::size_t count() const { return numbers.size() / width; }
  double at(std::size_t line, std::size_t i) const { return numbers[line * width + i]; }
};

/// The line between two others with the largest deviation from their linear interpolation, and this deviation.
std::pair<std::size_t, double> farthest_between(const Lines& lines, std::size_t from, std::size_t to) {
  std::pair<std::size_t, double> farthest{from, 0};
  for (std::size_t line = from + 1; line < to; ++line) {
    const double share = static_cast<double>(line - from) / static_cast<double>(to - from);
    for (std::size_t i = 0; i < lines.width; ++i) {
      const double far = std::abs(lines.at(line, i) - std::lerp(lines.at(from, i), lines.at(to, i), share));
      if (far > farthest.second) farthest = {line, far};
    }
  }
  return farthest;
}

/// Lines from which all others follow by linear interpolation within a tolerance. Source: D. Douglas and T. Peucker,
/// "Algorithms for the reduction of the number of points", Cartographica 10(2), 1973.
std::vector<std::size_t> needed(const Lines& lines, double tolerance) {
  std::vector<std::size_t> kept{0}, ends{lines.count() - 1};
  while (!ends.empty()) {
    const auto [line, far] = farthest_between(lines, kept.back(), ends.back());
    if (far > tolerance) {
      ends.push_back(line);
    } else {
      kept.push_back(ends.back());
      ends.pop_back();
    }
  }
  return kept;
}

template <class T>
std::vector<T> chosen(const std::vector<T>& all, const std::vector<std::size_t>& places) {
  std::vector<T> some;
  for (const std::size_t place : places) some.push_back(all[place]);
  return some;
}

/// Evenly spaced elements of a list, at most kMostChosen.
std::vector<std::size_t> thinned(const std::vector<std::size_t>& all) {
  const std::size_t stride = (all.size() + kMostChosen - 1) / kMostChosen;
  std::vector<std::size_t> some;
  for (std::size_t i = 0; i < all.size(); i += stride) some.push_back(all[i]);
  return some;
}

}  // namespace

Strip strip_along(const StripRequest& request,
                  const std::function<std::vector<RoadBelow>(const std::vector<GroundPlace>&)>& look) {
  const auto look_at = [&](Strip& strip) {
    std::vector<GroundPlace> places;
    for (const Station& station : strip.stations)
      for (const double offset : strip.offsets) places.push_back(Strip::place(station, offset));
    strip.road = look(places);
  };
  const double friction = kFrictionHeight * request.radius;
  const Way way = way_of(request);
  const double along = way.along + kMargin * request.radius, across = way.across + kMargin * request.radius;
  const std::size_t sides = count_of(2 * across, kCoarse * request.radius, 100);
  const double length = way.length() + 2 * along;
  Strip fine;
  for (const double s :
       spaced(-along, way.length() + along, count_of(length, kFinest * request.radius, kMostLooks / sides)))
    fine.stations.push_back(station_at(way, s));
  fine.offsets = spaced(-across, across, sides);
  look_at(fine);
  Lines rows{2 * sides + 2, {}};
  for (std::size_t i = 0; i < fine.stations.size(); ++i) {
    for (std::size_t k = 0; k < sides; ++k)
      rows.numbers.insert(rows.numbers.end(),
                          {fine.road[i * sides + k].height, friction * fine.road[i * sides + k].friction});
    rows.numbers.insert(rows.numbers.end(), {kWayHeight * fine.stations[i].x, kWayHeight * fine.stations[i].y});
  }
  double tolerance = kTolerance * request.radius;
  Strip wide{chosen(fine.stations, thinned(needed(rows, tolerance))),
             spaced(-across, across, count_of(2 * across, kFinest * request.radius, 2000)),
             {}};
  look_at(wide);
  const std::size_t across_count = wide.offsets.size();
  Lines columns{2 * wide.stations.size(), {}};
  for (std::size_t k = 0; k < across_count; ++k)
    for (std::size_t i = 0; i < wide.stations.size(); ++i)
      columns.numbers.insert(columns.numbers.end(), {wide.road[i * across_count + k].height,
                                                     friction * wide.road[i * across_count + k].friction});
  Strip strip;
  do {
    strip.stations = chosen(fine.stations, needed(rows, tolerance));
    strip.offsets = chosen(wide.offsets, needed(columns, tolerance));
    tolerance *= 1.5;
  } while (strip.stations.size() * strip.offsets.size() > request.most);
  look_at(strip);
  return strip;
}

}  // namespace mbgen
