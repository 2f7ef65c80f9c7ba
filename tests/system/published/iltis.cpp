// The Iltis of the IAVSD road vehicle benchmark: nominal forces and static equilibrium.

#include <algorithm>
#include <cmath>

#include "tests/system/published/published.hpp"
#include "tests/system/published/run.hpp"

namespace mbgen::published {
namespace {

double largest_error(const nlohmann::json& expected, const Run& run, const std::string& part) {
  double error = 0;
  for (const auto& [name, value] : expected.items())
    if (name.find(part) != std::string::npos) error = std::max(error, std::abs(run.output(name) - number(value)));
  return error;
}

}  // namespace

std::vector<Figure> iltis() {
  const nlohmann::json data = reference("iltis.json");
  const Run equilibrium("models/published/iltis.json", 1e-3);
  Run nominal = equilibrium;
  nominal.take_reference();
  return {{"leaf forces, nominal", largest_error(data["nominal"], nominal, "leaf_force"), 0.05, "N", "-",
           "-2728.9 N, 5 digits"},
          {"shock spring forces, nominal", largest_error(data["nominal"], nominal, "shock_force"), 0.05, "N", "-",
           "-128.0 N, 4 digits"},
          {"wheel loads, nominal", largest_error(data["nominal"], nominal, "load"), 0.1, "N", "-",
           "3829.6 and 3593.6 N, 5 digits; 3593.67 N by statics"},
          {"height, pitch, four corner coordinates in equilibrium", largest_error(data["equilibrium"], equilibrium, ""),
           1e-6, "m, rad", "-", "6 digits; the road's stiffness is fitted to the pitch"}};
}

}  // namespace mbgen::published
