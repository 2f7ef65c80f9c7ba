#include <algorithm>
#include <map>
#include <optional>

#include "compiler/emit/context_values.hpp"
#include "compiler/emit/mapped.hpp"
#include "compiler/emit/number_limits.hpp"
#include "compiler/emit/text.hpp"
#include "compiler/emit/texts.hpp"
#include "compiler/model/auxiliary_states.hpp"

namespace mbgen {
namespace {

constexpr std::size_t kLongestString = 255;  // MAX_STRING of the standard
constexpr std::size_t kLongestPart = 100;    // an identifier's part has 128 characters at most, some are added
constexpr int kTimeBytes = 8;                // the time is a double in both precisions
constexpr const char* kByteOrderMark = "\xef\xbb\xbf";

/// Format of the numbers of a type in the standard.
struct CalibrationType {
  int bytes;
  std::string name, largest;
};

CalibrationType type_of(Scalar scalar) {
  if (scalar == Scalar::floats) return {4, "FLOAT32_IEEE", "3.4028235e+38"};
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
  std::optional<double> least = {}, most = {};  ///< of its range; none: the largest numbers of its type
};

/// A structure with its numbers, and the kinds of the lists that name them.
struct CalibrationStructure {
  std::string name;  ///< "parameters"
  const char *content, *in_group, *in_function;
  std::vector<CalibrationNumber> numbers = {};
};

/// Prefix of every name of the file.
std::string prefix_of(const EmitContext& context) { return context.names.solver.substr(0, kLongestPart); }

/// A quoted string: one line, within the standard's length.
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

/// Adds a number to a structure. path: its name after the solver's name; place: among numbers of its size.
void add_number(const EmitContext& context, const std::string& path, const std::string& text, const std::string& unit,
                int place, CalibrationStructure& structure) {
  const CalibrationType type = type_of(context.options.scalar);
  structure.numbers.push_back({prefix_of(context) + "." + path, text, unit,
                               context.names.solver + "_a2l_" + structure.name, type.bytes * place, type});
}

/// Adds named numbers; texts: their names in the model, where it has them.
void add_members(const EmitContext& context, const std::vector<NumberMember>& members,
                 const std::vector<std::string>& texts, CalibrationStructure& structure) {
  for (std::size_t i = 0; i < members.size(); ++i) {
    const auto& [name, value, unit] = members[i];
    const bool is_of_model = i < texts.size();
    // The units of energies continue in words.
    add_number(context, structure.name + "." + name, is_of_model ? texts[i] : name,
               is_of_model ? unit : unit.substr(0, unit.find(',')), static_cast<int>(i), structure);
  }
}

/// Ranges of the first numbers of a structure, by "min" and "max".
template <class Given>
void add_ranges(const std::vector<Given>& given, Scalar scalar, CalibrationStructure& structure) {
  for (std::size_t i = 0; i < given.size(); ++i) {
    const Presentation& shown = given[i].shown;
    if (shown.min) structure.numbers[i].least = limit_in(*shown.min, scalar);
    if (shown.max) structure.numbers[i].most = limit_in(*shown.max, scalar);
  }
}

void add_state(const EmitContext& context, CalibrationStructure& structure) {
  const int coordinates = std::max(context.layout.coordinates, 1);
  const int auxiliary = std::max(context.layout.auxiliary_states, 1);
  for (const bool is_rate : {false, true}) {
    for (int i = 0; const TreeBody& body : context.topology.bodies) {
      add_number(context, (is_rate ? "zd." : "z.") + context.names.coordinates[i],
                 (is_rate ? "velocity of " : "") + body.coordinate,
                 unit_of(body.kind) + std::string(is_rate ? "/s" : ""), i + (is_rate ? coordinates : 0), structure);
      ++i;
    }
  }
  UniqueNames unique;
  for (int place = 2 * coordinates; const AuxiliaryState& state : auxiliary_states(context.model))
    add_number(context, "x." + unique.identifier(state.name), state.name, state.unit, place++, structure);
  add_number(context, "t", "time", "s", 2 * coordinates + auxiliary, structure);
  CalibrationNumber& time = structure.numbers.back();
  time.type = type_of(Scalar::doubles);
  time.offset = (time.offset + kTimeBytes - 1) / kTimeBytes * kTimeBytes;  // as compilers align it
}

/// The structures that hold numbers.
std::vector<CalibrationStructure> structures_of(const EmitContext& context) {
  const Model& model = context.model;
  CalibrationStructure parameters{"parameters", "tunable parameters", "REF_CHARACTERISTIC", "DEF_CHARACTERISTIC"};
  CalibrationStructure inputs{"inputs", "inputs", "REF_MEASUREMENT", "IN_MEASUREMENT"};
  CalibrationStructure outputs{"outputs", "outputs", "REF_MEASUREMENT", "OUT_MEASUREMENT"};
  CalibrationStructure state{"state", "coordinates, velocities, auxiliary states, time", "REF_MEASUREMENT",
                             "LOC_MEASUREMENT"};
  add_members(context, parameter_members(context), names_of(tunable_parameters(model)), parameters);
  add_members(context, input_members(context), names_of(model.inputs), inputs);
  add_members(context, output_members(context), names_of(model.outputs), outputs);
  add_ranges(tunable_parameters(model), context.options.scalar, parameters);
  add_ranges(model.inputs, context.options.scalar, inputs);
  add_state(context, state);
  std::vector<CalibrationStructure> all = {parameters, inputs, outputs, state};
  std::erase_if(all, [](const CalibrationStructure& structure) { return structure.numbers.empty(); });
  return all;
}

using Methods = std::map<std::string, std::string>;

/// Name of the conversion of each unit.
Methods methods_of(const EmitContext& context, const std::vector<CalibrationStructure>& structures) {
  Methods methods = {{"", "NO_COMPU_METHOD"}};
  UniqueNames unique;
  for (const CalibrationStructure& structure : structures) {
    for (const CalibrationNumber& number : structure.numbers) {
      if (methods.contains(number.unit)) continue;
      methods[number.unit] = prefix_of(context) + ".unit." + unique.identifier(number.unit.substr(0, kLongestPart));
    }
  }
  return methods;
}

FrameRows method_rows(const Methods& methods) {
  FrameRows rows;
  for (const auto& [unit, name] : methods) {
    if (!unit.empty()) rows.push_back({{"name", name}, {"unit", a2l_string(unit)}});
  }
  return rows;
}

FrameRows number_rows(const std::vector<CalibrationNumber>& numbers, const Methods& methods) {
  return mapped(numbers, [&](const CalibrationNumber& number) {
    return FrameValues{{"name", number.name},
                       {"text", a2l_string(number.text)},
                       {"type", number.type.name},
                       {"method", methods.at(number.unit)},
                       {"least", number.least ? number_text(*number.least) : "-" + number.type.largest},
                       {"most", number.most ? number_text(*number.most) : number.type.largest},
                       {"symbol", number.symbol},
                       {"offset", number.offset}};
  });
}

FrameRows structure_rows(const std::vector<CalibrationStructure>& structures, const Methods& methods) {
  return mapped(structures, [&](const CalibrationStructure& structure) {
    return FrameValues{{"structure", structure.name},
                       {"content", structure.content},
                       {"in_group", structure.in_group},
                       {"in_function", structure.in_function},
                       {"are_characteristics", structure.name == "parameters"},
                       {"numbers", number_rows(structure.numbers, methods)}};
  });
}

bool is_ascii(const std::string& text) {
  return std::none_of(text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0x80) != 0; });
}

}  // namespace

std::string calibration_text(const EmitContext& context) {
  const std::vector<CalibrationStructure> structures = structures_of(context);
  const Methods methods = methods_of(context, structures);
  const std::string text =
      fill_template(context, "calibration.a2l.in",
                    {{"banner", c_banner_text(context.model)},
                     {"prefix", prefix_of(context)},
                     {"title", a2l_string(context.model.name)},
                     {"hash", a2l_string(context.model.hash)},
                     {"version", a2l_string(kMbgenVersion)},
                     {"number_kind", context.options.scalar == Scalar::floats ? "Floats" : "Doubles"},
                     {"number_type", type_of(context.options.scalar).name},
                     {"methods", method_rows(methods)},
                     {"structures", structure_rows(structures, methods)}});
  return is_ascii(text) ? text : kByteOrderMark + text;
}

std::string calibration_header_text(const EmitContext& context) {
  return fill_template(context, "calibration.h.in",
                       {{"banner", c_banner_text(context.model)}, {"guard", guard_of(context.names.solver)}});
}

}  // namespace mbgen
