#pragma once
// Emitted files, compiled with every warning an error and loaded into the test.

#include <dlfcn.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "compiler/emit/emit.hpp"
#include "mbgen/driver.hpp"

namespace mbgen::test {

namespace fs = std::filesystem;

/// A directory that goes away with its owner.
class TemporaryDirectory {
 public:
  TemporaryDirectory() {
    std::string pattern = (fs::temp_directory_path() / "mbgen_emit_XXXXXX").string();
    path_ = mkdtemp(pattern.data());
  }
  ~TemporaryDirectory() { fs::remove_all(path_); }
  TemporaryDirectory(const TemporaryDirectory&) = delete;
  const fs::path& path() const { return path_; }

 private:
  fs::path path_;
};

/// Exit code and everything printed.
struct Finished {
  int code = -1;
  std::string text;
};

inline Finished run(const std::string& command) {
  Finished result;
  FILE* pipe = popen((command + " 2>&1").c_str(), "r");
  if (pipe == nullptr) return result;
  std::array<char, 4096> buffer;
  while (const std::size_t size = fread(buffer.data(), 1, buffer.size(), pipe)) result.text.append(buffer.data(), size);
  result.code = pclose(pipe);
  return result;
}

inline void write(const fs::path& directory, const EmittedFile& file) {
  const fs::path path = directory / file.path;
  fs::create_directories(path.parent_path());
  std::ofstream(path, std::ios::binary) << file.text;
}

struct Compiler {
  const char* command;
  CompilerFamily family;
};

/// For names of tests.
inline void PrintTo(const Compiler& compiler, std::ostream* out) { *out << compiler.command; }

inline bool is_installed(const Compiler& compiler) {
  return run(std::string(compiler.command) + " --version").code == 0;
}

/// Command with the flags of solvers and all warnings as errors.
inline std::string compile_command(const Compiler& compiler) {
  std::string text = compiler.command;
  for (const std::string& flag : solver_compile_flags(compiler.family)) text += " " + flag;
  return text + " -Wall -Wextra -Wpedantic -Wconversion -Wshadow -Wdouble-promotion -Werror";
}

/// Symbols that an object file leaves to others: of libm alone, unless something is wrong.
inline std::vector<std::string> foreign_symbols(const fs::path& object) {
  static const std::array allowed = {"sin", "cos", "sincos", "tan",  "asin", "acos", "atan",  "atan2",
                                     "exp", "log", "pow",    "tanh", "sqrt", "fabs", "floor", "_GLOBAL_OFFSET_TABLE_"};
  std::vector<std::string> foreign;
  std::istringstream lines(run("nm -u " + object.string()).text);
  for (std::string mark, symbol; lines >> mark >> symbol;) {
    if (std::find(allowed.begin(), allowed.end(), symbol) == allowed.end()) foreign.push_back(symbol);
  }
  return foreign;
}

/// Emitted files and their driver as a loaded library. A solver of several parts is compiled part by part.
class Loaded {
 public:
  /// files: with the solver and its driver; headers of the runtime are taken from the source tree.
  Loaded(const std::vector<EmittedFile>& files, const std::string& name, const Compiler& compiler,
         const std::string& more_flags = "") {
    for (const EmittedFile& file : files) write(directory_.path(), file);
    const std::string base = (directory_.path() / name).string();
    const std::string command = compile_command(compiler) + more_flags + " -I" + directory_.path().string() +
                                " -I" MBGEN_SOURCE_DIR "/runtime/include -fPIC ";
    std::string sources = base + "_driver.cpp";
    const int rare_parts = std::find_if(files.begin(), files.end(), [&](const EmittedFile& file) {
                             return file.path == name + ".cpp";
                           })->rare_parts;
    if (rare_parts == 0) sources += " " + base + ".cpp";
    for (int part = 0; rare_parts > 0 && part <= std::min(rare_parts, 2); ++part) {  // from the second on together
      const std::string object = base + "." + std::to_string(part) + ".o";
      std::string words = command + "-c -DMBGEN_PART=" + std::to_string(part);
      if (part == 2) words += " -DMBGEN_LAST_PART=" + std::to_string(rare_parts);
      if (part > 0) {
        for (const std::string& flag : rare_compile_flags(compiler.family)) words += " " + flag;
      }
      compilation_ = run(words + " -o " + object + " " + base + ".cpp");
      if (compilation_.code != 0) return;
      sources += " " + object;
    }
    compilation_ = run(command + "-shared -o " + base + ".so " + sources);
    if (compilation_.code != 0) return;
    handle_ = dlopen((base + ".so").c_str(), RTLD_NOW | RTLD_LOCAL);
    if (handle_ == nullptr) return;
    using Door = const SolverTable* (*)();
    if (const auto door = reinterpret_cast<Door>(dlsym(handle_, "mbgen_solver_table"))) table_ = door();
  }
  ~Loaded() {
    if (handle_ != nullptr) dlclose(handle_);
  }
  Loaded(const Loaded&) = delete;
  const Finished& compilation() const { return compilation_; }
  /// Null when something failed.
  const SolverTable* table() const { return table_; }

 private:
  TemporaryDirectory directory_;
  Finished compilation_;
  void* handle_ = nullptr;
  const SolverTable* table_ = nullptr;
};

}  // namespace mbgen::test
