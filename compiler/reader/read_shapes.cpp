// Shapes of bodies for pictures.
#include <fmt/format.h>

#include <charconv>

#include "compiler/reader/raw.hpp"
#include "compiler/reader/reader.hpp"

namespace mbgen::reading {
namespace {

/// Red, green and blue of "#rrggbb".
void read_colour(Reader& reader, const Value& value, ShapeFields& shape) {
  const Value* colour = find(value, "colour");
  if (!colour || colour->kind != Value::Kind::text) return;
  constexpr int kHex = 16, kByte = 256;
  const std::string& text = colour->text;
  int number = -1;
  const auto [end, error] = std::from_chars(text.data() + !text.empty(), text.data() + text.size(), number, kHex);
  if (text.size() != 7 || text[0] != '#' || error != std::errc() || end != text.data() + text.size() || number < 0) {
    report(reader, *colour, fmt::format("must be a colour \"#rrggbb\", got {}", in_quotes(text)));
    return;
  }
  shape.rgb = {number / (kByte * kByte), number / kByte % kByte, number % kByte};
  shape.has_colour = true;
}

void check_shape(Reader& reader, const Value& value, ShapeFields& shape) {
  read_colour(reader, value, shape);
  const bool is_sphere = shape.kind == DisplayShape::Kind::sphere, is_box = shape.kind == DisplayShape::Kind::box;
  const Value *to = find(value, "to"), *radius = find(value, "radius");
  if (shape.written_radius) shape.radius = *shape.written_radius;
  if (!find(value, "type")) return;
  if (is_sphere && to) report(reader, *to, "a sphere has no other end");
  if (!is_sphere && !to) report(reader, value, fmt::format("a {} needs \"to\"", is_box ? "box" : "cylinder"));
  if (is_box && radius) report(reader, *radius, "a box has no radius");
  if (!is_box && !radius)
    report(reader, value, fmt::format("a {} needs \"radius\"", is_sphere ? "sphere" : "cylinder"));
  if (is_sphere || !to || shape.from.body < 0 || shape.to.body < 0 || shape.from.body == shape.to.body) return;
  report(reader, *to,
         fmt::format("both points of a shape are on one body, {} is on another than {}",
                     in_quotes(attachment_text(reader.model, shape.to)),
                     in_quotes(attachment_text(reader.model, shape.from))));
}

}  // namespace

void read_shapes(Reader& reader, const Entries& entries) {
  std::vector<ShapeFields> list;
  read_list(reader, entries, list, check_shape);
  for (const ShapeFields& shape : list) reader.model.shapes.push_back(shape);
}

}  // namespace mbgen::reading
