#pragma once
// What is written, and what a solver knows of its start.

#include <string>
#include <vector>

namespace mbgen {

/// Version of mbgen in banners and manifests, equal to the project version of CMakeLists.txt.
constexpr const char* kMbgenVersion = "0.1.0";

/// Values that make a part of a file worth a compilation of its own: that reads the headers once more, which takes as
/// long as some thousand values.
constexpr std::size_t kFilePartValues = 4000;

/// Of the Functional Mock-up Interface.
enum class FmiVersion { two = 2, three = 3 };

/// A file to write, path relative to the output directory.
struct EmittedFile {
  std::string path;
  std::string text;
  /// Of a source: compilations with MBGEN_PART = 0, 1, ..., rare_parts give together what one without it gives. What
  /// the parts from 1 on hold runs rarely.
  int rare_parts = 0;
};

/// A parameter that acts at the start, and the change of the velocities there by its change of 1.
struct StartParameter {
  int parameter = -1;  ///< index into Model::parameters
  std::vector<double> zd;
};

/// Where solvers start: loops closed, velocities consistent.
struct InitialState {
  std::vector<double> z, zd, x;
  std::vector<StartParameter> parameters = {};
};

}  // namespace mbgen
