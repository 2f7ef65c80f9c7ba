#pragma once
// Comparison of a tyre with its mirror image.

#include <gtest/gtest.h>

#include "mbgen/tyres/tyre.hpp"

namespace mbgen {

/// Forces and moments of a tyre and of its mirror image in mirrored motion.
inline void expect_mirrored(const TyreResult<double>& mirrored, const TyreResult<double>& one) {
  EXPECT_EQ(mirrored.fx, one.fx);
  EXPECT_EQ(mirrored.fy, -one.fy);
  EXPECT_EQ(mirrored.mx, -one.mx);
  EXPECT_EQ(mirrored.my, one.my);
  EXPECT_EQ(mirrored.mz, -one.mz);
}

}  // namespace mbgen
