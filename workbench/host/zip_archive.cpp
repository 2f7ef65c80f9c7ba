#include "workbench/host/zip_archive.hpp"

#include <algorithm>
#include <cstdint>
#include <stdexcept>

namespace mbgen {
namespace {

// Source: APPNOTE.TXT of the zip format, sections 4.3.7, 4.3.12, 4.3.16; extra fields "UT" and "ux" of Info-ZIP.
constexpr std::size_t kEndSize = 22, kCentralSize = 46, kLocalSize = 30;
constexpr std::uint32_t kEnd = 0x06054b50, kCentral = 0x02014b50, kLocal = 0x04034b50;
constexpr std::uint32_t kTimes = 0x5455, kOwner = 0x7875;

std::uint32_t number_at(const std::string& bytes, std::size_t at, int size) {
  if (at + static_cast<std::size_t>(size) > bytes.size()) throw std::runtime_error("a zip archive ends too early");
  std::uint32_t value = 0;
  for (int i = size - 1; i >= 0; --i)
    value = value << 8 | static_cast<unsigned char>(bytes[at + static_cast<std::size_t>(i)]);
  return value;
}

void require_mark(const std::string& bytes, std::size_t at, std::uint32_t mark) {
  if (number_at(bytes, at, 4) != mark) throw std::runtime_error("not a zip archive as cmake writes it");
}

/// Extra fields of one entry.
void normalise_extra(std::string& bytes, std::size_t at, std::size_t size) {
  for (const std::size_t end = at + size; at + 4 <= end;) {
    const std::uint32_t kind = number_at(bytes, at, 2);
    const std::size_t length = number_at(bytes, at + 2, 2), first = at + 4;
    if (first + length > end) throw std::runtime_error("an extra field of a zip archive is too long");
    if (kind == kTimes && length >= 9) {
      for (std::size_t i = 5; i < length; ++i) bytes[first + i] = bytes[first + 1 + (i - 1) % 4];
    } else if (kind == kOwner && length == 11) {
      std::fill_n(bytes.begin() + static_cast<std::ptrdiff_t>(first + 2), 4, '\0');
      std::fill_n(bytes.begin() + static_cast<std::ptrdiff_t>(first + 7), 4, '\0');
    }
    at = first + length;
  }
}

}  // namespace

std::string without_circumstances(std::string archive) {
  if (archive.size() < kEndSize) throw std::runtime_error("a zip archive ends too early");
  const std::size_t end = archive.size() - kEndSize;
  require_mark(archive, end, kEnd);
  std::size_t at = number_at(archive, end + 16, 4);
  for (std::uint32_t entries = number_at(archive, end + 10, 2); entries > 0; --entries) {
    require_mark(archive, at, kCentral);
    const std::size_t name = number_at(archive, at + 28, 2), extra = number_at(archive, at + 30, 2);
    const std::size_t comment = number_at(archive, at + 32, 2), local = number_at(archive, at + 42, 4);
    normalise_extra(archive, at + kCentralSize + name, extra);
    require_mark(archive, local, kLocal);
    normalise_extra(archive, local + kLocalSize + number_at(archive, local + 26, 2), number_at(archive, local + 28, 2));
    at += kCentralSize + name + extra + comment;
  }
  return archive;
}

}  // namespace mbgen
