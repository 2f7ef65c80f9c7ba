#pragma once
// The way from what was asked for to a kept solver, without translating the model again.

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "compiler/compile.hpp"
#include "workbench/engines/engine.hpp"
#include "workbench/engines/host_compiler.hpp"

namespace mbgen {

/// Of the files of the cache with decisions about models, see kept_decisions.hpp.
constexpr const char* kEndingOfDecisions = ".decisions";

/// This program, as long as nobody builds it anew.
std::string this_program();

/// Removes all files of that ending but the `most` that were written last.
void keep_newest(const std::filesystem::path& cache, std::string_view ending, std::size_t most);

/// Hash of all that decides on the code of a solver, its name aside: this program, the texts of the model's files, its
/// elements as they are now, the choices and the compiler. Equal requests give equal solvers.
std::string request_of(const Compilation& decided, const EngineChoice& choice, const HostCompiler& compiler);

/// The request of the whole solver in place of one of regular positions alone.
std::string request_of_whole(const std::string& request);

/// The object that a request led to, where the cache has both.
std::optional<std::filesystem::path> object_of_request(const std::filesystem::path& cache, const std::string& request);

/// Remembers the object of a request. scratch: a directory in the cache. Nothing happens where the disk does not take
/// it.
void remember_request(const std::filesystem::path& cache, const std::filesystem::path& scratch,
                      const std::string& request, const std::filesystem::path& object);

/// Removes the requests whose objects are gone.
void forget_requests(const std::filesystem::path& cache);

}  // namespace mbgen
