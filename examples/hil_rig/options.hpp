#pragma once
// Command lines of the form --name value.

#include <charconv>
#include <cstdio>
#include <exception>
#include <map>
#include <stdexcept>
#include <string>

namespace hil_rig {

using Options = std::map<std::string, std::string>;

/// Options over their defaults, which also say what options there are. Throws std::runtime_error with the usage.
inline Options read_options(int argc, char** argv, Options options) {
  const auto usage = [&] {
    std::string text = "options, with their defaults:";
    for (const auto& [name, value] : options) text += " --" + name + " " + (value.empty() ? "''" : value);
    return text;
  };
  for (int i = 1; i < argc; i += 2) {
    const std::string name = argv[i];
    if (!name.starts_with("--") || !options.contains(name.substr(2))) {
      throw std::runtime_error("'" + name + "' is no option; " + usage());
    }
    if (i + 1 == argc) throw std::runtime_error(name + " needs a value; " + usage());
    options[name.substr(2)] = argv[i + 1];
  }
  return options;
}

/// An option as a number. Throws std::runtime_error when it is none or beyond its limits.
template <class Number>
Number number_of(const Options& options, const std::string& name, Number smallest, Number largest) {
  const std::string& text = options.at(name);
  Number value{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || !(value >= smallest && value <= largest)) {
    throw std::runtime_error("--" + name + " " + text + " is not a number from " + std::to_string(smallest) + " to " +
                             std::to_string(largest));
  }
  return value;
}

/// The command of this name: what `run` returns, or 1 after its error on a line.
template <class Run>
int guarded(const char* name, const Run& run) {
  try {
    return run();
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s: %s\n", name, error.what());
    return 1;
  }
}

}  // namespace hil_rig
