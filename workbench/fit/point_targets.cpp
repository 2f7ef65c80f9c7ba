#include "workbench/fit/point_targets.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "compiler/linearisation/linearisation.hpp"
#include "compiler/text/characters.hpp"
#include "compiler/text/number.hpp"
#include "compiler/text/user_error.hpp"
#include "workbench/host/assignments.hpp"
#include "workbench/operating/operating_point.hpp"

namespace mbgen::fit {
namespace {

constexpr const char* kGrammar = "start:OUTPUT=VALUE:SIGMA, mode:K:frequency=VALUE:SIGMA or mode:K:damping=VALUE:SIGMA";

/// VALUE:SIGMA behind the sign.
void read_numbers(const std::string& name, const std::string& text, MeasuredChannel& measured, Channel& channel) {
  const std::vector<std::string> parts = split_at(text, ':');
  if (parts.size() != 2)
    throw UserError(fmt::format("--target {}: write VALUE:SIGMA, found {}\n", name, in_quotes(text)));
  measured.at = {0};
  measured.values = {parse_number(parts[0], "--target " + name)};
  channel.sigma = parse_number(parts[1], "--target " + name + ": standard deviation");
  channel.has_sigma = true;
  if (!(channel.sigma > 0))
    throw UserError(fmt::format("--target {}: the standard deviation must be above 0, found {}\n", name, parts[1]));
}

void read_name(const Model& model, const std::vector<std::string>& words, Channel& channel) {
  if (words.size() == 2 && words[0] == "start") {
    const auto is_it = [&](const Output& output) { return output.name == words[1]; };
    const auto found = std::find_if(model.outputs.begin(), model.outputs.end(), is_it);
    std::vector<std::string> names;
    for (const Output& output : model.outputs) names.push_back(output.name);
    if (found == model.outputs.end())
      throw UserError(fmt::format("--target {}: the model has no output \"{}\"\n{}", channel.name, words[1],
                                  nearest_hint(words[1], names)));
    channel.output = static_cast<int>(found - model.outputs.begin());
    channel.unit = found->unit;
    return;
  }
  const bool is_mode = words.size() == 3 && words[0] == "mode" && (words[2] == "frequency" || words[2] == "damping");
  if (!is_mode) throw UserError(fmt::format("--target {}: must be {}\n", in_quotes(channel.name), kGrammar));
  const double number = parse_number(words[1], "--target " + channel.name + ": number of the mode");
  if (number < 1 || number != std::floor(number) || number > 1e6)
    throw UserError(fmt::format("--target {}: modes are numbered from 1, found {}\n", channel.name, words[1]));
  channel.mode = static_cast<int>(number);
  channel.quantity = words[2];
  channel.unit = words[2] == "frequency" ? "Hz" : "1";
}

/// Oscillations by increasing frequency.
std::vector<Mode> oscillations(const FitModel& model, Compilation& compilation, const OperatingPoint& at) {
  if (model.is_tuned) {
    compilation.whole = model.compilation.whole;
    compilation.emitted = model.compilation.emitted;
    compilation.spelling = model.compilation.spelling;
  }
  if (!compilation.has_programs()) add_programs(compilation);
  std::vector<Mode> list = modes(expect(linearise_by_any_choice(compilation, at)));
  put_slowest_first(list);
  std::erase_if(list, [](const Mode& mode) { return !mode.oscillates(); });
  return list;
}

/// Outputs of a state.
std::vector<double> outputs_at(const Compilation& compilation, const OperatingPoint& at) {
  const Engine engine = make_generic_engine(compilation, {});
  engine.set_inputs(at.inputs);
  LoadedState loaded;
  loaded.state.z = at.z;
  loaded.state.zd = at.zd;
  loaded.state.x = at.x;
  loaded.state.t = at.t;
  loaded.tau.assign(at.z.size(), 0.0);
  GenericDerivative derivative;
  GenericOutputs outputs;
  Status status = engine.accelerations(loaded, derivative);
  if (status.ok()) status = engine.outputs(loaded, derivative, outputs);
  if (!status.ok()) throw UserError(fmt::format("at the start: {}\n", describe(compilation, status)));
  return outputs.y;
}

double value_of(const Channel& channel, const std::vector<Mode>& list, const std::vector<double>& outputs) {
  if (channel.mode == 0) return outputs[static_cast<std::size_t>(channel.output)];
  if (static_cast<std::size_t>(channel.mode) > list.size())
    throw UserError(fmt::format("{}: the model has {} oscillations\n", channel.name, list.size()));
  const Mode& mode = list[static_cast<std::size_t>(channel.mode) - 1];
  return channel.quantity == "frequency" ? mode.undamped_frequency() : mode.damping_ratio();
}

}  // namespace

MeasuredFile point_targets(const Model& model, const std::vector<std::string>& texts, std::vector<Channel>& channels) {
  MeasuredFile file{.path = "--target", .is_of_points = true};
  for (const std::string& text : texts) {
    const std::size_t sign = text.find('=');
    if (sign == std::string::npos) throw UserError(fmt::format("--target: {} must be {}\n", in_quotes(text), kGrammar));
    Channel channel{.name = text.substr(0, sign)};
    const auto is_same = [&](const Channel& one) { return one.name == channel.name; };
    if (std::any_of(channels.begin(), channels.end(), is_same))
      throw UserError(fmt::format("--target: \"{}\" stands twice\n", channel.name));
    read_name(model, split_at(channel.name, ':'), channel);
    MeasuredChannel measured{static_cast<int>(channels.size()), {}, {}};
    read_numbers(channel.name, text.substr(sign + 1), measured, channel);
    channels.push_back(std::move(channel));
    file.channels.push_back(std::move(measured));
  }
  return file;
}

Outcome point_values(const FitModel& model, const MeasuredFile& file, const std::vector<Channel>& channels,
                     const std::vector<Unknown>& unknowns, const std::vector<double>& values) {
  const auto channel_of = [&](const MeasuredChannel& measured) -> const Channel& {
    return channels[static_cast<std::size_t>(measured.channel)];
  };
  try {
    Compilation compilation = compilation_at(model, unknowns, values);
    StateArguments start;
    start.at = "initial";
    start.inputs = model.arguments.engine.inputs;
    const OperatingPoint at = operating_point(compilation, start).point;
    const std::vector<double> outputs = outputs_at(compilation, at);
    const bool needs_modes = std::any_of(file.channels.begin(), file.channels.end(),
                                         [&](const MeasuredChannel& one) { return channel_of(one).mode > 0; });
    const std::vector<Mode> list = needs_modes ? oscillations(model, compilation, at) : std::vector<Mode>();
    Outcome outcome;
    for (const MeasuredChannel& measured : file.channels)
      outcome.series.push_back({{0}, {value_of(channel_of(measured), list, outputs)}});
    return outcome;
  } catch (const UserError& error) {
    const std::string text = error.what();
    return {text.substr(0, text.find('\n')), {}, {}};
  }
}

}  // namespace mbgen::fit
