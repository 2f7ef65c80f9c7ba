// Headers of emitted code include no header that takes a compiler longer to read than the code takes: those of vector
// instructions, 40 000 lines, were in every part of every solver.

#include <gtest/gtest.h>

#include <array>
#include <cstdio>
#include <string>

namespace mbgen {
namespace {

#if defined(__clang__)  // it has no builtins for vectors of eight
constexpr const char* kProcessors[] = {"x86-64-v2", "x86-64-v3"};
#else
constexpr const char* kProcessors[] = {"x86-64-v2", "x86-64-v3", "x86-64-v4"};
#endif

/// All headers that a header needs, on a processor; "" where the compiler does not know that.
std::string headers_of(const std::string& header, const std::string& processor) {
  const std::string include = std::string(MBGEN_SOURCE_DIR) + "/runtime/include";
  const std::string command = "c++ -std=c++17 -march=" + processor + " -M -x c++ '-I" + include + "' '" + include +
                              "/mbgen/" + header + "' 2>/dev/null";
  FILE* pipe = ::popen(command.c_str(), "r");
  if (pipe == nullptr) return "";
  std::string text;
  for (std::array<char, 4096> part{}; std::fgets(part.data(), part.size(), pipe) != nullptr;) text += part.data();
  return ::pclose(pipe) == 0 ? text : "";
}

TEST(LightHeaders, OfVectorsAreWithoutThoseOfTheCompiler) {
  for (const char* header : {"lanes.hpp", "fma.hpp", "elements.hpp", "solver.hpp"})
    for (const char* processor : kProcessors) {
      const std::string headers = headers_of(header, processor);
      if (headers.empty()) GTEST_SKIP() << "no compiler for " << processor;
      EXPECT_EQ(headers.find("intrin.h"), std::string::npos) << header << " on " << processor;
    }
}

}  // namespace
}  // namespace mbgen
