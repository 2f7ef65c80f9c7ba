#pragma once
// A network that does its worst, packet by packet and without clocks: the same number gives the same faults.

#include <cstdint>
#include <deque>
#include <random>
#include <vector>

using Bytes = std::vector<std::uint8_t>;

struct FaultyNetwork {
  std::mt19937 random{7};
  long passed = 0, lost = 0, doubled = 0, corrupted = 0, delayed = 0, garbage = 0;
  struct Waiting {
    long due;  ///< the packet that overtakes it
    Bytes packet;
  };
  std::deque<Waiting> waiting;
};

/// Packets that the network delivers for one that it is given: that one, none, two, a broken one, earlier ones.
inline std::vector<Bytes> deliver(FaultyNetwork& network, const Bytes& packet) {
  const auto chance = [&](std::size_t sides) { return network.random() % sides; };
  std::vector<Bytes> out;
  ++network.passed;
  switch (chance(10)) {
    case 0:
      ++network.lost;
      break;
    case 1:
      ++network.doubled;
      out = {packet, packet};
      break;
    case 2: {
      ++network.corrupted;
      Bytes broken = packet;
      broken[chance(broken.size())] ^= static_cast<std::uint8_t>(1u << chance(8));
      out = {broken};
      break;
    }
    case 3:
      ++network.delayed;
      network.waiting.push_back({network.passed + 1 + static_cast<long>(chance(8)), packet});
      break;
    case 4: {
      ++network.garbage;
      Bytes noise(chance(200));
      for (std::uint8_t& byte : noise) byte = static_cast<std::uint8_t>(chance(256));
      out = {noise, packet};
      break;
    }
    default:
      out = {packet};
  }
  while (!network.waiting.empty() && network.waiting.front().due <= network.passed) {
    out.push_back(network.waiting.front().packet);
    network.waiting.pop_front();
  }
  return out;
}
