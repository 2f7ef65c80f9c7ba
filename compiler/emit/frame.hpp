#pragma once
// Frames: texts with names that are replaced by values; most are under templates/.

#include <concepts>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace mbgen {

struct FrameValue;
/// Values of the names of a frame, or of one row of a section.
using FrameValues = std::map<std::string, FrameValue>;
/// Rows over which a section is repeated.
using FrameRows = std::vector<FrameValues>;

/// A text or number, whose section has one row, or none if the text is empty; or rows.
struct FrameValue {
  std::string text = {};
  FrameRows rows = {};
  bool is_text = true;

  FrameValue(std::string value) : text(std::move(value)), rows(text.empty() ? 0 : 1) {}
  FrameValue(const char* value) : FrameValue(std::string(value)) {}
  FrameValue(bool is_there) : rows(is_there ? 1 : 0) {}
  FrameValue(std::integral auto number) : FrameValue(std::to_string(number)) {}
  FrameValue(FrameRows values) : rows(std::move(values)), is_text(false) {}
};

/// Fills a frame: every {{name}} becomes its value. Text from {{#name}} to {{/name}} is repeated for each row of the
/// value; names of the row take precedence over names around it. Text from {{^name}} to {{/name}} remains if there is
/// no row. {{~name}} is {{#name}} for rows of one statement each, wrapped if it is too long. {{>name}} is another frame
/// of templates/, with the same values. A line that holds only such tags leaves no line. Fails: throws std::logic_error
/// when a name has no value, rows replace a text, a value is not used, or a section does not end. common: optional
/// values of lower precedence.
std::string fill_frame(std::string_view frame_name, std::string_view frame, const FrameValues& values,
                       const FrameValues& common = {});

/// The embedded file of this name under templates/. Fails: throws std::logic_error when there is none.
std::string_view template_text(const std::string& name);

/// Words of an embedded list, in order; lines that start with # are comments.
std::vector<std::string> words_of(const std::string& name);

/// The embedded frame of this name (under templates/), filled.
std::string fill_template(const std::string& name, const FrameValues& values, const FrameValues& common = {});

}  // namespace mbgen
