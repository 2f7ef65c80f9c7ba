#include "workbench/host/large_pages.hpp"

#include <cstdint>
#include <cstdlib>

#ifdef __GLIBC__
#include <malloc.h>
#include <sys/mman.h>
#include <unistd.h>
#endif

namespace mbgen {

void take_large_pages([[maybe_unused]] std::size_t bodies) {
#ifdef __GLIBC__
  constexpr std::size_t kManyBodies = 16;
  constexpr int kTaken = 64 << 20;  // bytes
  constexpr std::uintptr_t kPage = 2 << 20;
  if (bodies < kManyBodies) return;
  const auto heap_end = [] { return reinterpret_cast<std::uintptr_t>(sbrk(0)); };
  const std::uintptr_t begin = (heap_end() + kPage - 1) / kPage * kPage;
  mallopt(M_TOP_PAD, kTaken);
  void* volatile larger = std::malloc(kPage);  // than all that is free: the heap grows
  std::free(larger);
  if (const std::uintptr_t end = heap_end(); end > begin)
    madvise(reinterpret_cast<void*>(begin), end - begin, MADV_HUGEPAGE);
#endif
}

}  // namespace mbgen
