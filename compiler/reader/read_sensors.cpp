// Sensors, delays and named values: put together from sampled values and expressions.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <string>
#include <vector>

#include "compiler/reader/formula.hpp"
#include "compiler/reader/presentation.hpp"
#include "compiler/reader/raw.hpp"
#include "compiler/reader/read_states.hpp"
#include "compiler/reader/reader.hpp"
#include "compiler/text/hash.hpp"

namespace mbgen::reading {
namespace {

constexpr double kMostInstants = 1000;  ///< of a delay; each is an auxiliary state
constexpr double kLargestSeed = 1e9;

/// Suffixes of the sampled values of a sensor, in their order; its own comes last.
std::vector<std::string> parts_of_sensor(const Value& value) {
  std::vector<std::string> parts = {"_raw"};
  if (find(value, "filter")) parts.push_back("_filtered");
  if (find(value, "noise")) parts.insert(parts.end(), {"_seed_a", "_seed_b", "_seed_c"});
  parts.push_back("");
  return parts;
}

/// Suffixes of the sampled values of a delay: the instant, and four stored values, the latest one last.
const std::vector<std::string> kPartsOfDelay = {"_instant", "_stored_4", "_stored_3", "_stored_2", "_stored_1"};

int place_of_value(const Reader& reader, const std::string& written) {
  const auto found = find_visible(reader.names.values, written, current_scope(reader).visible);
  return found == reader.names.values.end() ? 0 : found->second;
}

/// Adds sampled values to the model, one after the other.
class SampledParts {
 public:
  SampledParts(Reader& reader, const Entry& entry, double period) : reader_(reader), entry_(entry), period_(period) {}

  /// The sampled value with this suffix as others see it.
  Formula part(const std::string& suffix) const {
    return state_formula(place_of_value(reader_, entry_.written + suffix));
  }

  SampledValue& add(const std::string& suffix, Quantity value, double initial, const std::string& unit) {
    SampledValue sampled;
    sampled.name = full_name(current_scope(reader_).visible.front(), entry_.written + suffix);
    sampled.where = where_of(reader_.documents, entry_.place);
    sampled.period = period_;
    sampled.value = value;
    sampled.initial = initial;
    sampled.unit = unit;
    reader_.model.sampled.push_back(std::move(sampled));
    return reader_.model.sampled.back();
  }

  /// text: of the formula, for people.
  SampledValue& add(const std::string& suffix, const Formula& formula, std::string text, double initial,
                    const std::string& unit) {
    return add(suffix, quantity(formula, std::move(text)), initial, unit);
  }

  Quantity quantity(const Formula& formula, std::string text) const {
    Quantity value;
    value.expression = static_cast<int>(reader_.model.expressions.size());
    reader_.model.expressions.push_back({std::move(text), formula.nodes});
    return value;
  }

 private:
  Reader& reader_;
  const Entry& entry_;
  double period_;
};

/// Number of periods in a delay, with a problem if it is not whole.
int instants_of(Reader& reader, const Value& value, double delay, double period, int least) {
  if (std::isnan(delay) || std::isnan(period) || period <= 0) return least;
  const double count = std::nearbyint(delay / period);
  const bool is_whole = std::abs(delay / period - count) < 1e-6;
  if (!is_whole || count < least)
    report(
        reader, member_or_object(value, "delay"),
        fmt::format("must be {}whole periods of {:g} s, got {:g} s", least > 1 ? "at least two " : "", period, delay),
        fmt::format("{:g} s, or another \"period\"", std::max(count, least + 0.0) * period));
  if (count > kMostInstants)
    report(reader, member_or_object(value, "delay"), fmt::format("is {:g} periods, {:g} at most", count, kMostInstants),
           "a longer \"period\"");
  return static_cast<int>(std::clamp(count, least + 0.0, kMostInstants));
}

/// The three generators of noise: B. A. Wichmann and I. D. Hill, Algorithm AS 183, Applied Statistics 31 (1982)
/// 188-190. Their products are exact in single precision.
struct Generator {
  const char* suffix;
  double factor, modulus;
};
constexpr Generator kGenerators[] = {{"_seed_a", 171, 30269}, {"_seed_b", 172, 30307}, {"_seed_c", 170, 30323}};

/// The next number of a generator.
Formula next(const Generator& generator, const Formula& x) {
  const Formula product = Formula(generator.factor) * x;
  return product - Formula(generator.modulus) * floor(product / Formula(generator.modulus));
}

/// Start of a generator, from 1 to its modulus - 1, from seed, name and generator.
double first_of(const Generator& generator, double seed, const std::string& name) {
  Hash hash;
  hash.add_bytes(fmt::format("{} {} {}", seed, name, generator.suffix));
  const std::uint64_t mixed = hash.value() ^ (hash.value() >> 32);
  return 1 + static_cast<double>(mixed % static_cast<std::uint64_t>(generator.modulus - 1));
}

/// A number between 0 and 1 from the three generators.
Formula between_zero_and_one(const std::vector<Formula>& x) {
  Formula sum = x[0] / Formula(kGenerators[0].modulus);
  for (std::size_t i = 1; i < x.size(); ++i) sum = sum + x[i] / Formula(kGenerators[i].modulus);
  return sum - floor(sum);
}

/// A number of the normal distribution with deviation 1. Source: G. E. P. Box and M. E. Muller, Annals of Mathematical
/// Statistics 29 (1958) 610-611.
Formula normal_number(const SampledParts& parts) {
  std::vector<Formula> now, after;
  for (const Generator& generator : kGenerators) {
    now.push_back(parts.part(generator.suffix));
    after.push_back(next(generator, now.back()));
  }
  constexpr double kLeast = 1e-9;
  return sqrt(Formula(-2.0) * log(max(between_zero_and_one(now), Formula(kLeast)))) *
         cos(Formula(2 * std::numbers::pi) * between_zero_and_one(after));
}

void read_sensor(Reader& reader, const Entry& entry, const SensorFields& sensor) {
  const Value& value = *entry.value;
  SampledParts parts(reader, entry, sensor.period);
  Quantity raw;
  if (sensor.written) read_value(reader, *sensor.written, {.name = "value", .sees_accelerations = true}, raw);
  parts.add("_raw", raw, sensor.initial, sensor.unit);
  const auto number = [&](const Quantity& q) { return formula_of(reader.model, q); };
  Formula shown = parts.part("_raw");
  if (sensor.filter) {  // of a value that holds between measurements, exact
    const Formula before = parts.part("_filtered");
    const Formula kept = exp(Formula(-2 * std::numbers::pi * sensor.period) * number(*sensor.filter));
    parts.add("_filtered", shown + kept * (before - shown), entry.written + "_raw, filtered", sensor.initial,
              sensor.unit);
    shown = before;
  }
  shown = number(sensor.gain) * shown + number(sensor.bias);
  if (find(value, "noise")) {
    if (!std::isnan(sensor.seed) && (sensor.seed != std::nearbyint(sensor.seed) || sensor.seed > kLargestSeed))
      report(reader, member_or_object(value, "seed"),
             fmt::format("must be a whole number up to {:g}, got {}", kLargestSeed, sensor.seed));
    for (const Generator& generator : kGenerators) {
      const Formula twice = next(generator, next(generator, parts.part(generator.suffix)));
      parts.add(generator.suffix, twice, "the next random number", first_of(generator, sensor.seed, entry.name), "1");
    }
    shown = shown + number(sensor.noise) * normal_number(parts);
  }
  if (sensor.least) shown = max(shown, number(*sensor.least));
  if (sensor.most) shown = min(shown, number(*sensor.most));
  if (sensor.least && sensor.most && sensor.least->expression < 0 && sensor.most->expression < 0 &&
      sensor.least->value > sensor.most->value)
    report(reader, *find(value, "least"),
           fmt::format("must be at most \"most\", {:g}, got {:g}", sensor.most->value, sensor.least->value));
  const bool is_stepped = sensor.quantisation.expression >= 0 || sensor.quantisation.value > 0;
  if (is_stepped) {
    const Formula step = number(sensor.quantisation);
    shown = select(-step, shown, step * floor(shown / step + Formula(0.5)));  // a tunable step may be zero
  }
  SampledValue& own =
      parts.add("", shown, "the measured value of " + entry.written + "_raw", sensor.initial, sensor.unit);
  own.delay = instants_of(reader, value, sensor.delay, sensor.period, 0);
  own.shown = sensor;
}

/// Lagrange's polynomial through values at -1, 0, 1 and 2, at a place between 0 and 1.
Formula through_four(const Formula& at, const std::vector<Formula>& values) {
  const Formula a = at + Formula(1.0), b = at, c = at - Formula(1.0), d = at - Formula(2.0);
  return values[0] * (b * c * d) / Formula(-6.0) + values[1] * (a * c * d) / Formula(2.0) -
         values[2] * (a * b * d) / Formula(2.0) + values[3] * (a * b * c) / Formula(6.0);
}

void read_delay(Reader& reader, const Entry& entry, const DelayFields& delay) {
  SampledParts parts(reader, entry, delay.period);
  const int instants = instants_of(reader, *entry.value, delay.delay, delay.period, 2);
  parts.add("_instant", time_formula(), "t", 0, "s");
  std::vector<Formula> stored;
  for (std::size_t i = 1; i < kPartsOfDelay.size(); ++i) stored.push_back(parts.part(kPartsOfDelay[i]));
  // Each takes the value that the next one had so far.
  for (std::size_t i = 1; i < stored.size(); ++i)
    parts.add(kPartsOfDelay[i], stored[i], entry.written + kPartsOfDelay[i + 1], delay.initial, delay.unit);
  Quantity newest;
  if (delay.written) read_value(reader, *delay.written, {.name = "value", .sees_accelerations = true}, newest);
  SampledValue& last = parts.add(kPartsOfDelay.back(), newest, delay.initial, delay.unit);
  last.delay = instants - 2;
  last.shown = delay;
}

/// The delayed value between the instants, as a named value.
void define_delay(Reader& reader, const Entry& entry, const DelayFields& delay) {
  const SampledParts parts(reader, entry, delay.period);
  std::vector<Formula> stored;
  for (std::size_t i = 1; i < kPartsOfDelay.size(); ++i) stored.push_back(parts.part(kPartsOfDelay[i]));
  const Formula place = (time_formula() - parts.part("_instant")) / Formula(delay.period);
  reader.names.named_values.emplace(entry.name, parts.quantity(through_four(place, stored), entry.written).expression);
}

/// Calls use(entry, fields) for every entry, in its scope.
template <class Fields, class Use>
void each_entry(Reader& reader, const Entries& entries, const std::vector<Fields>& fields, const Use& use) {
  for (std::size_t i = 0; i < fields.size(); ++i) {
    const InScope in_scope(reader, entries[i].scope);
    use(entries[i], fields[i]);
  }
}

}  // namespace

void name_sensors(Reader& reader, const Entries& sensors, const Entries& delays) {
  const auto add = [&](const Entry& entry, const std::string& suffix) {
    const std::string name = full_name(current_scope(reader).visible.front(), entry.written + suffix);
    const Names& names = reader.names;
    const bool is_taken = names.parameters.contains(name) || names.inputs.contains(name);
    if (!reader.names.values.emplace(name, static_cast<int>(names.values.size())).second ||
        (is_taken && !suffix.empty()))
      report(reader, entry.place, in_quotes(name) + " is the name of another value, too", "rename one of them");
  };
  for (const Entry& entry : sensors) {
    const InScope in_scope(reader, entry.scope);
    check_value_name(reader, entry);
    for (const std::string& part : parts_of_sensor(*entry.value)) add(entry, part);
  }
  for (const Entry& entry : delays) {
    const InScope in_scope(reader, entry.scope);
    check_value_name(reader, entry);
    for (const std::string& part : kPartsOfDelay) add(entry, part);
  }
}

void read_sensors(Reader& reader, const Entries& values, const Entries& sensors, const Entries& delays) {
  std::vector<SensorFields> measured;
  read_list(reader, sensors, measured, [](Reader& r, const Value& value, SensorFields& sensor) {
    check_presentation(r, value, sensor.unit, sensor, sensor.initial);
  });
  std::vector<DelayFields> delayed;
  read_list(reader, delays, delayed, [](Reader& r, const Value& value, DelayFields& delay) {
    check_presentation(r, value, delay.unit, delay, delay.initial);
  });
  each_entry(reader, delays, delayed, [&](const Entry& e, const DelayFields& f) {
    if (reader.names.values.contains(e.name))
      report(reader, e.place, in_quotes(e.name) + " is the name of another value, too", "rename one of them");
    define_delay(reader, e, f);
  });
  read_named_values(reader, values);
  each_entry(reader, sensors, measured, [&](const Entry& e, const SensorFields& f) { read_sensor(reader, e, f); });
  each_entry(reader, delays, delayed, [&](const Entry& e, const DelayFields& f) { read_delay(reader, e, f); });
}

}  // namespace mbgen::reading
