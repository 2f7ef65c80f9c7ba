// The smaller parts of the rig: histogram, queue, servo, driver, recording.

#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <thread>

#include "driver_model.hpp"
#include "histogram.hpp"
#include "recording.hpp"
#include "ring.hpp"
#include "steering.hpp"

namespace hil_rig {
namespace {

std::string printed(const Histogram& one, const Histogram& two) {
  char* text = nullptr;
  std::size_t size = 0;
  std::FILE* file = open_memstream(&text, &size);
  print(file, std::array{&one, &two});
  std::fclose(file);
  std::string result(text, size);
  std::free(text);
  return result;
}

// As cyclictest 2.4 of Debian 12 prints the histogram of two threads.
TEST(Histogram, IsPrintedAsCyclictestPrintsIt) {
  Histogram one, two;
  add(one, 1999, 0);
  add(one, 3000, 1);
  add(one, 1234567, 2);
  add(two, -5, 0);
  const std::string text = printed(one, two);
  const std::string begin =
      "# Histogram\n000000 000000\t000001\n000001 000001\t000000\n000002 000000\t000000\n000003 000001\t000000\n";
  const std::string end =
      "000999 000000\t000000\n# Total: 000000002 000000001\n# Min Latencies: 00001 00000\n# Avg Latencies: 00412 "
      "00000\n"
      "# Max Latencies: 01234 00000\n# Histogram Overflows: 00001 00000\n# Histogram Overflow at cycle number:\n"
      "# Thread 0: 00002\n# Thread 1:\n\n";
  EXPECT_EQ(text.substr(0, begin.size()), begin);
  EXPECT_EQ(text.substr(text.size() - end.size()), end);
}

TEST(Histogram, HasQuantilesAndCountsOverflowsThatItDoesNotKeep) {
  Histogram histogram;
  EXPECT_EQ(smallest(histogram), 0);
  EXPECT_EQ(mean(histogram), 0);
  for (int i = 1; i <= 100; ++i) add(histogram, i * 1000, i);
  EXPECT_EQ(quantile(histogram, 0.5), 50);
  EXPECT_EQ(quantile(histogram, 0.99), 99);
  for (int i = 0; i < 20; ++i) add(histogram, 5000000, i);
  EXPECT_EQ(quantile(histogram, 0.99), Histogram::kBins);
  EXPECT_NE(printed(histogram, histogram).find(" 00015 # 00004 others\n"), std::string::npos);
}

TEST(Ring, GivesAllInOrderAndSaysWhenItIsFull) {
  Ring<int, 4> ring;
  int value = 0;
  EXPECT_FALSE(ring.pop(value));
  for (int i = 0; i < 4; ++i) EXPECT_TRUE(ring.push(i));
  EXPECT_FALSE(ring.push(4));
  for (int i = 0; i < 4; ++i) {
    ASSERT_TRUE(ring.pop(value));
    EXPECT_EQ(value, i);
  }
  EXPECT_FALSE(ring.pop(value));
}

TEST(Ring, LosesNothingBetweenThreads) {
  constexpr long kLast = 20000;
  Ring<long, 64> ring;
  std::thread writer([&] {
    for (long i = 1; i <= kLast;) {
      if (ring.push(i)) {
        ++i;
      } else {
        std::this_thread::yield();
      }
    }
  });
  long wrong = 0;
  for (long i = 1, value = 0; i <= kLast;) {
    if (ring.pop(value)) {
      wrong += value != i++ ? 1 : 0;
    } else {
      std::this_thread::yield();
    }
  }
  writer.join();
  EXPECT_EQ(wrong, 0);
}

TEST(Servo, ReachesItsAngleWithinItsLimitsAndWithoutOvershoot) {
  const Servo servo;
  double angle = 0, rate = 0, largest = 0;
  for (int i = 0; i < 1000; ++i) {
    const double acceleration = servo_acceleration(servo, 0.5, angle, rate, 1e-3);
    EXPECT_LE(std::abs(acceleration), servo.largest_acceleration);
    angle += rate * 1e-3 + acceleration * 5e-7;
    rate += acceleration * 1e-3;
    EXPECT_LE(rate, servo.largest_rate + 1e-12);
    largest = std::max(largest, angle);
  }
  EXPECT_NEAR(angle, 0.5, 1e-6);
  EXPECT_LE(largest, 0.5 + 1e-6);
}

TEST(DriverModel, SteersToTheSideWhereThePathIsAndKeepsTheSpeed) {
  const Driver driver;
  EXPECT_EQ(path(driver, 0), 0);
  EXPECT_NEAR(path(driver, 55), driver.lane_change / 2, 1e-12);
  EXPECT_EQ(path(driver, 100), driver.lane_change);
  EXPECT_EQ(path(driver, 1000), 0);
  Motion motion;
  motion.forward_speed = 20;
  EXPECT_EQ(drive(driver, motion).steering, 0);
  motion.y = -1;
  EXPECT_GT(drive(driver, motion).steering, 0);
  motion.y = 0;
  motion.yaw = 0.1;
  EXPECT_LT(drive(driver, motion).steering, 0);
  motion.forward_speed = 21;
  EXPECT_EQ(drive(driver, motion).drive_torque, 640 - 8000);
}

TEST(Recording, RunsStraightBetweenItsRows) {
  const std::vector<RecordedCommand> rows = {{1, {0, 100}}, {2, {0.2, 300}}};
  EXPECT_EQ(recorded_command(rows, 0).drive_torque, 100);
  EXPECT_EQ(recorded_command(rows, 1.25).drive_torque, 150);
  EXPECT_NEAR(recorded_command(rows, 1.5).steering, 0.1, 1e-15);
  EXPECT_EQ(recorded_command(rows, 9).drive_torque, 300);
}

TEST(Recording, TheCommittedOneIsWholeAndSteersBothWays) {
  const auto rows = read_recording(std::string(HIL_RIG_DIR) + "/recording.csv");
  EXPECT_GT(rows.back().time, 9.5);
  const auto [least, most] = std::minmax_element(
      rows.begin(), rows.end(), [](const auto& a, const auto& b) { return a.command.steering < b.command.steering; });
  EXPECT_LT(least->command.steering, -0.05);
  EXPECT_GT(most->command.steering, 0.05);
}

TEST(Recording, SaysWhichRowIsWrong) {
  const std::string name = testing::TempDir() + "hil_rig_recording.csv";
  std::ofstream(name) << "t,steering,drive_torque\n0,0,0\n0,1,2\n";
  try {
    read_recording(name);
    FAIL() << "two rows of one time were taken";
  } catch (const std::runtime_error& error) {
    EXPECT_NE(std::string(error.what()).find("row 2: '0,1,2'"), std::string::npos) << error.what();
  }
  std::remove(name.c_str());
}

}  // namespace
}  // namespace hil_rig
