// mbgen kc: kinematics and compliance of axles on their rigs.

#include "workbench/kc/kc.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <memory>

#include "compiler/text/json_text.hpp"
#include "compiler/text/user_error.hpp"
#include "workbench/cli/commands.hpp"
#include "workbench/cli/options.hpp"
#include "workbench/describe/notes.hpp"
#include "workbench/host/assignments.hpp"
#include "workbench/host/blocked_signals.hpp"
#include "workbench/host/message.hpp"
#include "workbench/host/process.hpp"
#include "workbench/host/progress.hpp"
#include "workbench/operating/operating_point.hpp"
#include "workbench/results/results.hpp"

namespace mbgen::cli {
namespace {

struct KcOptions {
  std::string model, directory, compliance;
  std::vector<std::string> axles, with, measured;
  StateArguments at;
  KcSettings kc;
  std::vector<std::string> set;
  bool json = false;
};

/// A model beside the asked one.
struct KcVariant {
  std::string label;
  Compilation compilation;
};

/// Another file, or changed values of the model: NAME=VALUE, several separated by blanks.
KcVariant variant_of(const KcOptions& options, const std::string& with) {
  const bool is_set = with.find('=') != std::string::npos && !std::filesystem::exists(with);
  std::vector<std::string> set = options.set;
  for (std::size_t begin = 0; is_set && begin < with.size();) {
    const std::size_t end = std::min(with.find(' ', begin), with.size());
    if (end > begin) set.push_back(with.substr(begin, end - begin));
    begin = end + 1;
  }
  try {
    return {is_set ? with : std::filesystem::path(with).filename().string(),
            expect(decide(is_set ? read_set_model(options.model, set) : read_set_model(with, {})))};
  } catch (const UserError& error) {
    const std::string text = error.what();
    if (text.starts_with("--set:")) throw UserError("--with:" + text.substr(6));
    throw;
  }
}

/// Measured points as typed: [CURVE=]FILE.
struct MeasuredFile {
  std::string curve, path;
  Results table;
};

MeasuredFile measured_file(const std::string& typed) {
  MeasuredFile file;
  const std::size_t sign = std::filesystem::exists(typed) ? std::string::npos : typed.find('=');
  file.curve = sign == std::string::npos ? "" : typed.substr(0, sign);
  file.path = sign == std::string::npos ? typed : typed.substr(sign + 1);
  file.table = expect(read_table(read_text(file.path), file.path, "measured points are a table of numbers"));
  return file;
}

/// Whether a file belongs to an axle: with several axles its name begins with the name of its axle.
bool is_of_axle(const MeasuredFile& file, const std::string& axle, std::size_t axles) {
  return axles == 1 || std::filesystem::path(file.path).filename().string().starts_with(axle + "_");
}

void check_measured(const std::vector<MeasuredFile>& files, const std::vector<const Axle*>& axles) {
  for (const MeasuredFile& file : files) {
    const bool has_axle = std::any_of(axles.begin(), axles.end(),
                                      [&](const Axle* axle) { return is_of_axle(file, axle->name, axles.size()); });
    if (!has_axle)
      throw UserError(
          fmt::format("--measured: the name of {} begins with no axle\n  hint: name the axle after the "
                      "model, or call the file like its table: {}_CURVE.csv\n",
                      file.path, axles.front()->name));
  }
}

/// The rigs of one call, with one line of progress, until they are interrupted.
class KcRun {
 public:
  explicit KcRun(const KcOptions& options)
      : options_(options), compilation_(expect(decide(read_set_model(options.model, options.set)))) {
    count_notes(compilation_);
    axles_ = find_axles(compilation_.model, options.axles);
    for (const std::string& with : options.with) variants_.push_back(variant_of(options, with));
    for (const std::string& typed : options.measured) measured_.push_back(measured_file(typed));
    check_measured(measured_, axles_);
  }

  std::vector<KcReport> reports() {
    std::vector<KcReport> list;
    for (const Axle* axle : axles_) {
      if (is_stopped_) break;
      list.push_back(report_of(compilation_, *axle));
      if (!is_stopped_) add_overlays(list.back());
    }
    progress_.clear();
    return list;
  }

  bool is_stopped() const { return is_stopped_; }
  int signal() { return signals_.taken(); }
  std::size_t axles() const { return axles_.size(); }

  /// Files read by the command.
  std::vector<std::string> read() const {
    std::vector<std::string> files = files_read(compilation_.model, options_.at);
    for (const KcVariant& variant : variants_)
      for (const std::string& file : files_read(variant.compilation.model, options_.at)) files.push_back(file);
    for (const MeasuredFile& file : measured_) files.push_back(file.path);
    return files;
  }

 private:
  KcReport report_of(const Compilation& compilation, const Axle& axle) {
    const OperatingPoint at = operating_point(compilation, options_.at).point;
    const long rig = rigs_++, rigs = static_cast<long>(axles_.size() * (1 + variants_.size()));
    return kinematics_and_compliance(compilation, axle, at, options_.kc, [&](long done, long of) {
      progress_.show(rig * of + done, rigs * of);
      is_stopped_ = done < of && signals_.taken() != 0;
      return !is_stopped_;
    });
  }

  void add_overlays(KcReport& report) {
    for (const KcVariant& variant : variants_) {
      if (is_stopped_) return;
      KcReport other = report_of(variant.compilation, find_axle(variant.compilation.model, report.axle));
      report.overlays.push_back(
          {variant.label, false, std::move(other.figures), std::move(other.tables), std::move(other.notes)});
    }
    for (const MeasuredFile& file : measured_) {
      if (!is_of_axle(file, report.axle, axles_.size())) continue;
      const std::string curve = file.curve.empty() ? curve_of_file(report, file.path) : file.curve;
      report.overlays.push_back(expect(measured_overlay(report, curve, file.table, file.path)));
    }
  }

  const KcOptions& options_;
  Compilation compilation_;
  std::vector<const Axle*> axles_;
  std::vector<KcVariant> variants_;
  std::vector<MeasuredFile> measured_;
  BlockedSignals signals_;
  Progress progress_{"kc"};
  bool is_stopped_ = false;
  long rigs_ = 0;
};

std::string printed(const std::vector<KcReport>& reports, bool is_one, const KcOptions& options) {
  if (options.json && is_one) return json_text(kc_json(reports.front()));
  if (options.json) {
    nlohmann::ordered_json axles = nlohmann::ordered_json::object();
    for (const KcReport& report : reports) axles[report.axle] = kc_json(report);
    return json_text({{"model", reports.front().model}, {"axles", axles}});
  }
  std::string text;
  for (const KcReport& report : reports) {
    text += (text.empty() ? "" : "\n") + kc_text(report);
    if (!options.compliance.empty()) text += kc_matrix_text(report, options.compliance);
  }
  return text;
}

/// Fails: UserError for an amplitude that is no number above 0.
void check_amplitudes(const KcSettings& kc) {
  const std::pair<const char*, std::optional<double>> amplitudes[] = {
      {"--travel", kc.travel}, {"--steer", kc.steer}, {"--force", kc.force}, {"--moment", kc.moment}};
  for (const auto& [option, amplitude] : amplitudes) {
    if (amplitude && !(std::isfinite(*amplitude) && *amplitude > 0))
      throw UserError(fmt::format("{}: must be a number above 0, got {:g}\n", option, *amplitude));
  }
}

int run(const KcOptions& options) {
  check_amplitudes(options.kc);
  KcRun rigs(options);
  const std::vector<KcReport> reports = rigs.reports();
  const std::string text = printed(reports, rigs.axles() == 1, options);
  if (!options.directory.empty()) write_files(options.directory, kc_files(reports), rigs.read());
  print(text);
  if (!rigs.is_stopped()) return kDone;
  print_message("kc: interrupted; {}run the same command again for all curves, or fewer --points\n",
                options.directory.empty() ? "" : fmt::format("{} holds the points up to there, ", options.directory));
  throw Interrupted{rigs.signal()};
}

}  // namespace

void add_kc(NamedCommand application, int& exit_code) {
  const auto options = std::make_shared<KcOptions>();
  NamedCommand command = application.add_command("kc", "run the rig curves of axles: kinematics and compliance");
  command.footer(
      "Example: mbgen kc models/coach.json front -o kc\n"
      "The rig holds the body where it is at the start and moves the wheels on pads. Curves go from minus to plus of "
      "the\n"
      "amplitudes; tables, pictures and a page of them go to the directory of --out.");
  add_model_argument(command, options->model);
  command.add_option("AXLE", options->axles, "axles of the model (default: all)");
  command.add_option("-o,--out", options->directory, "directory for tables (CSV), pictures (SVG) and the page (HTML)");
  command.add_option("--travel", options->kc.travel, "m, of the wheel centres (default 0.05)");
  command.add_option("--steer", options->kc.steer,
                     "rad or m, of the steering coordinate (default 0.3 rad or 0.03 m), or in the unit of the input "
                     "that steers");
  command.add_option("--force", options->kc.force, "N at each wheel (default: half its load, at least 1000)");
  command.add_option("--moment", options->kc.moment, "N m about z at each wheel (default: 0.05 m times the force)");
  command.add_option("--points", options->kc.points, "of a curve").with_shown_default().between(3, 1001);
  command
      .add_option(
          "--compliance", options->compliance,
          "print a compliance matrix: loads at the wheel centres or the contact centres, wheels free or held at "
          "their height")
      .one_of({"centre", "contact", "centre_held", "contact_held"});
  command
      .add_option(
          "--with", options->with,
          "draw and compare another model, or this one with changed parameters: FILE or \"NAME=VALUE ...\"; may "
          "be repeated")
      .one_value_at_a_time();
  command
      .add_option("--measured", options->measured,
                  "[CURVE=]FILE.csv: draw and compare measured points; columns are named like those of the curve's "
                  "table; may be repeated")
      .one_value_at_a_time();
  options->at.at = "initial";
  command.add_option("--at", options->at.at, "initial: the state that the model starts from (default), or equilibrium")
      .one_of({"initial", "equilibrium"});
  add_input_option(command, options->at.inputs);
  add_set_option(command, options->set);
  add_json_option(command, options->json);
  command.callback([options, &exit_code] { exit_code = run(*options); });
}

}  // namespace mbgen::cli
