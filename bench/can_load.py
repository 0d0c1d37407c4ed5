#!/usr/bin/env python3
"""How much of a CAN bus the drives of one robot, or of several, take: axes x bit rate x servo rate, as docs/how-to/can.md has it.

Frames are as long as bit stuffing can make them: 8 n + 47 + floor((34 + 8 n - 1) / 4) bits for n data bytes (R. I. Davis
et al., "Controller Area Network (CAN) schedulability analysis: Refuted, revisited and revised", Real-Time Systems 35,
2007), the space between frames with it.
"""

import argparse

BIT_RATES = (1_000_000, 500_000, 250_000, 125_000)
SERVO_RATES = (100, 200, 250, 500, 1000)
AXES = range(1, 9)
COMMAND = {"position": 7, "velocity": 7, "torque": 5}  # bytes of RPDO 1, by mode
FEEDBACK = 8  # of TPDO 1
STATUS = 8  # of TPDO 2
SYNC, HEARTBEAT = 0, 1


def bits(data):
    return 8 * data + 47 + (34 + 8 * data - 1) // 4


def answers(axes, asked):
    """Bits until the last answer to a SYNC: a frame in transmission, the SYNC, TPDO 1 of every drive; those of the other robots, and their set-points, may come before."""
    others = bits(SYNC) + axes * (bits(FEEDBACK) + bits(COMMAND[asked.mode]))
    return bits(STATUS) + bits(SYNC) + axes * bits(FEEDBACK) + (asked.robots - 1) * others


def set_points(axes, asked):
    """Bits until the last set-point: set-points precede TPDO 2."""
    return answers(axes, asked) + axes * bits(COMMAND[asked.mode])


def load(axes, servo_rate, asked):
    """Bits per second."""
    cycle = bits(SYNC) + axes * (bits(COMMAND[asked.mode]) + bits(FEEDBACK) + bits(STATUS) / asked.status_every)
    heartbeats = (axes + 1) * bits(HEARTBEAT) / asked.heartbeat
    return asked.robots * (cycle * servo_rate + heartbeats)


def cell(axes, bit_rate, servo_rate, asked):
    share = load(axes, servo_rate, asked) / bit_rate
    if share > 1 or (set_points(axes, asked) / bit_rate + asked.drive_time) * servo_rate > 1:
        return "-"
    late = (answers(axes, asked) / bit_rate + asked.drive_time) * servo_rate > asked.answer_time
    return f"{100 * share:.0f} %" + (" !" if late else "")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--mode", choices=COMMAND, default="position")
    parser.add_argument("--robots", type=int, default=1, metavar="N", help="robots on the bus, each with as many axes; 1")
    parser.add_argument("--status_every", type=int, default=4, metavar="N", help="as in the table of drives; 4")
    parser.add_argument("--heartbeat", type=float, default=0.1, metavar="S", help="as in the table of drives; 0.1")
    parser.add_argument("--answer_time", type=float, default=0.5, metavar="SHARE", help="as in the table of drives; 0.5")
    parser.add_argument("--drive_time", type=float, default=0, metavar="S", help="from the SYNC until the slowest drive has its answer ready; 0")
    asked = parser.parse_args()
    for bit_rate in BIT_RATES:
        print(f"| axes at {bit_rate // 1000} kbit/s | last answer | last set-point | " + " | ".join(f"{rate} Hz" for rate in SERVO_RATES) + " |")
        print("|---|---|---|" + "---|" * len(SERVO_RATES))
        for axes in AXES:
            times = (1000 * count / bit_rate + 1000 * asked.drive_time for count in (answers(axes, asked), set_points(axes, asked)))
            cells = (cell(axes, bit_rate, rate, asked) for rate in SERVO_RATES)
            print(f"| {axes} | " + " | ".join([*(f"{time:.2f} ms" for time in times), *cells]) + " |")
        print()


if __name__ == "__main__":
    main()
