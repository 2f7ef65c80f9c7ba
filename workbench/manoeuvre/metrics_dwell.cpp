// Sine with dwell, ISO 19365; the limits of stability control are those of UN Regulation 140.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "workbench/manoeuvre/metrics_fits.hpp"

namespace mbgen {
namespace {

using namespace manoeuvre;

constexpr double kEarly = 1, kLate = 1.75;  ///< s after the steering, at which the yaw rate is compared with its peak
constexpr double kDisplaced = 1.07;         ///< s after the start of the steering

}  // namespace

VehicleMetrics dwell_metrics(const VehicleSeries& s, const SineWithDwell& sine) {
  std::string fault = fault_of(s, {{"x", &s.x},
                                   {"y", &s.y},
                                   {"heading", &s.heading},
                                   {"speed", &s.speed},
                                   {"lateral speed", &s.lateral_speed},
                                   {"lateral acceleration", &s.lateral_acceleration},
                                   {"yaw rate", &s.yaw_rate},
                                   {"roll angle", &s.roll},
                                   {"steer angle", &s.steer}});
  const double end = sine.begin + 1 / sine.frequency + sine.dwell;
  if (fault.empty() && s.t.back() < end + kLate)
    fault = fmt::format("the series ends at {:.4g} s, {:.4g} s are needed after the steering, which ends at {:.4g} s",
                        s.t.back(), kLate, end);
  if (!fault.empty()) return refused("sine with dwell", fault);
  VehicleMetrics metrics;
  const Span before{0, first_point(s, sine.begin) + 1}, after{before.end - 1, s.t.size()};
  // The second half of the sine steers back: the peak to compare with is on this side.
  const Span second{first_point(s, sine.begin + 0.5 / sine.frequency), first_point(s, end) + 1};
  const double yaw_side = sign_of(interpolated(s.t, s.yaw_rate, sine.begin + 0.45 / sine.frequency));
  double peak = 0;
  for (std::size_t i = second.begin; i < std::min(second.end, s.t.size()); ++i)
    peak = std::max(peak, -yaw_side * s.yaw_rate[i]);
  add(metrics, "steer_amplitude", largest(s.steer, after), "rad", "at the steering input");
  add(metrics, "speed", s.speed[before.end - 1], "m/s", "at the start of the steering");
  if (peak > 0) {
    add(metrics, "second_yaw_rate_peak", peak, "rad/s",
        "largest yaw rate after the steering has gone back (ISO 19365)");
    const auto ratio = [&](double later) { return -yaw_side * interpolated(s.t, s.yaw_rate, end + later) / peak; };
    add(metrics, "yaw_rate_ratio_1_00", ratio(kEarly), "1",
        "yaw rate 1.00 s after the end of the steering over its peak; UN Regulation 140 allows 0.35");
    add(metrics, "yaw_rate_ratio_1_75", ratio(kLate), "1",
        "yaw rate 1.75 s after the end of the steering over its peak; UN Regulation 140 allows 0.20");
  } else {
    metrics.notes.push_back("second_yaw_rate_peak: the vehicle does not turn back");
  }
  const double heading = interpolated(s.t, s.heading, sine.begin), later = sine.begin + kDisplaced;
  const double x = interpolated(s.t, s.x, later) - interpolated(s.t, s.x, sine.begin);
  const double y = interpolated(s.t, s.y, later) - interpolated(s.t, s.y, sine.begin);
  add(metrics, "lateral_displacement_1_07", std::abs(std::cos(heading) * y - std::sin(heading) * x), "m",
      "from the straight course 1.07 s after the start of the steering; UN Regulation 140 asks for 1.83 m, above 3.5 t "
      "for 1.52 m");
  add(metrics, "largest_sideslip", largest(sideslip_of(s), after), "rad",
      "largest sideslip angle of the reference point");
  add(metrics, "largest_lateral_acceleration", largest(s.lateral_acceleration, after), "m/s^2", "in magnitude");
  add(metrics, "largest_roll", largest(s.roll, after), "rad", "in magnitude");
  metrics.diagrams.push_back(
      {"Sine with dwell", {"time", "s"}, {"yaw rate", "rad/s"}, {{"yaw rate", s.t, s.yaw_rate}}});
  return metrics;
}

}  // namespace mbgen
