// A node that knows the motors of a parallel ankle and publishes all its joints: `motor_states` in, `joint_states` out.

#include <memory>
#include <rclcpp/rclcpp.hpp>
#include <sensor_msgs/msg/joint_state.hpp>

#include "joint_state.hpp"
#include "parallel_ankle.hpp"

using sensor_msgs::msg::JointState;

class Ankle : public rclcpp::Node {
 public:
  Ankle() : Node("parallel_ankle") {
    mbgen_ros2::set_names(parallel_ankle::kCoordinateNames, message_);
    publisher_ = create_publisher<JointState>("joint_states", 10);
    subscription_ =
        create_subscription<JointState>("motor_states", 10, [this](const JointState& motors) { take(motors); });
  }

 private:
  void take(const JointState& motors) {
    double position[parallel_ankle::kActuators], speed[parallel_ankle::kActuators];
    if (const char* missing = mbgen_ros2::read_positions(motors, parallel_ankle::kActuatorNames, position, speed)) {
      RCLCPP_WARN(get_logger(), "motor_states lacks %s", missing);
      return;
    }
    // The state is the last pose: the ankle stays on its branch.
    const mbgen::Status status = parallel_ankle::complete_joints(parameters_, {}, position, speed, state_);
    if (!status.ok()) {
      RCLCPP_WARN(get_logger(), "%s: %s", mbgen::text(status.code), parallel_ankle::describe(status));
      return;
    }
    mbgen_ros2::write_state(state_, message_);
    message_.header.stamp = motors.header.stamp;
    publisher_->publish(message_);
  }

  const parallel_ankle::Tuned parameters_ = parallel_ankle::Parameters();
  parallel_ankle::State state_ = parallel_ankle::initial_state();
  JointState message_;
  rclcpp::Publisher<JointState>::SharedPtr publisher_;
  rclcpp::Subscription<JointState>::SharedPtr subscription_;
};

int main(int argc, char** argv) {
  rclcpp::init(argc, argv);
  rclcpp::spin(std::make_shared<Ankle>());
  rclcpp::shutdown();
}
