#include "compiler/emit/names.hpp"

#include <algorithm>
#include <iterator>
#include <set>
#include <string_view>

#include "compiler/emit/emit.hpp"

namespace mbgen {
namespace {

/// Keywords, alternative tokens, macros of the C library's headers and of compilers, and global names of <cmath>.
const std::set<std::string_view>& reserved_names() {
  static const std::set<std::string_view> names = {
      "alignas", "alignof", "and", "and_eq", "asm", "auto", "bitand", "bitor", "bool", "break", "case", "catch", "char",
      "char8_t", "char16_t", "char32_t", "class", "compl", "concept", "const", "consteval", "constexpr", "constinit",
      "const_cast", "continue", "co_await", "co_return", "co_yield", "decltype", "default", "delete", "do", "double",
      "dynamic_cast", "else", "enum", "explicit", "export", "extern", "false", "float", "for", "friend", "goto", "if",
      "inline", "int", "long", "mutable", "namespace", "new", "noexcept", "not", "not_eq", "nullptr", "operator", "or",
      "or_eq", "private", "protected", "public", "register", "reinterpret_cast", "requires", "return", "short",
      "signed", "sizeof", "static", "static_assert", "static_cast", "struct", "switch", "template", "this",
      "thread_local", "throw", "true", "try", "typedef", "typeid", "typename", "union", "unsigned", "using", "virtual",
      "void", "volatile", "wchar_t", "while", "xor", "xor_eq",
      // Macros that <cmath> and compilers define.
      "M_E", "M_LOG2E", "M_LOG10E", "M_LN2", "M_LN10", "M_PI", "M_PI_2", "M_PI_4", "M_1_PI", "M_2_PI", "M_2_SQRTPI",
      "M_SQRT2", "M_SQRT1_2", "HUGE", "HUGE_VAL", "HUGE_VALF", "HUGE_VALL", "INFINITY", "NAN", "SNAN", "NULL", "EOF",
      "FP_NAN", "FP_INFINITE", "FP_ZERO", "FP_SUBNORMAL", "FP_NORMAL", "MATH_ERRNO", "MATH_ERREXCEPT", "MAXFLOAT",
      "DOMAIN", "SING", "OVERFLOW", "UNDERFLOW", "PLOSS", "TLOSS", "errno", "math_errhandling", "unix", "linux", "i386",
      // Namespaces and types that emitted code uses.
      "std", "mbgen", "Index", "Coordinate", "Body", "Input", "Output", "Parameter", "LoopBlock", "Inputs", "Outputs",
      "Parameters", "State", "Derivative", "Multipliers", "History", "System", "int8_t", "size_t", "div_t", "float_t",
      "double_t",
      // Functions of <cmath> and <cstdlib>, which C libraries declare in the global namespace.
      "abs", "acos", "acosh", "asin", "asinh", "atan", "atan2", "atanh", "cbrt", "ceil", "copysign", "cos", "cosh",
      "div", "drem", "erf", "erfc", "exit", "exp", "exp10", "exp2", "expm1", "fabs", "fdim", "finite", "floor", "fma",
      "fmax", "fmin", "fmod", "frexp", "free", "gamma", "hypot", "ilogb", "isinf", "isnan", "j0", "j1", "jn", "labs",
      "ldexp", "lgamma", "llrint", "log", "log10", "log1p", "log2", "logb", "lrint", "lround", "modf", "nan",
      "nearbyint", "nextafter", "pow", "pow10", "rand", "random", "remainder", "remquo", "rint", "round", "scalb",
      "scalbn", "select", "signbit", "significand", "signgam", "sin", "sincos", "sinh", "sqrt", "system", "tan", "tanh",
      "tgamma", "trunc", "y0", "y1", "yn"};
  return names;
}

bool is_letter_or_digit(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9'); }

/// Letters, digits and single underscores, starting with a letter.
std::string sanitised(const std::string& name) {
  std::string result;
  for (const char c : name) {
    if (is_letter_or_digit(c)) {
      result += c;
    } else if (!result.empty() && result.back() != '_') {
      // Two underscores in a row are reserved to the compiler, and so is one at the start.
      result += '_';
    }
  }
  while (!result.empty() && result.back() == '_') result.pop_back();
  if (result.empty()) return "unnamed";
  if (result.front() >= '0' && result.front() <= '9') result = "n_" + result;
  return result;
}

bool contains(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

std::vector<std::string> tunable_names(const Model& model) {
  std::vector<std::string> names;
  for (const Parameter& parameter : model.parameters) {
    if (parameter.tunable) names.push_back(parameter.name);
  }
  return names;
}

template <class Item>
std::vector<std::string> names_of(const std::vector<Item>& items) {
  std::vector<std::string> names;
  for (const Item& item : items) names.push_back(item.name);
  return names;
}

std::vector<std::string> identifiers(const std::vector<std::string>& names, std::vector<std::string> taken = {}) {
  std::vector<std::string> result;
  for (const std::string& name : names) result.push_back(identifier(name, taken));
  return result;
}

}  // namespace

std::string identifier_base(const std::string& name) {
  std::string base = sanitised(name);
  if (reserved_names().count(base)) base += '_';
  return base;
}

std::string numbered(const std::string& base, int number) {
  return base + (base.back() == '_' ? "" : "_") + std::to_string(number);
}

std::string identifier(const std::string& name, std::vector<std::string>& taken) {
  const std::string base = identifier_base(name);
  std::string candidate = base;
  for (int number = 2; contains(taken, candidate); ++number) candidate = numbered(base, number);
  taken.push_back(candidate);
  return candidate;
}

std::string solver_name(const Model& model) {
  std::vector<std::string> taken;
  return identifier(model.name, taken);
}

SolverNames model_names(const Model& model) {
  SolverNames names;
  names.solver = solver_name(model);
  names.bodies = identifiers(names_of(model.bodies));
  names.inputs = identifiers(names_of(model.inputs));
  names.parameters = identifiers(tunable_names(model));
  names.outputs = identifiers(names_of(model.outputs), {std::begin(kEnergyMembers), std::end(kEnergyMembers)});
  return names;
}

SolverNames solver_names(const Model& model, const Topology& topology) {
  SolverNames names = model_names(model);
  std::vector<std::string> coordinates, blocks;
  for (const TreeBody& body : topology.bodies) coordinates.push_back(body.coordinate);
  for (const LoopBlock& block : topology.blocks) blocks.push_back(topology.loops[block.loops.front()].name);
  names.coordinates = identifiers(coordinates);
  names.loop_blocks = identifiers(blocks);
  return names;
}

std::string block_title(const Topology& topology, int block) {
  std::string title;
  for (const int loop : topology.blocks[block].loops) title += (title.empty() ? "" : ", ") + topology.loops[loop].name;
  return title;
}

}  // namespace mbgen
