#pragma once
// A shared library, and what must hold.

#include <dlfcn.h>

#include <stdexcept>
#include <string>

inline int checks = 0;

inline void require(bool holds, const std::string& what) {
  ++checks;
  if (!holds) throw std::runtime_error(what);
}

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
