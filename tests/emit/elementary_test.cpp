// The bits of the runtime's elementary functions, by compiler and by flags.

#include <gtest/gtest.h>

#include <set>

#include "tests/support/compiled_solver.hpp"

namespace mbgen::test {
namespace {

/// Prints a hash of the sines, cosines and arc tangents of many numbers, alone and in arrays.
constexpr const char* kProgram = R"(
#include <cstdint>
#include <cstdio>
#include <initializer_list>
#include "mbgen/math/arc_tangent.hpp"
#include "mbgen/math/sincos.hpp"
int main() {
  std::uint64_t hash = 14695981039346656037u, seed = 1;
  const auto mix = [&](double value) { hash = (hash ^ __builtin_bit_cast(std::uint64_t, value)) * 1099511628211u; };
  double angles[21], sines[21], cosines[21], arcs[21];
  for (int turn = 0; turn < 20000; ++turn) {
    for (double& angle : angles) {
      seed = seed * 6364136223846793005u + 1442695040888963407u;
      angle = static_cast<double>(static_cast<std::int64_t>(seed)) * (turn % 3 == 0 ? 0x1p-43 : 0x1p-62);
    }
    mbgen::sincos(angles, sines, cosines);
    mbgen::arc_tangents(angles, arcs);
    for (int i = 0; i < 21; ++i) {
      double s = 0, c = 0;
      mbgen::sincos(angles[i], s, c);
      for (const double value : {s, c, sines[i], cosines[i], arcs[i], mbgen::arc_tangent(angles[i])}) mix(value);
    }
  }
  std::printf("%016llx\n", static_cast<unsigned long long>(hash));
}
)";

/// Outputs of the program by every installed compiler with every one of the flags.
std::set<std::string> printed(const std::vector<std::string>& more_flags) {
  TemporaryDirectory directory;
  write(directory.path(), {"bits.cpp", kProgram});
  const std::string base = (directory.path() / "bits").string();
  std::set<std::string> results;
  for (const Compiler& compiler : {Compiler{"g++", CompilerFamily::gnu}, Compiler{"clang++", CompilerFamily::clang}}) {
    if (!is_installed(compiler)) continue;
    for (const std::string& flags : more_flags) {
      const Finished compilation = run(compile_command(compiler) + " " + flags +
                                       " -I" MBGEN_SOURCE_DIR "/runtime/include -o " + base + " " + base + ".cpp");
      EXPECT_EQ(compilation.code, 0) << compilation.text;
      results.insert(run(base).text);
    }
  }
  return results;
}

TEST(ElementaryBits, areThoseOfEveryCompiler) {
  EXPECT_EQ(printed({"-march=native", "-march=native -O3", "-march=native -ffp-contract=fast"}).size(), 1u);
}

TEST(ElementaryBits, areThoseOfEveryCompilerWithoutFusedMultiplyAdd) {
  EXPECT_EQ(printed({"", "-O3", "-ffp-contract=fast"}).size(), 1u);
}

}  // namespace
}  // namespace mbgen::test
