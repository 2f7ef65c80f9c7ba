#pragma once
// The fine structure of a loop block under its frozen partition, for the elimination at run time.

#include <vector>

#include "compiler/analysis/findings.hpp"
#include "compiler/program/program.hpp"
#include "compiler/solver/layout.hpp"

namespace mbgen {

/// See FineBlock and FineStructure of mbgen/solver/fine.hpp; empty where all of a block is eliminated at once.
struct FineBlocks {
  struct Part {
    int size = 0, first = 0, first_earlier = 0, earlier = 0;
  };
  std::vector<Part> parts;
  std::vector<int> rows, columns, earlier, others;

  int largest() const;
};

/// Strongly connected parts of the equations with a pivot over the dependent coordinates, in the order in which they
/// can be solved. pattern: equations x coordinates, true where an entry is not always zero. Empty where the parts do
/// not save half of the elimination, and where equations of velocities alone are redundant, whose pivots wait.
/// Source: Dulmage and Mendelsohn.
FineBlocks fine_blocks(const BlockAnalysis& block, const std::vector<std::vector<bool>>& pattern);

/// The same by the Jacobian that the program of the closures' terms gives for the block.
FineBlocks fine_blocks(const BlockAnalysis& block, std::size_t b, const BlockPlaces& places,
                       const Program& closure_terms);

}  // namespace mbgen
