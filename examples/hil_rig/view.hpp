#pragma once
// View of a run: redrawn in place on a terminal, a line a second elsewhere, and the result at the end.

#include <cstdio>
#include <deque>
#include <string>

#include "loop.hpp"

namespace hil_rig {

/// An event in words, without end of line.
std::string words_of(const Event& event);

/// The view of a run while it goes on.
class View {
 public:
  View(std::FILE* file, bool terminal);

  /// Takes a message: into the view, or a line of its own.
  void say(const std::string& message);

  /// Shows where the run is: anew on a terminal, otherwise when the model's time passes a whole second.
  void show(const Glance& glance);

 private:
  std::FILE* file_;
  bool terminal_;
  std::deque<std::string> said_;  ///< the last few messages
  long seconds_ = 0;              ///< of the last line
};

/// Counters, one a line by name, and both times in numbers.
void print_result(std::FILE* file, const Tally& tally, const Plant& plant);

}  // namespace hil_rig
