#include "compiler/emit/frame.hpp"

#include <algorithm>
#include <iterator>
#include <set>
#include <sstream>
#include <stdexcept>

#include "compiler/emit/embedded.hpp"
#include "compiler/emit/text.hpp"

namespace mbgen {
namespace {

/// First characters of tags of sections and frames.
constexpr std::string_view kMarks = "#~^/>";

/// The frame with every line that holds only tags of sections or frames replaced by these tags.
std::string without_lines_of_tags(std::string_view frame) {
  std::string result;
  while (!frame.empty()) {
    const std::string_view line = frame.substr(0, std::min(frame.find('\n'), frame.size() - 1) + 1);
    std::string_view rest = line;
    bool has_tag = false;
    while (rest.size() > 2 && rest.starts_with("{{") && kMarks.find(rest[2]) != kMarks.npos) {
      rest.remove_prefix(std::min(rest.find("}}"), rest.size() - 2) + 2);
      has_tag = true;
    }
    result += has_tag && rest == "\n" ? line.substr(0, line.size() - 1) : line;
    frame.remove_prefix(line.size());
  }
  return result;
}

/// Fills the sections of a frame, from outside to inside.
class FrameFiller {
 public:
  FrameFiller(std::string_view frame_name, const FrameValues& common)
      : frame_name_(frame_name), open_rows_({&common}) {}

  /// Text with its names replaced by values of the row, or of the enclosing rows.
  std::string fill(std::string_view text, const FrameValues& row) {
    open_rows_.push_back(&row);
    std::string result;
    while (true) {
      const std::size_t at = text.find("{{");
      result += text.substr(0, at);
      if (at == std::string_view::npos) break;
      text.remove_prefix(at + 2);
      const std::string_view tag = cut(text, "}}", "{{ without }}");
      const std::string name(tag.substr(tag.find_first_not_of(kMarks)));
      if (tag.starts_with('/')) fail("{{/" + name + "}} ends no section");
      if (tag == name) {
        if (!value_of(name).is_text) fail("{{" + name + "}} is no text");
        result += value_of(name).text;
      } else if (tag.starts_with('>')) {
        result += fill(without_lines_of_tags(template_text(name)), {});
      } else {
        const std::string_view body = cut(text, "{{/" + name + "}}", "{{" + std::string(tag) + "}} without its end");
        result += section(tag.front(), body, value_of(name));
      }
    }
    open_rows_.pop_back();
    return result;
  }

  /// Fails for a value that no section used.
  void check_used(const FrameValues& values) const {
    for (const auto& [name, value] : values) {
      if (!used_.contains(&value)) fail("{{" + name + "}} is not used");
      for (const FrameValues& row : value.rows) check_used(row);
    }
  }

 private:
  /// Text before a mark; removes it and the mark from `text`.
  std::string_view cut(std::string_view& text, std::string_view mark, const std::string& problem) const {
    const std::size_t end = text.find(mark);
    if (end == std::string_view::npos) fail(problem);
    const std::string_view part = text.substr(0, end);
    text.remove_prefix(end + mark.size());
    return part;
  }

  /// kind: '#' for the rows, '~' for rows that are statements, '^' for their absence.
  std::string section(char kind, std::string_view body, const FrameValue& value) {
    if (kind != '^' && !value.rows.empty()) {
      std::string result;
      for (const FrameValues& row : value.rows) {
        const std::string text = fill(body, row);
        result += kind == '~' ? wrapped_statement(text.substr(0, text.size() - 1)) + "\n" : text;
      }
      return result;
    }
    // A section that is left out is searched for names all the same; names of its missing row are unknown.
    unknown_rows_ += value.is_text ? 0 : 1;
    const std::string without = fill(body, {});
    unknown_rows_ -= value.is_text ? 0 : 1;
    return kind == '^' && value.rows.empty() ? without : "";
  }

  const FrameValue& value_of(const std::string& name) {
    static const FrameValue kUnknown("");
    for (auto row = open_rows_.rbegin(); row != open_rows_.rend(); ++row) {
      const auto value = (*row)->find(name);
      if (value != (*row)->end()) return **used_.insert(&value->second).first;
    }
    if (unknown_rows_ == 0) fail("no value for {{" + name + "}}");
    return kUnknown;
  }

  [[noreturn]] void fail(const std::string& what) const {
    throw std::logic_error(std::string(frame_name_) + ": " + what);
  }

  std::string_view frame_name_;
  std::vector<const FrameValues*> open_rows_;  // from outside to inside
  std::set<const FrameValue*> used_;
  int unknown_rows_ = 0;  // how many sections are open whose rows are not there to tell their names
};

}  // namespace

std::string fill_frame(std::string_view frame_name, std::string_view frame, const FrameValues& values,
                       const FrameValues& common) {
  FrameFiller filler(frame_name, common);
  std::string text = filler.fill(without_lines_of_tags(frame), values);
  filler.check_used(values);
  return text;
}

std::string_view template_text(const std::string& name) {
  for (const EmbeddedFile& file : embedded_files()) {
    if (file.path == "templates/" + name) return file.text;
  }
  throw std::logic_error("templates/" + name + ": not embedded");
}

std::vector<std::string> words_of(const std::string& name) {
  std::vector<std::string> words;
  std::istringstream lines{std::string(template_text(name))};
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with('#')) continue;
    std::istringstream list(line);
    words.insert(words.end(), std::istream_iterator<std::string>(list), {});
  }
  return words;
}

std::string fill_template(const std::string& name, const FrameValues& values, const FrameValues& common) {
  return fill_frame("templates/" + name, template_text(name), values, common);
}

}  // namespace mbgen
