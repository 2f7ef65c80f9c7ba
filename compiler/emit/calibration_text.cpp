#include <algorithm>
#include <map>

#include "compiler/emit/context_values.hpp"
#include "compiler/emit/mapped.hpp"
#include "compiler/emit/text.hpp"
#include "compiler/emit/texts.hpp"
#include "compiler/model/auxiliary_states.hpp"

namespace mbgen {
namespace {

constexpr std::size_t kLongestString = 255;  // MAX_STRING of the standard
constexpr std::size_t kLongestPart = 100;    // an identifier's part has 128 characters at most, some are added
constexpr int kTimeBytes = 8;                // the time is a double in both precisions
constexpr const char* kByteOrderMark = "\xef\xbb\xbf";

/// How the standard writes numbers of a type.
struct CalibrationType {
  int bytes;
  std::string name, largest;
};

CalibrationType type_of(const std::string& scalar) {
  if (scalar == "float") return {4, "FLOAT32_IEEE", "3.4028235e+38"};
  return {8, "FLOAT64_IEEE", "1.7976931348623157e+308"};
}

/// A number of the structures that the application defines.
struct CalibrationNumber {
  std::string name;    ///< "four_bar.z.crank_pin"
  std::string text;    ///< as people know it
  std::string unit;    ///< "" for none
  std::string symbol;  ///< of the structure
  int offset = 0;      ///< bytes from its beginning
  CalibrationType type;
};

using CalibrationNumbers = std::vector<CalibrationNumber>;

/// The numbers of a file, by the structure that holds them.
struct CalibrationNumberSets {
  CalibrationNumbers parameters, inputs, outputs, state;
};

/// What every name of the file begins with.
std::string prefix_of(const EmitContext& context) { return context.names.solver.substr(0, kLongestPart); }

/// A quoted string: one line, not longer than the standard lets it be.
std::string a2l_string(const std::string& text) {
  std::string line = comment_text(text);
  if (line.size() > kLongestString) {
    std::size_t end = kLongestString;
    while (end > 0 && (static_cast<unsigned char>(line[end]) & 0xc0) == 0x80) --end;  // not inside a character
    line.resize(end);
  }
  std::string quoted = "\"";
  for (const char c : line) {
    if (c == '"' || c == '\\') quoted += '\\';
    quoted += c;
  }
  return quoted + "\"";
}

/// Adds the next number of a structure. group: part of the name between the solver's and the number's.
void add_number(const EmitContext& context, const std::string& structure, const std::string& group,
                const std::string& name, const std::string& text, const std::string& unit, CalibrationNumbers& numbers,
                int place) {
  numbers.push_back({prefix_of(context) + "." + group + name, text, unit, context.names.solver + "_a2l_" + structure,
                     type_of(context.options.scalar).bytes * place, type_of(context.options.scalar)});
}

/// Members of a structure of named numbers; texts: what the model calls them, for those that it names.
CalibrationNumbers members_of(const EmitContext& context, const std::string& structure,
                              const std::vector<NumberMember>& members, const std::vector<std::string>& texts) {
  CalibrationNumbers numbers;
  for (std::size_t i = 0; i < members.size(); ++i) {
    const bool is_of_model = i < texts.size();
    // Units of the energies go on in words.
    const std::string unit = is_of_model ? members[i].unit : members[i].unit.substr(0, members[i].unit.find(','));
    add_number(context, structure, structure + ".", members[i].name, is_of_model ? texts[i] : members[i].name, unit,
               numbers, static_cast<int>(i));
  }
  return numbers;
}

CalibrationNumbers state_numbers(const EmitContext& context) {
  const Topology& topology = context.topology;
  const int coordinates = std::max(context.layout.coordinates, 1);
  const int auxiliary = std::max(context.layout.auxiliary_states, 1);
  CalibrationNumbers numbers;
  for (const bool is_rate : {false, true}) {
    for (std::size_t i = 0; i < topology.bodies.size(); ++i) {
      const std::string unit = unit_of(topology.bodies[i].kind);
      add_number(context, "state", is_rate ? "zd." : "z.", context.names.coordinates[i],
                 (is_rate ? "velocity of " : "") + topology.bodies[i].coordinate, is_rate ? unit + "/s" : unit, numbers,
                 static_cast<int>(i) + (is_rate ? coordinates : 0));
    }
  }
  std::vector<std::string> taken;
  const std::vector<std::string> names = auxiliary_state_names(context.model);
  for (std::size_t i = 0; i < names.size(); ++i) {
    add_number(context, "state", "x.", identifier(names[i], taken), names[i], "m", numbers,
               2 * coordinates + static_cast<int>(i));
  }
  add_number(context, "state", "", "t", "time", "s", numbers, 2 * coordinates + auxiliary);
  CalibrationNumber& time = numbers.back();
  time.type = type_of("double");
  time.offset = (time.offset + kTimeBytes - 1) / kTimeBytes * kTimeBytes;  // as compilers align it
  return numbers;
}

CalibrationNumberSets numbers_of(const EmitContext& context) {
  const Model& model = context.model;
  return {members_of(context, "parameters", parameter_members(context), names_of(tunable_parameters(model))),
          members_of(context, "inputs", input_members(context), names_of(model.inputs)),
          members_of(context, "outputs", output_members(context), names_of(model.outputs)), state_numbers(context)};
}

/// Name of the conversion of each unit.
std::map<std::string, std::string> methods_of(const EmitContext& context, const CalibrationNumberSets& sets) {
  std::map<std::string, std::string> methods = {{"", "NO_COMPU_METHOD"}};
  std::vector<std::string> taken;
  for (const CalibrationNumbers* numbers : {&sets.parameters, &sets.inputs, &sets.outputs, &sets.state}) {
    for (const CalibrationNumber& number : *numbers) {
      if (methods.count(number.unit)) continue;
      methods[number.unit] = prefix_of(context) + ".unit." + identifier(number.unit.substr(0, kLongestPart), taken);
    }
  }
  return methods;
}

FrameRows method_rows(const std::map<std::string, std::string>& methods) {
  FrameRows rows;
  for (const auto& [unit, name] : methods) {
    if (!unit.empty()) rows.push_back({{"name", name}, {"unit", a2l_string(unit)}});
  }
  return rows;
}

FrameRows number_rows(const CalibrationNumbers& numbers, const std::map<std::string, std::string>& methods) {
  return mapped(numbers, [&](const CalibrationNumber& number) {
    return FrameValues{{"name", number.name},
                       {"text", a2l_string(number.text)},
                       {"type", number.type.name},
                       {"method", methods.at(number.unit)},
                       {"largest", number.type.largest},
                       {"symbol", number.symbol},
                       {"offset", number.offset}};
  });
}

/// The structures that hold numbers. in_group, in_function: kinds of the lists of their names.
FrameRows structure_rows(const CalibrationNumberSets& sets, const std::map<std::string, std::string>& methods) {
  FrameRows rows;
  const auto add = [&](const char* name, const char* content, const char* in_group, const char* in_function,
                       const CalibrationNumbers& numbers) {
    if (numbers.empty()) return;
    rows.push_back({{"structure", name},
                    {"content", content},
                    {"in_group", in_group},
                    {"in_function", in_function},
                    {"are_characteristics", &numbers == &sets.parameters},
                    {"numbers", number_rows(numbers, methods)}});
  };
  add("parameters", "tunable parameters", "REF_CHARACTERISTIC", "DEF_CHARACTERISTIC", sets.parameters);
  add("inputs", "inputs", "REF_MEASUREMENT", "IN_MEASUREMENT", sets.inputs);
  add("outputs", "outputs", "REF_MEASUREMENT", "OUT_MEASUREMENT", sets.outputs);
  add("state", "coordinates, velocities, auxiliary states, time", "REF_MEASUREMENT", "LOC_MEASUREMENT", sets.state);
  return rows;
}

bool is_ascii(const std::string& text) {
  return std::none_of(text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0x80) != 0; });
}

}  // namespace

std::string calibration_text(const EmitContext& context) {
  const CalibrationNumberSets sets = numbers_of(context);
  const std::map<std::string, std::string> methods = methods_of(context, sets);
  const std::string text = fill_template(context, "calibration.a2l.in",
                                         {{"banner", c_banner_text(context.model)},
                                          {"prefix", prefix_of(context)},
                                          {"title", a2l_string(context.model.name)},
                                          {"hash", a2l_string(context.model.hash)},
                                          {"version", a2l_string(kMbgenVersion)},
                                          {"number_kind", context.options.scalar == "float" ? "Floats" : "Doubles"},
                                          {"number_type", type_of(context.options.scalar).name},
                                          {"methods", method_rows(methods)},
                                          {"structures", structure_rows(sets, methods)}});
  return is_ascii(text) ? text : kByteOrderMark + text;
}

std::string calibration_header_text(const EmitContext& context) {
  return fill_template(context, "calibration.h.in",
                       {{"banner", c_banner_text(context.model)}, {"guard", guard_of(context.names.solver)}});
}

}  // namespace mbgen
