#include "workbench/manoeuvre/manoeuvre_run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "compiler/text/user_error.hpp"
#include "workbench/describe/notes.hpp"
#include "workbench/host/assignments.hpp"
#include "workbench/manoeuvre/learning.hpp"

namespace mbgen {
namespace {

constexpr double kUnlimited = 1e15;
constexpr double kSameStep = 1e-6;      // of a step: tolerance for the end of a plan
constexpr double kEngineBraking = 0.3;  // m/s^2, largest deceleration by the drive without brakes

/// Completed fraction of a change.
double done(double t, double at, double over) { return smooth_step((t - at) / over).value; }

/// Sets the course of an input, and its derivatives on the inputs of the derivatives.
void follow(const std::vector<Input>& model_inputs, int input, Course course, InputsOverTime& inputs) {
  while (input >= 0) {
    const auto i = static_cast<std::size_t>(input);
    inputs.courses[i] = course;
    course = derivative(course);
    input = model_inputs[i].derivative;
  }
}

void follow_line(int input, double t, double end, double from, double to, InputsOverTime& inputs) {
  if (input >= 0) inputs.courses[static_cast<std::size_t>(input)] = straight_lines({t, end}, {from, to});
}

/// Hermite polynomial between two rates; it matches accelerations too where the model has an input for them.
Course between(const std::vector<Input>& model_inputs, int input, double t, double end, const Rates& from,
               const Rates& to) {
  std::vector<std::vector<double>> orders = {{from.value, to.value}, {from.rate, to.rate}};
  const int rate = model_inputs[static_cast<std::size_t>(input)].derivative;
  if (rate >= 0 && model_inputs[static_cast<std::size_t>(rate)].derivative >= 0)
    orders.push_back({from.acceleration, to.acceleration});
  return hermite({t, end}, orders);
}

/// Rates after a time with a constant second derivative.
Rates advanced(const Rates& from, double acceleration, double time) {
  return {from.value + time * (from.rate + time * acceleration / 2), from.rate + time * acceleration, acceleration};
}

}  // namespace

ManoeuvreRun::ManoeuvreRun(const Model& model, const Manoeuvre& manoeuvre, const std::string& file)
    : vehicle_(*model.vehicle),
      manoeuvre_(manoeuvre),
      file_(file),
      inputs_(model.inputs),
      facts_(vehicle_facts(model)),
      plan_(plan_of(manoeuvre, model, facts_, file)),
      first_output_(first_vehicle_output(model)),
      lifted_(model.tyres.size(), -1.0) {
  series_.wheels = facts_.wheels;
  if (vehicle_.towed.body >= 0) reading_.towed.emplace();
}

void ManoeuvreRun::complete(SimulationArguments& arguments, double step_of_model) const {
  if (!arguments.input_table.empty())
    throw UserError("--input-table: a manoeuvre moves the inputs; leave out one of the two\n");
  if (arguments.integrator.starts_with("cvode"))
    throw UserError(
        fmt::format("--integrator: driver and speed controller act every {:g} s, where {} would start "
                    "anew: take rk4 or rosenbrock for a manoeuvre\n",
                    base_of(manoeuvre_).period, arguments.integrator));
  const std::string length_of = arguments.duration ? "--duration" : fmt::format("{}: /{}", file_, plan_.length_of);
  if (!arguments.duration) arguments.duration = plan_.duration;
  if (!arguments.step) arguments.step = base_of(manoeuvre_).step;
  constexpr double kMostSteps = 1e7;  // metrics hold all of them in memory: 1.5 GB
  const double step = arguments.step.value_or(step_of_model), steps = *arguments.duration / step;
  if (!(steps >= 1 - kSameStep))
    throw UserError(fmt::format("{}: the manoeuvre takes {:.4g} s, less than a step of {:g} s\n", length_of,
                                *arguments.duration, step));
  if (steps > kMostSteps)
    throw UserError(
        fmt::format("{}: the manoeuvre takes {:.4g} s, {:.2g} steps of {:g} s; at most {:g} are driven\n  hint: give "
                    "\"duration\", or a longer step\n",
                    length_of, *arguments.duration, steps, step, kMostSteps));
}

void ManoeuvreRun::look_at_steering(const Compilation& compilation, const GenericState& start,
                                    const std::vector<double>& inputs) {
  const std::optional<double> slope = steering_slope(compilation, start, inputs);
  if (!slope || *slope * vehicle_.steer_ratio > 0) return;
  steering_fault_ = fmt::format(
      "\"steer_ratio\" of the vehicle is {:g}, but a positive value at its steering input turns the wheels to the {}: "
      "its "
      "sign is wrong",
      vehicle_.steer_ratio, *slope > 0 ? "left" : "right");
}

InputControl ManoeuvreRun::control(double step) {
  every_ = std::max(1L, std::lround(base_of(manoeuvre_).period / step));
  period_ = static_cast<double>(every_) * step;
  return [this](const Sample& sample, InputsOverTime& inputs) { return take(sample, inputs); };
}

bool ManoeuvreRun::take(const Sample& sample, InputsOverTime& inputs) {
  const double t = sample.state.t, end = t + period_;
  reading_ = vehicle_reading(sample, first_output_, reading_);
  if (sample.step == 0) start(inputs);
  observe(t);
  append(series_, t, reading_, vehicle_.steer < 0 ? 0 : inputs.courses[static_cast<std::size_t>(vehicle_.steer)].at(t));
  if (sample.step % every_ != 0) return true;
  if (sample.step > 0) ended_ = reason_to_end();
  if (!ended_.empty()) return false;
  if (vehicle_.steer >= 0) steer(t, end, inputs);
  drive(t, end, inputs);
  move_others(t, end, inputs);
  inputs.rows = {end};
  return true;
}

void ManoeuvreRun::start(const InputsOverTime& inputs) {
  constexpr double kSameSpeed = 0.02, kStands = 0.01;  // of the speed; m/s
  const std::optional<double>& speed = base_of(manoeuvre_).speed;
  start_ = reading_.plane;
  if (speed && std::abs(start_.forward - *speed) > std::max(kStands, kSameSpeed * *speed)) {
    throw UserError(fmt::format(
        "{}: /speed: the vehicle starts at {:.4g} m/s instead of {:.4g} m/s\n  hint: name the parameter that sets its "
        "speed at the start as \"speed\" in the model's section \"vehicle\"\n",
        file_, start_.forward, *speed));
  }
  if (plan_.has_driver || plan_.is_straight) path_ = placed(plan_.path, start_.x, start_.y, start_.heading);
  for (const Course& course : inputs.courses) first_values_.push_back(course.at(0));
  const auto first = [&](int input) { return input < 0 ? 0 : first_values_[static_cast<std::size_t>(input)]; };
  hand_.value = first(vehicle_.steer);
  drive_ = first(vehicle_.drive);
  brake_ = first(vehicle_.brake);
}

void ManoeuvreRun::observe(double t) {
  for (std::size_t i = 0; i < reading_.loads.size(); ++i)
    if (lifted_[i] < 0 && reading_.loads[i] <= 0) lifted_[i] = t;
  std::optional<CoursePlace> place;
  if (plan_.has_driver || plan_.is_straight) place = place_ = find_place(path_, reading_.plane, place_.way);
  if (plan_.has_driver) largest_offset_ = std::max(largest_offset_, std::abs(place_.offset));
  watch_.add(t, reading_.plane, place, widest_offset(), place ? path_.at(place_.way).heading : 0);
  if (plan_.torques[phase_].holds_speed)
    largest_speed_error_ =
        std::max(largest_speed_error_, std::abs(reading_.plane.forward - wanted_speed(plan_, t, place_.way)));
  if (plan_.track && place_.way > std::min(plan_.last_way, static_cast<double>(laps_.size() + 1) * plan_.track->length))
    laps_.push_back(t);
}

std::string ManoeuvreRun::reason_to_end() const {
  const PlaneMotion& motion = reading_.plane;
  if (plan_.has_driver && place_.way > plan_.last_way) return "the track is passed";
  if (motion.forward > plan_.above_speed) return fmt::format("the speed is above {:g} m/s", plan_.above_speed);
  if (motion.speed() < plan_.last_speed) return fmt::format("the speed is below {:g} m/s", plan_.last_speed);
  if (std::abs(motion.lateral_acceleration) > plan_.largest_lateral_acceleration)
    return fmt::format("the lateral acceleration is above {:g} m/s^2", plan_.largest_lateral_acceleration);
  return "";
}

void ManoeuvreRun::steer(double t, double end, InputsOverTime& inputs) {
  if (!plan_.has_driver)
    return follow(inputs_, vehicle_.steer,
                  between(inputs_, vehicle_.steer, t, end, plan_.steer.at(t), plan_.steer.at(end)), inputs);
  const DriverSettings& driver = base_of(manoeuvre_).driver;
  const double wanted = vehicle_.steer_ratio * steering_target(path_, place_, reading_.plane, driver, facts_.wheelbase);
  const HandLimits limits{vehicle_.steer_limit.value_or(kUnlimited),
                          std::abs(vehicle_.steer_ratio) * driver.largest_rate};
  const double acceleration = hand_acceleration(hand_, wanted, driver.lag, end - t, limits);
  const Rates next = advanced(hand_, acceleration, end - t);
  follow(inputs_, vehicle_.steer,
         between(inputs_, vehicle_.steer, t, end, {hand_.value, hand_.rate, acceleration}, next), inputs);
  hand_ = next;
}

void ManoeuvreRun::drive(double t, double end, InputsOverTime& inputs) {
  if (plan_.free_way && place_.way > *plan_.free_way) {
    constexpr double kRelease = 0.2;  // s
    plan_.torques.push_back({.at = t, .over = kRelease});
    plan_.free_way.reset();
  }
  constexpr double kRounding = 1e-9;  // s
  while (phase_ + 1 < plan_.torques.size() && plan_.torques[phase_ + 1].at <= t + kRounding) {
    ++phase_;
    phase_drive_ = drive_;
    phase_brake_ = brake_;
  }
  const TorquePhase& phase = plan_.torques[phase_];
  double drive = phase_drive_ + (phase.drive - phase_drive_) * done(end, phase.at, phase.over);
  double brake = phase_brake_ + (phase.brake - phase_brake_) * done(end, phase.at, phase.over);
  if (phase.holds_speed) {
    const double torque = facts_.mass * facts_.radius;  // N m for 1 m/s^2
    const double most = vehicle_.drive_limit.value_or(kUnlimited) / torque;
    const bool has_brake = vehicle_.brake >= 0;
    const double by_drive = has_brake ? std::min(most, kEngineBraking) : most;
    const double least = -by_drive - (has_brake ? vehicle_.brake_limit.value_or(kUnlimited) / torque : 0);
    const double held = wanted_speed(plan_, end, place_.way + (end - t) * reading_.plane.forward);
    const double along = plan_.track ? (held - wanted_speed(plan_, t, place_.way)) / (end - t) : 0;  // of the profile
    const double wanted =
        along + speed_controller_.acceleration(base_of(manoeuvre_).speed_control, held, reading_.plane.forward, end - t,
                                               least - along, most - along);
    drive = torque * std::max(wanted, -by_drive);
    brake = torque * std::max(0.0, -wanted - by_drive);
  }
  follow_line(vehicle_.drive, t, end, drive_, drive, inputs);
  follow_line(vehicle_.brake, t, end, brake_, brake, inputs);
  drive_ = drive;
  brake_ = brake;
}

void ManoeuvreRun::move_others(double t, double end, InputsOverTime& inputs) const {
  const auto value = [&](int input, double at) {
    double result = first_values_[static_cast<std::size_t>(input)];
    for (const InputChange& change : plan_.others)
      if (change.input == input) result += (change.value - result) * done(at, change.at, change.over);
    return result;
  };
  for (const InputChange& change : plan_.others)
    follow(inputs_, change.input, straight_lines({t, end}, {value(change.input, t), value(change.input, end)}), inputs);
}

std::optional<VariedParameter> start_speed(const Manoeuvre& manoeuvre, const Model& model) {
  vehicle_facts(model);
  const std::optional<double>& speed = base_of(manoeuvre).speed;
  if (!speed || model.vehicle->speed < 0) return {};
  const Parameter& parameter = model.parameters[static_cast<std::size_t>(model.vehicle->speed)];
  return VariedParameter{parameter.name, *speed, parameter.tunable};
}

void require_others_inputs(const Model& model, const std::string& option, const std::vector<std::string>& inputs,
                           const std::string& owner) {
  for (const std::string& assignment : inputs) {
    const std::string name = assignment.substr(0, assignment.find('='));
    for (const int own : {model.vehicle->steer, model.vehicle->drive, model.vehicle->brake}) {
      if (own < 0 || model.inputs[static_cast<std::size_t>(own)].name != name) continue;
      throw UserError(fmt::format("{} {}: {} this input itself\n  hint: leave out {}\n", option, name, owner, option));
    }
  }
}

void prepare_model(Model& model, const Manoeuvre& manoeuvre) {
  vehicle_facts(model);
  add_vehicle_outputs(model);
  const auto* start = std::get_if<StartManoeuvre>(&manoeuvre);
  if (start && start->brake > 0 && model.vehicle->brake >= 0)
    model.inputs[static_cast<std::size_t>(model.vehicle->brake)].default_value = start->brake;
}

std::shared_ptr<ManoeuvreRun> run_of(const Manoeuvre& manoeuvre, const std::string& file, const Model& model,
                                     SimulationArguments& arguments) {
  Manoeuvre known = manoeuvre;
  Model seen = model;
  if (DriverSettings& driver = base_of(known).driver; driver.learns) {
    const LearnedVehicle learned = learn_vehicle(model, file);
    driver.understeer = learned.understeer;
    seen.vehicle->steer_ratio = learned.steer_ratio;
  }
  const auto run = std::make_shared<ManoeuvreRun>(seen, known, file);
  const bool is_planned = !arguments.duration;
  run->complete(arguments, model.solver.step);
  const double step = arguments.step.value_or(model.solver.step);
  // The plan is a whole number of steps long, so that times of rows are multiples of the step.
  if (is_planned && step > 0) arguments.duration = std::ceil(*arguments.duration / step - kSameStep) * step;
  return run;
}

std::shared_ptr<ManoeuvreRun> prepare_manoeuvre(const std::string& file, const std::string& model_file,
                                                std::vector<std::string>& assignments, Model& model,
                                                SimulationArguments& arguments) {
  if (file.empty()) return nullptr;
  const Manoeuvre manoeuvre = expect(read_manoeuvre_file(file));
  print_notes(base_of(manoeuvre).notes);
  if (const std::optional<VariedParameter> speed = start_speed(manoeuvre, model)) {
    assignments.push_back(fmt::format("{}={}", speed->name, *speed->value));
    model = read_set_model(model_file, assignments);
  }
  prepare_model(model, manoeuvre);
  return run_of(manoeuvre, file, model, arguments);
}

}  // namespace mbgen
