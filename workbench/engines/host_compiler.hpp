#pragma once
// The C++ compiler of the machine.

#include <filesystem>
#include <string>
#include <vector>

#include "workbench/host/process.hpp"

namespace mbgen {

struct HostCompiler {
  std::vector<std::string> words;       ///< of $CXX
  std::string version;                  ///< its own version text
  std::vector<std::string> flags;       ///< of emitted code; without -fPIC
  std::vector<std::string> hot_flags;   ///< further ones for code that runs at every step
  std::vector<std::string> rare_flags;  ///< further ones for code that runs rarely
  bool is_clang = false;
};

/// A text that differs where two compilers may make different objects of the same source on this processor.
std::string key_of(const HostCompiler& compiler);

/// A machine that a compiler here can compile for.
struct CrossTarget {
  std::string platform;   ///< "" for this machine
  std::string compiler;   ///< its command
  std::string variable;   ///< of the environment, for another command
  std::string package;    ///< of Debian, that has it
  std::string otherwise;  ///< a way without that compiler
};

/// The compiler for a target. scratch: a directory for its answer. Fails: UserError when it does not run.
HostCompiler find_cross_compiler(const std::filesystem::path& scratch, const CrossTarget& target);

/// $CXX, or c++. scratch: a directory for its answer; processor: a flag like "-march=native", "" for none; lanes: as
/// the solver has them. Fails: UserError when it does not run.
HostCompiler find_compiler(const std::filesystem::path& scratch, const std::string& processor, int lanes);

/// A compilation without its output: the compiler, its flags, `-I` of each directory.
std::vector<std::string> compilation_of(const HostCompiler& compiler,
                                        const std::vector<std::filesystem::path>& directories);

/// Runs compilations side by side and shows how many of them have ended. product: name of their result, in words;
/// advice: a way without waiting, from its comma on. Fails: std::runtime_error with the end of the messages of the
/// first that fails; Interrupted.
void run_all(const std::vector<Command>& commands, const std::string& product, const std::string& advice = "");

/// A source file to compile.
struct Source {
  std::filesystem::path path;
  int rare_parts = 0;               ///< see EmittedFile
  bool is_rare = false;             ///< all of it runs rarely
  std::filesystem::path user = {};  ///< another source, compiled in one with the last part: headers are read once
};

/// Compiles sources, large ones in as many parts as there are processors; code that runs rarely with rare_flags, other
/// code with hot_flags. directories: of headers; objects: the directory for the objects; product, advice: as for
/// run_all. Result: the objects. Fails: as run_all.
std::vector<std::string> compile_sources(const HostCompiler& compiler,
                                         const std::vector<std::filesystem::path>& directories,
                                         const std::vector<Source>& sources, const std::filesystem::path& objects,
                                         const std::string& product, const std::string& advice = "");

}  // namespace mbgen
