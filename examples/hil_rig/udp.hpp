#pragma once
// Datagrams by IPv4.

#include <netinet/in.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

namespace hil_rig {

/// "127.0.0.1:7001" as an address. Throws std::runtime_error when it is none.
sockaddr_in address_of(const std::string& text);

/// A descriptor that is closed in the end.
class Socket {
 public:
  /// Receives at an address, never waits. Throws std::runtime_error when the address is taken or not ours.
  explicit Socket(const sockaddr_in& at);
  ~Socket();
  Socket(const Socket&) = delete;
  Socket& operator=(const Socket&) = delete;

  int descriptor() const noexcept { return descriptor_; }

  /// The next datagram, as much of it as there is room for, and its sender. Result: its bytes, -1 when none waits.
  long receive(std::span<std::uint8_t> bytes, sockaddr_in* from = nullptr) const noexcept;

  /// Result: whether it left; a receiver that is not there is no fault.
  bool send(std::span<const std::uint8_t> bytes, const sockaddr_in& to) const noexcept;

 private:
  int descriptor_;
};

}  // namespace hil_rig
