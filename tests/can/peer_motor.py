"""The motor behind the drive: modes of operation over a shaft of first order, in increments and seconds."""

import math

from peer_states import ENABLED, State, next_state

NO_MODE, HOMING, POSITION, VELOCITY, TORQUE = 0, 6, 8, 9, 10
MODES = (NO_MODE, HOMING, POSITION, VELOCITY, TORQUE)
NEGATIVE_LIMIT, POSITIVE_LIMIT = 0x1, 0x2
LAGS = {POSITION: 0.005, VELOCITY: 0.02, TORQUE: 0.1}  # s
SPEED_OF_TORQUE = 1000.0  # increments per second that remain with friction, for a thousandth of the rated torque
FOLLOWING_ERROR = 0x8611


class Motor:
    """`objects(index, subindex)` reads a value that the master has written; `fault(code)` reports a fault of the motion."""

    def __init__(self, objects, fault):
        self.objects, self.fault = objects, fault
        self.state, self.word, self.mode = State.SWITCH_ON_DISABLED, 0, NO_MODE
        self.position = self.velocity = self.demand = self.shaft = 0.0  # the shaft's own position, without the homing offset
        self.torque = self.inputs = 0
        self.homing = self.homed = self.homing_failed = self.limited = self.jammed = False
        self.beyond = 0.0  # s outside the following error window

    def control(self, word):
        before, self.word = self.word, word
        old, self.state = self.state, next_state(self.state, word, before)
        if self.state is State.OPERATION_ENABLED and old is not self.state:
            self.demand, self.beyond, self.homing = self.position, 0.0, False
        if self.state is State.QUICK_STOP_ACTIVE and self.objects(0x605A) == 0:
            self.state = State.SWITCH_ON_DISABLED
        started = bool(word & 0x10)
        if self.state is State.OPERATION_ENABLED and self.mode == HOMING and started != bool(before & 0x10):
            self.homing = started
            if started:
                self.homed = self.homing_failed = False
        return old is State.FAULT and self.state is not old

    def statusword(self):
        word = self.state.value | 0x0200 | (0x10 if self.state is not State.SWITCH_ON_DISABLED else 0)
        word |= 0x0800 if self.limited else 0
        if self.mode == HOMING:
            return word | (0x1400 if self.homed else 0x0400 if not self.homing else 0) | (0x2000 if self.homing_failed else 0)
        if self.mode in LAGS and self.state is State.OPERATION_ENABLED:
            word |= 0x1000  # the drive follows the command value
        return word | (0x2000 if self.mode == POSITION and self.beyond > 0 else 0)

    def step(self, seconds):
        if self.state is State.FAULT_REACTION_ACTIVE:
            self.state, self.velocity = State.FAULT, 0.0
        asked = self.objects(0x6060)
        if asked != self.mode:
            self.mode, self.homing, self.homed, self.homing_failed, self.demand = asked, False, False, False, self.position
        self.limited, self.torque = False, 0
        if self.state is State.OPERATION_ENABLED:
            motions = {HOMING: self.home, POSITION: self.follow, VELOCITY: self.turn, TORQUE: self.push}
            motions.get(self.mode, self.rest)(seconds)
        elif self.state is State.QUICK_STOP_ACTIVE:
            self.brake(seconds)
        else:
            self.velocity = 0.0
        if self.state not in ENABLED:
            self.demand = self.position

    def follow(self, seconds):
        target, low, high = self.objects(0x607A), self.objects(0x607D, 1), self.objects(0x607D, 2)
        self.demand = min(max(target, low), high) if low < high else target
        self.limited = self.demand != target
        self.move((self.demand - self.position) * self.share(seconds) / seconds, seconds)
        window, patience = self.objects(0x6065), self.objects(0x6066) / 1000
        outside = window != 0xFFFFFFFF and abs(self.demand - self.position) > window
        self.beyond = self.beyond + seconds if outside else 0.0
        if self.beyond > patience:
            self.fault(FOLLOWING_ERROR)

    def turn(self, seconds):
        target = self.objects(0x60FF) + self.objects(0x60B1)
        self.move(self.velocity + (target - self.velocity) * self.share(seconds), seconds)

    def push(self, seconds):
        most = min(self.objects(0x6072), 0x7FFF)
        asked = self.objects(0x6071) + self.objects(0x60B2)
        self.torque = min(max(asked, -most), most)
        self.limited = self.torque != asked
        self.move(self.velocity + (self.torque * SPEED_OF_TORQUE - self.velocity) * self.share(seconds), seconds)

    def rest(self, _):
        self.velocity = 0.0

    def home(self, seconds):
        """The home switch is at the position of the shaft at power-on; methods 35 and 37 use the present position."""
        if not self.homing or self.homed or self.homing_failed:
            self.velocity = 0.0
            return
        step = self.objects(0x6099, 1) * seconds
        if self.objects(0x6098) in (35, 37) or abs(self.shaft) <= step:
            self.shaft = 0.0
            self.position = -float(self.objects(0x607C))  # the zero is the offset away from the home position
            self.velocity, self.homed = 0.0, True
        else:
            self.move(math.copysign(step, -self.shaft) / seconds, seconds)
            self.homing_failed = self.limited

    def brake(self, seconds):
        change = min(abs(self.velocity), self.objects(0x6085) * seconds)
        self.move(self.velocity - math.copysign(change, self.velocity), seconds)
        self.demand = self.position
        if self.velocity == 0 and self.objects(0x605A) in (1, 2, 3, 4):
            self.state = State.SWITCH_ON_DISABLED

    def share(self, seconds):
        return 1 - math.exp(-seconds / LAGS[self.mode])

    def move(self, velocity, seconds):
        if (velocity > 0 and self.inputs & POSITIVE_LIMIT) or (velocity < 0 and self.inputs & NEGATIVE_LIMIT):
            velocity, self.limited = 0.0, True
        self.velocity = 0.0 if self.jammed else velocity
        self.position += self.velocity * seconds
        self.shaft += self.velocity * seconds
