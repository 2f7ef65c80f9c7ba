#pragma once
// Structs of the values that cross the parts of a program.

#include <cstddef>
#include <string>
#include <vector>

namespace mbgen {

/// One struct: an argument of the parts, and its members.
struct CrossingStruct {
  std::string argument;              ///< "work", "work2", ...
  std::vector<std::string> members;  ///< declarators: "s3_12", "sines[22]"
  std::size_t values = 0;
};

using CrossingStructs = std::vector<CrossingStruct>;

/// The struct that takes a member of so many values: the last one, or a new one when that would hold more than `most`
/// (0: no limit). name_of(number): argument of the number-th struct from 1 on.
template <class NameOf>
CrossingStruct& struct_with_room(CrossingStructs& structs, std::size_t values, std::size_t most,
                                 const NameOf& name_of) {
  if (structs.empty() || (most > 0 && structs.back().values + values > most)) {
    structs.push_back({name_of(structs.size() + 1), {}, 0});
  }
  return structs.back();
}

}  // namespace mbgen
