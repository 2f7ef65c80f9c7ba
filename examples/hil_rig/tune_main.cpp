// Sets a tunable parameter of the running plant: hil_tune --name bar_front --value 12000.

#include <poll.h>

#include <cstdio>

#include "client.hpp"
#include "coach_rig.hpp"
#include "options.hpp"
#include "udp.hpp"

namespace {

using namespace hil_rig;

std::uint32_t number_of_parameter(const std::string& name) {
  std::string known;
  for (std::uint32_t i = 0; i < coach_rig::kParameters; ++i) {
    if (name == coach_rig::kParameterNames[i]) return i;
    known += std::string(" ") + coach_rig::kParameterNames[i];
  }
  throw std::runtime_error("'" + name + "' is no tunable parameter; there are" + known);
}

int run(int argc, char** argv) {
  const Options options = read_options(
      argc, argv, {{"listen", "127.0.0.1:7004"}, {"control", "127.0.0.1:7003"}, {"name", ""}, {"value", ""}});
  const std::uint32_t number = number_of_parameter(options.at("name"));
  const Setting setting = {number_of(options, "value", -1e12, 1e12)};
  const Socket socket(address_of(options.at("listen")));
  const sockaddr_in to = address_of(options.at("control"));
  const std::uint32_t session = new_session();
  std::array<std::uint8_t, kLargestPacket> bytes{};
  for (std::uint32_t sequence = 1; sequence <= 10; ++sequence) {
    Packet packet;
    const std::size_t size = encode({Type::setting, session, sequence, 0, number, 0}, setting, packet);
    socket.send({packet.data(), size}, to);
    pollfd waiting = {socket.descriptor(), POLLIN, 0};
    if (poll(&waiting, 1, 1000) == 0) continue;
    const long came = socket.receive(bytes);
    const auto header = came < 0 ? std::nullopt : open(bytes.data(), static_cast<std::size_t>(came));
    if (!header || header->type != Type::answer || header->session != session) continue;
    const bool taken = (header->flags & kTaken) != 0;
    std::printf("%s %s: it is %g %s\n", coach_rig::kParameterNames[number], taken ? "set" : "refused",
                payload_of<Setting>(bytes.data()).value, coach_rig::kParameterUnits[number]);
    return taken ? 0 : 2;
  }
  throw std::runtime_error("no answer from " + options.at("control"));
}

}  // namespace

int main(int argc, char** argv) {
  return hil_rig::guarded("hil_tune", [&] { return run(argc, argv); });
}
