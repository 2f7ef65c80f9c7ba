#include "compiler/model/read_text.hpp"

#include <filesystem>
#include <fstream>
#include <system_error>
#include <utility>

#include "compiler/model/document.hpp"

namespace mbgen::reading {

namespace fs = std::filesystem;

FileText read_text(const std::string& path) {
  std::error_code error;
  if (!fs::exists(path, error)) return {{}, "cannot read file, it does not exist"};
  if (fs::is_directory(path, error)) return {{}, "cannot read file, it is a directory"};
  std::ifstream stream(path, std::ios::binary);
  if (!stream) return {{}, "cannot read file"};
  std::string text, chunk(std::size_t{1} << 16, '\0');
  while (stream && text.size() <= kMaximumBytes) {
    stream.read(chunk.data(), static_cast<std::streamsize>(chunk.size()));
    text.append(chunk, 0, static_cast<std::size_t>(stream.gcount()));
  }
  if (text.size() > kMaximumBytes) return {{}, "file is larger than 64 MB"};
  return {std::move(text), {}};
}

FileText read_regular_file(const std::string& path) {
  std::error_code ignored;
  const fs::file_status status = fs::status(path, ignored);
  const bool is_special = fs::exists(status) && !fs::is_regular_file(status) && !fs::is_directory(status);
  return is_special ? FileText{{}, "cannot read file, it is a device or pipe"} : read_text(path);
}

}  // namespace mbgen::reading
