#pragma once
// The elementary functions of emitted code; docs/method/arithmetic.md says how exact they are.

#include "mbgen/arc_tangent.hpp"
#include "mbgen/exponential.hpp"
#include "mbgen/logarithm.hpp"
#include "mbgen/sincos.hpp"
#include "mbgen/single_precision.hpp"
