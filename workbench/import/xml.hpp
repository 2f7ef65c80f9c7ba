#pragma once
// XML as the translators read it: elements and attributes that know where they stand, and the numbers in them.

#include <deque>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "compiler/text/diagnostic.hpp"
#include "workbench/import/request.hpp"

namespace mbgen::importing {

/// A byte of one of the files.
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
};

/// A file that was read.
struct Source {
  std::string file, text;
  std::vector<std::size_t> line_starts;
};

/// Data that all parts of a translation share: the texts, their faults and their losses.
struct Reading {
  const ImportRequest& request;
  std::deque<Source> sources;
  Diagnostics problems, notes;
};

/// Adds a file. line_starts are found. Result: its index.
int add_source(Reading& reading, std::string file, std::string text);

/// The root element of the request's file, with the content of its <include> elements in their places.
/// Fails (nothing, with problems added): syntax, nesting deeper than 256 levels, more than 2 million elements, includes
/// that cannot be read or that include themselves.
std::optional<Element> read_xml(Reading& reading);

Where where_of(const Reading& reading, Spot spot);
void problem(Reading& reading, Spot spot, std::string message, std::string hint = {});
void note(Reading& reading, Spot spot, std::string message, std::string hint = {});

/// The first child of this name, or nullptr.
const Element* child(const Element& element, std::string_view name);
/// The attribute of this name, or nullptr.
const Attribute* attribute(const Element& element, std::string_view name);
/// Its value, "" when it is absent.
std::string text_of(const Element& element, std::string_view name);
/// The name of an element for a message: in quotes, shortened, without control characters.
std::string quoted_text(std::string_view text);

/// A value that must be there. Fails (nothing, with a problem): absent or empty.
std::optional<std::string> required_text(Reading& reading, const Element& element, std::string_view name);
/// The numbers of an attribute, between `least` and `most` of them. Fails (nothing, with a problem): something that is
/// no finite number, numbers above 1e15, another count.
std::optional<std::vector<double>> numbers(Reading& reading, const Attribute& attribute, std::size_t least,
                                           std::size_t most);
/// The same of numbers that mean "no limit" where they are infinite or above 1e15, as 2e19, inf and 1e308: these become
/// infinite.
std::optional<std::vector<double>> limits(Reading& reading, const Attribute& attribute, std::size_t least,
                                          std::size_t most);
/// One number, `fallback` when it is absent or unreadable.
double number(Reading& reading, const Element& element, std::string_view name, double fallback);

}  // namespace mbgen::importing
