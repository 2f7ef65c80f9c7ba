#include "workbench/search/measure.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>

#include "compiler/text/characters.hpp"
#include "compiler/text/number.hpp"
#include "compiler/text/user_error.hpp"
#include "workbench/host/assignments.hpp"
#include "workbench/sweep/sweep_case.hpp"

namespace mbgen {
namespace {

bool is_word(const std::string& text) {
  const auto is_of_word = [](unsigned char c) { return std::isalnum(c) != 0 || c == '_'; };
  return !text.empty() && std::isdigit(static_cast<unsigned char>(text[0])) == 0 &&
         std::ranges::all_of(text, is_of_word);
}

void read_start(const std::string& what, const Model& model, const std::string& name, Measure& measure) {
  const auto is_it = [&](const Output& output) { return output.name == name; };
  const auto found = std::ranges::find_if(model.outputs, is_it);
  std::vector<std::string> names;
  for (const Output& output : model.outputs) names.push_back(output.name);
  if (found == model.outputs.end())
    throw UserError(fmt::format("{}: the model has no output \"{}\"\n{}", what, name, nearest_hint(name, names)));
  measure.of = Measure::Of::start;
  measure.output = static_cast<int>(found - model.outputs.begin());
  measure.unit = found->unit;
}

void read_mode(const std::string& what, const std::vector<std::string>& words, Measure& measure) {
  const double number = parse_number(words[1], what + ": number of the mode");
  if (number < 1 || number != std::floor(number) || number > 1e6)
    throw UserError(fmt::format("{}: modes are numbered from 1, found {}\n", what, words[1]));
  measure.of = Measure::Of::mode;
  measure.mode = static_cast<int>(number);
  measure.part = words[2];
  measure.unit = words[2] == "frequency" ? "Hz" : "1";
}

void read_rig(const std::string& what, const Model& model, const std::vector<std::string>& words, Measure& measure) {
  std::vector<std::string> axles;
  for (const Axle& axle : model.axles) axles.push_back(axle.name);
  if (std::ranges::find(axles, words[1]) == axles.end())
    throw UserError(fmt::format("{}: the model has no axle \"{}\"\n{}", what, words[1], nearest_hint(words[1], axles)));
  measure.axle = words[1];
  measure.part = words.back();
  measure.of = words.size() == 4 ? Measure::Of::curve : Measure::Of::figure;
  if (words.size() == 4) measure.curve = words[2];
}

/// A metric, or a number of a manoeuvre.
void read_of_motion(const std::string& what, std::string text, const Model& model,
                    const std::vector<std::string>& manoeuvres, Measure& measure) {
  std::vector<std::string> stems;
  for (const std::string& file : manoeuvres) stems.push_back(std::filesystem::path(file).stem().string());
  const std::size_t colon = text.find(':');
  if (colon != std::string::npos) {
    const std::string stem = text.substr(0, colon);
    const auto found = std::ranges::find(stems, stem);
    if (found == stems.end())
      throw UserError(fmt::format("{}: must be {}\n{}", what, kMeasures, nearest_hint(stem, stems)));
    measure.motion = static_cast<int>(found - stems.begin());
    text = text.substr(colon + 1);
  } else if (stems.size() > 1) {
    throw UserError(fmt::format("{}: of which manoeuvre? write {}:{}\n", what, stems.front(), text));
  }
  measure.of = !manoeuvres.empty() && is_word(text) ? Measure::Of::manoeuvre : Measure::Of::metric;
  measure.part = text;
  if (manoeuvres.empty()) expect(read_metrics({text}, model, what));
}

}  // namespace

Measure read_measure(const std::string& option, const std::string& text, const Model& model,
                     const std::vector<std::string>& manoeuvres) {
  const std::string what = option + " " + in_quotes(text);
  Measure measure{.name = text};
  const std::vector<std::string> words = split_at(text, ':');
  const auto is = [&](const char* head, std::size_t least, std::size_t most) {
    if (words[0] != head) return false;
    const bool has_words = words.size() >= least && words.size() <= most && std::ranges::find(words, "") == words.end();
    if (!has_words) throw UserError(fmt::format("{}: must be {}\n", what, kMeasures));
    return true;
  };
  if (text.empty()) throw UserError(fmt::format("{}: must be {}\n", what, kMeasures));
  if (is("start", 2, 2)) {
    read_start(what, model, words[1], measure);
  } else if (is("mode", 3, 3)) {
    if (words[2] != "frequency" && words[2] != "damping")
      throw UserError(fmt::format("{}: must be {}\n", what, kMeasures));
    read_mode(what, words, measure);
  } else if (is("kc", 3, 4)) {
    read_rig(what, model, words, measure);
  } else {
    read_of_motion(what, text, model, manoeuvres, measure);
  }
  return measure;
}

std::vector<std::string> split_list(const std::vector<std::string>& texts) {
  std::vector<std::string> list;
  for (const std::string& text : texts) {
    int depth = 0;
    list.emplace_back();
    for (const char c : text) {
      depth += c == '(' ? 1 : c == ')' ? -1 : 0;
      if (c == ',' && depth == 0) {
        list.emplace_back();
      } else {
        list.back() += c;
      }
    }
  }
  return list;
}

}  // namespace mbgen
