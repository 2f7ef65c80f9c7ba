// Between plant and driver: spoils commands as faults.hpp does until it has passed so many, says what it did, then
// leaves them alone; ends when the plant does. proxy OWN_FOR_DRIVER OWN_FOR_PLANT DRIVER PLANT COMMANDS, addresses as
// 127.0.0.1:7001

#include <poll.h>

#include <cstdio>
#include <cstdlib>

#include "faults.hpp"
#include "packet.hpp"
#include "udp.hpp"

int main(int argc, char** argv) {
  using namespace hil_rig;
  if (argc != 6) return 2;
  const Socket at_driver(address_of(argv[1])), at_plant(address_of(argv[2]));
  const sockaddr_in driver = address_of(argv[3]), plant = address_of(argv[4]);
  const long commands = std::atol(argv[5]);
  FaultyNetwork network, motions;
  Bytes bytes(512);
  for (bool ended = false; !ended;) {
    pollfd waiting[] = {{at_driver.descriptor(), POLLIN, 0}, {at_plant.descriptor(), POLLIN, 0}};
    if (poll(waiting, 2, 300000) == 0) return 1;
    for (long size = at_plant.receive(bytes); size >= 0; size = at_plant.receive(bytes)) {
      const auto header = open(bytes.data(), static_cast<std::size_t>(size));
      ended = ended || (header && (header->flags & kLast) != 0);
      const Bytes packet(bytes.begin(), bytes.begin() + size);
      const bool clean = ended || network.passed >= commands;
      for (const Bytes& out : clean ? std::vector<Bytes>{packet} : deliver(motions, packet))
        at_driver.send(out, driver);
    }
    for (long size = at_driver.receive(bytes); size >= 0; size = at_driver.receive(bytes)) {
      const Bytes packet(bytes.begin(), bytes.begin() + size);
      const bool clean = network.passed >= commands;
      for (const Bytes& out : clean ? std::vector<Bytes>{packet} : deliver(network, packet)) at_plant.send(out, plant);
      if (clean || network.passed < commands) continue;
      std::printf("lost %ld doubled %ld corrupted %ld delayed %ld garbage %ld\n", network.lost, network.doubled,
                  network.corrupted, network.delayed, network.garbage);
      std::fflush(stdout);
    }
  }
  return 0;
}
