#pragma once
// A robot's file to import, and the files beside it.

#include <functional>
#include <optional>
#include <string>

namespace mbgen {

/// Base of a URDF robot, which the format does not define; a root link named "world" is the ground itself.
enum class RobotBase { fixed, floating };

struct ImportRequest {
  std::string file;             ///< path of the robot's file, used in messages and as the base of <include>
  std::string text;             ///< its content
  std::string loops_file = {};  ///< path of the sidecar, for messages
  /// content of the sidecar (URDF only): loops, and positions where they close; see docs/use/import.md
  std::optional<std::string> loops = {};
  std::optional<RobotBase> base = {};  ///< of a URDF robot only; fixed without it
  double stop_stiffness = 0;           ///< of stops at the ends of joints' ranges, N m/rad or N/m; 0: none
  /// Content of a file included by the robot's file, nothing if it cannot be read. Called with a path relative to the
  /// working directory.
  std::function<std::optional<std::string>(const std::string& path)> read = {};
};

}  // namespace mbgen
