#include "workbench/fit/point_targets.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "compiler/text/characters.hpp"
#include "compiler/text/number.hpp"
#include "compiler/text/user_error.hpp"

namespace mbgen::fit {
namespace {

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

}  // namespace

MeasuredFile point_targets(const Model& model, const std::vector<std::string>& texts,
                           const std::vector<std::string>& manoeuvres, std::vector<Channel>& channels) {
  MeasuredFile file{.path = "--target", .is_of_points = true};
  for (const std::string& text : split_list(texts)) {
    const std::size_t sign = text.find('=');
    if (sign == std::string::npos)
      throw UserError(fmt::format("--target: {} must be MEASURE=VALUE:SIGMA, with {}\n", in_quotes(text), kMeasures));
    Channel channel{.name = text.substr(0, sign)};
    const auto is_same = [&](const Channel& one) { return one.name == channel.name; };
    if (std::ranges::any_of(channels, is_same))
      throw UserError(fmt::format("--target: \"{}\" stands twice\n", channel.name));
    channel.measure = read_measure("--target", channel.name, model, manoeuvres);
    channel.unit = channel.measure->unit;
    if (channel.measure->of == Measure::Of::curve)
      throw UserError(fmt::format("--target {}: is a curve: give its points to --data, and --match kc:{}:{}\n",
                                  channel.name, channel.measure->axle, channel.measure->part));
    MeasuredChannel measured{static_cast<int>(channels.size()), {}, {}};
    read_numbers(channel.name, text.substr(sign + 1), measured, channel);
    channels.push_back(std::move(channel));
    file.channels.push_back(std::move(measured));
  }
  return file;
}

}  // namespace mbgen::fit
