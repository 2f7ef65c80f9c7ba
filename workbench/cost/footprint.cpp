#include "workbench/cost/footprint.hpp"

#include <algorithm>
#include <cstdlib>
#include <map>
#include <sstream>

#include "compiler/text/user_error.hpp"
#include "workbench/cost/call_graph.hpp"
#include "workbench/host/files.hpp"

namespace mbgen {
namespace {

namespace fs = std::filesystem;

/// Sizes of sections by kind.
void add_section(const std::string& name, long bytes, Footprint& footprint) {
  if (name.starts_with(".text")) footprint.code += bytes;
  if (name.starts_with(".rodata") || name.starts_with(".data.rel.ro")) footprint.read_only += bytes;
  if (name.starts_with(".eh_frame") || name.starts_with(".ARM.ex")) footprint.unwind_tables += bytes;
  const bool is_data = name.starts_with(".data") && !name.starts_with(".data.rel.ro");
  if (is_data || name.starts_with(".bss")) footprint.writable += bytes;
}

/// Sections of the objects, as `size -A` lists them.
void add_sections(const std::vector<fs::path>& objects, const fs::path& scratch, Footprint& footprint) {
  Command size{{"size", "-A", "-d"}, scratch / "sizes"};
  for (const fs::path& object : objects) size.arguments.push_back(object.string());
  if (run_side_by_side({size})[0] != 0) {
    throw UserError("generate: --measure needs the program `size` (apt-get install binutils)\n");
  }
  std::map<std::string, long> shared;  // sections of one function or table, of which a linker keeps one
  std::istringstream lines(read_text(size.log));
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    std::string name;
    long bytes = 0;
    if (!(words >> name >> bytes) || name.front() != '.') continue;
    if (name.find("._Z") != std::string::npos) {
      shared[name] = std::max(shared[name], bytes);
    } else {
      add_section(name, bytes, footprint);
    }
  }
  for (const auto& [name, bytes] : shared) add_section(name, bytes, footprint);
}

/// Whether an application calls a function.
bool is_interface(const std::string& name, const std::string& solver) {
  const bool is_of_solver = name.starts_with(solver + "::") || name.starts_with(solver + "_");
  return is_of_solver && name.find("::Dynamics::") == std::string::npos;
}

void add_deepest_paths(const std::vector<fs::path>& objects, const std::string& solver, Footprint& footprint) {
  CallGraph graph;
  for (fs::path object : objects) add_call_graph(read_text(object.replace_extension(".ci")), graph);
  for (const auto& [title, function] : graph) {
    if (function.is_outside) footprint.outside.push_back(title);
    if (function.is_outside || function.is_local || !is_interface(function.name, solver)) continue;
    const CallPath path = deepest_path(graph, title);
    StackUse use{function.name, path.bytes, {}};
    for (const std::string& step : path.titles) {
      if (!graph.at(step).is_outside) use.path.push_back(graph.at(step).name);
    }
    footprint.stack.push_back(std::move(use));
  }
  std::stable_sort(footprint.stack.begin(), footprint.stack.end(),
                   [](const StackUse& a, const StackUse& b) { return a.bytes > b.bytes; });
}

/// Sum over the .su files; clang++ leaves out the return address.
void add_all_frames(const std::vector<fs::path>& objects, const std::string& solver, Footprint& footprint) {
  long sum = 0;
  for (fs::path object : objects) {
    std::istringstream lines(read_text(object.replace_extension(".su")));
    for (std::string line; std::getline(lines, line);) {
      const std::size_t tab = line.find('\t');
      if (tab == std::string::npos) continue;
      sum += std::strtol(line.c_str() + tab, nullptr, 10) + static_cast<long>(sizeof(void*));
    }
  }
  footprint.stack_count = StackCount::sum_of_frames;
  footprint.stack.push_back({solver, sum, {}});
}

}  // namespace

Footprint measure_footprint(const std::vector<EmittedFile>& files, const std::string& solver,
                            const HostCompiler& compiler, const fs::path& scratch) {
  std::vector<NamedText> texts;
  std::vector<Command> compilations;
  std::vector<fs::path> objects;
  for (const EmittedFile& file : files) {
    texts.push_back({file.path, file.text});
    if (!file.path.ends_with(".cpp")) continue;
    const fs::path source = scratch / file.path;
    objects.push_back(fs::path(source).replace_extension(".o"));
    Command compilation{compilation_of(compiler, {scratch}), source.string() + ".log"};
    compilation.arguments.push_back("-fstack-usage");
    if (!compiler.is_clang) compilation.arguments.push_back("-fcallgraph-info=su");
    compilation.arguments.insert(compilation.arguments.end(), {"-c", source.string(), "-o", objects.back().string()});
    compilations.push_back(std::move(compilation));
  }
  write_files(scratch, texts, {});
  run_all(compilations, "the solver of " + solver + " to count its bytes");
  Footprint footprint;
  add_sections(objects, scratch, footprint);
  if (compiler.is_clang) {
    add_all_frames(objects, solver, footprint);
  } else {
    add_deepest_paths(objects, solver, footprint);
  }
  return footprint;
}

}  // namespace mbgen
