#pragma once
// Formulations of the paper's first section.

namespace mbgen {

/// Solution method of (5).
enum class CartesianMethod {
  augmented,    ///< (5) with redundant equations removed by (12)-(15)
  range_space,  ///< (16)-(20)
  null_space,   ///< (27)
  maggi         ///< (30)
};

}  // namespace mbgen
