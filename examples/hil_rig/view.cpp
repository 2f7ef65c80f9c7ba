#include "view.hpp"

#include <algorithm>

namespace hil_rig {

namespace {

template <class... Values>
std::string formatted(const char* format, Values... values) {
  char text[200];
  std::snprintf(text, sizeof text, format, values...);
  return text;
}

// A mark at a value between two ends.
std::string scale(double value, double end) {
  constexpr int kHalf = 20;
  std::string bar(2 * kHalf + 1, '-');
  bar[kHalf] = '|';
  const double place = std::clamp(value / end, -1.0, 1.0) * kHalf;
  bar[static_cast<std::size_t>(kHalf - static_cast<int>(place))] = '#';  // the driver's left is left
  return bar;
}

void print_counts(std::FILE* file, const Counts& counts, const char* format, const char* separator) {
  const std::pair<const char*, long> rows[] = {
      {"received", counts.received}, {"accepted", counts.accepted}, {"corrupt", counts.corrupt},
      {"refused", counts.refused},   {"foreign", counts.foreign},   {"duplicate", counts.duplicate},
      {"late", counts.late},         {"stale", counts.stale},       {"lost", counts.lost}};
  for (const auto& [name, value] : rows) {
    std::fprintf(file, format, name, value);
    std::fputs(separator, file);
  }
}

void print_times(std::FILE* file, const char* name, const Histogram& histogram) {
  std::fprintf(file, "%-22s min %ld  mean %ld", name, static_cast<long>(smallest(histogram)),
               static_cast<long>(mean(histogram)));
  for (const auto& [share, label] : {std::pair{0.99, "99%"}, std::pair{0.999, "99.9%"}}) {
    const auto us = static_cast<long>(quantile(histogram, share));
    std::fprintf(file, us < Histogram::kBins ? "  %s %ld" : "  %s over %ld", label, us);
  }
  std::fprintf(file, "  max %ld us\n", static_cast<long>(histogram.largest));
}

// The whole view anew at the top left of a terminal.
void draw(std::FILE* file, const Glance& glance, const std::deque<std::string>& said) {
  const Motion& m = glance.motion;
  std::string lines[] = {
      formatted("coach on the rig   t %8.3f s   %s", m.time, text(glance.phase)),
      formatted("  along %8.2f m   left %7.3f m   speed %6.2f m/s", m.x, m.y, m.forward_speed),
      formatted("  left      %s %7.3f m", scale(m.y, 5).c_str(), m.y),
      formatted("  steering  %s %7.3f rad", scale(m.steering, 0.3).c_str(), m.steering),
      formatted("  lateral   %s %7.3f m/s^2", scale(m.lateral_acceleration, 5).c_str(), m.lateral_acceleration),
      formatted("  loads     %6.0f %6.0f %6.0f %6.0f N", m.loads[0], m.loads[1], m.loads[2], m.loads[3]),
      formatted("  wake-up   mean %4ld  max %6ld us", static_cast<long>(glance.wakeup_mean),
                static_cast<long>(glance.wakeup_largest)),
      formatted("  step      mean %4ld  max %6ld us", static_cast<long>(glance.work_mean),
                static_cast<long>(glance.work_largest)),
      formatted("  cycles %ld   overruns %ld   missed periods %ld", glance.cycles, glance.overruns, glance.missed)};
  std::fputs("\033[H", file);
  for (const std::string& line : lines) std::fprintf(file, "%s\033[K\n", line.c_str());
  std::fputs("  packets ", file);
  print_counts(file, glance.counts, "%s %ld", " ");
  std::fputs("\033[K\n", file);
  for (const std::string& message : said) std::fprintf(file, "  %s\033[K\n", message.c_str());
  std::fputs("\033[J", file);
  std::fflush(file);
}

void print_line(std::FILE* file, const Glance& glance) {
  const Motion& m = glance.motion;
  std::fprintf(file, "%6.2f  %8.2f  %7.3f  %4.1f  %8.4f | %15ld %5ld | %12ld %5ld | %8ld\n", m.time, m.x, m.y,
               m.forward_speed, m.steering, static_cast<long>(glance.wakeup_mean),
               static_cast<long>(glance.wakeup_largest), static_cast<long>(glance.work_mean),
               static_cast<long>(glance.work_largest), glance.overruns);
  std::fflush(file);
}

}  // namespace

std::string words_of(const Event& event) {
  switch (event.kind) {
    case Event::Kind::phase:
      return formatted("cycle %ld: %s", event.cycle, text(static_cast<Phase>(event.value)));
    case Event::Kind::parameters:
      return formatted("cycle %ld: parameters taken over", event.cycle);
    case Event::Kind::overrun:
      return formatted("cycle %ld: overrun, %ld periods missed", event.cycle, event.value);
    case Event::Kind::session:
      return formatted("cycle %ld: driver %lx speaks", event.cycle, static_cast<unsigned long>(event.value));
    case Event::Kind::failed:
      return formatted("cycle %ld: the solver failed: %s", event.cycle,
                       mbgen::text(static_cast<mbgen::Code>(event.value)));
  }
  return {};
}

View::View(std::FILE* file, bool terminal) : file_(file), terminal_(terminal) {
  std::fputs(terminal
                 ? "\033[2J"
                 : "   t s   along m   left m  m/s  steer rad | wake-up us mean  max | step us mean  max | overruns\n",
             file_);
}

void View::say(const std::string& message) {
  if (!terminal_) std::fprintf(file_, "%s\n", message.c_str());
  std::fflush(file_);
  said_.push_back(message);
  if (said_.size() > 6) said_.pop_front();
}

void View::show(const Glance& glance) {
  if (terminal_) return draw(file_, glance, said_);
  const long seconds = static_cast<long>(glance.motion.time);
  if (seconds == seconds_) return;
  seconds_ = seconds;
  print_line(file_, glance);
}

void print_result(std::FILE* file, const Tally& tally, const Plant& plant) {
  const Motion m = motion_of(plant);
  const char* subject = coach_rig::describe(tally.status);
  std::fprintf(file, "status                 %s%s%s\n", mbgen::text(tally.status.code), *subject == 0 ? "" : ": ",
               subject);
  std::fprintf(file, "at the end             t %.3f s, along %.2f m, left %.3f m, %.2f m/s\n", m.time, m.x, m.y,
               m.forward_speed);
  coach_rig::ClosureResidual residual;
  if (coach_rig::closure_residual(plant.parameters, plant.inputs, plant.state, residual).ok()) {
    std::fprintf(file, "loops closed to        %.1e m\n", residual.largest_position);
  }
  print_times(file, "wake-up latency", tally.wakeup);
  print_times(file, "step time", tally.work);
  const std::pair<const char*, long> rows[] = {{"cycles", tally.cycles},
                                               {"overruns", tally.overruns},
                                               {"missed periods", tally.missed},
                                               {"motions not sent", tally.unsent},
                                               {"messages dropped", tally.unsaid}};
  for (const auto& [name, value] : rows) std::fprintf(file, "%-22s %ld\n", name, value);
  print_counts(file, tally.link.counts, "packets %-14s %ld", "\n");
}

}  // namespace hil_rig
