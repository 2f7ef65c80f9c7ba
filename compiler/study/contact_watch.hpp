#pragma once
// Rolling contacts that pull: nothing lifts off, so a motion says where a disc or ball would.

#include <string>
#include <vector>

#include "compiler/study/simulation.hpp"

namespace mbgen {

/// The normal forces of rolling discs and balls along a motion.
class ContactWatch {
 public:
  explicit ContactWatch(const Compilation& compilation);

  /// Whether the motion's samples need their multipliers.
  bool needs_multipliers() const { return !contacts_.empty(); }
  void add(const Sample& sample);
  /// A warning for each contact that pulled, with the first time and the largest force.
  std::vector<std::string> warnings() const;

 private:
  struct Contact {
    const Loop* loop;
    std::size_t row;     ///< of the normal force among all multipliers
    double since = 0;    ///< s, when it first pulled
    double largest = 0;  ///< N, of pulling
    double scale = 0;    ///< N, the largest force of any sign
  };
  std::vector<Contact> contacts_;
};

}  // namespace mbgen
