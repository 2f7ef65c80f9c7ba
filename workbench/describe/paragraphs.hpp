#pragma once
// Text layout: paragraphs, headings, counts.

#include <string>
#include <vector>

namespace mbgen {

/// A paragraph broken into lines of at most 100 characters, each after `margin`.
std::string paragraph(const std::string& words, const std::string& margin = "");

std::string heading(const std::string& title);

/// "no joints", "1 joint", "2 joints". several: default `one` with an s.
std::string counted(long count, const std::string& one, std::string several = "");

/// "a", "a and b", "a, b and c".
std::string listed(const std::vector<std::string>& names);

}  // namespace mbgen
