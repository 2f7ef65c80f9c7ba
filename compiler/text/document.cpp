#include "compiler/text/document.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <nlohmann/json.hpp>

namespace mbgen::reading {
namespace {

constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";

/// Next byte from `at` on that is no white space, comment, comma or colon.
std::size_t skip_separators(std::string_view text, std::size_t at) {
  constexpr std::string_view kSeparators = " \t\r\n,:";
  while (at < text.size()) {
    if (kSeparators.find(text[at]) != std::string_view::npos) {
      ++at;
    } else if (text.substr(at, 2) == "//") {
      at = std::min(text.find_first_of("\r\n", at), text.size());
    } else if (text.substr(at, 2) == "/*" && text.find("*/", at + 2) != std::string_view::npos) {
      at = text.find("*/", at + 2) + 2;
    } else {
      break;
    }
  }
  return at;
}

/// End of the token that starts at `at`. Requires: the parser has accepted the token.
std::size_t token_end(std::string_view text, std::size_t at) {
  if (text[at] == '"') {
    for (++at; at < text.size() && text[at] != '"'; ++at) {
      if (text[at] == '\\') ++at;
    }
    return at + 1;
  }
  if (std::string_view("{}[]").find(text[at]) != std::string_view::npos) return at + 1;
  return std::min(text.find_first_of(" \t\r\n,:{}[]\"/", at), text.size());
}

/// The parser's message for a syntax error, without its position and last token.
std::string syntax_message(std::string_view what) {
  constexpr std::string_view kMarker = "syntax error while parsing ";
  if (const auto at = what.find(kMarker); at != std::string_view::npos) what.remove_prefix(at + kMarker.size());
  what = what.substr(0, what.find("; last read"));
  const auto dash = what.find(" - ");
  if (dash == std::string_view::npos) return "syntax error: " + std::string(what);
  return fmt::format("syntax error in {}: {}", what.substr(0, dash), what.substr(dash + 3));
}

/// The text from `at` to the next white space or punctuation.
std::string_view word_at(std::string_view text, std::size_t at) {
  return text.substr(at, text.find_first_of(" \t\r\n,:{}[]\"/", at) - at);
}

std::string syntax_hint(std::string_view text, std::size_t at, std::string_view message) {
  const std::string_view word = word_at(text, at);
  for (const std::string_view not_a_number : {"NaN", "nan", "Infinity", "-Infinity", "inf", "-inf", "Inf", "-Inf"}) {
    if (word == not_a_number) return "every number must be finite";
  }
  const auto before = text.find_last_not_of(" \t\r\n", at == 0 ? 0 : at - 1);
  const auto is_digit_at = [&](std::size_t place) {
    return place < text.size() && std::isdigit(static_cast<unsigned char>(text[place])) != 0;
  };
  if (at >= 2 && text[at - 1] == ',' && is_digit_at(at) && is_digit_at(at - 2)) return "decimals have a point, as 4.5";
  const bool closing = at < text.size() && (text[at] == '}' || text[at] == ']');
  if (closing && before != std::string_view::npos && text[before] == ',') return "remove the comma before it";
  if (message.find("; expected '}'") != std::string_view::npos ||
      message.find("; expected ']'") != std::string_view::npos) {
    return "a comma or a closing bracket is missing before it";
  }
  if (word.size() > 1 && message.find("invalid literal") != std::string_view::npos)
    return "texts stand in double quotes";
  return {};
}

/// Handler of the parser's events; it follows the text in parallel to find the position of each token.
class TreeBuilder {
 public:
  TreeBuilder(Document& document, std::uint32_t index, Problems& problems)
      : document_(document), problems_(problems), file_(index) {
    if (document.text.starts_with(kByteOrderMark)) cursor_ = kByteOrderMark.size();
  }

  bool null() { return add(Value::Kind::null) != nullptr; }
  bool boolean(bool value) {
    Value* added = add(Value::Kind::boolean);
    if (added) added->boolean = value;
    return added != nullptr;
  }
  bool number_integer(std::int64_t value) { return number(static_cast<double>(value)); }
  bool number_unsigned(std::uint64_t value) { return number(static_cast<double>(value)); }
  bool number_float(double value, const std::string&) { return number(value); }
  bool string(std::string& value) {
    Value* added = add(Value::Kind::text);
    if (added) added->text = std::move(value);
    return added != nullptr;
  }
  bool binary(nlohmann::json::binary_t&) { return false; }
  bool start_object(std::size_t) { return open(Value::Kind::object); }
  bool start_array(std::size_t) { return open(Value::Kind::array); }
  bool key(std::string& name) {
    key_place_ = next_token();
    key_ = std::move(name);
    return true;
  }
  bool end_array() { return close(); }
  bool end_object() {
    report_duplicates(*open_.back());
    return close();
  }
  bool parse_error(std::size_t position, const std::string& token, const nlohmann::json::exception& error);

 private:
  bool number(double value) {
    Value* added = add(Value::Kind::number);
    if (added) added->number = value;
    return added != nullptr;
  }

  Place next_token() {
    const std::size_t start = skip_separators(document_.text, cursor_);
    cursor_ = token_end(document_.text, start);
    return {file_, static_cast<std::uint32_t>(start)};
  }

  Value* add(Value::Kind kind) {
    const Place place = next_token();
    if (++count_ > kMaximumValues) {
      problems_.push_back({place, fmt::format("file has more than {} values", kMaximumValues), {}});
      return nullptr;
    }
    Value* added = &document_.root;
    if (!open_.empty()) {
      Value& parent = *open_.back();
      if (parent.kind == Value::Kind::object) {
        parent.members.push_back({std::move(key_), key_place_, {}});
        added = &parent.members.back().value;
      } else {
        parent.items.emplace_back();
        added = &parent.items.back();
      }
    }
    added->kind = kind;
    added->place = place;
    return added;
  }

  bool open(Value::Kind kind) {
    Value* added = add(kind);
    if (!added) return false;
    open_.push_back(added);
    if (static_cast<int>(open_.size()) <= kMaximumDepth) return true;
    problems_.push_back({added->place, fmt::format("nested deeper than {} levels", kMaximumDepth), {}});
    return false;
  }

  bool close() {
    next_token();
    open_.pop_back();
    return true;
  }

  void report_duplicates(const Value& object) {
    std::vector<const Member*> sorted;
    for (const Member& member : object.members) sorted.push_back(&member);
    std::stable_sort(sorted.begin(), sorted.end(), [](const Member* a, const Member* b) { return a->key < b->key; });
    for (std::size_t i = 1, first = 0; i < sorted.size(); ++i) {
      if (sorted[i]->key != sorted[first]->key) {
        first = i;
        continue;
      }
      // Both positions are in this file; its line table exists before parsing.
      const Where earlier = where_of_line(sorted[first]->place);
      problems_.push_back({sorted[i]->place,
                           fmt::format("key {} is defined twice, first at {}:{}", in_quotes(sorted[i]->key),
                                       earlier.line, earlier.column),
                           {}});
    }
  }

  Where where_of_line(Place place) const {
    const auto& starts = document_.line_starts;
    const auto line = std::upper_bound(starts.begin(), starts.end(), place.offset) - starts.begin();
    return {document_.file,
            static_cast<int>(line),
            static_cast<int>(place.offset - starts[static_cast<std::size_t>(line - 1)]) + 1,
            {}};
  }

  /// Indentation of the line of a position, and whether the position follows it directly.
  std::pair<std::size_t, bool> indentation(Place place) const {
    const std::string_view text = document_.text;
    const auto& starts = document_.line_starts;
    const auto after = std::upper_bound(starts.begin(), starts.end(), place.offset);
    const std::size_t start = after == starts.begin() ? 0 : *(after - 1);
    const std::size_t first = text.find_first_not_of(" \t", start);
    return {first - start, first == place.offset};
  }

  /// First key on its own line with an indentation no deeper than the line of its object's begin; nullptr if there is
  /// none.
  const Member* first_misplaced(const Value& container) const {
    const std::size_t depth = indentation(container.place).first;
    for (const Member& member : container.members) {
      const auto [blanks, is_first] = indentation(member.place);
      const bool below = where_of_line(member.place).line > where_of_line(container.place).line;
      if (is_first && below && blanks <= depth && &container != &document_.root) return &member;
      if (const Member* inside = first_misplaced(member.value)) return inside;
    }
    for (const Value& item : container.items)
      if (const Member* inside = first_misplaced(item)) return inside;
    return nullptr;
  }

  /// Hint on the position of a missing closing bracket, from the indentation.
  std::string missing_bracket_hint() const {
    const Member* member = first_misplaced(document_.root);
    if (!member) return "a closing bracket is missing";
    const Where where = where_of_line(member->place);
    return fmt::format("by the indentation a closing bracket is missing before {} in line {}", in_quotes(member->key),
                       where.line);
  }

  Document& document_;
  Problems& problems_;
  std::uint32_t file_;
  std::size_t cursor_ = 0;  ///< one past the last token
  std::size_t count_ = 0;
  std::vector<Value*> open_;  ///< open containers, outermost first
  std::string key_;
  Place key_place_;
};

bool TreeBuilder::parse_error(std::size_t position, const std::string& token, const nlohmann::json::exception& error) {
  const std::string_view text = document_.text;
  std::size_t at = std::min({skip_separators(text, cursor_), position == 0 ? 0 : position - 1, text.size()});
  std::string message = syntax_message(error.what());
  const bool names_word =
      message.find("invalid literal") != std::string::npos || message.find("invalid number") != std::string::npos;
  if (names_word) message += ", got " + in_quotes(word_at(text, at));
  std::string hint = syntax_hint(text, at, message);
  constexpr int kNumberOverflow = 406;
  if (error.id == kNumberOverflow) {
    message = fmt::format("number {} is too large", token);
    hint = "every number must be finite";
  } else if (at == text.size()) {
    message = "unexpected end of file";
    hint.clear();
    if (!open_.empty()) {
      const Where opened = where_of_line(open_.back()->place);
      const char* what = open_.back()->kind == Value::Kind::object ? "object" : "array";
      message += fmt::format(", the {} opened at {}:{} is not closed", what, opened.line, opened.column);
      hint = missing_bracket_hint();
    }
    const auto last = text.find_last_not_of(" \t\r\n");
    at = last == std::string_view::npos ? 0 : last + 1;
  }
  problems_.push_back({{file_, static_cast<std::uint32_t>(at)}, message, hint});
  return false;
}

}  // namespace

void find_lines(Document& document) {
  document.line_starts = {document.text.starts_with(kByteOrderMark) ? 3u : 0u};
  for (std::size_t at = document.text.find('\n'); at != std::string::npos; at = document.text.find('\n', at + 1)) {
    document.line_starts.push_back(static_cast<std::uint32_t>(at + 1));
  }
}

bool parse_document(Document& document, std::uint32_t index, Problems& problems) {
  const std::string& text = document.text;
  const auto fail = [&](std::size_t offset, std::string message, std::string hint) {
    problems.push_back({{index, static_cast<std::uint32_t>(offset)}, std::move(message), std::move(hint)});
    return false;
  };
  document.line_starts = {0};
  if (text.size() > kMaximumBytes) {
    return fail(0, fmt::format("file is larger than 64 MB, it has {} bytes", text.size()), {});
  }
  if (text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF")) {
    return fail(0, "file is UTF-16 text", "save it as UTF-8");
  }
  find_lines(document);
  if (const auto zero = text.find('\0'); zero != std::string::npos) return fail(zero, "file has a zero byte", {});
  const std::size_t start = text.starts_with(kByteOrderMark) ? kByteOrderMark.size() : 0;
  if (skip_separators(text, start) == text.size() && text.find_first_of(",:") == std::string::npos) {
    return fail(start, "file is empty", "the smallest model starts with { \"mbgen\": 1, \"bodies\": ...");
  }
  const bool is_named_by_model = index > 0;
  if (is_named_by_model && text[skip_separators(text, start)] != '{') {
    document.is_shown = false;
    return fail(start, "file is no model, which begins with {", {});
  }
  TreeBuilder builder(document, index, problems);
  constexpr bool kStrict = true, kIgnoreComments = true;
  const bool parsed = nlohmann::json::sax_parse(text.begin(), text.end(), &builder,
                                                nlohmann::json::input_format_t::json, kStrict, kIgnoreComments);
  if (!parsed) document.root = {};  // an incomplete tree would give misleading pointers
  return parsed;
}

}  // namespace mbgen::reading
