#pragma once
// Packets on the network: fixed layouts, little-endian on every machine, with a checksum at the end. Pure functions
// over bytes; docs/use/hil_rig.md has the same as a table.

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <optional>

namespace hil_rig {

constexpr std::uint32_t kMagic = 0x4752424d;  // the bytes "MBRG"
constexpr std::uint16_t kVersion = 1;

enum class Type : std::uint16_t { command = 1, motion = 2, setting = 3, answer = 4 };

/// Start of every packet.
struct Header {
  Type type = Type::command;
  std::uint32_t session = 0;   ///< chosen by the sender when it starts
  std::uint32_t sequence = 0;  ///< counts the sender's packets, modulo 2^32
  std::int64_t time = 0;       ///< ns on the plant's clock; in a command: that of the motion it answers
  std::uint32_t subject = 0;   ///< setting, answer: number of the parameter; otherwise 0
  std::uint32_t flags = 0;     ///< motion: kLast, kFailed; answer: kTaken; otherwise 0
};

constexpr std::uint32_t kLast = 1;    ///< the plant stops after this motion
constexpr std::uint32_t kFailed = 2;  ///< the solver failed, the motion is the last good one
constexpr std::uint32_t kTaken = 1;   ///< the parameter has been set

/// From the driver to the plant.
struct Command {
  double steering = 0;      ///< rad, at the pitman arm
  double drive_torque = 0;  ///< N m, sum of both driven wheels
};

/// From the plant to the driver: the state at the end of a step.
struct Motion {
  double time = 0;                  ///< s, of the model
  double x = 0, y = 0;              ///< m, of the chassis, in the global frame
  double yaw = 0, roll = 0;         ///< rad
  double forward_speed = 0;         ///< m/s
  double yaw_rate = 0;              ///< rad/s
  double lateral_acceleration = 0;  ///< m/s^2, of the chassis' centre of mass
  double steering = 0;              ///< rad, where the pitman arm is
  double steering_torque = 0;       ///< N m, what holds it there
  double loads[4] = {};             ///< N, front left, front right, rear left, rear right
};

/// To the plant and back: one tunable parameter.
struct Setting {
  double value = 0;  ///< in the unit of the model
};

constexpr std::size_t kHeaderBytes = 32, kChecksumBytes = 4;

constexpr std::size_t bytes_with(std::size_t values) { return kHeaderBytes + 8 * values + kChecksumBytes; }

constexpr std::size_t kCommandBytes = bytes_with(2), kMotionBytes = bytes_with(14), kSettingBytes = bytes_with(1);
constexpr std::size_t kLargestPacket = kMotionBytes;

using Packet = std::array<std::uint8_t, kLargestPacket>;

/// Bytes of a packet of this type, 0 when there is no such type.
constexpr std::size_t bytes_of(Type type) {
  switch (type) {
    case Type::command:
      return kCommandBytes;
    case Type::motion:
      return kMotionBytes;
    case Type::setting:
    case Type::answer:
      return kSettingBytes;
  }
  return 0;
}

/// The CRC-32 of Ethernet, zip and PNG: polynomial 0xedb88320, reflected, starting from and finally inverted with all
/// ones.
constexpr std::uint32_t checksum(const std::uint8_t* bytes, std::size_t size) {
  constexpr auto kTable = [] {
    std::array<std::uint32_t, 256> table{};
    for (std::uint32_t i = 0; i < 256; ++i) {
      std::uint32_t value = i;
      for (int bit = 0; bit < 8; ++bit) value = (value & 1) != 0 ? (value >> 1) ^ 0xedb88320u : value >> 1;
      table[i] = value;
    }
    return table;
  }();
  std::uint32_t crc = 0xffffffffu;
  for (std::size_t i = 0; i < size; ++i) crc = (crc >> 8) ^ kTable[(crc ^ bytes[i]) & 0xff];
  return ~crc;
}

namespace packet_detail {

template <class Unsigned>
constexpr std::uint8_t* put(std::uint8_t* to, Unsigned value) {
  for (std::size_t i = 0; i < sizeof(Unsigned); ++i) *to++ = static_cast<std::uint8_t>(value >> (8 * i));
  return to;
}

template <class Unsigned>
constexpr const std::uint8_t* get(const std::uint8_t* from, Unsigned& value) {
  value = 0;
  for (std::size_t i = 0; i < sizeof(Unsigned); ++i) value |= static_cast<Unsigned>(Unsigned{*from++} << (8 * i));
  return from;
}

// Where the values of each packet are, in the order of the layout; of a value to read or to write.
template <class Payload>
constexpr auto places(Payload& p) {
  if constexpr (requires { p.drive_torque; }) {
    return std::array{&p.steering, &p.drive_torque};
  } else if constexpr (requires { p.loads; }) {
    return std::array{&p.time,     &p.x,
                      &p.y,        &p.yaw,
                      &p.roll,     &p.forward_speed,
                      &p.yaw_rate, &p.lateral_acceleration,
                      &p.steering, &p.steering_torque,
                      &p.loads[0], &p.loads[1],
                      &p.loads[2], &p.loads[3]};
  } else {
    return std::array{&p.value};
  }
}

}  // namespace packet_detail

/// Writes a packet. Result: its size in bytes.
template <class Payload>
constexpr std::size_t encode(const Header& header, const Payload& payload, Packet& packet) {
  using packet_detail::put;
  std::uint8_t* at = put(packet.data(), kMagic);
  at = put(at, kVersion);
  at = put(at, static_cast<std::uint16_t>(header.type));
  at = put(at, header.session);
  at = put(at, header.sequence);
  at = put(at, static_cast<std::uint64_t>(header.time));
  at = put(at, header.subject);
  at = put(at, header.flags);
  for (const double* value : packet_detail::places(payload)) at = put(at, std::bit_cast<std::uint64_t>(*value));
  const auto size = static_cast<std::size_t>(at - packet.data());
  put(at, checksum(packet.data(), size));
  return size + kChecksumBytes;
}

/// The header of a whole packet; nothing when size, magic, version, type or checksum are wrong.
constexpr std::optional<Header> open(const std::uint8_t* bytes, std::size_t size) {
  using packet_detail::get;
  if (size < kHeaderBytes + kChecksumBytes) return std::nullopt;
  std::uint32_t magic = 0, crc = 0;
  std::uint16_t version = 0, type = 0;
  std::uint64_t time = 0;
  Header header;
  const std::uint8_t* at = get(get(get(bytes, magic), version), type);
  get(get(get(get(get(at, header.session), header.sequence), time), header.subject), header.flags);
  get(bytes + size - kChecksumBytes, crc);
  header.type = static_cast<Type>(type);
  header.time = static_cast<std::int64_t>(time);
  const bool whole = magic == kMagic && version == kVersion && size == bytes_of(header.type) &&
                     crc == checksum(bytes, size - kChecksumBytes);
  return whole ? std::optional(header) : std::nullopt;
}

/// The values of a packet that open() took and whose type is that of the payload.
template <class Payload>
constexpr Payload payload_of(const std::uint8_t* bytes) {
  Payload payload;
  const std::uint8_t* at = bytes + kHeaderBytes;
  for (double* value : packet_detail::places(payload)) {
    std::uint64_t bits = 0;
    at = packet_detail::get(at, bits);
    *value = std::bit_cast<double>(bits);
  }
  return payload;
}

}  // namespace hil_rig
