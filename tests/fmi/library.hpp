#pragma once
// A shared library, and what must hold.

#ifdef _WIN32
#ifndef NOMINMAX
#define NOMINMAX
#endif
#define WIN32_LEAN_AND_MEAN
#include <windows.h>
#else
#include <dlfcn.h>
#endif

#include <stdexcept>
#include <string>

inline int checks = 0;
/// The last message of an FMU, and its category.
inline std::string last_message, last_category;

inline void require(bool holds, const std::string& what) {
  ++checks;
  if (!holds) throw std::runtime_error(what);
}

#ifdef _WIN32
class Library {
 public:
  explicit Library(const std::string& path) : handle_(::LoadLibraryA(path.c_str())) {
    if (handle_ == nullptr) throw std::runtime_error("LoadLibrary fails: " + std::to_string(::GetLastError()));
  }
  ~Library() { ::FreeLibrary(handle_); }
  Library(const Library&) = delete;
  Library& operator=(const Library&) = delete;

  template <class Function>
  Function* function(const char* name) const {
    const FARPROC address = ::GetProcAddress(handle_, name);
    if (address == nullptr) throw std::runtime_error(std::string("the FMU does not export ") + name);
    return reinterpret_cast<Function*>(reinterpret_cast<void*>(address));
  }

 private:
  HMODULE handle_;
};
#else
class Library {
 public:
  explicit Library(const std::string& path) : handle_(::dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL)) {
    if (handle_ == nullptr) throw std::runtime_error(::dlerror());
  }
  ~Library() { ::dlclose(handle_); }
  Library(const Library&) = delete;
  Library& operator=(const Library&) = delete;

  template <class Function>
  Function* function(const char* name) const {
    void* address = ::dlsym(handle_, name);
    if (address == nullptr) throw std::runtime_error(std::string("the FMU does not export ") + name);
    return reinterpret_cast<Function*>(address);
  }

 private:
  void* handle_;
};
#endif
