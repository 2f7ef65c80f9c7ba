#pragma once
// Values for expressions of the model: parameters, inputs, time, and coordinates by joint and component.

#include <array>
#include <vector>

#include "compiler/expressions/evaluate.hpp"
#include "compiler/model/model.hpp"

namespace mbgen::cartesian {

/// Tree index per joint of the model and component; -1 for a cut joint.
using CoordinateTable = std::vector<std::vector<int>>;

struct Values {
  const Model& model;
  const CoordinateTable& table;
  const std::vector<double>&parameters, &inputs;
  double t = 0;
  const std::vector<double>*z = nullptr, *zd = nullptr;  ///< per tree coordinate; zero without
  std::array<double, 2> locals{};
  std::vector<double> states{};            ///< the user's, then sampled values
  std::vector<double> lengths{}, rates{};  ///< of springs, air springs, rods: m, m/s
  std::vector<double> observed{};          ///< of Model::observed, as far as they are known

  double parameter(int i) const { return parameters[i]; }
  double input(int i) const { return inputs[i]; }
  double time() const { return t; }
  double position(const CoordinateReference& c) const { return at(z, c); }
  double velocity(const CoordinateReference& c) const { return at(zd, c); }
  double local(int i) const { return locals[i]; }
  double state(int i) const { return states[i]; }
  double length(int i) const { return lengths[i]; }
  double rate(int i) const { return rates[i]; }
  double output(int i) const { return observed[i]; }

  double operator()(const Quantity& quantity) const { return evaluate<double>(quantity, model.expressions, *this); }

 private:
  double at(const std::vector<double>* values, const CoordinateReference& c) const {
    const int i = table[c.joint][c.component];
    return values == nullptr || i < 0 ? 0.0 : (*values)[i];
  }
};

}  // namespace mbgen::cartesian
