#pragma once
// XML for the translators: elements and attributes with their positions, and numbers in them.

#include <deque>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "compiler/text/diagnostic.hpp"
#include "workbench/import/request.hpp"

namespace mbgen::importing {

/// A position in one of the files.
struct Spot {
  int file = 0;            ///< index into Reading::sources
  std::size_t offset = 0;  ///< bytes from the start of the text
};

struct Attribute {
  std::string name, value;
  Spot spot;
};

struct Element {
  std::string name;
  Spot spot;
  std::vector<Attribute> attributes;
  std::vector<Element> children;
  std::string text = {};  ///< between its tags, without blanks around it
};

/// A file with its text.
struct Source {
  std::string file, text;
  std::vector<std::size_t> line_starts;
};

/// Common data of a translation: texts, problems and notes.
struct Reading {
  const ImportRequest& request;
  std::deque<Source> sources;
  Diagnostics problems, notes;
};

/// Adds a file and finds its line_starts. Result: its index.
int add_source(Reading& reading, std::string file, std::string text);

/// Root element of the request's file, with <include> elements replaced by their content. Fails (nothing, with problems
/// added): syntax, nesting deeper than 256 levels, more than 2 million elements, includes that cannot be read or that
/// include themselves.
std::optional<Element> read_xml(Reading& reading);
/// The same of another file, of this text.
std::optional<Element> read_xml(Reading& reading, const std::string& name, const std::string& text);

Where where_of(const Reading& reading, Spot spot);
void problem(Reading& reading, Spot spot, std::string message, std::string hint = {});
void note(Reading& reading, Spot spot, std::string message, std::string hint = {});

/// The first child of this name, or nullptr.
const Element* child(const Element& element, std::string_view name);
/// The attribute of this name, or nullptr.
const Attribute* attribute(const Element& element, std::string_view name);
/// Value of this attribute, "" without it.
std::string text_of(const Element& element, std::string_view name);
/// Name of an element for a message: in quotes, shortened, without control characters.
std::string quoted_text(std::string_view text);

/// A required value. Fails (nothing, with a problem): absent or empty.
std::optional<std::string> required_text(Reading& reading, const Element& element, std::string_view name);
/// The numbers of an attribute, between `least` and `most` of them. Fails (nothing, with a problem): a value that is no
/// finite number, numbers above 1e15, another count.
std::optional<std::vector<double>> numbers(Reading& reading, const Attribute& attribute, std::size_t least,
                                           std::size_t most);
/// The numbers of a limit: infinite ones or those above 1e15, as 2e19, inf and 1e308, mean "no limit" and become
/// infinite.
std::optional<std::vector<double>> limits(Reading& reading, const Attribute& attribute, std::size_t least,
                                          std::size_t most);
/// One number, `fallback` if it is absent or unreadable.
double number(Reading& reading, const Element& element, std::string_view name, double fallback);

}  // namespace mbgen::importing
