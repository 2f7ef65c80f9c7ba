#include "compiler/emit/function_text.hpp"

#include "compiler/emit/frame.hpp"
#include "compiler/emit/mapped.hpp"
#include "compiler/emit/text.hpp"

namespace mbgen {
namespace {

/// Type of such an argument: AccelerationsWork1 of "w1".
std::string work_type(const ProgramShape& shape, const CrossingStruct& work) {
  return (shape.work.empty() ? shape.result : shape.work) + "Work" + std::to_string(work.number);
}

/// Declaration of an argument of a function or of one of its parts; unused ones have no name.
std::string declaration(const ProgramShape& shape, const Argument& argument, bool is_used) {
  using enum Passing;
  const auto passed = [&]() -> const char* {
    switch (argument.passing) {
      case value:
        return " ";
      case reference:
        return "& ";
      case pointer:
        return "* ";
      case sole_reference:
        return is_used ? "& __restrict " : "& ";
      case sole_pointer:
        return is_used ? "* __restrict " : "* ";
    }
    return " ";
  };
  const std::string type = argument.type == kOfScalar ? "const " + type_text(shape) : argument.type;
  return type + passed() + (is_used ? argument.name : "/*" + argument.name + "*/");
}

/// The arguments of a program, the structs of values that cross its parts, and the result.
Arguments taken_arguments(const ProgramShape& shape, const CrossingStructs& crossing) {
  Arguments list = shape.arguments;
  for (const CrossingStruct& work : crossing)
    list.push_back({work.argument, work_type(shape, work), Passing::sole_reference});
  for (const LawShape& law : shape.laws) list.push_back({law.argument, law.type, Passing::sole_reference});
  if (!shape.result.empty()) list.push_back({"result", shape.result, Passing::sole_reference});
  return list;
}

/// All parameters of a function; arrays of structs if it computes group by group.
std::string whole_parameters(const ProgramShape& shape, const std::set<std::string>& used) {
  std::vector<std::string> list;
  for (Argument argument : taken_arguments(shape, {})) {
    if (std::ranges::count(shape.laws, argument.name, &LawShape::argument) > 0) continue;
    if (shape.in_groups) {
      if (argument.name == "tau") argument.type = "const JointForces";
      argument.passing = argument.passing == Passing::sole_reference ? Passing::sole_pointer : Passing::pointer;
    }
    list.push_back(declaration(shape, argument, used.contains(argument.name)));
  }
  return joined(list, ", ");
}

std::string part_parameters(const ProgramShape& shape, const CrossingStructs& crossing,
                            const std::set<std::string>& used) {
  std::vector<std::string> list;
  for (const Argument& argument : taken_arguments(shape, crossing))
    if (used.contains(argument.name)) list.push_back(declaration(shape, argument, true));
  return joined(list, ", ");
}

/// Arguments of a part; those of group g if it is called for each group.
std::string part_arguments(const ProgramShape& shape, const CrossingStructs& crossing,
                           const std::set<std::string>& used) {
  std::vector<std::string> list;
  for (const auto& [name, type, passing] : taken_arguments(shape, crossing))
    if (used.contains(name)) list.push_back(!shape.in_groups ? name : name == "tau" ? "tau[g].tau" : name + "[g]");
  return joined(list, ", ");
}

/// Calls of the shared laws, one row each.
FrameRows law_rows(const ProgramShape& shape) {
  return mapped(shape.laws, [](const LawShape& law) {
    return FrameValues{{"argument", law.argument},
                       {"function", law.function()},
                       {"lanes", law.lanes},
                       {"elements", law.elements},
                       {"beside", law.beside.empty() ? "" : ", " + law.beside}};
  });
}

/// The parts as functions, and their calls. law_part: the first part after the laws.
FrameRows part_rows(const ProgramShape& shape, const std::vector<PartText>& parts, const CrossingStructs& crossing,
                    std::size_t law_part) {
  FrameRows rows;
  for (const PartText& part : parts) {
    const std::string number = std::to_string(rows.size() + 1), function = shape.function + "_" + number;
    const std::string titles = comment_text(joined(part.sections, "; "));
    const std::string comment =
        "Part " + number + " of " + shape.function + (titles.empty() ? "." : ": " + titles + ".");
    const std::string parameters = part_parameters(shape, crossing, part.arguments);
    const bool tells_step = !shape.clock.empty() && part.ended_step;
    rows.push_back(
        {{"comment", wrapped_words(comment, "/// ")},
         {"declaration", wrapped_statement("[[gnu::noinline]] void " + function + "(" + parameters + ") noexcept {")},
         {"body", part.body},
         {"laws", rows.size() == law_part ? law_rows(shape) : FrameRows{}},
         {"call", function + "(" + part_arguments(shape, crossing, part.arguments) + ")"},
         {"ended_step", tells_step ? std::to_string(*part.ended_step) : ""}});
  }
  return rows;
}

std::string declaration(const ProgramShape& shape, const std::set<std::string>& used, const char* end) {
  return wrapped_statement("void " + shape.function + "(" + whole_parameters(shape, used) + ") noexcept" + end);
}

/// Members of such a struct: single values, then the values that share a place in unions.
std::string member_declarations(const CrossingStruct& work) {
  std::string text, unions, type;
  std::vector<std::string> alone;
  const auto write_alone = [&] {
    if (!alone.empty()) text += "  " + type + "\n" + wrapped_list(alone, 6) + ";\n";
    alone.clear();
  };
  for (const auto& [of_place, names] : work.places) {
    if (names.size() > 1) {
      unions += wrapped_statement("  union { " + of_place + " " + joined(names, ", ") + "; };") + "\n";
      continue;
    }
    if (of_place != type) write_alone();
    type = of_place;
    alone.push_back(names[0]);
  }
  write_alone();
  return text + unions;
}

FrameRows work_rows(const ProgramShape& shape, const CrossingStructs& crossing) {
  return mapped(crossing, [&](const CrossingStruct& work) {
    return FrameValues{
        {"type", work_type(shape, work)}, {"argument", work.argument}, {"values", member_declarations(work)}};
  });
}

/// Arguments that the function as a whole uses.
std::set<std::string> used_arguments(const ProgramShape& shape, const std::vector<PartText>& parts,
                                     const CrossingStructs& crossing) {
  std::set<std::string> used;
  for (const PartText& part : parts) {
    used.insert(part.arguments.begin(), part.arguments.end());
    if (!shape.clock.empty() && part.ended_step) used.insert(shape.clock);
  }
  for (const CrossingStruct& values : crossing) used.erase(values.argument);
  for (const LawShape& law : shape.laws) used.erase(law.argument);
  return used;
}

}  // namespace

void add_line(PartText& part, const std::string& statement) {
  part.body += wrapped_statement(part.indent + statement) + "\n";
}

void add_comment(PartText& part, const std::string& words) {
  part.body += wrapped_words(words, part.indent + "// ") + "\n";
}

std::string function_declaration(const ProgramShape& shape) {
  std::set<std::string> all = {"result"};
  for (const Argument& argument : shape.arguments) all.insert(argument.name);
  return declaration(shape, all, " {");
}

std::string function_text(const ProgramShape& shape, const std::vector<PartText>& parts,
                          const CrossingStructs& crossing, std::size_t law_part) {
  const bool is_whole = parts.size() == 1 && shape.clock.empty() && !shape.in_groups;
  std::set<std::string> all = {"result"};
  for (const Argument& argument : shape.arguments) all.insert(argument.name);
  const FrameRows members = mapped(shape.members, [](const ArrayMember& member) {
    return FrameValues{{"name", member.name}, {"size", size_text(member.size)}, {"comment", member.comment}};
  });
  return fill_template("function.in",
                       {{"function", shape.function},
                        {"result", shape.result},
                        {"scalar", type_text(shape)},
                        {"clock", shape.clock},
                        {"in_groups", shape.in_groups},
                        {"has_members", !shape.members.empty()},
                        {"members", members},
                        {"file_part", shape.file_part > 0 ? std::to_string(shape.file_part) : ""},
                        {"announcement", declaration(shape, all, ";")},
                        {"work", work_rows(shape, crossing)},
                        {"law_structs", mapped(shape.laws,
                                               [](const LawShape& law) {
                                                 const bool is_alone = law.home.empty();
                                                 return FrameValues{
                                                     {"type", law.type + (is_alone ? "" : "&")},
                                                     {"argument", law.argument + (is_alone ? "" : " = " + law.home)}};
                                               })},
                        {"parts", is_whole ? FrameRows{} : part_rows(shape, parts, crossing, law_part)},
                        {"title", wrapped_words(shape.title, "/// ")},
                        {"declaration", declaration(shape, used_arguments(shape, parts, crossing), " {")},
                        {"whole_body", is_whole ? parts[0].body : ""}});
}

}  // namespace mbgen
