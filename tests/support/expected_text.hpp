#pragma once
// Texts that a test expects, a file each.

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

namespace mbgen::testing {

/// Bytes of a file; "" where it cannot be read.
inline std::string content(const std::filesystem::path& path) {
  std::ifstream stream(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

/// Compares a text with that of a file, which MBGEN_UPDATE=1 rewrites.
inline void expect_text(const std::filesystem::path& expected, const std::string& text) {
  if (std::getenv("MBGEN_UPDATE")) std::ofstream(expected, std::ios::binary) << text;
  EXPECT_EQ(text, content(expected)) << expected << "; MBGEN_UPDATE=1 rewrites the expected texts";
}

}  // namespace mbgen::testing
