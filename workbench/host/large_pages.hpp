#pragma once
// Memory for work on many values, in large pages.

#include <cstddef>

namespace mbgen {

/// Before a model of so many bodies is translated: takes the next 64 MB of the heap in large pages, where the system
/// has them to give. The passes over a coach touch seven thousand small ones, each 10 us on a virtual machine, a
/// seventh of their time; few bodies do without, since a large page is to be cleared, too.
void take_large_pages(std::size_t bodies);

}  // namespace mbgen
