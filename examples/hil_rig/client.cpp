#include "client.hpp"

#include <poll.h>
#include <unistd.h>

#include <algorithm>

#include "link.hpp"
#include "realtime.hpp"
#include "udp.hpp"

namespace hil_rig {

namespace {

struct Heard {
  Header header;
  Motion motion;
};

// The client's knowledge of the plant's packets; a plant that started anew is another session.
struct Hearing {
  std::optional<std::uint32_t> session;
  Numbers numbers;
};

bool is_newer(Hearing& hearing, const Header& header) {
  long skipped = 0;
  if (hearing.session == header.session) return note(hearing.numbers, header.sequence, skipped) == Order::newer;
  hearing = {header.session, {header.sequence, ~std::uint64_t{0}}};
  return true;
}

// The newest of the motions that wait.
std::optional<Heard> newest_motion(const Socket& socket, Hearing& hearing, ClientResult& result) {
  std::optional<Heard> newest;
  std::array<std::uint8_t, kLargestPacket + 64> bytes;
  for (long size = socket.receive(bytes); size >= 0; size = socket.receive(bytes)) {
    const std::optional<Header> header = open(bytes.data(), static_cast<std::size_t>(size));
    if (!header || header->type != Type::motion || !is_newer(hearing, *header)) {
      ++result.dropped;
      continue;
    }
    ++result.motions;
    newest = Heard{*header, payload_of<Motion>(bytes.data())};
  }
  return newest;
}

}  // namespace

std::uint32_t new_session() {
  const auto now = static_cast<std::uint64_t>(monotonic_now());
  return static_cast<std::uint32_t>(now / 1000) ^ (static_cast<std::uint32_t>(getpid()) << 16);
}

ClientSettings client_settings(const Options& options) {
  return {options.at("listen"), options.at("plant"), number_of(options, "patience", 0.1, 1e4)};
}

ClientResult run_client(const ClientSettings& settings, const std::function<Command(const Motion&)>& decide) {
  const Socket socket(address_of(settings.own));
  const sockaddr_in to = address_of(settings.plant);
  const std::uint32_t session = new_session();
  Hearing hearing;
  ClientResult result;
  for (std::uint32_t sequence = 1;; ++sequence) {
    pollfd waiting = {socket.descriptor(), POLLIN, 0};
    const double patience = result.motions == 0 ? std::max(10.0, settings.patience) : settings.patience;
    if (poll(&waiting, 1, static_cast<int>(1000 * patience)) == 0) return result;
    const std::optional<Heard> heard = newest_motion(socket, hearing, result);
    if (!heard) continue;
    result.last = heard->motion;
    Packet packet;
    const std::size_t size =
        encode({Type::command, session, sequence, heard->header.time, 0, 0}, decide(heard->motion), packet);
    socket.send({packet.data(), size}, to);
    if ((heard->header.flags & kLast) != 0) return result.ended = true, result;
  }
}

}  // namespace hil_rig
