#include "workbench/host/depfile.hpp"

#include <fmt/format.h>

#include "compiler/text/user_error.hpp"

namespace mbgen {
namespace {

/// A path with the special characters of Make escaped: blanks, the backslashes before them, # and $.
std::string escaped(const std::string& path) {
  std::string text;
  std::size_t backslashes = 0;
  for (const char c : path) {
    if (c == '\n' || c == '\r') throw UserError("--depfile: a path with the end of a line in it: " + path + "\n");
    if (c == ' ' || c == '\t') text += std::string(backslashes + 1, '\\');
    if (c == '#') text += '\\';
    if (c == '$') text += '$';
    text += c;
    backslashes = c == '\\' ? backslashes + 1 : 0;
  }
  return text;
}

}  // namespace

std::string depfile_text(const std::string& output, const std::vector<std::string>& inputs) {
  std::string text = escaped(output) + ":";
  for (const std::string& input : inputs) text += " \\\n  " + escaped(input);
  return text + "\n";
}

std::optional<AtomicFile> depfile_of(const std::string& path, const std::string& output,
                                     const std::vector<std::string>& inputs) {
  if (path.empty()) return {};
  AtomicFile file(path, inputs);
  file.write(depfile_text(output, inputs));
  file.close();
  return file;
}

}  // namespace mbgen
