"""A driver from the tables of docs/use/hil_rig.md alone, with Python's own checksum: client.py OWN PLANT CONTROL MOTIONS

Answers so many motions or more, until the plant follows, sets parameters, then falls silent.
"""

import math
import socket
import struct
import sys
import zlib

HEADER = "<4sHHIIqII"
own, plant, control = (("127.0.0.1", int(port)) for port in sys.argv[1:4])
motions = int(sys.argv[4])


def sealed(kind, sequence, time, subject, *values):
    packet = struct.pack(HEADER + f"{len(values)}d", b"MBRG", 1, kind, 77, sequence, time, subject, 0, *values)
    return packet + struct.pack("<I", zlib.crc32(packet))


def opened(packet, kind, count):
    assert struct.unpack("<I", packet[-4:])[0] == zlib.crc32(packet[:-4]), "checksum"
    magic, version, its_kind, _, sequence, time, subject, flags, *values = struct.unpack(
        HEADER + f"{count}d", packet[:-4])
    assert (magic, version, its_kind) == (b"MBRG", 1, kind), packet
    return sequence, time, subject, flags, values


with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as line:
    line.bind(own)
    line.settimeout(300)
    before, count, farthest = None, 0, 0.0
    while count < motions or farthest < 0.01:
        sequence, time, _, _, values = opened(line.recv(1024), 2, 14)
        t, x, y, yaw, roll, speed, yaw_rate, lateral, steering, torque, *loads = values
        assert all(map(math.isfinite, values)), values
        assert before is None or (sequence, time) > before, "motions come in order"
        assert 10 < speed < 25 and 0 < x < 20.1 * t + 1, (t, x, speed)
        assert abs(sum(loads) / (15400 * 9.81) - 1) < 0.2, loads
        before = sequence, time
        line.sendto(sealed(1, count, time, 0, 0.02, 700.0), plant)
        farthest = max(farthest, steering)
        count += 1
    assert farthest < 0.0201, "the pitman arm goes where it is told"
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as other:
        other.settimeout(300)
        for subject, value, taken, now in ((2, 9000.0, 1, 9000.0), (3, -1.0, 0, 15000.0), (99, 1.0, 0, 0.0)):
            other.sendto(sealed(3, subject, 0, subject, value), control)
            _, _, its_subject, flags, values = opened(other.recv(1024), 4, 1)
            assert (its_subject, flags, values) == (subject, taken, [now]), (its_subject, flags, values)
print(f"client.py: {count} motions answered, 3 settings")
