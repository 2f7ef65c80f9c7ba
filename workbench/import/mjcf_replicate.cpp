// MJCF: <replicate> becomes copies of its contents, each in a frame, before anything else is read.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include "workbench/import/mjcf.hpp"

namespace mbgen::importing {
namespace {

constexpr std::size_t kMostElements = 2'000'000;  // as a file may have

/// Kind and name of an element that others refer to.
using Named = std::pair<std::string_view, std::string>;

struct Reference {
  std::string_view attribute, kind;
};
constexpr std::array<Reference, 14> kReferences = {{{"joint", "joint"},
                                                    {"joint1", "joint"},
                                                    {"joint2", "joint"},
                                                    {"jointinparent", "joint"},
                                                    {"body", "body"},
                                                    {"body1", "body"},
                                                    {"body2", "body"},
                                                    {"site", "site"},
                                                    {"site1", "site"},
                                                    {"site2", "site"},
                                                    {"refsite", "site"},
                                                    {"tendon", "tendon"},
                                                    {"tendon1", "tendon"},
                                                    {"tendon2", "tendon"}}};
constexpr std::array<std::string_view, 3> kReferring = {"tendon", "equality", "actuator"};

std::string_view kind_of(const Element& element, std::string_view section) {
  if (section == "tendon") return section;
  if (element.name == "freejoint") return "joint";
  return element.name;
}

void find_names(const Element& element, std::set<Named>& names) {
  for (const Element& inner : element.children) {
    if (const Attribute* name = attribute(inner, "name")) names.emplace(kind_of(inner, ""), name->value);
    find_names(inner, names);
  }
}

void rename(Element& element, const std::string& suffix) {
  for (Attribute& written : element.attributes)
    if (written.name == "name") written.value += suffix;
  for (Element& inner : element.children) rename(inner, suffix);
}

std::size_t size_of(const Element& element) {
  std::size_t size = 1;
  for (const Element& inner : element.children) size += size_of(inner);
  return size;
}

/// Calls `visit` for attributes that name one of these.
template <class Target, class Visit>
void for_references(Target& element, const std::set<Named>& names, const Visit& visit) {
  for (auto& written : element.attributes) {
    for (const Reference& reference : kReferences)
      if (reference.attribute == written.name && names.contains({reference.kind, written.value})) visit(written);
  }
  for (auto& inner : element.children) for_references(inner, names, visit);
}

/// The suffix of a copy: as many digits as the number of copies has.
std::string suffix_of(const std::string& separator, int copy, int count) {
  return separator + fmt::format("{:0{}}", copy, std::to_string(count).size());
}

/// Copies the elements of a section that refer to copied elements.
void copy_references(Element& section, std::set<Named>& names, const std::string& separator, int count,
                     std::size_t& elements) {
  std::vector<Element> children;
  for (Element& element : section.children) {
    bool refers = false;
    for_references(element, names, [&](const Attribute&) { refers = true; });
    if (!refers) {
      children.push_back(std::move(element));
      continue;
    }
    elements += size_of(element) * static_cast<std::size_t>(count);
    if (elements > kMostElements) return;
    for (int copy = 0; copy < count; ++copy) {
      const std::string suffix = suffix_of(separator, copy, count);
      children.push_back(element);
      for_references(children.back(), names, [&](Attribute& written) { written.value += suffix; });
      for (Attribute& written : children.back().attributes)
        if (written.name == "name") written.value += suffix;
    }
    if (const Attribute* name = attribute(element, "name"); name && section.name == "tendon")
      names.emplace(section.name, name->value);
  }
  section.children = std::move(children);
}

/// All replicates of a tree, the innermost first.
struct Expansion {
  Mjcf& mjcf;
  Element& root;
  std::size_t elements = 0;

  bool is_too_large(const Element& replicate) {
    if (elements <= kMostElements) return false;
    problem(mjcf.reading, replicate.spot, fmt::format("<replicate> makes more than {} elements", kMostElements));
    return true;
  }

  std::optional<int> count_of(const Element& replicate) {
    const Attribute* written = attribute(replicate, "count");
    const double count = number(mjcf.reading, replicate, "count", 0);
    if (count >= 1 && count <= static_cast<double>(kMostElements) && count == std::floor(count))
      return static_cast<int>(count);
    problem(mjcf.reading, written ? written->spot : replicate.spot,
            "<replicate> needs a count, a whole number above 0");
    return std::nullopt;
  }

  /// The way from one copy to the next.
  Isometry3d step_of(const Element& replicate) {
    Element frame{.name = "frame", .spot = replicate.spot, .attributes = {}, .children = {}};
    for (const Attribute& written : replicate.attributes) {
      if (written.name == "offset") frame.attributes.push_back({"pos", written.value, written.spot});
      if (written.name == "euler") frame.attributes.push_back(written);
    }
    return read_pose(mjcf, frame, "");
  }

  /// The copies, in frames.
  std::vector<Element> copies_of(const Element& replicate) {
    const std::optional<int> count = count_of(replicate);
    if (!count) return {};
    elements += size_of(replicate) * static_cast<std::size_t>(*count);
    if (is_too_large(replicate)) return {};
    const Isometry3d step = step_of(replicate);
    const std::string separator = text_of(replicate, "sep");
    std::set<Named> names;
    find_names(replicate, names);
    for (const std::string_view name : kReferring) {
      for (Element& section : root.children)
        if (section.name == name) copy_references(section, names, separator, *count, elements);
    }
    if (is_too_large(replicate)) return {};
    std::vector<Element> copies;
    Isometry3d at = Isometry3d::Identity();
    for (int copy = 0; copy < *count; ++copy, at = at * step) {
      Element frame{.name = "frame", .spot = replicate.spot, .attributes = {}, .children = replicate.children};
      const Vector3d p = at.translation();
      const Eigen::Quaterniond q(at.linear());
      frame.attributes = {{"pos", fmt::format("{} {} {}", p[0], p[1], p[2]), replicate.spot},
                          {"quat", fmt::format("{} {} {} {}", q.w(), q.x(), q.y(), q.z()), replicate.spot}};
      if (const Attribute* childclass = attribute(replicate, "childclass")) frame.attributes.push_back(*childclass);
      rename(frame, suffix_of(separator, copy, *count));
      copies.push_back(std::move(frame));
    }
    return copies;
  }

  void expand(Element& element) {
    std::vector<Element> children;
    for (Element& inner : element.children) {
      expand(inner);
      if (inner.name != "replicate") {
        children.push_back(std::move(inner));
        continue;
      }
      for (Element& copy : copies_of(inner)) children.push_back(std::move(copy));
    }
    element.children = std::move(children);
  }
};

}  // namespace

void expand_replicates(Mjcf& mjcf, Element& root) {
  Expansion expansion{mjcf, root};
  for (Element& section : root.children)
    if (section.name == "worldbody") expansion.expand(section);
}

}  // namespace mbgen::importing
