#include "bench/compare/table.hpp"

#include <fmt/format.h>

#include <fstream>
#include <thread>

namespace mbgen::compare {
namespace {

/// The value of the first line of a file that starts with `key`, behind its colon; "" when there is none.
std::string line_of(const std::string& path, const std::string& key) {
  std::ifstream file(path);
  for (std::string line; std::getline(file, line);) {
    if (line.starts_with(key)) return line.substr(std::min(line.size(), line.find(':') + 2));
  }
  return "";
}

std::string word_of(const std::string& path) {
  std::ifstream file(path);
  std::string word;
  return file >> word ? word : "?";
}

/// "1.93", "573": three digits, as far as they are after the point.
std::string three_digits(double value) {
  return fmt::format("{:.{}f}", value, value < 10 ? 3 : value < 100 ? 2 : value < 1000 ? 1 : 0);
}

std::string row_text(const Row& row) {
  if (!row.absent.empty()) return fmt::format("  {:<32} {}\n", row.name, row.absent);
  std::string text = fmt::format("  {:<32}", row.name);
  const Timing& t = row.timing;
  for (const double value : {t.microseconds.least, t.microseconds.median, t.microseconds.most})
    text += fmt::format("{:>10}", three_digits(value));
  text += "  |";
  for (const double value : {t.ratio.least, t.ratio.median, t.ratio.most}) text += fmt::format("{:>8.1f}", value);
  text += fmt::format("  |{:>10.1e}", row.deviation);
  std::string remark = row.remark;
  if (row.deviation_at_rest) remark += fmt::format(" ({:.1e} at rest)", *row.deviation_at_rest);
  return text + (remark.empty() ? "" : "  " + remark) + "\n";
}

std::string_view name_of(Figure figure) {
  switch (figure) {
    case Figure::single_microseconds:
      return "single instance, us";
    case Figure::lane_microseconds:
      return "per instance, eight in SIMD lanes, us";
    case Figure::operations:
      return "floating-point operations";
    case Figure::times_straightforward:
      return "times faster than straightforward Maggi on Eigen";
    case Figure::times_mujoco:
      return "times faster than MuJoCo";
    case Figure::times_simbody:
      return "times faster than Simbody";
    case Figure::hot_bytes:
      return "code that computes accelerations, bytes";
    case Figure::compile_seconds:
      return "compile time of the emitted file, s";
    case Figure::generation_seconds:
      break;
  }
  return "mbgen itself, s";
}

std::string verdict_text(const Verdict& verdict) {
  const bool whole = verdict.target.value >= 1000;
  const auto number = [&](double value) { return whole ? fmt::format("{:.0f}", value) : three_digits(value); };
  return fmt::format("  {:<50}{:>10}   {} {:>8}   {}\n", name_of(verdict.target.figure),
                     verdict.value ? number(*verdict.value) : "-",
                     is_lower_limit(verdict.target.figure) ? ">=" : "<=", fmt::format("{:g}", verdict.target.value),
                     !verdict.value     ? "not there"
                     : verdict.is_met() ? "met"
                                        : "missed");
}

std::string code_text(const CodeFacts& code) {
  const OperationCount& o = code.operations;
  return fmt::format(
      "  code: {} operations ({} add, {} multiply, {} divide; {} sqrt, {} trigonometric), {} instructions (x86-64-v3, "
      "callgrind),\n  {} bytes compute accelerations, {} the whole object; g++ took {:.1f} s, mbgen {:.2f} s\n",
      o.total(), o.add, o.multiply, o.divide, o.sqrt, o.trigonometric,
      code.instructions ? fmt::format("{}", *code.instructions) : "unknown", code.hot_bytes, code.text_bytes,
      code.compile_seconds, code.generation_seconds);
}

std::string title(const Comparison& c) {
  return fmt::format("{}{}: {} coordinates, {} closure equations, {} degrees of freedom; {}\n", c.model,
                     c.rods_are_massless ? " with massless rods" : "", c.coordinates, c.closure_equations,
                     c.degrees_of_freedom, c.states);
}

std::string json_string(const std::string& text) {
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' || c == '\\' ? std::string("\\") + c : std::string(1, c);
  return quoted + "\"";
}

std::string spread_json(const Spread& s) { return fmt::format("[{:.6g}, {:.6g}, {:.6g}]", s.least, s.median, s.most); }

std::string row_json(const Row& row) {
  if (!row.absent.empty())
    return fmt::format("{{\"key\": {}, \"name\": {}, \"absent\": {}}}", json_string(row.key), json_string(row.name),
                       json_string(row.absent));
  return fmt::format(
      "{{\"key\": {}, \"name\": {}, \"exact\": {}, \"deviation\": {:.3g}, \"evaluations\": {}, \"microseconds\": {}, "
      "\"ratio\": {}}}",
      json_string(row.key), json_string(row.name), row.exact, row.deviation, row.timing.evaluations,
      spread_json(row.timing.microseconds), spread_json(row.timing.ratio));
}

std::string code_json(const CodeFacts& code) {
  return fmt::format(
      "{{\"operations\": {}, \"hot_bytes\": {}, \"text_bytes\": {}, \"compile_seconds\": {:.3g}, "
      "\"generation_seconds\": {:.3g}, \"instructions\": {}}}",
      code.operations.total(), code.hot_bytes, code.text_bytes, code.compile_seconds, code.generation_seconds,
      code.instructions ? fmt::format("{}", *code.instructions) : "null");
}

std::string comparison_json(const Comparison& c) {
  std::string text = fmt::format("  {{\"model\": {}, \"rods_are_massless\": {}, \"states\": {},\n   \"rows\": [",
                                 json_string(c.model), c.rods_are_massless, json_string(c.states));
  for (std::size_t k = 0; k < c.rows.size(); ++k) text += (k > 0 ? ",\n     " : "\n     ") + row_json(c.rows[k]);
  text += "],\n   \"targets\": [";
  const std::vector<Verdict> list = verdicts(c);
  for (std::size_t k = 0; k < list.size(); ++k) {
    text += fmt::format("{}\n     {{\"figure\": \"{}\", \"target\": {:g}, \"value\": {}, \"met\": {}}}",
                        k > 0 ? "," : "", name_of(list[k].target.figure), list[k].target.value,
                        list[k].value ? fmt::format("{:.6g}", *list[k].value) : "null", list[k].is_met());
  }
  return text + "],\n   \"code\": " + (c.code ? code_json(*c.code) : "null") + "}";
}

}  // namespace

std::string machine_text() {
  std::string text = line_of("/proc/cpuinfo", "model name");
  if (text.empty()) text = "unknown processor";
  const std::string cache = "/sys/devices/system/cpu/cpu0/cache/index";
  return fmt::format("{}, {} processors, caches: {} data, {} instructions, {} second level; g++ {}, load {}", text,
                     std::thread::hardware_concurrency(), word_of(cache + "0/size"), word_of(cache + "1/size"),
                     word_of(cache + "2/size"), __VERSION__, word_of("/proc/loadavg"));
}

std::string table_text(const Comparison& c) {
  std::string text = title(c);
  if (!c.disagreeing.empty()) {
    for (const std::string& name : c.disagreeing) text += fmt::format("  does not agree: {}\n", name);
    for (const Row& row : c.rows) text += fmt::format("  {:<32}{:>10.1e}\n", row.name, row.deviation);
    return text;
  }
  text += fmt::format("  {:<32}{:>10}{:>10}{:>10}  |{:>8}{:>8}{:>8}  |{:>10}\n", "one evaluation", "us: least",
                      "median", "most", "times", "median", "most", "deviation");
  for (const Row& row : c.rows) text += row_text(row);
  const std::vector<Verdict> list = verdicts(c);
  if (!list.empty()) text += fmt::format("\n  {:<50}{:>10}   {:>11}\n", "target", "here", "wanted");
  for (const Verdict& verdict : list) text += verdict_text(verdict);
  return c.code ? text + "\n" + code_text(*c.code) : text;
}

std::string json_text(const std::vector<Comparison>& comparisons) {
  std::string text = fmt::format("{{\"machine\": {},\n \"comparisons\": [\n", json_string(machine_text()));
  for (std::size_t k = 0; k < comparisons.size(); ++k)
    text += comparison_json(comparisons[k]) + (k + 1 < comparisons.size() ? ",\n" : "\n");
  return text + " ]}\n";
}

}  // namespace mbgen::compare
