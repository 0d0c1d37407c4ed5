"""A CAN bus without AF_CAN: each packet of an AF_UNIX SOCK_SEQPACKET socket is one `struct can_frame`, and the hub relays
what one of its clients sends to all the others."""

import os
import selectors
import socket
import struct
import threading
import time

import can

FRAME = struct.Struct("=IB3x8s")
EXTENDED, REMOTE, ERROR = 0x80000000, 0x40000000, 0x20000000


class UnixBus(can.BusABC):
    """A client of the hub at `channel`; waits up to `patience` seconds for the hub to come."""

    def __init__(self, channel, patience=5.0, **options):
        self.channel_info = f"unix:{channel}"
        self._can_protocol = can.CanProtocol.CAN_20
        deadline = time.monotonic() + patience
        while True:
            self.socket = socket.socket(socket.AF_UNIX, socket.SOCK_SEQPACKET)
            try:
                self.socket.connect(channel)
                break
            except (FileNotFoundError, ConnectionRefusedError):
                self.socket.close()
                if time.monotonic() > deadline:
                    raise
                time.sleep(0.02)
        super().__init__(channel, **options)

    def send(self, msg, timeout=None):
        identifier = msg.arbitration_id | (EXTENDED if msg.is_extended_id else 0) | (REMOTE if msg.is_remote_frame else 0)
        self.socket.settimeout(timeout)
        self.socket.send(FRAME.pack(identifier, msg.dlc, bytes(msg.data)))

    def _recv_internal(self, timeout):
        with selectors.DefaultSelector() as selector:  # a time limit of the socket would also apply to sending
            selector.register(self.socket, selectors.EVENT_READ)
            if not selector.select(timeout):
                return None, False
        packet = self.socket.recv(FRAME.size)
        if len(packet) != FRAME.size:
            raise can.CanOperationError("the hub has ended")
        identifier, length, data = FRAME.unpack(packet)
        extended = bool(identifier & EXTENDED)
        return can.Message(
            timestamp=time.time(), arbitration_id=identifier & (0x1FFFFFFF if extended else 0x7FF), is_extended_id=extended,
            is_remote_frame=bool(identifier & REMOTE), is_error_frame=bool(identifier & ERROR), dlc=length,
            data=None if identifier & REMOTE else data[:length], is_rx=True), False

    def fileno(self):
        return self.socket.fileno()

    def shutdown(self):
        super().shutdown()
        self.socket.close()


class Hub(threading.Thread):
    """The hub at `path`, until the program ends."""

    def __init__(self, path):
        super().__init__(daemon=True)
        if os.path.exists(path):
            os.unlink(path)
        self.listener = socket.socket(socket.AF_UNIX, socket.SOCK_SEQPACKET)
        self.listener.bind(path)
        self.listener.listen()
        self.start()

    def run(self):
        clients = []
        selector = selectors.DefaultSelector()
        selector.register(self.listener, selectors.EVENT_READ)
        while True:
            for key, _ in selector.select():
                if key.fileobj is self.listener:
                    client, _ = self.listener.accept()
                    clients.append(client)
                    selector.register(client, selectors.EVENT_READ)
                elif not self.relay(key.fileobj, clients):
                    selector.unregister(key.fileobj)
                    clients.remove(key.fileobj)
                    key.fileobj.close()

    @staticmethod
    def relay(source, clients):
        try:
            packet = source.recv(FRAME.size)
        except ConnectionResetError:
            return False
        for client in clients if packet else ():
            if client is not source:
                try:
                    client.send(packet, socket.MSG_DONTWAIT | socket.MSG_NOSIGNAL)
                except OSError:
                    pass  # a client that does not read loses frames, like a controller with a full buffer
        return bool(packet)


def open_bus(name):
    """`unix:PATH` or the name of a network interface."""
    return UnixBus(name[len("unix:"):]) if name.startswith("unix:") else can.Bus(interface="socketcan", channel=name)
