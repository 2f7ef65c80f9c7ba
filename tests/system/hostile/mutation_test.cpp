// Every file of models/ with one place damaged: a model that compiles, or diagnostics that stand inside the text.
//   MBGEN_MUTATIONS=all hostile_test --gtest_filter='Mutations.*'   every place in every way (minutes); by default a
//   sample MBGEN_LAST_MUTATION=FILE                                        keeps the text at work, to be found after a
//   crash
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>

#include "compiler/compile.hpp"
#include "compiler/reader/read_model.hpp"
#include "mutations.hpp"

namespace mbgen::test {
namespace {

namespace fs = std::filesystem;

/// Coordinates up to which a mutant is compiled and emitted; the others end at their tree.
constexpr int kMostCompiled = 12;

std::vector<fs::path> model_files() {
  std::vector<fs::path> files;
  for (const auto& entry : fs::recursive_directory_iterator(fs::path(MBGEN_SOURCE_DIR) / "models")) {
    const bool is_model = entry.path().parent_path().filename() != "manoeuvres";
    if (is_model && entry.path().extension() == ".json") files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

/// One damaged file.
struct Mutant {
  std::size_t file, place, way;
};

struct Tally {
  std::size_t mutants = 0, refused = 0, trees = 0, compiled = 0;
  double slowest = 0;  ///< s
  std::string slowest_of;
};

void expect_clean(const Diagnostics& problems, const std::string& text, const std::string& file) {
  ASSERT_FALSE(problems.empty());
  const auto lines = std::count(text.begin(), text.end(), '\n') + 1;
  for (const Diagnostic& problem : problems) {
    ASSERT_FALSE(problem.message.empty());
    if (problem.where.file != file) continue;  // of an include, which is whole
    ASSERT_GE(problem.where.line, 0);
    ASSERT_LE(problem.where.line, lines);
    ASSERT_LE(static_cast<std::size_t>(std::max(problem.where.column, 0)), text.size() + 1);
  }
  for (const char c : to_text(problems)) ASSERT_TRUE(static_cast<unsigned char>(c) >= 0x20 || c == '\n' || c == '\t');
}

/// Reads, and compiles where that is quick. Any exception is a defect.
void examine(const std::string& text, const std::string& file, Tally& tally) {
  const Result<Model> model = read_model(text, file);
  if (!model) {
    ++tally.refused;
    return expect_clean(model.problems(), text, file);
  }
  const Result<Topology> topology = build_topology(*model);
  if (!topology) {
    ++tally.refused;
    return expect_clean(topology.problems(), text, file);
  }
  ++tally.trees;
  if (topology->size() > kMostCompiled) return;
  const Result<Compilation> compilation = compile(*model);
  if (!compilation) {
    ++tally.refused;
    return expect_clean(compilation.problems(), text, file);
  }
  ++tally.compiled;
  ASSERT_GT(emit(*compilation).size(), 4u);
}

std::string content(const fs::path& path) {
  std::ifstream stream(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

class Mutations : public testing::Test {
 protected:
  Mutations() : files_(model_files()) {
    for (const fs::path& file : files_) documents_.push_back(Json::parse(content(file), nullptr, true, true));
  }

  /// Every place of every file in every way.
  std::vector<Mutant> all() const {
    std::vector<Mutant> list;
    for (std::size_t f = 0; f < files_.size(); ++f) {
      std::vector<bool> is_member;
      Damage::members_in(documents_[f], is_member);
      for (std::size_t place = 0; place < is_member.size(); ++place) {
        const std::size_t ways = is_member[place] ? ways_of_member() : ways_of_value();
        for (std::size_t way = 0; way < ways; ++way) list.push_back({f, place, way});
      }
    }
    return list;
  }

  void examine_all(const std::vector<Mutant>& mutants) {
    const char* kept = std::getenv("MBGEN_LAST_MUTATION");
    Tally tally;
    for (const Mutant& mutant : mutants) {
      const std::string text = Damage(documents_[mutant.file], mutant.place, mutant.way).text();
      const std::string file = files_[mutant.file].string();
      const std::string name = fmt::format("{} place {} way {}", file, mutant.place, mutant.way);
      SCOPED_TRACE(name);
      if (kept != nullptr) std::ofstream(kept, std::ios::binary) << text;
      const auto start = std::chrono::steady_clock::now();
      ASSERT_NO_THROW(examine(text, file, tally)) << text.substr(0, 20'000);
      if (HasFatalFailure()) return;
      const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
      if (taken.count() > tally.slowest) tally.slowest = taken.count(), tally.slowest_of = name;
      ++tally.mutants;
    }
    fmt::print("{} mutants: {} refused, {} with a tree, {} of them compiled and emitted; slowest {:.2f} s: {}\n",
               tally.mutants, tally.refused, tally.trees, tally.compiled, tally.slowest, tally.slowest_of);
    EXPECT_GT(tally.refused, tally.mutants / 4);
    EXPECT_GT(tally.compiled, tally.mutants / 100);
  }

  std::vector<fs::path> files_;
  std::vector<Json> documents_;
};

TEST_F(Mutations, undamagedDocumentsAreWrittenWhole) {
  ASSERT_GT(files_.size(), 15u);
  for (const Json& document : documents_) {
    EXPECT_EQ(Json::parse(Damage(document, Damage::places_in(document), 0).text()), document);
  }
}

TEST_F(Mutations, giveModelsOrDiagnostics) {
  const char* set = std::getenv("MBGEN_MUTATIONS");
  const std::string asked = set == nullptr ? "2500" : set;
  std::vector<Mutant> mutants = all();
  ASSERT_GT(mutants.size(), 100'000u);
  if (asked != "all") {
    const std::size_t sample = std::min<std::size_t>(std::stoul(asked), mutants.size());
    std::mt19937 random(5);
    for (std::size_t i = 0; i < sample; ++i) std::swap(mutants[i], mutants[i + random() % (mutants.size() - i)]);
    mutants.resize(sample);
  }
  examine_all(mutants);
}

}  // namespace
}  // namespace mbgen::test
