#include "tests/system/published/run.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstdio>
#include <fstream>
#include <stdexcept>

#include "compiler/reader/read_model.hpp"
#include "compiler/text/user_error.hpp"
#include "workbench/start/initial_state.hpp"

namespace mbgen::published {
namespace {

std::string source_path(const std::string& relative) { return std::string(MBGEN_SOURCE_DIR) + "/" + relative; }

}  // namespace

nlohmann::json reference(const std::string& name) {
  return nlohmann::json::parse(std::ifstream(source_path("tests/data/reference/" + name)));
}

double number(const nlohmann::json& value) {
  return value.is_string() ? std::stod(value.get<std::string>()) : value.get<double>();
}

Compilation compiled(const std::string& model) { return expect(compile(source_path(model))); }
Compilation compiled(Model model) { return expect(compile(std::move(model))); }

Compilation compiled_text(const std::string& text) { return compiled(expect(read_model(text, "text.json"))); }

std::string output_of(const std::string& command) {
  FILE* const pipe = popen(fmt::format("cd '{}' && {}", MBGEN_SOURCE_DIR, command).c_str(), "r");
  if (pipe == nullptr) throw std::runtime_error("cannot run " + command);
  std::string text;
  for (int c = std::fgetc(pipe); c != EOF; c = std::fgetc(pipe)) text += static_cast<char>(c);
  if (pclose(pipe) != 0) throw std::runtime_error("failed: " + command);
  return text;
}

Run::Run(const std::string& model, double h) : Run(compiled(model), h) {}

Run::Run(Compilation compilation, double h) : compilation_(std::move(compilation)), h_(h) {
  EngineChoice choice;
  choice.use_cache = false;  // the solver of this source, whatever was compiled before
  engine_ = make_engine(compilation_, choice);
  state_.state = initial_state(compilation_, {});
  state_.tau.assign(state_.state.z.size(), 0.0);
}

void Run::take_reference() { state_.state = reference_state(compilation_); }

void Run::set_step(double h) { h_ = h; }

void Run::go_to(double t) {
  for (long steps = std::lround((t - state_.state.t) / h_); steps > 0; --steps) {
    const Status status = engine_.step(state_.state, h_);
    if (!status.ok())
      throw std::runtime_error(fmt::format("{} at {} s", describe(compilation_, status), state_.state.t));
  }
}

GenericOutputs Run::outputs() const {
  GenericDerivative derivative;
  GenericOutputs values;
  Status status = engine_.accelerations_in_motion(state_.state, h_, derivative);
  if (status.ok()) status = engine_.outputs(state_, derivative, values);
  if (!status.ok()) throw std::runtime_error(describe(compilation_, status));
  return values;
}

double Run::output(const std::string& name) const {
  for (std::size_t i = 0; i < compilation_.model.outputs.size(); ++i)
    if (compilation_.model.outputs[i].name == name) return outputs().y[i];
  throw std::runtime_error("no output " + name);
}

double Run::energy() const {
  const GenericOutputs values = outputs();
  return values.kinetic_energy + values.potential_energy;
}

}  // namespace mbgen::published
