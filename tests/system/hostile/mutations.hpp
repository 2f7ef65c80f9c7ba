#pragma once
// Every way to damage one place of a JSON text: a value dropped, doubled, retyped, spoiled; a key renamed.

#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace mbgen::test {

using Json = nlohmann::ordered_json;

/// Numbers, texts and structures to stand where something else stood, as JSON text.
inline const std::vector<std::string>& replacements() {
  static const std::vector<std::string> list = {
      "null", "true", "\"text\"", "\"\"", "[]", "{}", "7", "0", "-1", "-0.0", "0.5",
      // Numbers that are none, or too large or small.
      "NaN", "Infinity", "1e999", "-1e999", "1e308", "1e15", "1e16", "-1e15", "1e-308", "4.9e-324",
      "123456789012345678901234567890", "0x10", "01", "1.", "--1",
      // Expressions.
      "\"0/0\"", "\"1/0\"", "\"t\"", "\"sqrt(-1)\"", "\"1e300*1e300\"", "\"2*\"", "\"sin(\"", "\"nowhere\"",
      "\"z.nowhere\"", "\"" + std::string(300, '(') + "1" + std::string(300, ')') + "\"",
      "\"1" + std::string(2000, '-') + "1\"",
      // References and names.
      "\"ground\"", "\"ground.\"", "\".\"", "\"a.b.c\"", "\"ground.nowhere\"", "\"\\u0000\"", "\"\\ud800\"", "\"\xff\"",
      "\"\\\"\\\\\\n*/\"", "\"" + std::string(10'000, 'n') + "\"", "\"../../etc/passwd\"",
      // Structures.
      "[0, 0, 0]", "[0]", "[1, [2, [3]]]", "[null, null, null]", "{\"deg\": 90}", "{\"deg\": \"x\"}",
      "{\"value\": 1, \"value\": 2}", "{\"table\": [[0, 0], [1, 1]]}", "{\"table\": [[1, 0], [0, 1]]}",
      std::string(100, '[') + std::string(100, ']'), std::string(100'000, '['),
      "{\"a\":" + std::string(70, '[') + std::string(70, ']') + "}", "", "}", "]", ",", "/*", "//"};
  return list;
}

/// Keys to stand where another stood, as JSON text.
inline const std::vector<std::string>& key_replacements() {
  static const std::vector<std::string> list = {"\"\"",
                                                "\"ground\"",
                                                "\"x y\"",
                                                "\"\\n\"",
                                                "\"class\"",
                                                "\"__x\"",
                                                "\"type\"",
                                                "\"\xc3\xa9\"",
                                                "\"../x\"",
                                                "\"\\\";\"",
                                                "7",
                                                "null",
                                                "\"" + std::string(65, 'k') + "\"",
                                                "\"" + std::string(10'000, 'k') + "\""};
  return list;
}

/// Ways to damage one value: replacements, then drop, double, nest; for members also the keys.
inline std::size_t ways_of_value() { return replacements().size() + 3; }
inline std::size_t ways_of_member() { return ways_of_value() + key_replacements().size() + 1; }

/// Writes a document with one place damaged. Places are counted in the order of the text: every value below the root.
class Damage {
 public:
  Damage(const Json& document, std::size_t place, std::size_t way) : place_(place), way_(way) { write(document); }
  const std::string& text() const { return text_; }

 private:
  void write(const Json& value) {
    if (value.is_object()) return write_object(value);
    if (value.is_array()) return write_array(value);
    text_ += value.dump();
  }

  void write_object(const Json& value) {
    text_ += '{';
    for (const auto& [key, member] : value.items()) {
      const bool here = at_++ == place_;
      const std::string plain_key = Json(key).dump();
      if (!here) {
        begin_item();
        text_ += plain_key + ":";
        write(member);
      } else if (way_ < ways_of_value()) {
        write_damaged(member, plain_key + ":");
      } else {
        const std::size_t name = way_ - ways_of_value();
        begin_item();
        text_ += (name < key_replacements().size() ? key_replacements()[name] : Json(key + "x").dump()) + ":";
        write(member);
      }
    }
    text_ += '}';
  }

  void write_array(const Json& value) {
    text_ += '[';
    for (const Json& item : value) {
      const bool here = at_++ == place_;
      if (here) {
        write_damaged(item, "");
      } else {
        begin_item();
        write(item);
      }
    }
    text_ += ']';
  }

  void write_damaged(const Json& value, const std::string& key) {
    const std::size_t count = replacements().size();
    if (way_ == count) return;  // dropped
    begin_item();
    text_ += key;
    if (way_ < count) {
      text_ += replacements()[way_];
    } else if (way_ == count + 1) {
      text_ += value.dump() + "," + key + value.dump();
    } else {
      text_ += "[" + value.dump() + "]";
    }
    at_ += places_in(value);
  }

  void begin_item() {
    if (text_.back() != '{' && text_.back() != '[') text_ += ',';
  }

 public:
  /// Values below a value.
  static std::size_t places_in(const Json& value) {
    std::size_t count = value.is_structured() ? value.size() : 0;
    if (value.is_structured()) {
      for (const Json& item : value) count += places_in(item);
    }
    return count;
  }

  /// Whether each value below a value is a member of an object, in the order of places.
  static void members_in(const Json& value, std::vector<bool>& is_member) {
    if (!value.is_structured()) return;
    for (const Json& item : value) {
      is_member.push_back(value.is_object());
      members_in(item, is_member);
    }
  }

 private:
  std::size_t place_, way_, at_ = 0;
  std::string text_;
};

}  // namespace mbgen::test
