#include "workbench/engines/compile_solver.hpp"

#include <dlfcn.h>
#include <fmt/format.h>

#include <filesystem>
#include <fstream>
#include <stdexcept>

#include "compiler/text/hash.hpp"
#include "compiler/text/user_error.hpp"
#include "workbench/engines/host_compiler.hpp"
#include "workbench/engines/kept_object.hpp"
#include "workbench/host/files.hpp"
#include "workbench/host/own_directory.hpp"
#include "workbench/host/temporary_directory.hpp"

namespace mbgen {
namespace {

namespace fs = std::filesystem;

constexpr const char* kSymbol = "mbgen_solver_table";

/// The line of /proc/cpuinfo that lists the processor's instruction sets: code made for one processor may not run on
/// another.
std::string processor() {
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);) {
    if (line.starts_with("flags") || line.starts_with("Features")) return line;
  }
  return "";
}

std::string object_name(const std::string& solver, const std::vector<EmittedFile>& files,
                        const HostCompiler& compiler) {
  Hash hash;
  for (const EmittedFile& file : files) {
    hash.add(file.path);
    hash.add(file.text);
  }
  for (const std::string& word : compiler.words) hash.add(word);
  for (const std::string& flag : compiler.flags) hash.add(flag);
  for (const std::string& flag : compiler.hot_flags) hash.add(flag);
  for (const std::string& flag : compiler.rare_flags) hash.add(flag);
  hash.add(compiler.version);
  hash.add(processor());
  return fmt::format("{}-{}.so", solver, hash.text());
}

/// Compiles the sources of a solver and links them. Result: the shared object, in `scratch`.
fs::path build(const fs::path& scratch, const std::string& solver, const std::vector<EmittedFile>& files,
               HostCompiler compiler) {
  std::vector<NamedText> texts;
  std::vector<Source> sources;
  for (const EmittedFile& file : files) {
    texts.push_back({file.path, file.text});
    if (file.path.ends_with(".cpp")) sources.push_back({scratch / file.path, file.rare_parts});
  }
  write_files(scratch, texts, {});
  compiler.flags.emplace_back("-fPIC");
  const std::string product = "the solver of " + solver;
  const fs::path result = scratch / "solver.so";
  Command link{compiler.words, scratch / "link.log", result};
  link.arguments.insert(link.arguments.end(), {"-shared", "-o", result.string()});
  for (std::string& object : compile_sources(compiler, {scratch}, sources, scratch, product)) {
    link.arguments.push_back(std::move(object));
  }
  link.arguments.push_back("-lm");
  run_all({link}, product);
  return result;
}

/// The table of a compiled solver, null when the file is none of this mbgen and this model.
std::shared_ptr<const SolverTable> open_solver(const fs::path& object, const std::string& hash) {
  void* handle = ::dlopen(object.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (handle == nullptr) return nullptr;
  const std::shared_ptr<void> library(handle, ::dlclose);
  const auto table_of = reinterpret_cast<const SolverTable* (*)()>(::dlsym(handle, kSymbol));
  const SolverTable* table = table_of == nullptr ? nullptr : table_of();
  if (table == nullptr || table->layout != kSolverTableLayout || table->hash != hash) return nullptr;
  return {library, table};
}

}  // namespace

std::shared_ptr<const SolverTable> load_solver(const Compilation& compilation, const EngineChoice& choice) {
  const bool use_cache = choice.use_cache;
  std::vector<EmittedFile> files = emit(compilation, {.lanes = choice.lanes});
  files.push_back(choice.use == SolverUse::timing_steps ? emit_clocked_driver(compilation, choice.lanes)
                                                        : emit_driver(compilation.model, choice.lanes));
  const fs::path cache = use_cache ? own_cache() : fs::path();
  const bool has_cache = !cache.empty();
  const TemporaryDirectory scratch(has_cache ? cache : temporary_parent());
  HostCompiler compiler = find_compiler(scratch.path(), "-march=native", choice.lanes);
  if (choice.use == SolverUse::running && choice.lanes == 0) {
    compiler.hot_flags = quick_compile_flags(compiler.is_clang ? CompilerFamily::clang : CompilerFamily::gnu);
  }
  const std::string name = solver_name(compilation.model);
  const fs::path kept = cache / object_name(name, files, compiler);

  if (has_cache && is_own_file(kept) && is_sealed(kept)) {
    if (auto solver = open_solver(kept, compilation.model.hash)) return solver;
  }
  fs::path object = build(scratch.path(), name, files, compiler);
  if (has_cache) {
    seal(object);
    if (keep(object, kept)) object = kept;
  }
  auto solver = open_solver(object, compilation.model.hash);
  if (!solver) throw std::runtime_error(fmt::format("the compiled solver {} does not load", object.string()));
  return solver;
}

}  // namespace mbgen
