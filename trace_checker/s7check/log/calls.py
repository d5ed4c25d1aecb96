"""The format of a log, its calls and its modes; everything else about them the engine knows."""

LOG_FORMAT = "s7-interrupt-log/1"

OPERANDS: dict[str, tuple[str, ...]] = {
    "SET_TINT": ("ob", "sdt", "period"),
    "SET_TINTL": ("ob", "sdt", "local", "period", "activate"),
    "CAN_TINT": ("ob",),
    "ACT_TINT": ("ob",),
    "QRY_TINT": ("ob",),
    "SRT_DINT": ("ob", "dtime", "sign"),
    "CAN_DINT": ("ob",),
    "QRY_DINT": ("ob",),
    "DIS_IRT": ("mode", "ob"),
    "EN_IRT": ("mode", "ob"),
    "DIS_AIRT": (),
    "EN_AIRT": (),
}
"""Call -> its operands, without RET_VAL and STATUS; SFCs in the order of their numbers, 28 to 34 and 39 to 42."""

WITHOUT_NUMBER = "SET_TINTL"
"""A call of the S7-1500: S7-300/400 have no such SFC."""

MODES = {"stop": "STOP", "restart": "STARTUP", "run": "RUN", "hold": "HOLD", "release": "RUN"}
"""Line of the kind ``mode`` -> the mode that it says the CPU is in."""
