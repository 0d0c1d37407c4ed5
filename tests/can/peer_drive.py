#!/usr/bin/env python3
"""Independent CiA 402 drives, and CiA 401 I/O nodes: nodes of python-canopen with the object dictionary of an EDS, for tests
of a master.

Prints `ready` when they are on the bus. Obeys lines of its standard input, for every node or after `node N` for one, and
for the first axis of a drive or after `axis K`, from 1, for another:
  emcy CODE               a fault of the axis with that error code; 0 of an I/O node: its end
  limit positive|negative on|off
  jam on|off              the shaft does not turn
  input BLOCK VALUE       of an I/O node: 8 digital inputs
  analog NUMBER VALUE     of an I/O node: the counts of an analogue input
  silence, speak          no frames in or out, as with its plug pulled, and back
  reboot                  power off and on
  die                     the program ends without output
"""

import argparse
import os
import queue
import sys
import threading

import canopen

from peer_drive_node import PeerDrive
from peer_io_node import ANALOG_INPUTS, INPUTS, PeerIo
from peer_motor import NEGATIVE_LIMIT, POSITIVE_LIMIT
from unix_bus import open_bus

TICK = 0.005  # s between updates of the timers and the motor


def obey(peer, words, axis=0):
    name, rest = words[0], words[1:]
    motor = peer.motors[axis] if hasattr(peer, "motors") else None
    if name == "axis":
        obey(peer, rest[1:], int(rest[0]) - 1)
    elif name == "emcy":
        fault = motor.fault if motor else peer.fault
        fault(int(rest[0], 0)) if int(rest[0], 0) else peer.heal()
    elif name == "input":
        peer.set_input(INPUTS, int(rest[0]), int(rest[1], 0))
    elif name == "analog":
        peer.set_input(ANALOG_INPUTS, int(rest[0]), int(rest[1], 0))
    elif name == "limit":
        bit = {"positive": POSITIVE_LIMIT, "negative": NEGATIVE_LIMIT}[rest[0]]
        motor.inputs = motor.inputs | bit if is_on(rest[1]) else motor.inputs & ~bit
    elif name == "jam":
        motor.jammed = is_on(rest[0])
    elif name in ("silence", "speak"):
        peer.set_silent(name == "silence")
    elif name == "reboot":
        peer.restart()
    elif name == "die":
        os._exit(1)
    else:
        raise ValueError(name)


def is_on(word):
    return {"on": True, "off": False}[word]


def read_lines(lines):
    for line in sys.stdin:
        lines.put(line.split())


def obey_line(peers, words):
    if words[:1] == ["node"]:
        peers, words = [peer for peer in peers if peer.node.id == int(words[1], 0)], words[2:]
    for peer in peers if words else ():
        with peer.lock:
            obey(peer, words)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--bus", required=True, help="a network interface, or unix:PATH of a hub")
    parser.add_argument("--eds", required=True)
    parser.add_argument("--cycle", type=float, metavar="S", help="motors turn by S at each SYNC; default: real time")
    parser.add_argument("--axes", type=int, default=1, help="of each drive")
    parser.add_argument("--io-eds", help="of the I/O nodes")
    parser.add_argument("--io", type=int, nargs="*", default=[], metavar="NODE", help="node numbers of I/O nodes")
    parser.add_argument("nodes", type=int, nargs="+", help="node numbers")
    asked = parser.parse_args()

    network = canopen.Network(open_bus(asked.bus))
    peers = [PeerDrive(network, number, asked.eds, asked.cycle, asked.axes) for number in asked.nodes]
    peers += [PeerIo(network, number, asked.io_eds, asked.cycle) for number in asked.io]
    network.listeners += [peer.on_frame for peer in peers]
    network.connect()
    print("ready", flush=True)

    lines = queue.Queue()
    threading.Thread(target=read_lines, args=[lines], daemon=True).start()
    while network.notifier.exception is None:
        try:
            words = lines.get(timeout=TICK)
            obey_line(peers, words)
            print("done", *words, flush=True)
        except queue.Empty:
            pass
        except (ValueError, KeyError, IndexError) as error:
            print("not understood:", error, flush=True)
        for peer in peers:
            peer.tick()
    return f"the bus is gone: {network.notifier.exception}"


if __name__ == "__main__":
    sys.exit(main())
