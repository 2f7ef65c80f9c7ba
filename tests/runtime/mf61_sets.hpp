#pragma once
// Sets of MF 6.1 of the reference data.

#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "mbgen/tyres/mf61.hpp"

namespace mbgen {

constexpr double kNominalPressure = 220e3;  // Pa, of the sets

inline nlohmann::json reference_data(const std::string& name) {
  return nlohmann::json::parse(std::ifstream(MBGEN_SOURCE_DIR "/tests/data/" + name));
}

template <class Numbers>
MagicFormula61<double> mf61_set(const Numbers& number) {
  std::vector<double> values;
  for (const TyreField& field : kMf61Fields) values.push_back(number(field));
  return MagicFormula61<double>::from_fields(values.data());
}

/// Without coefficients of turn slip.
inline MagicFormula61<double> passenger_car() {
  static const nlohmann::json numbers = reference_data("tyre_mf61.json")["parameters"];
  return mf61_set([](const TyreField& f) { return numbers.value(f.name, f.default_value); });
}

/// Coefficients of the same tyre with those of turn slip.
inline const nlohmann::json& turning_numbers() {
  static const nlohmann::json numbers = [] {
    nlohmann::json all = reference_data("tyre_mf61.json")["parameters"];
    all.update(reference_data("tyre_mf61_turn_slip.json")["parameters"]);
    return all;
  }();
  return numbers;
}
inline const MagicFormula61<double>& turning_car() {
  static const nlohmann::json& numbers = turning_numbers();
  static const MagicFormula61<double> set =
      mf61_set([](const TyreField& f) { return numbers.value(f.name, f.default_value); });
  return set;
}

/// The same without what acts at no slip and no camber.
inline MagicFormula61<double> symmetric_car() {
  MagicFormula61<double> set = turning_car();
  for (double* shift :
       {&set.phy1, &set.phy2, &set.pvy1, &set.pvy2, &set.qdz6, &set.qdz7, &set.qhz1, &set.qhz2, &set.phx1, &set.phx2,
        &set.pvx1, &set.pvx2, &set.ssz1, &set.rhy1, &set.rhy2, &set.rhx1, &set.pey3})
    *shift = 0;
  return set;
}

}  // namespace mbgen
