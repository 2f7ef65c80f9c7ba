#include "compiler/emit/function_text.hpp"

#include <fmt/format.h>

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

/// An argument of a function or of one of its parts.
struct TakenArgument {
  std::string name, type;
  bool is_used = false;
};

/// The arguments of a program, the structs of values that cross its parts, and the result. Nothing else reaches the
/// last two: without the promise every store would make the compiler read the state again.
std::vector<TakenArgument> taken_arguments(const ProgramShape& shape, const CrossingStructs& crossing,
                                           const std::set<std::string>& used) {
  std::vector<TakenArgument> list;
  for (const auto& [name, declaration] : shape.arguments)
    list.push_back({name, declaration.substr(0, declaration.size() - name.size())});
  for (const CrossingStruct& work : crossing) list.push_back({work.argument, work_type(shape, work) + "& __restrict "});
  list.push_back({"result", shape.result + "& __restrict "});
  for (TakenArgument& argument : list) argument.is_used = used.contains(argument.name);
  return list;
}

/// Every parameter of a function, the unused ones without a name; arrays of structs where it goes by groups.
std::string whole_parameters(const ProgramShape& shape, const std::set<std::string>& used) {
  std::vector<std::string> list;
  for (auto& [name, type, is_used] : taken_arguments(shape, {}, used)) {
    if (shape.in_groups) type = name == "tau" ? "const JointForces* " : type.replace(type.find('&'), 1, "*");
    list.push_back(is_used ? type + name : type.substr(0, type.find("__restrict")) + "/*" + name + "*/");
  }
  return joined(list, ", ");
}

std::string part_parameters(const ProgramShape& shape, const CrossingStructs& crossing,
                            const std::set<std::string>& used) {
  std::vector<std::string> list;
  for (const auto& [name, type, is_used] : taken_arguments(shape, crossing, used))
    if (is_used) list.push_back(type + name);
  return joined(list, ", ");
}

/// The arguments of a part, those of group g where it is called for each.
std::string part_arguments(const ProgramShape& shape, const CrossingStructs& crossing,
                           const std::set<std::string>& used) {
  std::vector<std::string> list;
  for (const auto& [name, type, is_used] : taken_arguments(shape, crossing, used))
    if (is_used) list.push_back(!shape.in_groups ? name : name == "tau" ? "tau[g].tau" : name + "[g]");
  return joined(list, ", ");
}

std::string heading(const std::string& comment, const std::string& declaration) {
  return wrapped_words(comment, "/// ") + "\n" + wrapped_statement(declaration) + "\n";
}

/// Kept out of line: inlined, the parts would grow together again.
std::string part_function(const ProgramShape& shape, const CrossingStructs& crossing, const PartText& part,
                          std::size_t number) {
  const std::string name = shape.function + "_" + std::to_string(number);
  const std::string titles = comment_text(joined(part.sections, "; "));
  return heading(
             "Part " + std::to_string(number) + " of " + shape.function + (titles.empty() ? "." : ": " + titles + "."),
             "[[gnu::noinline]] void " + name + "(" + part_parameters(shape, crossing, part.arguments) +
                 ") noexcept {") +
         part.body + "}\n\n";
}

/// The function without a body, for the parts of the file that call it.
std::string declaration(const ProgramShape& shape) {
  std::set<std::string> all = {"result"};
  for (const auto& [name, text] : shape.arguments) all.insert(name);
  return wrapped_statement("void " + shape.function + "(" + whole_parameters(shape, all) + ") noexcept;") + "\n";
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
    if (shape.in_groups) calls += "  for (int g = 0; g < kGroups; ++g)\n  ";
    calls += "  " + function + "(" + part_arguments(shape, crossing, parts[p].arguments) + ");\n";
    if (!shape.clock.empty() && parts[p].ended_step) {
      calls += "  " + shape.clock + ".at_end_of(" + std::to_string(*parts[p].ended_step) + ");\n";
      used.insert(shape.clock);
    }
  }
  for (const CrossingStruct& values : crossing) used.erase(values.argument);
  const std::string declared = "void " + shape.function + "(" + whole_parameters(shape, used) + ") noexcept {";
  return structs + functions + heading(shape.title, declared) + work + calls + "}\n";
}

}  // namespace

void add_line(PartText& part, const std::string& statement) {
  part.body += wrapped_statement(part.indent + statement) + "\n";
}

void add_comment(PartText& part, const std::string& words) {
  part.body += wrapped_words(words, part.indent + "// ") + "\n";
}

std::string in_file_part(int part, const std::string& text) {
  return fmt::format("#if MBGEN_IS_PART({})\n{}#endif  // part {}\n", part, text, part);
}

std::string function_text(const ProgramShape& shape, const std::vector<PartText>& parts,
                          const CrossingStructs& crossing) {
  const std::string text = definitions(shape, parts, crossing);
  if (shape.file_part == 0) return result_struct(shape) + text;
  return result_struct(shape) + declaration(shape) + "\n" + in_file_part(shape.file_part, text);
}

}  // namespace mbgen
