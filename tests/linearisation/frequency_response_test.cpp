// Frequency responses against closed forms.

#include "compiler/linearisation/frequency_response.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "compiler/compile.hpp"
#include "compiler/reader/read_model.hpp"
#include "tests/support/model_support.hpp"

namespace mbgen {
namespace {

using Complex = std::complex<double>;

LinearSystem system_of(const Compilation& c) {
  OperatingPoint point;
  point.z.assign(c.topology.bodies.size(), 0.0);
  point.zd = point.z;
  for (const Input& input : c.model.inputs) point.inputs.push_back(input.default_value);
  Result<LinearSystem> system = linearise(c, point);
  if (!system) throw std::runtime_error(to_text(system.problems()));
  return std::move(*system);
}

Compilation compilation_of(const std::string& text) {
  Result<Model> model = read_model(text, "model.json");
  if (!model) throw std::runtime_error(to_text(model.problems()));
  Result<Compilation> compiled = compile(std::move(*model));
  if (!compiled) throw std::runtime_error(to_text(compiled.problems()));
  return std::move(*compiled);
}

const std::vector<double> kFrequencies = {0.01, 0.3, 1, 1.5915494309189535, 4, 37};

// 2 kg on 200 N/m and 8 N s/m: x over force, and its acceleration, which has a direct part.
TEST(FrequencyResponse, OfAnOscillator) {
  const Compilation c = compilation_of(R"({ "mbgen": 1, "gravity": [0, 0, 0], "inputs": { "push": {} },
    "bodies": { "ground": { "points": { "O": [0, 0, 0] } },
      "slide": { "mass": 2, "inertia": [0, 0, 0], "points": { "O": [0, 0, 0] } } },
    "joints": { "slide": { "type": "prismatic", "from": "ground.O", "to": "slide.O", "axis": "x" } },
    "joint_forces": { "all": { "joint": "slide", "force": "push - 200*z.slide - 8*zd.slide" } },
    "outputs": { "x": { "joint": "slide" }, "a": { "joint": "slide", "quantity": "acceleration" } } })");
  const LinearSystem system = system_of(c);
  const std::vector<Complex> x = frequency_response(c.model, system, 0, 0, kFrequencies);
  const std::vector<Complex> a = frequency_response(c.model, system, 0, 1, kFrequencies);
  for (std::size_t i = 0; i < kFrequencies.size(); ++i) {
    const Complex s(0, 2 * std::numbers::pi * kFrequencies[i]);
    const Complex exact = 1.0 / (2.0 * s * s + 8.0 * s + 200.0);
    EXPECT_LT(std::abs(x[i] - exact), 1e-12 * std::abs(exact)) << i;
    EXPECT_LT(std::abs(a[i] - s * s * exact), 1e-12 * std::abs(s * s * exact) + 1e-15) << i;
  }
}

// Without damping the response is infinite at the resonance alone.
TEST(FrequencyResponse, IsInfiniteAtAnUndampedMode) {
  const Compilation c = compilation_of(R"({ "mbgen": 1, "gravity": [0, 0, 0], "inputs": { "push": {} },
    "bodies": { "ground": { "points": { "O": [0, 0, 0] } },
      "slide": { "mass": 1, "inertia": [0, 0, 0], "points": { "O": [0, 0, 0] } } },
    "joints": { "slide": { "type": "prismatic", "from": "ground.O", "to": "slide.O", "axis": "x" } },
    "joint_forces": { "all": { "joint": "slide", "force": "push" } },
    "outputs": { "x": { "joint": "slide" } } })");
  const LinearSystem system = system_of(c);
  for (const std::complex<double>& value : frequency_response(c.model, system, 0, 0, {1e-200, 1}))
    EXPECT_FALSE(std::isnan(value.real()) || std::isnan(value.imag()));
  EXPECT_TRUE(std::isinf(frequency_response(c.model, system, 0, 0, {1e-200})[0].real()));
}

// A driven carriage carries a mass on a spring: the input moves with its rate and its acceleration.
TEST(FrequencyResponse, OfAMotionByAnInputWithRates) {
  const Compilation c = compilation_of(R"({ "mbgen": 1, "gravity": [0, 0, 0],
    "inputs": { "way": { "derivative": "way_rate" }, "way_rate": { "derivative": "way_acceleration" }, "way_acceleration": {} },
    "bodies": { "ground": { "points": { "O": [0, 0, 0] } },
      "carriage": { "mass": 3, "inertia": [0, 0, 0], "points": { "O": [0, 0, 0] } },
      "slide": { "mass": 2, "inertia": [0, 0, 0], "points": { "O": [0, 0, 0] } } },
    "joints": { "drive": { "type": "prismatic", "from": "ground.O", "to": "carriage.O", "axis": "x" },
      "slide": { "type": "prismatic", "from": "carriage.O", "to": "slide.O", "axis": "x" } },
    "motions": { "drive": { "joint": "drive", "position": "way" } },
    "joint_forces": { "all": { "joint": "slide", "force": "-200*z.slide - 8*zd.slide" } },
    "outputs": { "x": { "point": "slide.O", "axis": "x" }, "force": { "motion": "drive" } } })");
  const LinearSystem system = system_of(c);
  const std::vector<Complex> x = frequency_response(c.model, system, 0, 0, kFrequencies);
  const std::vector<Complex> force = frequency_response(c.model, system, 0, 1, kFrequencies);
  for (std::size_t i = 0; i < kFrequencies.size(); ++i) {
    const Complex s(0, 2 * std::numbers::pi * kFrequencies[i]);
    const Complex exact = (8.0 * s + 200.0) / (2.0 * s * s + 8.0 * s + 200.0), driven = s * s * (3.0 + 2.0 * exact);
    EXPECT_LT(std::abs(x[i] - exact), 1e-11 * std::abs(exact)) << i;
    EXPECT_LT(std::abs(force[i] - driven), 1e-11 * std::abs(driven)) << i;
  }
}

}  // namespace
}  // namespace mbgen
