"""A CiA 401 node over python-canopen: its inputs are set by the test, its outputs take their error values when it fails."""

from peer_node import PeerNode

INPUTS, OUTPUTS, ERROR_MODE, ERROR_VALUE = 0x6000, 0x6200, 0x6206, 0x6207
ANALOG_INPUTS, ANALOG_OUTPUTS, ANALOG_ERROR_MODE, ANALOG_ERROR_VALUE = 0x6401, 0x6411, 0x6443, 0x6444


class PeerIo(PeerNode):
    def power_on(self):
        self.inputs = {}  # (index, subindex): value

    def actual(self, index, subindex):
        return self.inputs.get((index, subindex), 0) if index in (INPUTS, ANALOG_INPUTS) and subindex else None

    def set_input(self, index, subindex, value):
        self.inputs[index, subindex] = value

    def stopped(self):
        self.react()

    def react(self):
        for block in range(1, self.number(OUTPUTS, 0) + 1):
            mode, value = self.number(ERROR_MODE, block), self.number(ERROR_VALUE, block)
            self.node.set_data(OUTPUTS, block, bytes([self.number(OUTPUTS, block) & ~mode | value & mode]))
        for output in range(1, self.number(ANALOG_OUTPUTS, 0) + 1):
            if self.number(ANALOG_ERROR_MODE, output) == 1:
                value = self.number(ANALOG_ERROR_VALUE, output) >> 16
                self.node.set_data(ANALOG_OUTPUTS, output, value.to_bytes(2, "little", signed=True))
