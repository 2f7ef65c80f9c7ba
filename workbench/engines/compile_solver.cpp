#include "workbench/engines/compile_solver.hpp"

#include <dlfcn.h>
#include <fmt/format.h>

#include <filesystem>
#include <optional>
#include <stdexcept>

#include "compiler/text/code_text.hpp"
#include "compiler/text/hash.hpp"
#include "compiler/text/user_error.hpp"
#include "workbench/engines/host_compiler.hpp"
#include "workbench/engines/kept_object.hpp"
#include "workbench/engines/kept_objects.hpp"
#include "workbench/engines/kept_request.hpp"
#include "workbench/host/files.hpp"
#include "workbench/host/large_pages.hpp"
#include "workbench/host/message.hpp"
#include "workbench/host/own_directory.hpp"
#include "workbench/host/progress.hpp"
#include "workbench/host/temporary_directory.hpp"

namespace mbgen {
namespace {

namespace fs = std::filesystem;

/// The symbol that a driver with this table exports.
template <class Table>
constexpr const char* kSymbol = std::is_same_v<Table, TangentTable> ? "mbgen_tangent_table" : "mbgen_solver_table";
constexpr const char* kAdvice = "; simulate --engine auto does not wait for it";
/// Of a processor, in g++ 12 for a quick compilation: 200 functions of the truck on a bending frame (models/beams), 8
/// MB.
constexpr double kSecondsPerMegabyte = 6;
constexpr double kToldFrom = 60;  // s

bool is_code(const EmittedFile& file) { return file.path.ends_with(".cpp") || file.path.ends_with(".hpp"); }

std::string object_name(const std::string& solver, const std::vector<EmittedFile>& files,
                        const HostCompiler& compiler) {
  Hash hash;
  for (const EmittedFile& file : files) {
    if (!is_code(file)) continue;
    hash.add(file.path);
    hash.add(code_without_comments(file.text));
  }
  hash.add(key_of(compiler));
  return fmt::format("{}-{}.so", solver, hash.text());
}

/// The sources of a solver. For a quick compilation its driver, the last one, is no source of its own.
std::vector<Source> sources_of(const std::vector<EmittedFile>& files, const fs::path& scratch, bool is_quick) {
  std::vector<Source> sources;
  for (const EmittedFile& file : files)
    if (file.path.ends_with(".cpp")) sources.push_back({scratch / file.path, file.rare_parts});
  if (!is_quick) return sources;
  sources.front().user = sources.back().path;
  sources.pop_back();
  return sources;
}

/// Says beforehand that a compilation takes minutes.
void tell_long_compilation(const std::vector<EmittedFile>& files, const std::string& product) {
  double megabytes = 0;
  for (const EmittedFile& file : files)
    if (file.path.ends_with(".cpp")) megabytes += 1e-6 * static_cast<double>(file.text.size());
  const double seconds = kSecondsPerMegabyte * megabytes;
  if (seconds < kToldFrom) return;
  print_message("compiling {} takes about {} of a processor: {:.0f} MB of code{}\n", product, time_text(seconds),
                megabytes, kAdvice);
}

/// Compiles the sources of a solver and links them. Result: the shared object, in `scratch`.
fs::path build(const fs::path& scratch, const std::string& solver, const std::vector<EmittedFile>& files,
               HostCompiler compiler) {
  std::vector<NamedText> texts;
  for (const EmittedFile& file : files) texts.push_back({file.path, file.text});
  write_files(scratch, texts, {});
  const std::vector<Source> sources = sources_of(files, scratch, !compiler.hot_flags.empty());
  compiler.flags.emplace_back("-fPIC");
  const std::string product = "the solver of " + solver;
  tell_long_compilation(files, product);
  const fs::path result = scratch / "solver.so";
  Command link{compiler.words, scratch / "link.log", result};
  link.arguments.insert(link.arguments.end(), {"-shared", "-o", result.string()});
  for (std::string& object : compile_sources(compiler, {scratch}, sources, scratch, product, kAdvice)) {
    link.arguments.push_back(std::move(object));
  }
  link.arguments.push_back("-lm");
  run_all({link}, product);
  return result;
}

/// The table of a compiled solver, null when the file is none of this mbgen and a model of that name.
template <class Table>
std::shared_ptr<const Table> open_solver(const fs::path& object, const std::string& model) {
  void* handle = ::dlopen(object.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (handle == nullptr) return nullptr;
  const std::shared_ptr<void> library(handle, ::dlclose);
  const auto table_of = reinterpret_cast<const Table* (*)()>(::dlsym(handle, kSymbol<Table>));
  const Table* table = table_of == nullptr ? nullptr : table_of();
  if (table == nullptr || table->layout != kSolverTableLayout || table->model != model) return nullptr;
  return {library, table};
}

/// The same of the cache, null when it has none that is whole.
template <class Table>
std::shared_ptr<const Table> open_kept(const fs::path& object, const std::string& model) {
  if (!is_own_file(object) || !is_sealed(object)) return nullptr;
  auto solver = open_solver<Table>(object, model);
  if (solver) mark_used(object);
  return solver;
}

/// Whether a solver is compiled fast.
bool runs_briefly(const EngineChoice& choice) {
  return (choice.use == SolverUse::running || choice.use == SolverUse::regular) && choice.lanes == 0;
}

HostCompiler compiler_for(const fs::path& scratch, const EngineChoice& choice) {
  const int lanes = choice.use == SolverUse::derivatives ? kDirections : choice.lanes;
  HostCompiler compiler = find_compiler(scratch, "-march=native", lanes);
  if (runs_briefly(choice)) {
    compiler.hot_flags = quick_compile_flags(compiler.is_clang ? CompilerFamily::clang : CompilerFamily::gnu);
    // Functions of <cmath> like Bessel's, which no solver calls, are a third of the headers' time.
    compiler.flags.emplace_back("-D_GLIBCXX_BITS_SPECFUN_H");
  }
  return compiler;
}

std::vector<EmittedFile> files_of(const Compilation& decided, const EngineChoice& choice) {
  const auto emitted = [&](const Compilation& compilation) {
    return choice.use == SolverUse::derivatives
               ? emit_tangents_for_loading(compilation)
               : emit_for_loading(compilation, {.clocked = choice.use == SolverUse::timing_steps,
                                                .lanes = choice.lanes,
                                                .regular_only = choice.use == SolverUse::regular});
  };
  if (decided.has_programs()) return emitted(decided);
  take_large_pages(decided.model.bodies.size());
  Compilation compilation = decided;
  add_programs(compilation, {.form = choice.form, .for_text_alone = true});
  return emitted(compilation);
}

/// The solver of a request that the cache holds, in place of one of regular positions alone the whole one; or null.
template <class Table>
std::shared_ptr<const Table> open_requested(const fs::path& cache, const std::string& request,
                                            const std::string& model) {
  const auto opened = [&](const std::string& one) -> std::shared_ptr<const Table> {
    const auto kept = object_of_request(cache, one);
    return kept ? open_kept<Table>(*kept, model) : nullptr;
  };
  const std::string whole = request_of_whole(request);
  auto solver = opened(whole);
  return solver || whole == request ? solver : opened(request);
}

/// See load_solver.
template <class Table>
std::shared_ptr<const Table> load(const Compilation& decided, const EngineChoice& choice) {
  const fs::path cache = choice.use_cache ? own_cache() : fs::path();
  const bool has_cache = !cache.empty();
  const TemporaryDirectory scratch(has_cache ? cache : temporary_parent());
  const HostCompiler compiler = compiler_for(scratch.path(), choice);
  const std::string& model = decided.model.name;
  const std::string request = has_cache ? request_of(decided, choice, compiler) : "";
  if (has_cache) {
    if (auto solver = open_requested<Table>(cache, request, model)) return solver;
  }
  const std::vector<EmittedFile> files = files_of(decided, choice);
  const std::string name = solver_name(decided.model);
  const fs::path kept = cache / object_name(name, files, compiler);
  if (has_cache) {
    if (auto solver = open_kept<Table>(kept, model)) {
      remember_request(cache, scratch.path(), request, kept);
      return solver;
    }
  }
  fs::path object = build(scratch.path(), name, files, compiler);
  if (has_cache) {
    seal(object);
    if (keep(object, kept)) {
      object = kept;
      remember_request(cache, scratch.path(), request, kept);
    }
  }
  auto solver = open_solver<Table>(object, model);
  if (!solver) throw std::runtime_error(fmt::format("the compiled solver {} does not load", object.string()));
  if (has_cache) keep_within_room(cache);
  return solver;
}

}  // namespace

std::shared_ptr<const SolverTable> kept_solver(const Compilation& decided, EngineChoice choice) {
  const fs::path cache = choice.use_cache ? own_cache() : fs::path();
  const TemporaryDirectory scratch(temporary_parent());
  const HostCompiler compiler = compiler_for(scratch.path(), choice);
  if (runs_briefly(choice)) choice.use = SolverUse::regular;
  if (cache.empty()) return nullptr;
  return open_requested<SolverTable>(cache, request_of(decided, choice, compiler), decided.model.name);
}

std::shared_ptr<const SolverTable> load_solver(const Compilation& decided, const EngineChoice& choice) {
  return load<SolverTable>(decided, choice);
}

std::shared_ptr<const SolverTable> load_regular_solver(const Compilation& decided, EngineChoice choice) {
  if (runs_briefly(choice)) choice.use = SolverUse::regular;
  return load<SolverTable>(decided, choice);
}

std::shared_ptr<const TangentTable> load_tangents(const Compilation& decided, EngineChoice choice) {
  choice.use = SolverUse::derivatives;
  choice.lanes = 0;
  return load<TangentTable>(decided, choice);
}

}  // namespace mbgen
