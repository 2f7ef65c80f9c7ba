#include "compiler/emit/emit.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <nlohmann/json.hpp>

#include "compiler/emit/context_values.hpp"
#include "compiler/emit/cost_sheet.hpp"
#include "compiler/emit/embedded.hpp"
#include "compiler/emit/quantity_ranges.hpp"
#include "compiler/emit/text.hpp"
#include "compiler/emit/texts.hpp"

namespace mbgen {
namespace {

constexpr std::string_view kRuntime = "runtime/include/";

/// Adds the runtime's headers that a text includes, directly or indirectly.
void add_included_headers(std::string_view text, std::vector<EmittedFile>& files) {
  constexpr std::string_view kInclude = "#include \"mbgen/";
  for (std::size_t at = text.find(kInclude); at != std::string_view::npos; at = text.find(kInclude, at + 1)) {
    const std::size_t start = text.find('"', at) + 1;
    const std::string_view path = text.substr(start, text.find('"', start) - start);
    if (std::ranges::count(files, path, &EmittedFile::path) > 0) continue;
    for (const EmbeddedFile& file : embedded_files()) {
      if (file.path.substr(0, kRuntime.size()) != kRuntime || file.path.substr(kRuntime.size()) != path) continue;
      files.push_back({std::string(path), std::string(file.text)});
      add_included_headers(file.text, files);
    }
  }
}

std::string cmake_words(const std::vector<std::string>& flags) { return wrapped_words(joined(flags, " "), "      "); }

/// `CMakeLists.txt`. rare_parts: of the solver's file.
std::string build_text(const EmitContext& context, int rare_parts) {
  constexpr auto gnu = CompilerFamily::gnu, clang = CompilerFamily::clang;
  return fill_template(context, "CMakeLists.txt.in",
                       {{"banner", banner_text(context.model, "#")},
                        {"c_interface", context.options.c_interface},
                        {"casadi", context.options.casadi},
                        {"whole", rare_parts == 0},
                        {"parts", rare_parts == 0 ? "" : std::to_string(rare_parts)},
                        {"gnu_flags", cmake_words(solver_compile_flags(gnu))},
                        {"gnu_rare_flags", cmake_words(rare_compile_flags(gnu))},
                        {"x86_flags", joined(lane_flags_of_gnu_on_x86(), " ")},
                        {"clang_flags", cmake_words(solver_compile_flags(clang))},
                        {"clang_rare_flags", cmake_words(rare_compile_flags(clang))}});
}

/// `<model>_samples.hpp`: tables of numbers for programs.
std::string samples_text(const EmitContext& context) {
  return fill_template(
      context, "samples.hpp.in",
      {{"banner", banner_text(context.model, "//")},
       {"samples", array_text("inline constexpr double kSamples", number_texts(*context.model.samples), "0")}});
}

/// `<model>_tangents.hpp` and `.cpp`: the whole solver over numbers with derivatives.
void add_tangents(EmitContext context, std::vector<EmittedFile>& files) {
  context.options.scalar = Scalar::tangents;
  context.names.solver += kTangentSuffix;
  files.push_back({context.names.solver + ".hpp", interface_text(context)});
  files.push_back(solver_file(context, shaped_programs(context), false));
  add_samples(context, files);
  add_quantities(context, files);
}

}  // namespace

void add_samples(const EmitContext& context, std::vector<EmittedFile>& files) {
  if (context.model.samples) files.push_back({context.names.solver + "_samples.hpp", samples_text(context)});
}

std::vector<EmittedFile> emit(const WrittenPrograms& programs, const Model& model, const Topology& topology,
                              const Analysis& analysis, const EmitOptions& options) {
  const EmitContext context(programs, model, topology, analysis, options);
  const std::string& name = context.names.solver;
  const std::vector<ShapedProgram> solver = shaped_programs(context);
  std::vector<EmittedFile> files = {{name + ".hpp", interface_text(context)}, solver_file(context, solver, false)};
  std::optional<nlohmann::ordered_json> manifest;
  if (!options.sources_alone) {
    manifest = manifest_json(context, solver);
    files.push_back({name + "_cost.txt", cost_text(*manifest, banner_text(model, "#"))});
    files.push_back({"CMakeLists.txt", build_text(context, files[1].rare_parts)});
  }
  add_samples(context, files);
  add_quantities(context, files);
  if (options.lanes > 0) {
    files.push_back({name + "_batch.hpp", batch_interface_text(context)});
    files.push_back({name + "_batch.cpp", batch_text(context, solver)});
  }
  if (options.tangents) add_tangents(context, files);
  if (options.c_interface) {
    files.push_back({name + "_c.h", c_header_text(context)});
    files.push_back({name + "_c.cpp", c_source_text(context)});
    files.push_back({name + ".py", python_text(context)});
    if (options.tangents) std::ranges::move(tangents_c_files(context), std::back_inserter(files));
    if (options.calibration) {
      files.push_back({name + ".a2l", calibration_text(context)});
      files.push_back({name + "_a2l.h", calibration_header_text(context)});
    }
  }
  if (options.runtime_headers) {
    add_runtime_headers(files);
    if (options.scalar == Scalar::doubles)
      add_included_headers(emit_driver(model, options.lanes, context.layout.actuators > 0).text, files);
  }
  if (manifest) files.push_back({name + ".json", manifest_text(*manifest)});
  return files;
}

std::vector<EmittedFile> emit_tangents(const WrittenPrograms& programs, const Model& model, const Topology& topology,
                                       const Analysis& analysis) {
  std::vector<EmittedFile> files;
  const EmitContext context(programs, model, topology, analysis, {});
  add_tangents(context, files);
  files.push_back(emit_tangent_driver(model, context.layout.actuators > 0));
  add_runtime_headers(files);
  return files;
}

void add_runtime_headers(std::vector<EmittedFile>& files) {
  std::vector<std::string> texts;
  for (const EmittedFile& file : files) texts.push_back(file.text);
  for (const std::string& text : texts) add_included_headers(text, files);
}

std::optional<double> beyond_single_precision(const WrittenPrograms& programs, const Model& model) {
  const auto is_beyond = [](double number) {
    return std::isfinite(number) && std::abs(number) > std::numeric_limits<float>::max();
  };
  for (const Program* program : all_programs(programs))
    for (const Node& node : program->nodes)
      if (node.op == Op::constant && is_beyond(node.constant)) return node.constant;
  for (const Parameter& parameter : model.parameters)
    if (parameter.tunable && is_beyond(parameter.value)) return parameter.value;
  for (const Input& input : model.inputs)
    if (is_beyond(input.default_value)) return input.default_value;
  return {};
}

std::vector<std::string> solver_compile_flags(CompilerFamily family) {
  return words_of(family == CompilerFamily::gnu ? "gnu.flags" : "clang.flags");
}

std::vector<std::string> quick_compile_flags(CompilerFamily family) {
  return words_of(family == CompilerFamily::gnu ? "gnu_quick.flags" : "clang_quick.flags");
}

std::vector<std::string> rare_compile_flags(CompilerFamily family) {
  return words_of(family == CompilerFamily::gnu ? "gnu_rare.flags" : "clang_rare.flags");
}

std::vector<std::string> lane_flags_of_gnu_on_x86() { return words_of("gnu_lanes_x86.flags"); }

}  // namespace mbgen
