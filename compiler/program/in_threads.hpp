#pragma once
// Independent work on several processors at once.

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <exception>
#include <system_error>
#include <thread>
#include <vector>

namespace mbgen {

/// More threads would hold more programs in memory at the same time.
constexpr std::size_t kMostThreads = 4;

/// Calls work(i) for every i below `count`, in order, each in the first thread that is free, of at most so many.
/// Results do not depend on threads where work(i) changes nothing that another one looks at. Fails: with the first
/// failure by i.
template <class Work>
void in_threads(std::size_t count, const Work& work, std::size_t most = kMostThreads) {
  std::atomic<std::size_t> next{0};
  std::vector<std::exception_ptr> failures(count);
  const auto run = [&] {
    for (std::size_t i = next++; i < count; i = next++) {
      try {
        work(i);
      } catch (...) {
        failures[i] = std::current_exception();
      }
    }
  };
  const std::size_t processors = std::max(1u, std::thread::hardware_concurrency());
  std::vector<std::thread> others;
  try {
    for (std::size_t t = 1; t < std::min({count, processors, most}); ++t) others.emplace_back(run);
  } catch (const std::system_error&) {
    // No more threads are to be had: the others take all of the work.
  }
  run();
  for (std::thread& other : others) other.join();
  for (const std::exception_ptr& failure : failures)
    if (failure) std::rethrow_exception(failure);
}

}  // namespace mbgen
