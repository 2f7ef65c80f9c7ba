#pragma once
// Execution of a manoeuvre: control of the inputs from point to point of a motion, and its result.

#include <memory>
#include <string>
#include <vector>

#include "workbench/manoeuvre/course_watch.hpp"
#include "workbench/manoeuvre/plan.hpp"
#include "workbench/motion/simulation_arguments.hpp"
#include "workbench/motion/simulation_text.hpp"

namespace mbgen {

/// Controls one motion; several motions need several runs.
class ManoeuvreRun {
 public:
  /// model: with the outputs of the vehicle. file: of the manoeuvre.
  ManoeuvreRun(const Model& model, const Manoeuvre& manoeuvre, const std::string& file);

  /// Sets the plan's length and the manoeuvre's step unless the command line sets others. Fails: UserError for options
  /// that a manoeuvre excludes.
  void complete(SimulationArguments& arguments, double step_of_model) const;

  /// Checks the sign of the vehicle's steer_ratio against the turn of the road wheels, at a start with these inputs.
  void look_at_steering(const Compilation& compilation, const GenericState& start, const std::vector<double>& inputs);

  /// Control of the inputs of a motion with this step, s; the run must outlive it. Its calls fail: UserError if the
  /// vehicle does not start at the manoeuvre's speed.
  InputControl control(double step);

  /// Adds deviations of the motion from the manoeuvre.
  void judge(StepVerdict& verdict) const;
  /// Result of the manoeuvre, after the motion.
  ManoeuvreWords words() const;
  /// Its numbers, SI: largest deviations from course and speed, then the metrics of the standard.
  std::vector<VehicleMetric> numbers() const;

 private:
  /// Adds a point of the motion. Result: false at the end of the manoeuvre.
  bool take(const Sample& sample, InputsOverTime& inputs);
  void start(const InputsOverTime& inputs);
  void observe(double t);
  std::string reason_to_end() const;
  VehicleMetrics metrics() const;
  /// Lateral offset from the course, m, at which the vehicle has left it.
  double widest_offset() const;
  void steer(double t, double end, InputsOverTime& inputs);
  void drive(double t, double end, InputsOverTime& inputs);
  void move_others(double t, double end, InputsOverTime& inputs) const;

  Vehicle vehicle_;
  Manoeuvre manoeuvre_;
  std::string file_;
  std::vector<Input> inputs_;
  VehicleFacts facts_;
  Plan plan_;
  Path path_;  ///< of the driver, in the world
  std::size_t first_output_;
  PlaneMotion start_;
  std::vector<double> first_values_;  ///< of the inputs
  long every_ = 1;                    ///< steps from one instant of control to the next
  double period_ = 0;                 ///< s, the same
  VehicleReading reading_;            ///< of the last point
  CoursePlace place_;
  Rates hand_;  ///< rad at the input
  SpeedController speed_controller_;
  std::size_t phase_ = 0;                     ///< of torques
  double drive_ = 0, brake_ = 0;              ///< N m, at the end of the last period
  double phase_drive_ = 0, phase_brake_ = 0;  ///< N m, when the phase began
  VehicleSeries series_;
  double largest_offset_ = 0, largest_speed_error_ = 0;  ///< m, m/s
  std::vector<double> lifted_;                           ///< s, per wheel, of its first lift-off; negative: never
  CourseWatch watch_;
  std::vector<double> laps_;    ///< s, the end of each lap of a track
  std::string steering_fault_;  ///< fault of steer_ratio
  std::string ended_;           ///< why before its time
};

/// The parameter that sets the vehicle's speed at the start, with its value; nothing where the manoeuvre has no speed
/// or the model no parameter for it. Fails: UserError for a model without a vehicle.
std::optional<VariedParameter> start_speed(const Manoeuvre& manoeuvre, const Model& model);

/// Fails: UserError for an input that the manoeuvre moves itself: steering, drive, brake. option: it was given by,
/// "--input"; inputs: names or name=value; owner: of the inputs, for messages.
void require_others_inputs(const Model& model, const std::string& option, const std::vector<std::string>& inputs,
                           const std::string& owner = "the manoeuvre moves");

/// Adds the outputs of the vehicle to a model, and lets it start with the brake that the manoeuvre begins with. Fails:
/// UserError without a vehicle, or for an output of the same name.
void prepare_model(Model& model, const Manoeuvre& manoeuvre);

/// A run of a manoeuvre with a model, which has the outputs of the vehicle. Completes the arguments: the duration is a
/// whole number of steps. Fails: UserError.
std::shared_ptr<ManoeuvreRun> run_of(const Manoeuvre& manoeuvre, const std::string& file, const Model& model,
                                     SimulationArguments& arguments);

/// A run of the manoeuvre of a file with a model. Sets the speed at the start (also in `assignments`, --set) and adds
/// the outputs of the vehicle. Null without a file. Fails: UserError.
std::shared_ptr<ManoeuvreRun> prepare_manoeuvre(const std::string& file, const std::string& model_file,
                                                std::vector<std::string>& assignments, Model& model,
                                                SimulationArguments& arguments);

}  // namespace mbgen
