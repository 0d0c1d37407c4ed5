"""A CiA 402 drive over python-canopen."""

from canopen.sdo import SdoAbortedError

from peer_motor import MODES, Motor
from peer_node import WRONG_VALUE, PeerNode
from peer_states import State


def wrapped(value):
    """As the value of a 32-bit object."""
    return (round(value) + 0x80000000) % 0x100000000 - 0x80000000


class PeerDrive(PeerNode):
    def power_on(self):
        self.motor = Motor(self.number, self.fault)

    def actual(self, index, subindex):
        motor = self.motor
        value = {
            0x603F: lambda: self.error, 0x6041: motor.statusword,
            0x6061: lambda: motor.mode, 0x6062: lambda: wrapped(motor.demand), 0x6064: lambda: wrapped(motor.position),
            0x606C: lambda: wrapped(motor.velocity), 0x6077: lambda: motor.torque, 0x6078: lambda: motor.torque,
            0x60F4: lambda: wrapped(motor.demand - motor.position), 0x60FD: lambda: motor.inputs,
        }.get(index)
        return value() if value else None

    def change(self, index, subindex, data):
        if index == 0x6060 and int.from_bytes(data, "little", signed=True) not in MODES:
            raise SdoAbortedError(WRONG_VALUE)
        if index == 0x6040 and self.motor.control(int.from_bytes(data, "little")):
            self.heal()

    def step(self, seconds):
        self.motor.step(seconds)

    def react(self):
        if self.motor.state is not State.FAULT:
            self.motor.state = State.FAULT_REACTION_ACTIVE
