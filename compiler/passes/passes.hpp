#pragma once
// The door of the passes room. A pass is a pure function Program -> Program; each header holds its contract.
// Every pass keeps name, outputs, sections, owners and labels, and verifies its result.

#include "compiler/passes/contract.hpp"
#include "compiler/passes/dead_values.hpp"
#include "compiler/passes/derived_constants.hpp"
#include "compiler/passes/factor_sums.hpp"
#include "compiler/passes/fewest_alive.hpp"
#include "compiler/passes/lower.hpp"
#include "compiler/passes/merge_divisions.hpp"
