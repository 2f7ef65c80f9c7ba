// mbgen linearize: small oscillations about a state.

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <nlohmann/json.hpp>

#include "compiler/model/auxiliary_states.hpp"
#include "compiler/text/characters.hpp"
#include "compiler/text/json_text.hpp"
#include "compiler/text/number.hpp"
#include "compiler/text/user_error.hpp"
#include "workbench/cli/commands.hpp"
#include "workbench/cli/compiled.hpp"
#include "workbench/cli/frequency_responses.hpp"
#include "workbench/cli/html_report.hpp"
#include "workbench/cli/options.hpp"
#include "workbench/cli/trims.hpp"
#include "workbench/describe/notes.hpp"
#include "workbench/host/assignments.hpp"
#include "workbench/host/files.hpp"
#include "workbench/host/message.hpp"
#include "workbench/manoeuvre/mode_names.hpp"
#include "workbench/operating/operating_point.hpp"
#include "workbench/report/report.hpp"

namespace mbgen::cli {
namespace {

using Json = nlohmann::ordered_json;

struct LinearizeOptions {
  std::string model, file, page;
  std::vector<std::string> set;
  StateArguments state;
  BodeArguments bode;
  TrimArguments trim;
  std::string band;  ///< FIRST:LAST, Hz
  bool slowest_first = false, json = false;
};

std::vector<std::string> state_names(const Compilation& compilation, const LinearSystem& system) {
  const std::vector<std::string> auxiliary = auxiliary_state_names(compilation.model);
  std::vector<std::string> names;
  for (const LinearState& state : system.states) {
    const auto index = static_cast<std::size_t>(state.index);
    if (state.kind == LinearState::Kind::auxiliary) {
      names.push_back("x." + auxiliary[index]);
    } else {
      const bool is_velocity = state.kind == LinearState::Kind::velocity;
      names.push_back((is_velocity ? "zd." : "z.") + compilation.topology.bodies[index].coordinate);
    }
  }
  return names;
}

Json matrix_json(const Eigen::MatrixXd& matrix) {
  Json rows = Json::array();
  for (Eigen::Index i = 0; i < matrix.rows(); ++i) {
    Json row = Json::array();
    for (Eigen::Index j = 0; j < matrix.cols(); ++j) row.push_back(matrix(i, j));
    rows.push_back(std::move(row));
  }
  return rows;
}

Json complex_json(std::complex<double> value) { return Json::array({value.real(), value.imag()}); }

/// Modes with the parts that move in them.
struct NamedModes {
  std::vector<Mode> list;
  std::vector<std::vector<Participation>> parts;  ///< per mode
};

Json modes_json(const Compilation& compilation, const NamedModes& modes) {
  Json result = Json::array();
  for (std::size_t m = 0; m < modes.list.size(); ++m) {
    const Mode& mode = modes.list[m];
    Json shape = Json::object();
    for (std::size_t i = 0; i < mode.coordinates.size(); ++i) {
      shape[compilation.topology.bodies[i].coordinate] = complex_json(mode.coordinates[i]);
    }
    result.push_back({{"eigenvalue", complex_json(mode.eigenvalue)},
                      {"frequency", mode.frequency()},
                      {"undamped_frequency", mode.undamped_frequency()},
                      {"damping_ratio", mode.damping_ratio()},
                      {"neutral", mode.is_neutral},
                      {"shape", std::move(shape)}});
    if (modes.parts[m].empty()) continue;
    Json& parts = result.back()["participation"] = Json::object();
    for (const Participation& part : modes.parts[m]) parts[part.name] = part.share;
  }
  return result;
}

Json linear_json(const Compilation& compilation, const OperatingPoint& point, const LinearSystem& system,
                 const NamedModes& modes, const std::vector<std::string>& places) {
  Json inputs = Json::array(), outputs = Json::array(), z = Json::object();
  for (const Input& input : compilation.model.inputs) inputs.push_back(input.name);
  for (const Output& output : compilation.model.outputs) outputs.push_back(output.name);
  Json zd = Json::object();
  for (std::size_t i = 0; i < point.z.size(); ++i) {
    z[compilation.topology.bodies[i].coordinate] = point.z[i];
    zd[compilation.topology.bodies[i].coordinate] = point.zd[i];
  }
  Json input_values = Json::object();
  for (std::size_t i = 0; i < point.inputs.size(); ++i)
    input_values[compilation.model.inputs[i].name] = point.inputs[i];
  return {{"model", compilation.model.name},
          {"states", state_names(compilation, system)},
          {"inputs", inputs},
          {"outputs", outputs},
          {"positions", z},
          {"velocities", zd},
          {"input_values", input_values},
          {"drift", std::vector<double>(system.drift.begin(), system.drift.end())},
          {"A", matrix_json(system.A)},
          {"B", matrix_json(system.B)},
          {"C", matrix_json(system.C)},
          {"D", matrix_json(system.D)},
          {"rigid_body", places},
          {"modes", modes_json(compilation, modes)}};
}

/// Four decimals, without the sign of a rounded zero.
std::string without_minus_zero(double value) {
  const std::string text = fmt::format("{:.4f}", value);
  return text == "-0.0000" ? "0.0000" : text;
}

double largest_drift(const LinearSystem& system) {
  return system.drift.size() > 0 ? system.drift.cwiseAbs().maxCoeff() : 0.0;
}

/// One line for all neutral modes.
std::string neutral_text(const Compilation& compilation, const std::vector<Mode>& list,
                         const std::vector<std::string>& places) {
  const auto first = std::find_if(list.begin(), list.end(), [](const Mode& mode) { return mode.is_neutral; });
  if (first == list.end()) return "";
  long count = 0;  // the list has one of each conjugate pair
  for (const Mode& mode : list) count += !mode.is_neutral ? 0 : mode.eigenvalue.imag() > 0 ? 2 : 1;
  const char* kind = rolling_loop(compilation.topology) ? "rigid body and rolling" : "rigid body";
  return fmt::format("{:>4}{:>14} {:<17}{:>12}{:>12}   {}{}: {}\n", first - list.begin() + 1, 0, "", "-", "-", kind,
                     count == 1 ? "" : fmt::format(" ({} eigenvalues)", count), fmt::join(places, ", "));
}

/// Compilation, point and linear system of the requested state.
struct Linearised {
  Compilation compilation;
  ChosenPoint chosen;
  LinearSystem system;
  std::optional<TrimStudy> trim = {};
};

std::string point_text(const LinearizeOptions& options, const Linearised& found, const LinearSystem& system) {
  const Compilation& compilation = found.compilation;
  std::string text = fmt::format("{}: {} states, {} inputs, {} outputs\n", compilation.model.name, system.states.size(),
                                 compilation.model.inputs.size(), compilation.model.outputs.size());
  const auto is_load = [](const SampledValue& value) { return value.load.has_value(); };
  if (!std::ranges::all_of(compilation.model.sampled, is_load))
    text += "sampled values hold: the modes belong to the plant without its sampled controllers\n";
  if (std::ranges::any_of(compilation.model.sampled, is_load))
    text += "reactions that press frictions hold: the modes belong to the loads of the start\n";
  if (found.trim) return text + trims_text(*found.trim);
  if (found.chosen.steady) return text + steady_text(compilation, *found.chosen.steady, options.state.steady);
  return text + fmt::format("rates of the states at this point: at most {:.3g}\n\n", largest_drift(system));
}

std::string modes_text(const Compilation& compilation, const NamedModes& modes,
                       const std::vector<std::string>& places) {
  const std::vector<Mode>& list = modes.list;
  std::string text;
  text += "        eigenvalue [1/s]           frequency [Hz]   damping   moves most\n";
  int number = 0;
  for (const Mode& mode : list) {
    ++number;
    if (mode.is_neutral) continue;
    const bool oscillates = mode.oscillates();
    const std::string frequency = oscillates ? fmt::format("{:.4f}", mode.frequency()) : "-";
    const std::string damping = oscillates ? without_minus_zero(mode.damping_ratio()) : "-";
    const std::string imaginary = oscillates ? fmt::format("+-{:.4f} i", mode.eigenvalue.imag()) : "";
    const std::string real = without_minus_zero(mode.eigenvalue.real());
    const std::string name = participation_text(modes.parts[static_cast<std::size_t>(number) - 1]);
    std::string line =
        fmt::format("{:>4}{:>14} {:<17}{:>12}{:>12}   {}{}{}", number, real, imaginary, frequency, damping, name,
                    name.empty() ? "" : ": ",
                    leading_coordinates(compilation.model, compilation.topology, compilation.analysis, mode));
    line.erase(line.find_last_not_of(' ') + 1);
    text += line + "\n";
  }
  text += neutral_text(compilation, list, places);
  const auto unstable = std::count_if(list.begin(), list.end(), [](const Mode& mode) { return mode.is_unstable; });
  if (unstable > 0) text += fmt::format("\nunstable: {} of {} modes grow\n", unstable, list.size());
  return text;
}

/// Description of the requested state.
std::string state_text(const StateArguments& state) {
  if (!state.result.empty()) {
    return state.time ? fmt::format("state at {:g} s of {}", *state.time, state.result)
                      : fmt::format("row {} of {}", state.row, state.result);
  }
  if (state.at == "steady") return "steady motion";
  if (!state.states.empty()) return fmt::format("state {} of {}", state.index, state.states);
  return state.at == "equilibrium" ? "static equilibrium" : "initial state";
}

void write_page(const LinearizeOptions& options, const Compilation& compilation, const OperatingPoint& point,
                const LinearSystem& system, const std::vector<Mode>& list, const FrequencyResponses& responses) {
  if (list.empty()) throw UserError(fmt::format("--report: {} has no modes, nothing is free\n", options.model));
  write_file(options.page,
             modes_html({compilation.model, compilation.topology, compilation.analysis, point, list,
                         state_text(options.state), largest_drift(system), responses_diagrams(responses)}),
             files_read(compilation.model, options.state));
}

void write_responses(const LinearizeOptions& options, const Model& model, const FrequencyResponses& responses) {
  for (const std::string& file : options.bode.files) {
    const bool is_table = file.ends_with(".csv");
    if (!is_table && !file.ends_with(".svg"))
      throw UserError(fmt::format("--bode-out: \"{}\" is no .csv and no .svg file\n", file));
    write_file(file, is_table ? responses_csv(responses) : responses_svg(responses), files_read(model, options.state));
  }
}

void require_files_apart(const LinearizeOptions& options) {
  std::vector<WrittenFile> files{{"--out", options.file}, {"--report", options.page}};
  for (const std::string& file : options.bode.files) files.push_back({"--bode-out", file});
  for (const std::string& file : options.trim.files) files.push_back({"--handling-out", file});
  require_written_apart(files);
}

void require_compatible(const LinearizeOptions& options) {
  require_files_apart(options);
  if (!options.page.empty()) require_report_page("--report");
  if (!options.bode.files.empty() && options.bode.pairs.empty())
    throw UserError("--bode-out: nothing to write\n  hint: --bode INPUT:OUTPUT names a response\n");
  if (!options.bode.frequencies.empty() && options.bode.pairs.empty())
    throw UserError("--frequencies: of no response\n  hint: --bode INPUT:OUTPUT names a response\n");
  const TrimArguments& trim = options.trim;
  if (!trim.is_asked()) {
    if (!trim.lateral_acceleration.empty() || trim.radius || trim.grade || !trim.files.empty())
      throw UserError(
          "--lateral-acceleration, --radius, --grade, --handling-out: these belong to a steady motion of a vehicle, "
          "--speed\n");
    return;
  }
  const StateArguments& state = options.state;
  if (!state.steady.hold.empty() || !state.steady.solve.empty() || !state.states.empty() || !state.result.empty())
    throw UserError(
        "--speed: finds the steady motion of the vehicle itself; leave out --hold, --solve, --states and --result\n");
  if (state.at == "equilibrium") throw UserError("--at equilibrium: a vehicle at --speed is in steady motion\n");
}

/// The table of a range of steady motions.
int run_range(const LinearizeOptions& options, const TrimStudy& study) {
  if (!options.page.empty() || !options.bode.pairs.empty())
    throw UserError("--report, --bode: these belong to one steady motion, not to a range\n");
  const std::vector<std::string> read = files_read(study.compilation.model, options.state);
  write_trims(options.trim, study, read);
  const std::string json = json_text({{"model", study.compilation.model.name}, {"trims", trims_json(study)}});
  if (!options.file.empty()) write_file(options.file, json, read);
  print_beside(options.file, options.json ? json : trims_text(study));
  if (study.end.empty()) return kDone;
  print_message("{}: {}\n", options.model, study.end);
  return kUserFault;
}

Linearised linearised(const LinearizeOptions& options) {
  Linearised result;
  result.compilation = compiled(read_set_model(options.model, options.set));
  count_notes(result.compilation);
  result.chosen = operating_point(result.compilation, options.state);
  // A steady motion keeps the coordinates of its solution as names of states.
  result.system = expect(result.chosen.steady ? linearise(result.compilation, result.chosen.point)
                                              : linearise_by_any_choice(result.compilation, result.chosen.point));
  return result;
}

Linearised linearised(TrimStudy study) {
  Linearised result;
  const Trim& trim = study.trims.front();
  result.chosen = {trim.steady.point, trim.steady};
  result.system = trim.system;
  result.compilation = study.compilation;
  result.trim = std::move(study);
  return result;
}

/// Oscillations with frequencies of the band only, if there is one.
void leave_band(const std::string& band, std::vector<Mode>& list) {
  if (band.empty()) return;
  std::vector<double> ends;
  for (const std::string& part : split_at(band, ':')) ends.push_back(parse_number(part, "--band"));
  if (ends.size() != 2 || !(ends[0] >= 0) || !(ends[1] > ends[0]))
    throw UserError(
        fmt::format("--band: \"{}\" is no range of frequencies\n  hint: FIRST:LAST in Hz, for example 0.5:15\n", band));
  std::erase_if(list, [&](const Mode& mode) {
    return !mode.oscillates() || mode.frequency() < ends[0] || mode.frequency() > ends[1];
  });
}

NamedModes named_modes(const LinearizeOptions& options, const Linearised& found, const LinearSystem& system) {
  NamedModes named{modes(system), {}};
  if (found.chosen.steady) mark_places(*found.chosen.steady, named.list);
  leave_band(options.band, named.list);
  if (options.slowest_first) put_slowest_first(named.list);
  named.parts = participations(found.compilation, found.chosen.point, named.list);
  return named;
}

int run(const LinearizeOptions& options) {
  require_compatible(options);
  std::optional<TrimStudy> study;
  if (options.trim.is_asked()) study = trim_study(options.model, options.set, options.state.inputs, options.trim);
  if (study && study->is_range()) return run_range(options, *study);
  Linearised found = study ? linearised(std::move(*study)) : linearised(options);
  const Compilation& compilation = found.compilation;
  const OperatingPoint& point = found.chosen.point;
  LinearSystem& system = found.system;
  if (found.chosen.steady)
    print_message("{}{}", instant_note(compilation, *found.chosen.steady),
                  corners_note(compilation, *found.chosen.steady));
  const std::vector<std::string> places = neutral_coordinates(compilation.topology, system);
  if (found.chosen.steady) system = turning_with(*found.chosen.steady, std::move(system));
  const NamedModes modes = named_modes(options, found, system);
  const FrequencyResponses responses = frequency_responses(options.bode, compilation.model, system);
  Json linear = linear_json(compilation, point, system, modes, places);
  if (!responses.all.empty()) linear["responses"] = responses_json(responses);
  if (found.trim) linear["trim"] = trims_json(*found.trim)[0];
  const std::string json = json_text(linear);
  write_responses(options, compilation.model, responses);
  if (found.trim) write_trims(options.trim, *found.trim, files_read(compilation.model, options.state));
  if (!options.file.empty()) write_file(options.file, json, files_read(compilation.model, options.state));
  if (!options.page.empty()) write_page(options, compilation, point, system, modes.list, responses);
  const std::string& result = is_standard_output(options.page) ? options.page : options.file;
  print_beside(result, options.json ? json
                                    : point_text(options, found, system) + modes_text(compilation, modes, places) +
                                          (responses.all.empty() ? "" : responses_text(responses)));
  return kDone;
}

}  // namespace

void add_linearize(NamedCommand application, int& exit_code) {
  const auto options = std::make_shared<LinearizeOptions>();
  NamedCommand command = application.add_command("linearize", "print linear equations and modes about a state");
  command.footer(
      "Example: mbgen linearize models/coach.json --at equilibrium --report modes.html\n"
      "States are positions and velocities of the independent coordinates, slips of the tyres and states of the\n"
      "model; the loops stay closed. --json and --out give A, B, C, D, the eigenvalues and the mode shapes over all\n"
      "coordinates.\n"
      "--report writes a page that animates the mode shapes: one file that needs no network.");
  add_model_argument(command, options->model);
  add_set_option(command, options->set);
  add_state_options(command, options->state);
  command.add_option("--speed", options->trim.speed,
                     "m/s, or FIRST:LAST:COUNT: steady motion of the vehicle, steered and driven so that it keeps this "
                     "speed straight on or in a bend; with the gains of steering");
  command.add_option("--lateral-acceleration", options->trim.lateral_acceleration,
                     "of --speed: m/s^2 to the left, or FIRST:LAST:COUNT");
  command.add_option("--radius", options->trim.radius, "of --speed: m, positive to the left");
  command.add_option("--grade", options->trim.grade, "of --speed: rise over run of the road");
  command.add_option(
      "--handling-out", options->trim.files,
      "of --speed: write angles and gains to this file, a table (.csv) or a plot (.svg); may be repeated");
  command.add_option("-o,--out", options->file, "write matrices and modes to this file, as --json prints them");
  command.add_option("--report", options->page, "write the modes as a page: list, animation, eigenvalues (HTML)");
  command.add_option("--bode", options->bode.pairs, "INPUT:OUTPUT, a frequency response; may be repeated");
  command.add_option("--frequencies", options->bode.frequencies,
                     "FIRST:LAST:COUNT in Hz, evenly on a logarithmic axis");
  command.add_option("--bode-out", options->bode.files,
                     "write the responses to this file, a table (.csv) or a plot (.svg); may be repeated");
  command.add_flag("--slowest-first", options->slowest_first,
                   "list oscillations by increasing frequency, then the other modes by increasing rate");
  command.add_option("--band", options->band, "FIRST:LAST in Hz: only modes that oscillate within");
  add_json_option(command, options->json);
  command.callback([options, &exit_code] { exit_code = run(*options); });
}

}  // namespace mbgen::cli
