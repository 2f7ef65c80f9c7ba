#pragma once
// Helpers of the model tests: models from text, and small models to vary.

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "compiler/model/model.hpp"
#include "compiler/reader/read_model.hpp"

namespace mbgen {

/// The model of a text. Fails the test, with the messages, when there is none.
inline Model read(const std::string& text) {
  const Result<Model> result = read_model(text, "test.json");
  if (result) return *result;
  ADD_FAILURE() << to_text(result.problems());
  return {};
}

/// Model files in a directory of their own for each test, gone afterwards.
class ModelFiles : public ::testing::Test {
 protected:
  ModelFiles() : directory_(std::filesystem::temp_directory_path() / ("mbgen_model_test_" + std::to_string(getpid()))) {
    std::filesystem::create_directories(directory_);
  }
  ~ModelFiles() override { std::filesystem::remove_all(directory_); }
  std::string write(const std::string& name, const std::string& text) {
    std::ofstream(directory_ / name, std::ios::binary) << text;
    return (directory_ / name).string();
  }
  Model read_file(const std::string& path) {
    const Result<Model> result = read_model_file(path);
    if (result) return *result;
    ADD_FAILURE() << to_text(result.problems());
    return {};
  }
  std::filesystem::path directory_;
};

/// Every message of a text that is no model; empty when it is one.
inline std::string messages(const std::string& text) {
  const Result<Model> result = read_model(text, "test.json");
  return result ? std::string() : to_text(result.problems());
}

/// An arm on a pin about y, with further sections: `"springs": { ... }`.
inline std::string arm_model(const std::string& sections) {
  return R"({ "mbgen": 1,
    "bodies": {
      "ground": { "points": { "A": [0, 0, 0], "T": [0, 0, 2] } },
      "arm": { "mass": 1, "inertia": [1, 1, 1], "points": { "A": [0, 0, 0], "B": [1, 0, 0] } }
    },
    "joints": { "pin": { "type": "revolute", "from": "ground.A", "to": "arm.A", "axis": "y" } })" +
         (sections.empty() ? "" : ", " + sections) + " }";
}

/// Two bodies and one joint, given by what follows its ends: `"type": "spherical"`.
inline std::string joint_model(const std::string& joint, const std::string& pose = "{}") {
  return R"({ "mbgen": 1, "bodies": {
      "ground": { "points": { "A": [0, 0, 0] } },
      "base": { "pose": )" +
         pose + R"(, "points": { "A": [0, 0, 0] } },
      "arm": { "pose": )" +
         pose + R"(, "points": { "A": [0, 0, 0] } } },
    "joints": { "j": { "from": "base.A", "to": "arm.A", )" +
         joint + " } } }";
}

}  // namespace mbgen
