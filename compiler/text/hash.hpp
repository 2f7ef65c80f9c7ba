#pragma once
// Hash of texts, for names of files and detection of damage.

#include <fmt/format.h>

#include <cstdint>
#include <string>
#include <string_view>

namespace mbgen {

/// FNV-1a, 64 bits, over texts and their boundaries.
class Hash {
 public:
  void add(std::string_view text) {
    add_bytes(text);
    mix(0x100);
  }
  /// A text without its boundary.
  void add_bytes(std::string_view text) {
    for (const char byte : text) mix(static_cast<unsigned char>(byte));
  }
  std::uint64_t value() const { return value_; }
  /// 16 hex digits.
  std::string text() const { return fmt::format("{:016x}", value_); }

 private:
  void mix(std::uint64_t byte) { value_ = (value_ ^ byte) * 0x100000001b3u; }
  std::uint64_t value_ = 0xcbf29ce484222325u;
};

}  // namespace mbgen
