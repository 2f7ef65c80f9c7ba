// Counts of generated code against tests/ceilings.json.

#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "compiler/compile.hpp"
#include "tests/support/compiled_solver.hpp"

namespace mbgen::test {
namespace {

const Compiler kGcc{"g++", CompilerFamily::gnu};

nlohmann::ordered_json ceilings() {
  std::ifstream file(MBGEN_SOURCE_DIR "/tests/ceilings.json");
  return nlohmann::ordered_json::parse(file, nullptr, true, true);
}

Compilation compilation(const std::string& model) {
  Result<Compilation> compiled = compile(MBGEN_SOURCE_DIR "/models/" + model + ".json");
  if (!compiled) throw std::runtime_error(to_text(compiled.problems()));
  return std::move(*compiled);
}

/// Sizes of the functions of an object whose names hold `part`, summed up.
long bytes_of(const fs::path& object, const std::string& part) {
  std::istringstream lines(run("nm -S --defined-only " + object.string()).text);
  long sum = 0;
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    std::string address, size, type, name;
    if (!(words >> address >> size >> type >> name) || (type != "t" && type != "T")) continue;
    if (name.find(part) != std::string::npos) sum += std::stol(size, nullptr, 16);
  }
  return sum;
}

TEST(Ceilings, operationsOfAccelerations) {
  const nlohmann::ordered_json table = ceilings();
  for (const auto& [model, limits] : table.items()) {
    const long operations = count_operations(counted_programs(compilation(model)).accelerations).total();
    EXPECT_LE(operations, limits["operations"].get<long>()) << model << ": see tests/ceilings.json";
    EXPECT_GT(operations, 0) << model;
  }
}

TEST(Ceilings, bytesOfAccelerations) {
  if (!is_installed(kGcc)) GTEST_SKIP() << "g++ is not installed";
  const nlohmann::ordered_json table = ceilings();
  for (const auto& [model, limits] : table.items()) {
    if (!limits.contains("bytes")) continue;
    const Compilation compiled = compilation(model);
    const TemporaryDirectory directory;
    std::string part;
    for (const EmittedFile& file : emit(compiled, {.runtime_headers = false})) {
      write(directory.path(), file);
      if (file.rare_parts > 0) part = " -DMBGEN_PART=0";  // the part with the accelerations
    }
    const fs::path source = directory.path() / (solver_name(compiled.model) + ".cpp"), object = directory.path() / "o";
    const Finished finished =
        run(compile_command(kGcc) + part + " -march=x86-64-v3 -I" + directory.path().string() + " -I" MBGEN_SOURCE_DIR +
            "/runtime/include -c -o " + object.string() + " " + source.string());
    ASSERT_EQ(finished.code, 0) << finished.text;
    const long bytes = bytes_of(object, "compute_accelerations");
    EXPECT_LE(bytes, limits["bytes"].get<long>()) << model << ": see tests/ceilings.json";
    EXPECT_GT(bytes, 0) << model;
  }
}

}  // namespace
}  // namespace mbgen::test
