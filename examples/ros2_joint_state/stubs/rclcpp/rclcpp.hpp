#pragma once
// As much of rclcpp as a node of this example needs, for compiling and running it without ROS: `spin` gives the
// subscription two messages and prints each that the node publishes.
#include <cmath>
#include <cstdio>
#include <functional>
#include <memory>
#include <string>

#include "sensor_msgs/msg/joint_state.hpp"

#define RCLCPP_WARN(logger, ...) (std::printf("warning: "), std::printf(__VA_ARGS__), std::printf("\n"))

namespace rclcpp {

template <class Message>
struct Publisher {
  using SharedPtr = std::shared_ptr<Publisher>;
  void publish(const Message& message) const {
    for (std::size_t i = 0; i < message.name.size(); ++i)
      std::printf("%s %.9f %.9f\n", message.name[i].c_str(), message.position[i], message.velocity[i]);
  }
};

template <class Message>
struct Subscription {
  using SharedPtr = std::shared_ptr<Subscription>;
  std::function<void(const Message&)> take;
};

class Node {
 public:
  explicit Node(const char*) {}
  template <class Message>
  typename Publisher<Message>::SharedPtr create_publisher(const char*, int) {
    return std::make_shared<Publisher<Message>>();
  }
  template <class Message>
  typename Subscription<Message>::SharedPtr create_subscription(const char*, int,
                                                                std::function<void(const Message&)> take) {
    take_ = take;
    return std::make_shared<Subscription<Message>>(Subscription<Message>{take});
  }
  int get_logger() const { return 0; }
  void give(const sensor_msgs::msg::JointState& message) const { take_(message); }

 private:
  std::function<void(const sensor_msgs::msg::JointState&)> take_;
};

inline void init(int, char**) {}
inline void shutdown() {}

inline void spin(const std::shared_ptr<Node>& node) {
  sensor_msgs::msg::JointState motors;
  motors.name = {"ankle_b", "ankle_a"};  // in another order than the solver's
  motors.position = {0.12215774463828834, 0.12215774463828834};
  motors.velocity = {3.6341814903009055, 3.6341814903009055};
  node->give(motors);
  motors.name[0] = "other";
  node->give(motors);
}

}  // namespace rclcpp
