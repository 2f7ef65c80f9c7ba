#include "udp.hpp"

#include <arpa/inet.h>
#include <fcntl.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cerrno>
#include <charconv>
#include <cstring>
#include <stdexcept>

namespace hil_rig {

sockaddr_in address_of(const std::string& text) {
  const std::size_t colon = text.find(':');
  sockaddr_in address{};
  address.sin_family = AF_INET;
  std::uint16_t port = 0;
  const std::string host = text.substr(0, colon), digits = colon == std::string::npos ? "" : text.substr(colon + 1);
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), port);
  const bool is_port = error == std::errc() && end == digits.data() + digits.size() && port != 0;
  if (!is_port || inet_pton(AF_INET, host.c_str(), &address.sin_addr) != 1) {
    throw std::runtime_error("'" + text + "' is no address; write it as 127.0.0.1:7001");
  }
  address.sin_port = htons(port);
  return address;
}

Socket::Socket(const sockaddr_in& at) : descriptor_(socket(AF_INET, SOCK_DGRAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0)) {
  if (descriptor_ < 0) throw std::runtime_error(std::string("no socket: ") + std::strerror(errno));
  if (bind(descriptor_, reinterpret_cast<const sockaddr*>(&at), sizeof at) == 0) return;
  const std::string why = std::strerror(errno);
  close(descriptor_);
  throw std::runtime_error("cannot receive at port " + std::to_string(ntohs(at.sin_port)) + ": " + why);
}

Socket::~Socket() { close(descriptor_); }

long Socket::receive(std::span<std::uint8_t> bytes, sockaddr_in* from) const noexcept {
  sockaddr_in sender{};
  for (;;) {
    socklen_t size = sizeof sender;
    const long count =
        recvfrom(descriptor_, bytes.data(), bytes.size(), 0, reinterpret_cast<sockaddr*>(&sender), &size);
    if (count < 0 && errno == EINTR) continue;
    if (from != nullptr) *from = sender;
    return count;
  }
}

bool Socket::send(std::span<const std::uint8_t> bytes, const sockaddr_in& to) const noexcept {
  const long count =
      sendto(descriptor_, bytes.data(), bytes.size(), 0, reinterpret_cast<const sockaddr*>(&to), sizeof to);
  return count == static_cast<long>(bytes.size()) || errno == ECONNREFUSED;
}

}  // namespace hil_rig
