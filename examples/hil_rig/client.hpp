#pragma once
// The driver's end of the line: answers every motion with a command.

#include <functional>
#include <string>

#include "options.hpp"
#include "packet.hpp"

namespace hil_rig {

/// Result of a client's run.
struct ClientResult {
  long motions = 0;    ///< received whole and newer than those before
  long dropped = 0;    ///< broken, doubled or late
  bool ended = false;  ///< the plant said so; otherwise it fell silent
  Motion last;
};

/// Who hears what from whom; addresses as 127.0.0.1:7001.
struct ClientSettings {
  std::string own;      ///< motions come here
  std::string plant;    ///< commands go there
  double patience = 2;  ///< s, the client ends when the plant is silent for so long; 10 s before the first motion
};

/// From the options `listen`, `plant` and `patience`. Throws std::runtime_error for a patience that is none.
ClientSettings client_settings(const Options& options);

/// Answers motions with what `decide` makes of them until the plant ends or is silent. Throws std::runtime_error.
ClientResult run_client(const ClientSettings& settings, const std::function<Command(const Motion&)>& decide);

/// Number of a session: differs from run to run.
std::uint32_t new_session();

}  // namespace hil_rig
