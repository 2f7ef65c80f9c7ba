#pragma once
// The libraries of a Functional Mock-up Unit: its sources, compiled for this machine and for others.

#include <filesystem>
#include <string>
#include <vector>

#include "compiler/fmu/fmu.hpp"

namespace mbgen {

/// Machines that libraries are compiled for, by FMI 3's names: "x86_64-linux", ...
std::vector<std::string> fmu_platforms();

/// The one of them that runs mbgen.
std::string fmu_platform_of_this_machine();

/// Writes entries of the archive: readable by all, whatever the user's mask is. Fails: as write_files.
void write_entries(const std::filesystem::path& directory, const std::vector<EmittedFile>& files);

/// Compiles the sources below `content` into a library for each of the platforms, with files of its own in `scratch`.
/// Result: the libraries, relative to `content`. Fails: UserError without the platform's compiler; as compile_sources.
std::vector<std::string> compile_fmu_libraries(const FmuFiles& files, FmiVersion version,
                                               const std::vector<std::string>& platforms,
                                               const std::filesystem::path& content,
                                               const std::filesystem::path& scratch);

}  // namespace mbgen
