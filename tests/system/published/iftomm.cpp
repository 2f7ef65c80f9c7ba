// IFToMM benchmarks A01 to A05.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "tests/system/published/published.hpp"
#include "tests/system/published/run.hpp"

namespace mbgen::published {
namespace {

using Json = nlohmann::json;

/// Largest distance of the point (x, y) from rows [t, x, y, ..] up to a time; the run is at the last of them then.
double distance_from(const Json& rows, double until, Run& run) {
  double error = 0;
  for (const Json& row : rows) {
    if (number(row[0]) > until) break;
    run.go_to(number(row[0]));
    error = std::max({error, std::abs(run.output("x") - number(row[1])), std::abs(run.output("y") - number(row[2]))});
  }
  return error;
}

/// Largest change of energy over equal intervals up to a time.
double drift(Run& run, double until, int samples) {
  const double first = run.energy();
  double largest = 0;
  for (int k = 1; k <= samples; ++k) {
    run.go_to(until * k / samples);
    largest = std::max(largest, std::abs(run.energy() - first));
  }
  return largest;
}

}  // namespace

std::vector<Figure> simple_pendulum() {
  const Json data = reference("a01_simple_pendulum.json");
  const Run start("models/iftomm/a01_simple_pendulum.json", 1e-3);
  Run energy = start, exact = start, published = start;
  exact.set_step(5e-4);
  return {{"energy over 10 s", drift(energy, 10, 1000), 1e-9, "J", "1e-3 s",
           "drift below 5e-5 J asked for; Exudyn meets it"},
          {"x, y over 2000 s, closed form", distance_from(data["exact_rows_t_x_y_vx_vy"], 2000, exact), 1e-8, "m",
           "5e-4 s", "exact; LIM asks for 1e-3"},
          {"x, y over 2000 s, LIM's file", distance_from(data["published_rows_t_x_y"], 2000, published), 6e-7, "m",
           "1e-3 s", "6 digits"}};
}

std::vector<Figure> n_four_bar() {
  const Json data = reference("a02_n_four_bar.json"), rows = data["rows_t_x_y_vx_vy"];
  const Run start("models/iftomm/a02_n_four_bar_2.json", 1e-3);
  Run before = start, all = start, energy = start;
  return {{"x, y up to the first singular position at 0.714 s", distance_from(rows, 0.7, before), 1e-10, "m", "1e-3 s",
           "exact"},
          {"x, y over 10 s, through ten singular positions", distance_from(rows, 10, all), 1e-8, "m", "1e-3 s",
           "exact on the parallelogram's branch; LIM asks for 1e-3"},
          {"energy over 10 s", drift(energy, 10, 1000), 1e-8, "J", "1e-3 s", "Exudyn 0.114 J at a step of 1e-2 s"},
          n_four_bar_of(5, 3)};
}

namespace {

/// The N-four-bar on the parallelogram's branch is one pendulum, theta'' = a sin(theta) from the vertical; its sine and
/// cosine are x and y of the first tip. Steps of 1e-5 s in extended precision.
struct Parallelogram {
  long double a, theta = 0, rate = 1;

  explicit Parallelogram(int n) : a(9.81L * ((n + 1) / 2.0L + n) / ((n + 1) / 3.0L + n)) {}
  void step() {
    constexpr long double h = 1e-5L;
    const auto acceleration = [this](long double angle) { return a * std::sin(angle); };
    const long double k1 = acceleration(theta), r2 = rate + h / 2 * k1, k2 = acceleration(theta + h / 2 * rate),
                      r3 = rate + h / 2 * k2, k3 = acceleration(theta + h / 2 * r2), r4 = rate + h * k3,
                      k4 = acceleration(theta + h * r3);
    theta += h / 6 * (rate + 2 * r2 + 2 * r3 + r4);
    rate += h / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
  }
};

}  // namespace

Figure n_four_bar_of(int n, int seconds) {
  Run run(compiled_text(output_of(fmt::format("bench/growth_model.sh four-bar {}", n))), 1e-3);
  Parallelogram exact(n);
  double error = 0;
  for (int tenth = 1; tenth <= 10 * seconds; ++tenth) {
    for (int step = 0; step < 10000; ++step) exact.step();
    run.go_to(0.1 * tenth);
    error = std::max({error, std::abs(run.output("x") - static_cast<double>(std::sin(exact.theta))),
                      std::abs(run.output("y") - static_cast<double>(std::cos(exact.theta)))});
  }
  return {fmt::format("x, y over {} s with N = {}, through its singular positions", seconds, n),
          error,
          1e-8,
          "m",
          "1e-3 s",
          "pendulum equation in extended precision, 1e-15; LIM asks for 1e-3"};
}

std::vector<Figure> andrews() {
  const Json data = reference("andrews.json");
  Run run("models/iftomm/a03_andrews.json", 2.5e-6);
  const char* const names[] = {"beta", "theta", "gamma", "phi", "delta", "omega", "epsilon"};
  const auto error = [&](const auto& expected) {
    double largest = 0;
    for (int i = 0; i < 7; ++i)
      largest = std::max(largest, std::abs(run.output(fmt::format("angle_{}", names[i])) - number(expected[i])));
    return largest;
  };
  const auto row_at = [&](double t) {
    for (const Json& row : data["rows"])
      if (std::abs(number(row["t"]) - t) < 1e-12) return row["q"];
    throw std::runtime_error("no such row");
  };
  run.go_to(0.03);
  const double published = error(data["published_y_at_0p03"]), own = error(row_at(0.03));
  run.go_to(0.05);
  return {{"angles at 0.03 s, test set", published, 2e-9, "rad", "2.5e-6 s", "16 digits; theta is off by 1.4e-9"},
          {"angles at 0.03 s, quadruple precision", own, 1e-10, "rad", "2.5e-6 s", "1e-17"},
          {"angles at 0.05 s, extended precision", error(row_at(0.05)), 1e-9, "rad", "2.5e-6 s", "5e-15"}};
}

std::vector<Figure> bricard() {
  const Json data = reference("a04_bricard.json");
  const Run start("models/iftomm/a04_bricard.json", 1e-3);
  Run run = start, energy = start;
  double error = 0;
  for (const Json& row : data["rows"]) {
    run.go_to(number(row["t"]));
    const char* const axes[] = {"x", "y", "z"};
    for (int k = 0; k < 3; ++k) error = std::max(error, std::abs(run.output(axes[k]) - number(row["P3"][k])));
  }
  return {{"P3 over 10 s", error, 1e-9, "m", "1e-3 s", "plot only; independent integrator 4e-14; LIM asks for 1e-3"},
          {"energy over 10 s", drift(energy, 10, 1000), 1e-9, "J", "1e-3 s", "constant"}};
}

std::vector<Figure> flyball_governor() {
  const Json data = reference("a05_flyball.json");
  Run run("models/iftomm/a05_flyball_governor.json", 1e-4);
  double height = 0, angle = 0, speed = 0;
  for (const Json& row : data["rows_t_s_beta_Omega"]) {
    run.go_to(number(row[0]));
    height = std::max(height, std::abs(run.output("slider_height") - number(row[1])));
    angle = std::max(angle, std::abs(run.output("arm_angle") - number(row[2])));
    speed = std::max(speed, std::abs(run.output("shaft_speed") - number(row[3])));
  }
  const std::string known = "plot only (0.50 to 0.743 m); minimal coordinates, Radau, 1e-11";
  return {{"slider over 10 s", height, 1e-9, "m", "1e-4 s", known},
          {"arm over 10 s", angle, 1e-9, "rad", "1e-4 s", known},
          {"shaft over 10 s", speed, 1e-8, "rad/s", "1e-4 s", known}};
}

}  // namespace mbgen::published
