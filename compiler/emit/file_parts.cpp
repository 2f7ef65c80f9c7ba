#include "compiler/emit/file_parts.hpp"

#include <fmt/format.h>

namespace mbgen {
namespace {

bool runs_rarely(Role role) {
  return role == Role::multipliers || role == Role::closure_terms || role == Role::accelerations_chosen ||
         role == Role::outputs;
}

}  // namespace

int divide_file(std::vector<ShapedProgram>& programs, std::size_t least_values) {
  std::vector<ShapedProgram*> rare;
  std::size_t left = 0;
  for (ShapedProgram& program : programs) {
    if (!runs_rarely(program.role)) continue;
    rare.push_back(&program);
    left += program.program->nodes.size();
  }
  if (left < least_values) return 0;
  int part = 1;
  std::size_t values = 0;
  for (ShapedProgram* program : rare) {
    program->shape.file_part = part;
    values += program->program->nodes.size();
    left -= program->program->nodes.size();
    if (values < least_values || left < least_values) continue;
    ++part;
    values = 0;
  }
  return part;
}

std::string in_file_part(int part, const std::string& text) {
  return fmt::format("#if MBGEN_IS_PART({})\n{}#endif  // part {}\n", part, text, part);
}

std::string file_parts_text(int rare_parts) {
  return fmt::format(
      "// Compiled with -DMBGEN_PART=0 this file is what runs at every step, with 1 to {} programs that run rarely; "
      "the\n"
      "// {} objects together are the solver. Compiled without MBGEN_PART it is the whole solver.\n"
      "#ifdef MBGEN_PART\n"
      "#define MBGEN_IS_PART(part) (MBGEN_PART == part)\n"
      "#define MBGEN_BETWEEN_PARTS inline namespace between_parts\n"
      "#else\n"
      "#define MBGEN_IS_PART(part) 1\n"
      "#define MBGEN_BETWEEN_PARTS namespace\n"
      "#endif\n\n",
      rare_parts, rare_parts + 1);
}

std::string divided_programs(const std::string& hot, const std::string& shared) {
  return in_file_part(0, "\n" + hot) + "\n}  // namespace\n\nMBGEN_BETWEEN_PARTS {\n\n" + shared +
         "}  // namespace\n\n#if MBGEN_IS_PART(0)\nnamespace {\n";
}

}  // namespace mbgen
