"""The states of a drive after CiA 402-2: commands of the controlword, states in the statusword."""

import enum


class State(enum.Enum):
    """The state bits of the statusword."""

    SWITCH_ON_DISABLED = 0x40
    READY_TO_SWITCH_ON = 0x21
    SWITCHED_ON = 0x23
    OPERATION_ENABLED = 0x27
    QUICK_STOP_ACTIVE = 0x07
    FAULT_REACTION_ACTIVE = 0x0F
    FAULT = 0x08


ENABLED = (State.OPERATION_ENABLED, State.QUICK_STOP_ACTIVE)
POWERED = (State.SWITCHED_ON, *ENABLED)

# (mask, value) of the controlword: {state: next state}, as in the table of device control commands
COMMANDS = [
    ((0x82, 0x00), {state: State.SWITCH_ON_DISABLED for state in (State.READY_TO_SWITCH_ON, *POWERED)}),  # disable voltage
    ((0x86, 0x02), {State.READY_TO_SWITCH_ON: State.SWITCH_ON_DISABLED, State.SWITCHED_ON: State.SWITCH_ON_DISABLED,
                    State.OPERATION_ENABLED: State.QUICK_STOP_ACTIVE}),
    ((0x87, 0x06), {state: State.READY_TO_SWITCH_ON
                    for state in (State.SWITCH_ON_DISABLED, State.SWITCHED_ON, State.OPERATION_ENABLED)}),  # shutdown
    ((0x8F, 0x07), {State.READY_TO_SWITCH_ON: State.SWITCHED_ON, State.OPERATION_ENABLED: State.SWITCHED_ON}),
    ((0x8F, 0x0F), {State.READY_TO_SWITCH_ON: State.OPERATION_ENABLED, State.SWITCHED_ON: State.OPERATION_ENABLED,
                    State.QUICK_STOP_ACTIVE: State.OPERATION_ENABLED}),
]
FAULT_RESET = 0x80


def next_state(state, word, before):
    """The state after the controlword `word`; `before` is the previous controlword."""
    if state is State.FAULT:
        return State.SWITCH_ON_DISABLED if word & FAULT_RESET and not before & FAULT_RESET else state
    if word & FAULT_RESET:
        word &= ~FAULT_RESET  # of no meaning outside a fault
    for (mask, value), transitions in COMMANDS:
        if word & mask == value:
            return transitions.get(state, state)
    return state


def error_register(code):
    """The bits of the object 1001h for an error code."""
    kinds = {0x2: 0x02, 0x3: 0x04, 0x4: 0x08, 0x7: 0x20}
    if code == 0:
        return 0
    return 0x01 | (0x10 if code >> 8 == 0x81 else 0x20 if code >> 8 == 0x86 else kinds.get(code >> 12, 0))
