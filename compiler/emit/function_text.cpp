#include "compiler/emit/function_text.hpp"

#include <fmt/format.h>

#include "compiler/emit/file_parts.hpp"
#include "compiler/emit/text.hpp"

namespace mbgen {
namespace {

std::string result_struct(const ProgramShape& shape) {
  if (shape.members.empty()) return "";
  std::string text =
      "/// Result of " + shape.function + ".\n" +
      (shape.in_groups ? "template <class Lanes>\nstruct " + shape.result + "Of" : "struct " + shape.result) + " {\n";
  for (const ArrayMember& member : shape.members) {
    text += "  " + shape.scalar + " " + member.name + "[" + std::to_string(member.size > 0 ? member.size : 1) +
            "];  ///< " + member.comment + "\n";
  }
  text += "};\n";
  if (shape.in_groups) text += fmt::format("using {0} = {0}Of<{1}>;\n", shape.result, shape.scalar);
  return text + "\n";
}

/// The type of such an argument: AccelerationsWork of "work", AccelerationsWork2 of "work2".
std::string work_type(const ProgramShape& shape, const CrossingStruct& work) {
  return shape.result + "W" + work.argument.substr(1);
}

std::string work_structs(const ProgramShape& shape, const CrossingStructs& crossing) {
  std::string text;
  for (const CrossingStruct& work : crossing) {
    text += "/// Values of " + shape.function + " that cross its parts.\nstruct " + work_type(shape, work) + " {\n  " +
            shape.scalar + "\n" + wrapped_list(work.members, 6) + ";\n};\n\n";
  }
  return text;
}

/// Whether a function has every parameter of the shape, the unused ones without a name, or only those it uses.
enum class Signature { whole, used };

std::string joined(const std::vector<std::string>& items, const std::string& separator) {
  std::string text;
  for (const std::string& item : items) text += (text.empty() ? "" : separator) + item;
  return text;
}

std::string parameter_list(const ProgramShape& shape, const CrossingStructs& crossing,
                           const std::set<std::string>& used, Signature signature) {
  std::vector<std::string> list;
  for (const auto& [name, declaration] : shape.arguments) {
    if (used.count(name)) {
      list.push_back(declaration);
    } else if (signature == Signature::whole) {
      list.push_back(declaration.substr(0, declaration.size() - name.size()) + "/*" + name + "*/");
    }
  }
  // Nothing else reaches these: without the promise every store would make the compiler read the state again.
  for (const CrossingStruct& work : crossing) {
    if (used.count(work.argument)) list.push_back(work_type(shape, work) + "& __restrict " + work.argument);
  }
  if (used.count("result")) {
    list.push_back(shape.result + "& __restrict result");
  } else if (signature == Signature::whole) {
    list.push_back(shape.result + "& /*result*/");
  }
  return joined(list, ", ");
}

std::string argument_list(const ProgramShape& shape, const CrossingStructs& crossing,
                          const std::set<std::string>& used) {
  std::vector<std::string> list;
  for (const auto& [name, declaration] : shape.arguments) {
    if (used.count(name)) list.push_back(name);
  }
  for (const CrossingStruct& work : crossing) {
    if (used.count(work.argument)) list.push_back(work.argument);
  }
  if (used.count("result")) list.push_back("result");
  return joined(list, ", ");
}

/// The parameters of a function of all groups, arrays of structs.
std::string group_parameters(const ProgramShape& shape, const std::set<std::string>& used) {
  std::vector<std::string> list;
  for (const auto& [name, declaration] : shape.arguments) {
    const std::string type =
        name == "tau" ? "const JointForces& " : declaration.substr(0, declaration.size() - name.size());
    list.push_back(type.substr(0, type.find('&')) + "* " + (used.count(name) ? name : "/*" + name + "*/"));
  }
  list.push_back(shape.result + "* " + (used.count("result") ? "__restrict result" : "/*result*/"));
  return joined(list, ", ");
}

/// The arguments of a part for group g.
std::string group_arguments(const ProgramShape& shape, const CrossingStructs& crossing,
                            const std::set<std::string>& used) {
  std::vector<std::string> list;
  for (const auto& [name, declaration] : shape.arguments) {
    if (used.count(name)) list.push_back(name == "tau" ? "tau[g].tau" : name + "[g]");
  }
  for (const CrossingStruct& work : crossing) {
    if (used.count(work.argument)) list.push_back(work.argument + "[g]");
  }
  if (used.count("result")) list.push_back("result[g]");
  return joined(list, ", ");
}

std::string heading(const std::string& comment, const std::string& declaration) {
  return wrapped_words(comment, "/// ") + "\n" + wrapped_statement(declaration) + "\n";
}

std::string whole_heading(const ProgramShape& shape, const std::set<std::string>& used) {
  return heading(shape.title, "void " + shape.function + "(" +
                                  (shape.in_groups ? group_parameters(shape, used)
                                                   : parameter_list(shape, {}, used, Signature::whole)) +
                                  ") noexcept {");
}

/// Kept out of line: inlined, the parts would grow together again.
std::string part_function(const ProgramShape& shape, const CrossingStructs& crossing, const PartText& part,
                          std::size_t number) {
  const std::string name = shape.function + "_" + std::to_string(number);
  const std::string titles = comment_text(joined(part.sections, "; "));
  return heading(
             "Part " + std::to_string(number) + " of " + shape.function + (titles.empty() ? "." : ": " + titles + "."),
             "[[gnu::noinline]] void " + name + "(" + parameter_list(shape, crossing, part.arguments, Signature::used) +
                 ") noexcept {") +
         part.body + "}\n\n";
}

/// The function without a body, for the parts of the file that call it.
std::string declaration(const ProgramShape& shape) {
  std::set<std::string> all = {"result"};
  for (const auto& [name, text] : shape.arguments) all.insert(name);
  return wrapped_statement("void " + shape.function + "(" + parameter_list(shape, {}, all, Signature::whole) +
                           ") noexcept;") +
         "\n";
}

/// The structs of values that cross parts, and the functions.
std::string definitions(const ProgramShape& shape, const std::vector<PartText>& parts,
                        const CrossingStructs& crossing) {
  const std::string structs = work_structs(shape, crossing);
  std::string work;
  for (const CrossingStruct& values : crossing)
    work += "  " + work_type(shape, values) + " " + values.argument + (shape.in_groups ? "[kGroups];\n" : ";\n");
  std::string functions, calls;
  std::set<std::string> used;
  for (std::size_t p = 0; p < parts.size(); ++p) {
    used.insert(parts[p].arguments.begin(), parts[p].arguments.end());
    if (parts.size() == 1 && shape.clock.empty() && !shape.in_groups) {
      calls = parts[0].body;
      break;
    }
    functions += part_function(shape, crossing, parts[p], p + 1);
    const std::string function = shape.function + "_" + std::to_string(p + 1);
    if (shape.in_groups)
      calls += "  for (int g = 0; g < kGroups; ++g)\n    " + function + "(" +
               group_arguments(shape, crossing, parts[p].arguments) + ");\n";
    else
      calls += "  " + function + "(" + argument_list(shape, crossing, parts[p].arguments) + ");\n";
    if (!shape.clock.empty() && parts[p].ended_step) {
      calls += "  " + shape.clock + ".at_end_of(" + std::to_string(*parts[p].ended_step) + ");\n";
      used.insert(shape.clock);
    }
  }
  for (const CrossingStruct& values : crossing) used.erase(values.argument);
  return structs + functions + whole_heading(shape, used) + work + calls + "}\n";
}

}  // namespace

void add_line(PartText& part, const std::string& statement) {
  part.body += wrapped_statement(part.indent + statement) + "\n";
}

void add_comment(PartText& part, const std::string& words) {
  part.body += wrapped_words(words, part.indent + "// ") + "\n";
}

std::string function_text(const ProgramShape& shape, const std::vector<PartText>& parts,
                          const CrossingStructs& crossing) {
  const std::string text = definitions(shape, parts, crossing);
  if (shape.file_part == 0) return result_struct(shape) + text;
  return result_struct(shape) + declaration(shape) + "\n" + in_file_part(shape.file_part, text);
}

}  // namespace mbgen
