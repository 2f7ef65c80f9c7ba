#include "workbench/engines/kept_decisions.hpp"

#include <filesystem>
#include <fstream>
#include <optional>
#include <string>
#include <system_error>
#include <utility>

#include "compiler/analysis/analysis_bytes.hpp"
#include "compiler/text/hash.hpp"
#include "workbench/describe/dump_model.hpp"
#include "workbench/engines/auto_engine.hpp"
#include "workbench/engines/kept_object.hpp"
#include "workbench/engines/kept_objects.hpp"
#include "workbench/engines/kept_request.hpp"
#include "workbench/host/own_directory.hpp"
#include "workbench/host/temporary_directory.hpp"

namespace mbgen {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostDecisions = 64;  // of some kilobytes each: models that one works on

fs::path file_of_decisions(const fs::path& cache, const Model& model) {
  Hash hash;
  for (const std::string& text : {this_program(), model.name, model.hash, dump_model(model)}) hash.add(text);
  return cache / (hash.text() + kEndingOfDecisions);
}

/// The decisions of a file, with the topology that they count in.
std::optional<Compilation> recalled(const fs::path& file, const Model& model) {
  if (!is_own_file(file)) return std::nullopt;
  const std::optional<std::string> bytes = content_of_sealed(file);
  std::optional<Analysis> analysis = bytes ? analysis_of_bytes(*bytes) : std::nullopt;
  if (!analysis) return std::nullopt;
  Result<Topology> topology = build_topology(model);
  if (!topology || analysis->blocks.size() != topology->blocks.size() ||
      analysis->driven.size() != topology->bodies.size())
    return std::nullopt;
  return Compilation{model, std::move(*topology), std::move(*analysis)};
}

void keep_decisions(const fs::path& cache, const fs::path& file, const Analysis& analysis) {
  const TemporaryDirectory scratch(cache);
  const fs::path written = scratch.path() / "decisions";
  std::ofstream stream(written, std::ios::binary);
  stream << sealed(bytes_of(analysis));
  stream.close();
  std::error_code problem;
  if (!stream) return;
  fs::permissions(written, fs::perms::owner_read | fs::perms::owner_write, problem);
  if (!problem) fs::rename(written, file, problem);
  keep_newest(cache, kEndingOfDecisions, kMostDecisions);
}

Result<Compilation> decide_or_recall(Model model) {
  const fs::path cache = own_cache(false);  // the search for a solver tells
  if (cache.empty()) return decide(std::move(model));
  const fs::path file = file_of_decisions(cache, model);
  if (std::optional<Compilation> kept = recalled(file, model)) {
    mark_used(file);
    return std::move(*kept);
  }
  Result<Compilation> decided = decide(std::move(model));
  if (decided) keep_decisions(cache, file, decided->analysis);
  return decided;
}

}  // namespace

Result<Compilation> decide_for(Model model, const EngineChoice& choice) {
  const bool is_generated = choice.name == "generated";
  const bool is_kept = choice.use_cache && (is_generated || choice.name == kAutoEngine);
  Result<Compilation> decided = is_kept ? decide_or_recall(std::move(model)) : decide(std::move(model));
  if (!decided || !is_generated) return decided;
  if (Diagnostics problems = too_large(*decided, choice.form); !problems.empty()) return problems;
  return decided;
}

}  // namespace mbgen
