#include "workbench/fit/least_squares.hpp"

#include <dlfcn.h>
#include <fmt/format.h>

#include <filesystem>

#include "compiler/text/user_error.hpp"

namespace mbgen::fit {
namespace {

namespace fs = std::filesystem;

#ifdef MBGEN_CERES
constexpr bool kWithCeres = true;
constexpr const char* kInstalled = MBGEN_CERES;
#else
constexpr bool kWithCeres = false;
constexpr const char* kInstalled = "";
#endif
constexpr const char* kLibrary = "mbgen_least_squares.so";

/// Beside the running program, where it is built; below its installation's libraries otherwise.
fs::path library_path() {
  const fs::path programs = fs::read_symlink("/proc/self/exe").parent_path();
  const fs::path built = programs / kLibrary;
  return fs::exists(built) ? built : (programs / kInstalled / kLibrary).lexically_normal();
}

}  // namespace

Method least_squares_method() {
  if (!kWithCeres)
    throw UserError(
        "fit: this mbgen is built without Ceres: install it (Debian: apt-get install libceres-dev) and build again\n");
  const fs::path path = library_path();
  void* library = ::dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL);
  void* method = library == nullptr ? nullptr : ::dlsym(library, "mbgen_least_squares");
  if (method == nullptr)
    throw UserError(
        fmt::format("fit: {}\n  it belongs to this mbgen and needs Ceres (Debian: apt-get install "
                    "libceres3); install mbgen whole\n",
                    ::dlerror()));
  return reinterpret_cast<Method>(method);
}

}  // namespace mbgen::fit
