#pragma once
// The elementary functions of emitted code; docs/method/arithmetic.md gives their errors.

#include "mbgen/math/arc_tangent.hpp"
#include "mbgen/math/exponential.hpp"
#include "mbgen/math/logarithm.hpp"
#include "mbgen/math/sincos.hpp"
#include "mbgen/math/single_precision.hpp"
