#pragma once
// A reader of ASAP2 files that takes what mbgen writes and nothing else: which blocks stand in which, what follows each
// keyword, which names refer to which. Source: ASAM MCD-2 MC (ASAP2), version 1.6.

#include <cctype>
#include <map>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

namespace mbgen::test {

/// A block or keyword with its arguments as they stand there, strings without quotes and escapes.
struct A2lItem {
  std::string keyword;
  std::vector<std::string> arguments;
  std::vector<A2lItem> items;

  const A2lItem& child(const std::string& name) const {
    for (const A2lItem& item : items) {
      if (item.keyword == name) return item;
    }
    throw std::runtime_error(keyword + " without " + name);
  }
  std::vector<const A2lItem*> all(const std::string& name) const {
    std::vector<const A2lItem*> found;
    for (const A2lItem& item : items) {
      if (item.keyword == name) found.push_back(&item);
    }
    return found;
  }
};

namespace a2l_detail {

enum class Kind { word, string, begin, end, nothing };

struct Token {
  Kind kind = Kind::nothing;
  std::string text;
};

/// Contents of a block. arguments: i identifier, s string, n number, w word of the standard, f format; a list is
/// identifiers to the end of the block.
struct Rule {
  std::string arguments;
  std::set<std::string> blocks;
  std::map<std::string, std::string> keywords = {};
  bool is_list = false;
};

inline const std::map<std::string, Rule>& rules() {
  static const std::map<std::string, std::string> kLink = {{"SYMBOL_LINK", "sn"}, {"ECU_ADDRESS", "n"}};
  static const std::map<std::string, Rule> kRules = {
      {"PROJECT", {"is", {"HEADER", "MODULE"}}},
      {"HEADER", {"s", {}, {{"VERSION", "s"}, {"PROJECT_NO", "i"}}}},
      {"MODULE",
       {"is",
        {"MOD_PAR", "MOD_COMMON", "COMPU_METHOD", "RECORD_LAYOUT", "CHARACTERISTIC", "MEASUREMENT", "GROUP",
         "FUNCTION"}}},
      {"MOD_PAR", {"s", {}, {{"SYSTEM_CONSTANT", "ss"}, {"VERSION", "s"}, {"EPK", "s"}}}},
      {"MOD_COMMON",
       {"s",
        {},
        {{"DEPOSIT", "w"},
         {"BYTE_ORDER", "w"},
         {"ALIGNMENT_BYTE", "n"},
         {"ALIGNMENT_WORD", "n"},
         {"ALIGNMENT_LONG", "n"},
         {"ALIGNMENT_FLOAT32_IEEE", "n"},
         {"ALIGNMENT_FLOAT64_IEEE", "n"}}}},
      {"COMPU_METHOD", {"iswfs", {}}},
      {"RECORD_LAYOUT", {"i", {}, {{"FNC_VALUES", "nwww"}}}},
      {"CHARACTERISTIC", {"iswnininn", {}, {{"SYMBOL_LINK", "sn"}}}},
      {"MEASUREMENT", {"iswinnnn", {}, kLink}},
      {"GROUP", {"is", {"SUB_GROUP", "REF_CHARACTERISTIC", "REF_MEASUREMENT"}, {{"ROOT", ""}}}},
      {"FUNCTION", {"is", {"DEF_CHARACTERISTIC", "IN_MEASUREMENT", "OUT_MEASUREMENT", "LOC_MEASUREMENT"}}},
      {"SUB_GROUP", {"", {}, {}, true}},
      {"REF_CHARACTERISTIC", {"", {}, {}, true}},
      {"REF_MEASUREMENT", {"", {}, {}, true}},
      {"DEF_CHARACTERISTIC", {"", {}, {}, true}},
      {"IN_MEASUREMENT", {"", {}, {}, true}},
      {"OUT_MEASUREMENT", {"", {}, {}, true}},
      {"LOC_MEASUREMENT", {"", {}, {}, true}}};
  return kRules;
}

/// Words of the standard that stand as values.
inline const std::set<std::string> kValues = {"ABSOLUTE",   "MSB_LAST", "IDENTICAL", "FLOAT64_IEEE",
                                              "COLUMN_DIR", "DIRECT",   "VALUE"};

inline std::vector<Token> tokens_of(const std::string& text) {
  std::vector<Token> tokens;
  std::size_t at = text.compare(0, 3, "\xef\xbb\xbf") == 0 ? 3 : 0;
  while (at < text.size()) {
    if (std::isspace(static_cast<unsigned char>(text[at]))) {
      ++at;
    } else if (text.compare(at, 2, "/*") == 0) {
      const std::size_t end = text.find("*/", at + 2);
      if (end == std::string::npos) throw std::runtime_error("a comment without end");
      at = end + 2;
    } else if (text[at] == '"') {
      Token token{Kind::string, ""};
      for (++at; at < text.size() && text[at] != '"'; ++at) {
        if (text[at] == '\\') ++at;
        if (at < text.size() && static_cast<unsigned char>(text[at]) < ' ') throw std::runtime_error("a broken string");
        token.text += text[at];
      }
      if (at >= text.size()) throw std::runtime_error("a string without end");
      if (token.text.size() > 255) throw std::runtime_error("a string of more than 255 bytes");
      ++at;
      tokens.push_back(token);
    } else {
      const std::size_t start = at;
      while (at < text.size() && !std::isspace(static_cast<unsigned char>(text[at])) && text[at] != '"') ++at;
      const std::string word = text.substr(start, at - start);
      tokens.push_back({word == "/begin" ? Kind::begin : word == "/end" ? Kind::end : Kind::word, word});
    }
  }
  return tokens;
}

/// Identifiers of C joined by points, none of them longer than 128.
inline bool is_identifier(const std::string& text) {
  std::size_t length = 0;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (c == '.' ? length == 0 : !(c == '_' || (byte < 128 && (std::isalpha(byte) || (length && std::isdigit(byte))))))
      return false;
    length = c == '.' ? 0 : length + 1;
    if (length > 128) return false;
  }
  return length > 0 && text.size() <= 1024;
}

inline bool is_number(const std::string& text) {
  std::size_t end = 0;
  try {
    (void)std::stod(text, &end);
  } catch (const std::exception&) {
    return false;
  }
  return end == text.size() && text.find_first_of("nN") == std::string::npos;
}

inline bool is_format(const std::string& text) {
  const std::size_t point = text.find('.');
  return text.size() > 3 && text[0] == '%' && point != std::string::npos && point + 1 < text.size() &&
         text.find_first_not_of("0123456789.", 1) == std::string::npos;
}

class Reader {
 public:
  explicit Reader(std::vector<Token> tokens) : tokens_(std::move(tokens)) {}

  A2lItem file() {
    A2lItem file{"", {}, {}};
    expect("ASAP2_VERSION");
    arguments("nn", file.arguments);
    if (next().kind != Kind::begin) fail("no PROJECT");
    file.items.push_back(block({"PROJECT"}));
    if (at_ != tokens_.size()) fail("something after the PROJECT");
    return file;
  }

 private:
  [[noreturn]] void fail(const std::string& what) const {
    throw std::runtime_error(what + ", before token " + std::to_string(at_) +
                             (at_ < tokens_.size() ? ": " + tokens_[at_].text : ""));
  }
  const Token& next() {
    if (at_ >= tokens_.size()) fail("the file ends");
    return tokens_[at_++];
  }
  void expect(const std::string& word) {
    const Token& token = next();
    if (token.kind != Kind::word || token.text != word) fail("no " + word);
  }
  void arguments(const std::string& kinds, std::vector<std::string>& values) {
    for (const char kind : kinds) {
      const Token& token = next();
      const bool is_string = kind == 's' || kind == 'f';
      const bool fits = token.kind == (is_string ? Kind::string : Kind::word) &&
                        (kind != 'i' || is_identifier(token.text)) && (kind != 'n' || is_number(token.text)) &&
                        (kind != 'w' || kValues.count(token.text)) && (kind != 'f' || is_format(token.text));
      if (!fits) fail(std::string("no argument of kind ") + kind);
      values.push_back(token.text);
    }
  }
  /// After "/begin".
  A2lItem block(const std::set<std::string>& allowed) {
    A2lItem item{next().text, {}, {}};
    if (!allowed.count(item.keyword)) fail("no place for " + item.keyword);
    const Rule& rule = rules().at(item.keyword);
    arguments(rule.arguments, item.arguments);
    for (;;) {
      const Token& token = next();
      if (token.kind == Kind::end) break;
      if (token.kind == Kind::begin) {
        item.items.push_back(block(rule.blocks));
      } else if (rule.is_list && is_identifier(token.text)) {
        item.arguments.push_back(token.text);
      } else if (rule.keywords.count(token.text)) {
        A2lItem keyword{token.text, {}, {}};
        arguments(rule.keywords.at(token.text), keyword.arguments);
        item.items.push_back(std::move(keyword));
      } else {
        fail("not in " + item.keyword + ": " + token.text);
      }
    }
    expect(item.keyword);
    return item;
  }

  std::vector<Token> tokens_;
  std::size_t at_ = 0;
};

inline void require(bool condition, const std::string& what) {
  if (!condition) throw std::runtime_error(what);
}

/// Names of the blocks of one keyword; they must differ.
inline std::set<std::string> names_of(const A2lItem& module, const std::vector<std::string>& keywords) {
  std::set<std::string> names;
  for (const std::string& keyword : keywords) {
    for (const A2lItem* item : module.all(keyword)) {
      require(names.insert(item->arguments[0]).second, "twice: " + item->arguments[0]);
    }
  }
  return names;
}

inline void require_known(const A2lItem& list, const std::set<std::string>& names) {
  for (const std::string& name : list.arguments) require(names.count(name), list.keyword + " of unknown " + name);
}

inline void check_references(const A2lItem& module) {
  const std::set<std::string> measurements = names_of(module, {"MEASUREMENT"});
  const std::set<std::string> characteristics = names_of(module, {"CHARACTERISTIC"});
  const std::set<std::string> groups = names_of(module, {"GROUP"}), layouts = names_of(module, {"RECORD_LAYOUT"});
  std::set<std::string> methods = names_of(module, {"COMPU_METHOD"});
  methods.insert("NO_COMPU_METHOD");
  names_of(module, {"MEASUREMENT", "CHARACTERISTIC"});  // share one space
  for (const A2lItem* item : module.all("CHARACTERISTIC")) {
    require(layouts.count(item->arguments[4]) && methods.count(item->arguments[6]),
            "reference of " + item->arguments[0]);
    require(std::stod(item->arguments[7]) < std::stod(item->arguments[8]), "limits of " + item->arguments[0]);
  }
  for (const A2lItem* item : module.all("MEASUREMENT")) {
    require(methods.count(item->arguments[3]), "reference of " + item->arguments[0]);
    require(std::stod(item->arguments[6]) < std::stod(item->arguments[7]), "limits of " + item->arguments[0]);
  }
  std::set<std::string> grouped;
  for (const char* keyword : {"GROUP", "FUNCTION"}) {
    for (const A2lItem* block : module.all(keyword)) {
      for (const A2lItem& list : block->items) {
        const bool is_of_groups = list.keyword == "SUB_GROUP";
        const bool is_of_characteristics = list.keyword.ends_with("CHARACTERISTIC");
        require_known(list, is_of_groups ? groups : is_of_characteristics ? characteristics : measurements);
        grouped.insert(list.arguments.begin(), list.arguments.end());
      }
    }
  }
  for (const auto* names : {&measurements, &characteristics}) {
    for (const std::string& name : *names) require(grouped.count(name), "in no group: " + name);
  }
}

}  // namespace a2l_detail

/// The MODULE of a file. Fails: std::runtime_error for what the standard does not have there, for references to what is
/// not there, and for names that are there twice.
inline A2lItem read_a2l(const std::string& text) {
  const A2lItem file = a2l_detail::Reader(a2l_detail::tokens_of(text)).file();
  const A2lItem module = file.child("PROJECT").child("MODULE");
  a2l_detail::check_references(module);
  return module;
}

}  // namespace mbgen::test
