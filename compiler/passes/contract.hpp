#pragma once

#include "compiler/program/program.hpp"

namespace mbgen {

/// Products that only sums and differences need go into all of them, rounded once: the choice that compilers make in
/// contracting, each in its own way, made here for all of them. Of two such products in one sum the later one goes, so
/// that the sum waits for one operation less. Labelled products and outputs stay.
/// Ensures: every other value as it was; each contracted one with one rounding less. A product of several sums counts
/// in each of them.
///   %3 = mul %0 %1; %4 = sub %2 %3   =>   %3 = submul %2 %0 %1
Program contract(const Program& program);

}  // namespace mbgen
