#include "bench/compare/code_facts.hpp"

#include <fmt/format.h>
#include <sys/resource.h>

#include <algorithm>
#include <ctime>
#include <filesystem>
#include <sstream>

#include "compiler/reader/read_model.hpp"
#include "compiler/text/user_error.hpp"
#include "workbench/host/files.hpp"
#include "workbench/host/own_directory.hpp"
#include "workbench/host/process.hpp"
#include "workbench/host/temporary_directory.hpp"

namespace mbgen::compare {
namespace {

namespace fs = std::filesystem;
using Words = std::vector<std::string>;

constexpr int kGenerations = 3;

/// Processor time, s: of this process, and of the programs that it waited for.
double own_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

double children_seconds() {
  rusage use{};
  getrusage(RUSAGE_CHILDREN, &use);
  const auto seconds = [](const timeval& t) {
    return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
  };
  return seconds(use.ru_utime) + seconds(use.ru_stime);
}

/// Output of a program; "" when it fails.
std::string answer(const fs::path& scratch, const Words& words) {
  const fs::path log = scratch / "log";
  return run_side_by_side({{words, log}})[0] == 0 ? read_text(log) : "";
}

/// g++ with the flags of solvers for a processor.
Words compiler(const std::string& processor) {
  Words words{"g++"};
  for (const std::string& flag : solver_compile_flags(CompilerFamily::gnu)) words.push_back(flag);
  words.push_back("-march=" + processor);
  return words;
}

void compile_or_throw(const fs::path& scratch, Words words, const Words& more) {
  words.insert(words.end(), more.begin(), more.end());
  words.insert(words.end(), {"-I", scratch.string()});
  if (run_side_by_side({{words, scratch / "log"}})[0] == 0) return;
  throw UserError("g++ does not compile the generated solver:\n" + read_text(scratch / "log"));
}

/// Files of the solver and its driver, in scratch. Result: the least time that making them took, s.
double generate(const Model& model, const fs::path& scratch, OperationCount& operations) {
  double least = 1e9;
  for (int k = 0; k < kGenerations; ++k) {
    const double start = own_seconds();
    const Compilation compilation =
        expect(model.file.empty() ? compile(model) : compile(expect(read_model_file(model.file))));
    std::vector<NamedText> files;
    for (EmittedFile& file : emit(compilation)) files.push_back({file.path, std::move(file.text)});
    write_files(scratch, files, {});
    least = std::min(least, own_seconds() - start);
    const EmittedFile driver = emit_driver(compilation.model);
    write_files(scratch, {{driver.path, driver.text}}, {});
    operations = count_operations(counted_programs(compilation).accelerations);
  }
  return least;
}

/// Bytes of the functions whose names say that they compute accelerations.
long hot_bytes(const fs::path& scratch, const std::string& object) {
  std::istringstream lines(answer(scratch, {"nm", "-S", "--defined-only", object}));
  long sum = 0;
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    std::string address, size, type, name;
    if (!(words >> address >> size >> type >> name) || (type != "t" && type != "T")) continue;
    if (name.find("compute_accelerations") != std::string::npos) sum += std::stol(size, nullptr, 16);
  }
  return sum;
}

long text_bytes(const fs::path& scratch, const std::string& object) {
  std::istringstream words(answer(scratch, {"size", "-A", object}));
  long sum = 0;
  for (std::string name, size; words >> name;) {
    if (!name.starts_with(".text")) continue;
    words >> size;
    sum += std::stol(size);
  }
  return sum;
}

std::string states_text(const std::vector<LoadedState>& states) {
  std::string text = fmt::format("{}\n", states.size());
  for (const LoadedState& at : states) {
    for (const std::vector<double>* part : {&at.state.z, &at.state.zd, &at.state.x})
      for (const double value : *part) text += fmt::format("{:.17g} ", value);
    text += fmt::format("{:.17g}\n", at.state.t);
    for (const double value : at.tau) text += fmt::format("{:.17g} ", value);
    text += "\n";
  }
  return text;
}

/// Instructions that a run of the counting program executes, -1 without valgrind.
long collected(const fs::path& scratch, int repetitions) {
  const std::string text =
      answer(scratch, {"valgrind", "--tool=callgrind", "--callgrind-out-file=/dev/null", (scratch / "counted").string(),
                       (scratch / "states").string(), std::to_string(repetitions)});
  const std::size_t place = text.find("Collected :");
  return place == std::string::npos ? -1 : std::stol(text.substr(place + 11));
}

std::optional<long> instructions(const fs::path& scratch, const std::string& source,
                                 const std::vector<LoadedState>& states) {
  if (answer(scratch, {"valgrind", "--version"}).empty()) return {};
  const std::string driver = source.substr(0, source.size() - 4) + "_driver.cpp";
  write_files(scratch, {{"states", states_text(states)}}, {});
  compile_or_throw(
      scratch, compiler("x86-64-v3"),
      {source, driver, MBGEN_SOURCE_DIR "/bench/compare/counted/main.cpp", "-o", (scratch / "counted").string()});
  const long once = collected(scratch, 1), more = collected(scratch, 11);
  if (once < 0 || more < 0) return {};
  return (more - once) / (10 * static_cast<long>(states.size()));
}

}  // namespace

CodeFacts code_facts(const Model& model, const std::vector<LoadedState>& states) {
  const TemporaryDirectory directory(temporary_parent());
  const fs::path& scratch = directory.path();
  CodeFacts facts;
  facts.generation_seconds = generate(model, scratch, facts.operations);
  const std::string source = (scratch / (solver_name(model) + ".cpp")).string(), object = source + ".o";
  const double start = children_seconds();
  compile_or_throw(scratch, compiler("native"), {"-c", source, "-o", object});
  facts.compile_seconds = children_seconds() - start;
  facts.hot_bytes = hot_bytes(scratch, object);
  facts.text_bytes = text_bytes(scratch, object);
  facts.instructions = instructions(scratch, source, states);
  return facts;
}

}  // namespace mbgen::compare
