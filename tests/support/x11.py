"""Asks of a window what a window manager would: x11.py close|iconify|restore WINDOW_ID

xdotool of Debian 12 cannot ask a window to close (it destroys it instead), and without a window
manager nobody else sets WM_STATE (ICCCM 4.1.3.1), which is how a window learns that it is an icon.
"""

import ctypes
import sys
from ctypes import c_char_p, c_int, c_long, c_ulong, c_void_p

CLIENT_MESSAGE, PROP_MODE_REPLACE = 33, 0
NORMAL, ICONIC = 1, 3


class ClientMessage(ctypes.Structure):
    _fields_ = [
        ("type", c_int), ("serial", c_ulong), ("send_event", c_int), ("display", c_void_p),
        ("window", c_ulong), ("message_type", c_ulong), ("format", c_int), ("data", c_long * 5),
        ("padding", c_long * 24),  # an XEvent is larger than this one
    ]  # fmt: skip


def main(action: str, window: int) -> None:
    x11 = ctypes.CDLL("libX11.so.6")
    x11.XOpenDisplay.restype = c_void_p
    x11.XInternAtom.restype = c_ulong
    x11.XInternAtom.argtypes = [c_void_p, c_char_p, c_int]
    display = c_void_p(x11.XOpenDisplay(None))
    if not display:
        sys.exit("x11.py: no display")

    def atom(name: bytes) -> int:
        return x11.XInternAtom(display, name, 0)

    if action == "close":
        event = ClientMessage(
            type=CLIENT_MESSAGE, window=window, message_type=atom(b"WM_PROTOCOLS"), format=32
        )
        event.data[0] = atom(b"WM_DELETE_WINDOW")
        x11.XSendEvent(display, c_ulong(window), 0, c_long(0), ctypes.byref(event))
    else:
        state = (c_long * 2)(ICONIC if action == "iconify" else NORMAL, 0)
        wm_state = c_ulong(atom(b"WM_STATE"))
        if action == "restore":
            x11.XMapWindow(display, c_ulong(window))
        x11.XChangeProperty(
            display, c_ulong(window), wm_state, wm_state, 32, PROP_MODE_REPLACE,
            ctypes.byref(state), 2,
        )  # fmt: skip
        if action == "iconify":
            x11.XUnmapWindow(display, c_ulong(window))
    x11.XCloseDisplay(display)  # flushes


if __name__ == "__main__":
    if len(sys.argv) != 3 or sys.argv[1] not in ("close", "iconify", "restore"):
        sys.exit(__doc__)
    main(sys.argv[1], int(sys.argv[2]))
