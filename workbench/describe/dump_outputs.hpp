#pragma once
// Outputs as text, with names in place of indices.

#include <string>

#include "compiler/model/model.hpp"

namespace mbgen {

/// Names and numbers of one model.
struct ModelWords {
  const Model& model_;

  std::string quantity(const Quantity& value) const;
  std::string attachment(const Attachment& at) const;
  std::string coordinate(const CoordinateReference& reference) const;
  std::string body_name(int body) const;  ///< of none ground
};

/// A line: name, unit and source.
std::string output_text(const Model& model, const Output& output);

}  // namespace mbgen
