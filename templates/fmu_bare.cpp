// What compilers call for large copies, inside the library: an FMU imports nothing but libm.
#include <cstddef>

extern "C" {

[[gnu::visibility("hidden")]] void* memcpy(void* __restrict to, const void* __restrict from, std::size_t size) {
  for (std::size_t i = 0; i < size; ++i) static_cast<char*>(to)[i] = static_cast<const char*>(from)[i];
  return to;
}

[[gnu::visibility("hidden")]] void* memmove(void* to, const void* from, std::size_t size) {
  char* target = static_cast<char*>(to);
  const char* source = static_cast<const char*>(from);
  if (target < source) return memcpy(to, from, size);
  while (size-- > 0) target[size] = source[size];
  return to;
}

[[gnu::visibility("hidden")]] void* memset(void* to, int value, std::size_t size) {
  for (std::size_t i = 0; i < size; ++i) static_cast<char*>(to)[i] = static_cast<char>(value);
  return to;
}

}  // extern "C"
