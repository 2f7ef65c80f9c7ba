// Packets: the layout that docs/use/hil_rig.md gives, and what is not taken for one.

#include "packet.hpp"

#include <gtest/gtest.h>

#include <cstring>
#include <string>

namespace hil_rig {
namespace {

TEST(Packet, ChecksumIsThatOfTheCatalogues) {
  const std::string digits = "123456789";  // the check value of CRC-32/ISO-HDLC
  EXPECT_EQ(checksum(reinterpret_cast<const std::uint8_t*>(digits.data()), digits.size()), 0xcbf43926u);
  EXPECT_EQ(checksum(nullptr, 0), 0u);
}

TEST(Packet, CommandHasItsBytesWhereTheTableSays) {
  Packet packet;
  ASSERT_EQ(encode({Type::command, 0x01020304, 0x0a0b0c0d, 0x1122334455667788, 0, 0}, Command{-2.0, 1.0}, packet), 52u);
  const unsigned char expected[] = {'M',  'B',  'R',  'G',  1,    0,    1,    0,    4, 3, 2, 1, 0x0d, 0x0c, 0x0b, 0x0a,
                                    0x88, 0x77, 0x66, 0x55, 0x44, 0x33, 0x22, 0x11, 0, 0, 0, 0, 0,    0,    0,    0,
                                    0,    0,    0,    0,    0,    0,    0,    0xc0, 0, 0, 0, 0, 0,    0,    0xf0, 0x3f};
  EXPECT_EQ(std::memcmp(packet.data(), expected, sizeof expected), 0);
}

TEST(Packet, ComesBackAsItWas) {
  Motion motion;
  motion.time = 1.5;
  motion.lateral_acceleration = -0.0;
  motion.steering_torque = 1e300;
  motion.loads[0] = 1, motion.loads[1] = 2, motion.loads[2] = 3, motion.loads[3] = 4;
  const Header header = {Type::motion, 7, 0xffffffff, -5, 3, kLast | kFailed};
  Packet packet;
  const std::size_t size = encode(header, motion, packet);
  ASSERT_EQ(size, kMotionBytes);
  const auto opened = open(packet.data(), size);
  ASSERT_TRUE(opened);
  EXPECT_EQ(opened->type, Type::motion);
  EXPECT_EQ(opened->session, 7u);
  EXPECT_EQ(opened->sequence, 0xffffffffu);
  EXPECT_EQ(opened->time, -5);
  EXPECT_EQ(opened->subject, 3u);
  EXPECT_EQ(opened->flags, kLast | kFailed);
  const Motion back = payload_of<Motion>(packet.data());
  EXPECT_EQ(std::memcmp(&back, &motion, sizeof motion), 0);
}

TEST(Packet, NoSingleBitAndNoOtherSizeIsTaken) {
  Packet packet{};
  const std::size_t size = encode({Type::setting, 1, 2, 3, 4, 5}, Setting{6.0}, packet);
  for (std::size_t bit = 0; bit < 8 * size; ++bit) {
    Packet broken = packet;
    broken[bit / 8] ^= static_cast<std::uint8_t>(1u << (bit % 8));
    EXPECT_FALSE(open(broken.data(), size)) << "bit " << bit;
  }
  for (std::size_t other = 0; other <= packet.size(); ++other) {
    EXPECT_EQ(open(packet.data(), other).has_value(), other == size) << other << " bytes";
  }
}

// Whole by its checksum, but of a version, a type or a size that there is not.
TEST(Packet, OthersVersionsTypesAndSizesAreNotTaken) {
  const auto resealed = [](std::size_t place, std::uint8_t value, std::size_t size) {
    Packet packet{};
    encode({Type::command, 1, 2, 3, 0, 0}, Command{}, packet);
    packet[place] = value;
    packet_detail::put(packet.data() + size - kChecksumBytes, checksum(packet.data(), size - kChecksumBytes));
    return open(packet.data(), size).has_value();
  };
  EXPECT_TRUE(resealed(4, 1, kCommandBytes));
  EXPECT_FALSE(resealed(4, 2, kCommandBytes));
  EXPECT_FALSE(resealed(6, 9, kCommandBytes));
  EXPECT_FALSE(resealed(6, 3, kCommandBytes));
  EXPECT_FALSE(resealed(4, 1, kCommandBytes + 8));
  EXPECT_FALSE(resealed(0, 'm', kCommandBytes));
}

}  // namespace
}  // namespace hil_rig
