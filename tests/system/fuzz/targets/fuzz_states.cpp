// Bytes as the states file of `evaluate` and `bench`: states of the right sizes, or a UserError.
#include "compiler/text/user_error.hpp"
#include "fuzz_tables.hpp"
#include "workbench/start/states_file.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace mbgen;
  static const Compilation compilation = fuzz::small_compilation();
  const auto n = static_cast<std::size_t>(compilation.topology.size());
  try {
    const StatesFile file = parse_states(fuzz::text_of(data, size), "states.json", compilation, {0, 0});
    fuzz::require(file.coordinate.size() == n, "every coordinate has its place");
    for (const FileState& state : file.states) {
      const GenericState& at = state.at.state;
      const bool whole = at.z.size() == n && at.zd.size() == n && state.at.tau.size() == n && at.x.empty() &&
                         state.inputs.size() == 2 && (state.zdd.empty() || state.zdd.size() == n);
      fuzz::require(whole, "states have the sizes of the model");
    }
  } catch (const UserError& error) {
    fuzz::require(error.what()[0] != 0, "an error has a text");
  }
  return 0;
}
