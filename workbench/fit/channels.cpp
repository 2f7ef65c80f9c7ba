#include "workbench/fit/channels.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "compiler/text/characters.hpp"
#include "compiler/text/number.hpp"
#include "compiler/text/user_error.hpp"
#include "workbench/host/assignments.hpp"

namespace mbgen::fit {
namespace {

constexpr std::string_view kOfRig = "kc:";

/// Takes ":SIGMA" off the end of a text, where it is there.
std::optional<double> take_sigma(std::string& text, bool is_of_rig) {
  const std::size_t colon = text.rfind(':');
  const std::size_t names = is_of_rig ? text.find(':', kOfRig.size()) : std::string::npos;
  if (colon == std::string::npos || (is_of_rig && (names == std::string::npos || colon <= names))) return {};
  const std::string number = text.substr(colon + 1);
  text = text.substr(0, colon);
  const double sigma = parse_number(number, "--match " + text + ": standard deviation");
  if (!(sigma > 0))
    throw UserError(fmt::format("--match {}: the standard deviation must be above 0, found {}\n", text, number));
  return sigma;
}

void find_output(const Model& model, Channel& channel) {
  std::vector<std::string> names;
  for (const Output& output : model.outputs) names.push_back(output.name);
  const auto found = std::find(names.begin(), names.end(), channel.name);
  if (found == names.end())
    throw UserError(fmt::format(
        "--match: the model has no output \"{}\"\n{}", channel.name,
        names.empty() ? "  hint: list it in \"outputs\" of the model\n" : nearest_hint(channel.name, names)));
  channel.output = static_cast<int>(found - names.begin());
  channel.unit = model.outputs[static_cast<std::size_t>(channel.output)].unit;
}

Channel channel_of(const Model& model, std::string text) {
  Channel channel;
  const bool is_of_rig = text.starts_with(kOfRig);
  if (const std::optional<double> sigma = take_sigma(text, is_of_rig)) {
    channel.sigma = *sigma;
    channel.has_sigma = true;
  }
  const std::size_t sign = text.find('=');
  channel.name = text.substr(0, sign);
  channel.column = sign == std::string::npos ? channel.name : text.substr(sign + 1);
  if (!is_of_rig) {
    find_output(model, channel);
    return channel;
  }
  const std::vector<std::string> words = split_at(channel.name, ':');
  if (words.size() != 3 || words[1].empty() || words[2].empty())
    throw UserError(fmt::format("--match {}: a column of a rig is kc:AXLE:COLUMN\n", channel.name));
  channel.axle = words[1];
  channel.quantity = words[2];
  if (sign == std::string::npos) channel.column = channel.quantity;
  return channel;
}

void add_nuisance(const std::string& word, Channel& channel, int number, std::vector<Unknown>& unknowns) {
  Unknown unknown{.name = word + " of " + channel.name, .channel = number};
  int* place = nullptr;
  if (word == "gain") {
    unknown.kind = Unknown::Kind::gain;
    unknown.unit = "1";
    unknown.start = 1;
    unknown.lower = kLeastGain;
    unknown.upper = kMostGain;
    place = &channel.gain;
  } else if (word == "bias") {
    unknown.kind = Unknown::Kind::bias;
    unknown.unit = channel.unit;
    place = &channel.bias;
  } else if (word == "delay" && !channel.is_of_rig()) {
    unknown.kind = Unknown::Kind::delay;
    unknown.unit = "s";
    unknown.lower = -kMostDelay;
    unknown.upper = kMostDelay;
    unknown.scale = 0.1 * kMostDelay;
    place = &channel.delay;
  } else {
    throw UserError(fmt::format("--nuisance {}: {} is not among gain, bias{}\n", channel.name, in_quotes(word),
                                channel.is_of_rig() ? "" : ", delay"));
  }
  if (*place >= 0) throw UserError(fmt::format("--nuisance {}: {} stands twice\n", channel.name, word));
  *place = static_cast<int>(unknowns.size());
  unknowns.push_back(std::move(unknown));
}

}  // namespace

std::vector<Channel> matched_channels(const Model& model, const std::vector<std::string>& texts) {
  std::vector<Channel> channels;
  for (const std::string& text : texts) {
    Channel channel = channel_of(model, text);
    const auto is_same = [&](const Channel& one) { return one.name == channel.name; };
    if (std::any_of(channels.begin(), channels.end(), is_same))
      throw UserError(fmt::format("--match: \"{}\" stands twice\n", channel.name));
    channels.push_back(std::move(channel));
  }
  return channels;
}

void add_nuisances(const std::vector<std::string>& texts, std::vector<Channel>& channels,
                   std::vector<Unknown>& unknowns) {
  std::vector<std::string> names;
  for (const Channel& channel : channels) names.push_back(channel.name);
  for (const std::string& text : texts) {
    const auto is_of = [&](const std::string& name) { return text.starts_with(name + ":"); };
    const auto found = std::find_if(names.begin(), names.end(), is_of);
    const bool is_all = is_of("*");
    if (text == "*" || std::ranges::find(names, text) != names.end())
      throw UserError(fmt::format("--nuisance {0}: name the faults that are found, {0}:gain:bias:delay\n", text));
    if (found == names.end() && !is_all)
      throw UserError(fmt::format("--nuisance: {} must be OUTPUT:gain:bias:delay with an output of --match\n{}",
                                  in_quotes(text), nearest_hint(text.substr(0, text.find(':')), names)));
    const std::size_t length = is_all ? 1 : found->size();
    for (std::size_t c = 0; c < channels.size(); ++c) {
      if (is_all ? channels[c].is_of_point() : names[c] != *found) continue;
      for (const std::string& word : split_at(text.substr(length + 1), ':'))
        add_nuisance(word, channels[c], static_cast<int>(c), unknowns);
    }
  }
}

}  // namespace mbgen::fit
