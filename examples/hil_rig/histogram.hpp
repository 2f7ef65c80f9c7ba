#pragma once
// Times in bins of a microsecond, printed as cyclictest prints its histogram, so that what draws the one draws the
// other.

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdio>
#include <limits>

namespace hil_rig {

struct Histogram {
  static constexpr int kBins = 1000, kKeptOverflows = 16;
  std::array<long, kBins> bins{};
  std::array<long, kKeptOverflows> overflow_cycles{};
  long overflows = 0;  ///< times of kBins microseconds and more
  long count = 0;
  std::int64_t smallest = std::numeric_limits<std::int64_t>::max(), largest = 0, sum = 0;  ///< us
};

/// Counts a time, ns, of a cycle, the first of which is 0. Microseconds are cut off, not rounded, as in cyclictest.
inline void add(Histogram& histogram, std::int64_t time, long cycle) {
  const std::int64_t us = std::max<std::int64_t>(time, 0) / 1000;
  ++histogram.count;
  histogram.sum += us;
  histogram.smallest = std::min(histogram.smallest, us);
  histogram.largest = std::max(histogram.largest, us);
  if (us < Histogram::kBins) {
    ++histogram.bins[static_cast<std::size_t>(us)];
    return;
  }
  if (histogram.overflows < Histogram::kKeptOverflows) {
    histogram.overflow_cycles[static_cast<std::size_t>(histogram.overflows)] = cycle;
  }
  ++histogram.overflows;
}

inline std::int64_t smallest(const Histogram& histogram) { return histogram.count == 0 ? 0 : histogram.smallest; }

/// us, 0 of nothing.
inline std::int64_t mean(const Histogram& histogram) {
  return histogram.count == 0 ? 0 : histogram.sum / histogram.count;
}

/// Smallest time, us, that a share of all counted times does not pass; kBins when that is in the overflows.
inline std::int64_t quantile(const Histogram& histogram, double share) {
  long below = 0;
  for (int us = 0; us < Histogram::kBins; ++us) {
    below += histogram.bins[static_cast<std::size_t>(us)];
    if (static_cast<double>(below) >= share * static_cast<double>(histogram.count)) return us;
  }
  return Histogram::kBins;
}

/// The format of `cyclictest --histfile`, the histograms as its threads.
template <std::size_t Count>
void print(std::FILE* file, const std::array<const Histogram*, Count>& histograms) {
  const auto line = [&](const char* label, const char* format, auto value) {
    std::fputs(label, file);
    for (const Histogram* histogram : histograms) std::fprintf(file, format, static_cast<long>(value(*histogram)));
    std::fputc('\n', file);
  };
  std::fputs("# Histogram\n", file);
  for (std::size_t us = 0; us < Histogram::kBins; ++us) {
    std::fprintf(file, "%06d ", static_cast<int>(us));
    for (std::size_t i = 0; i < Count; ++i) std::fprintf(file, i == 0 ? "%06ld" : "\t%06ld", histograms[i]->bins[us]);
    std::fputc('\n', file);
  }
  line("# Total:", " %09ld", [](const Histogram& h) { return h.count - h.overflows; });
  line("# Min Latencies:", " %05ld", [](const Histogram& h) { return smallest(h); });
  line("# Avg Latencies:", " %05ld", [](const Histogram& h) { return mean(h); });
  line("# Max Latencies:", " %05ld", [](const Histogram& h) { return h.largest; });
  line("# Histogram Overflows:", " %05ld", [](const Histogram& h) { return h.overflows; });
  std::fputs("# Histogram Overflow at cycle number:\n", file);
  for (std::size_t i = 0; i < Count; ++i) {
    const Histogram& histogram = *histograms[i];
    const long kept = std::min<long>(histogram.overflows, Histogram::kKeptOverflows);
    std::fprintf(file, "# Thread %d:", static_cast<int>(i));
    for (long k = 0; k < kept; ++k) {
      std::fprintf(file, " %05ld", histogram.overflow_cycles[static_cast<std::size_t>(k)]);
    }
    if (histogram.overflows > kept) std::fprintf(file, " # %05ld others", histogram.overflows - kept);
    std::fputc('\n', file);
  }
  std::fputc('\n', file);
}

}  // namespace hil_rig
