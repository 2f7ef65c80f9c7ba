// Tables as files: what is written is read again, and every bad file of tests/errors/results has its exact message.
// After a wanted change: MBGEN_UPDATE=1 results_test rewrites the texts; read the difference before committing it.
#include "workbench/results/results.hpp"

#include <gtest/gtest.h>

#include <cstring>
#include <filesystem>

#include "tests/support/expected_text.hpp"

namespace mbgen {
namespace {

using namespace mbgen::testing;
namespace fs = std::filesystem;

const fs::path kErrors = fs::path(MBGEN_SOURCE_DIR) / "tests" / "errors" / "results";

TEST(Results, EveryBadFileHasItsExactMessage) {
  int count = 0;
  for (const fs::directory_entry& entry : fs::directory_iterator(kErrors)) {
    if (entry.path().extension() != ".table") continue;
    const std::string name = entry.path().filename().string();
    const Result<Results> results = read_results(content(entry.path()), name);
    ASSERT_FALSE(results) << name << " was accepted";
    expect_text(fs::path(entry.path()).replace_extension(".txt"), to_text(results.problems()));
    ++count;
  }
  EXPECT_GE(count, 13);
}

Results example() {
  return {{{{"t", "s"}, {0, 0.5, 1}},
           {{"z.hinge", "rad"}, {1e-300, -2.5, 1.0 / 3}},
           {{"height above the road", "m"}, {4, 5, 6}},
           {{"bare", ""}, {7, 8, 9}}},
          "{\"mbgen_run\": 1}"};
}

TEST(Results, MatIsReadAsItWasWritten) {
  const Results written = example();
  const Result<Results> read = read_results(mat_text(written), "x.mat");
  ASSERT_TRUE(read);
  EXPECT_EQ(read->run, written.run);
  ASSERT_EQ(read->columns.size(), written.columns.size());
  for (std::size_t c = 0; c < written.columns.size(); ++c) {
    EXPECT_EQ(read->columns[c].heading.name, written.columns[c].heading.name);
    EXPECT_EQ(read->columns[c].heading.unit, written.columns[c].heading.unit);
    EXPECT_EQ(read->columns[c].values, written.columns[c].values);
  }
}

// The format's own example of a header: rows, columns, imaginary flag and length of the name with its zero.
TEST(Results, MatBeginsWithTheNamesAsText) {
  const std::string bytes = mat_text(example());
  std::int32_t header[5];
  ASSERT_GT(bytes.size(), sizeof(header));
  std::memcpy(header, bytes.data(), sizeof(header));
  EXPECT_EQ(header[0], 51);
  EXPECT_EQ(header[1], 4);
  EXPECT_EQ(header[2], 21);
  EXPECT_EQ(header[3], 0);
  EXPECT_EQ(header[4], 6);
  EXPECT_EQ(bytes.substr(sizeof(header), 6), std::string("names\0", 6));
  EXPECT_EQ(bytes.substr(sizeof(header) + 6, 8), "tzhb .ea") << "column by column";
}

TEST(Results, EveryCutMatFileIsRefused) {
  const std::string bytes = mat_text(example());
  for (std::size_t size = 0; size < bytes.size(); ++size) {
    const Result<Results> read = read_results(std::string_view(bytes).substr(0, size), "x.mat");
    if (!read) continue;
    EXPECT_TRUE(read->run.empty() && size > bytes.size() / 2) << "cut after " << size << " bytes";
  }
}

TEST(Results, CsvFieldsComeBackFromQuotes) {
  for (const std::string text : {"plain", "a,b", "say \"no\"", "N m"}) {
    EXPECT_EQ(csv_fields(csv_field(text) + ", " + csv_field(text)), (std::vector<std::string>{text, text}));
  }
  EXPECT_EQ(heading_of("a [b] [N/m]").name, "a [b]");
  EXPECT_EQ(heading_of("a [b] [N/m]").unit, "N/m");
}

TEST(Results, CsvMayHaveBlankLinesAndCarriageReturns) {
  const Result<Results> read = read_results("t [s],\"a, b [m]\"\r\n0, 1\r\n\r\n1,-2.5e-3\r\n", "x.csv");
  ASSERT_TRUE(read) << to_text(read.problems());
  EXPECT_EQ(find_column(*read, "a, b"), 1);
  EXPECT_EQ(find_column(*read, "a, b [m]"), 1);
  EXPECT_EQ(find_column(*read, "a"), -1);
  EXPECT_EQ(read->columns[1].values, (std::vector<double>{1, -2.5e-3}));
}

}  // namespace
}  // namespace mbgen
