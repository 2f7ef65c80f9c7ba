#pragma once
// The fields of sensor_msgs/JointState, for compiling without ROS.
#include <string>
#include <vector>

namespace sensor_msgs::msg {

struct Time {
  int sec = 0;
  unsigned nanosec = 0;
};

struct Header {
  Time stamp;
  std::string frame_id;
};

struct JointState {
  Header header;
  std::vector<std::string> name;
  std::vector<double> position, velocity, effort;
};

}  // namespace sensor_msgs::msg
