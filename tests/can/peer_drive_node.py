"""A CiA 402 drive over python-canopen, with one axis or several."""

import canopen
from canopen.sdo import SdoAbortedError

from peer_axes import index_of, split, with_axes
from peer_motor import MODES, Motor
from peer_node import WRONG_VALUE, PeerNode
from peer_states import State


def wrapped(value):
    """As the value of a 32-bit object."""
    return (round(value) + 0x80000000) % 0x100000000 - 0x80000000


class PeerDrive(PeerNode):
    def __init__(self, network, number, eds, cycle=None, axes=1):
        self.axes = axes
        super().__init__(network, number, eds, cycle)

    def dictionary(self, eds, number):
        return with_axes(canopen.import_od(eds, number), self.axes)

    def power_on(self):
        self.failing = None  # the axis with the fault; None: all
        self.motors = [Motor(self.objects_of(axis), self.fault_of(axis)) for axis in range(self.axes)]

    def objects_of(self, axis):
        return lambda index, subindex=0: self.number(index_of(index, axis), subindex)

    def fault_of(self, axis):
        def fault(code):
            self.failing = axis
            self.fault(code)
            self.failing = None
        return fault

    def actual(self, index, subindex):
        axis, index = split(index)
        if axis >= self.axes:
            return None
        motor = self.motors[axis]
        value = {
            0x603F: lambda: self.error, 0x6041: motor.statusword,
            0x6061: lambda: motor.mode, 0x6062: lambda: wrapped(motor.demand), 0x6064: lambda: wrapped(motor.position),
            0x606C: lambda: wrapped(motor.velocity), 0x6077: lambda: motor.torque, 0x6078: lambda: motor.torque,
            0x60F4: lambda: wrapped(motor.demand - motor.position), 0x60FD: lambda: motor.inputs,
        }.get(index)
        return value() if value else None

    def change(self, index, subindex, data):
        axis, index = split(index)
        if index == 0x6060 and int.from_bytes(data, "little", signed=True) not in MODES:
            raise SdoAbortedError(WRONG_VALUE)
        if index == 0x6040 and self.motors[axis].control(int.from_bytes(data, "little")):
            if all(motor.state is not State.FAULT for motor in self.motors):
                self.heal()

    def step(self, seconds):
        for motor in self.motors:
            motor.step(seconds)

    def react(self):
        for axis, motor in enumerate(self.motors):
            if motor.state is not State.FAULT and self.failing in (None, axis):
                motor.state = State.FAULT_REACTION_ACTIVE
