"""A toy CPU for the template of an adapter: time-delay interrupts, interrupts from outside, SFC 41 and 42, restart.

It stands in the place of an implementation. It offers little, and it is not right everywhere: the kit says where.
"""

CLASSES = {
    1: 1,
    **{20 + n: 3 + n for n in range(4)},
    **{30 + n: 7 + n for n in range(9)},
    **{40 + n: 16 + n for n in range(8)},
}
HIGHEST = 26
STARTUP = {"warm": 100, "cold": 102}
CYCLE = 10
NEVER = 1 << 60


class UnsupportedError(Exception):
    """The program needs what this CPU does not have."""


class ToyCpu:
    """Tells `adapter` by `log`, `start` and `stop` what happens, and reads the time from its `now`."""

    lacks = ("priority", "step7", "cycle", "zone", "classes", "queue")
    """Fields of a header that it cannot keep."""

    def __init__(self, header, adapter):
        for field in self.lacks:
            if header.get(field):
                raise UnsupportedError(f"no {field} in the header")
        self.adapter = adapter
        self.family = header["cpu"]
        self.obs = set(header["obs"])
        self.mode = header.get("mode", "STOP")
        self.frames, self.waiting, self.delays = [], [], {}
        self.disabled, self.cycle = 0, NEVER
        if self.mode != "STOP":
            self.enter(1 if self.mode == "RUN" else STARTUP["warm"], logged=False)

    def runs(self):
        """Whether time passes for the OB on top."""
        return bool(self.frames)

    def level(self, ob):
        """The priority class."""
        return CLASSES.get(ob, HIGHEST)

    def enter(self, ob, logged=True, **info):
        """An OB begins."""
        self.frames.append(ob)
        if logged and ob != 1:
            self.adapter.log("start", ob=ob, **({"info": info} if info else {}))
        self.adapter.start(ob)

    def ended(self, ob):
        """The adapter has come to the end of the OB's body."""
        self.frames.pop()
        self.disabled = 0
        self.adapter.log("end", ob=ob)
        if ob in STARTUP.values():
            self.mode = "RUN"
            self.adapter.log("run")
            self.enter(1)
        elif ob == 1:
            self.cycle = self.adapter.now + CYCLE

    def request(self, ob, **info):
        """A start event; one for an OB that is missing is an error."""
        if ob in self.obs:
            self.waiting.append((ob, info))
        elif ob in (80, 85):
            self.to_stop("16#4568" if ob == 80 else "16#456D")
        elif ob > 47:
            raise UnsupportedError(f"no reaction to a missing OB {ob}")
        else:
            self.request(85, flt_id=0xA2 if ob in self.delays else 0xA1)

    def dispatch(self):
        """Starts the waiting OB of the highest class; False where none may start."""
        if self.mode != "RUN" or self.disabled or not self.waiting:
            return False
        first = max(self.waiting, key=lambda one: self.level(one[0]))
        if self.frames and self.level(first[0]) <= self.level(self.frames[-1]):
            return False
        self.waiting.remove(first)
        self.enter(first[0], **first[1])
        return True

    def poll(self):
        """What the time has brought about."""
        for ob, due in list(self.delays.items()):
            if due <= self.adapter.now and self.mode == "RUN":
                del self.delays[ob]
                self.request(ob)
        if self.cycle <= self.adapter.now and self.mode == "RUN" and not self.frames:
            self.cycle = NEVER
            self.enter(1)

    def next_moment(self):
        """When `poll` has something to do."""
        return min([NEVER] if self.mode != "RUN" else [*self.delays.values(), NEVER if self.frames else self.cycle])

    def to_stop(self, cause="16#4303"):
        """Mode STOP."""
        if self.mode != "STOP":
            self.mode = "STOP"
            self.frames, self.waiting, self.delays, self.disabled, self.cycle = [], [], {}, 0, NEVER
            self.adapter.stop()
            self.adapter.log("stop", cause=cause)

    def outside(self, event):
        """An event from outside."""
        kind = event["event"]
        if kind == "stop":
            self.to_stop()
        elif kind == "restart":
            self.to_stop()
            self.mode = "STARTUP"
            self.adapter.log("restart", type=event["type"])
            self.enter(STARTUP[event["type"]], logged=STARTUP[event["type"]] in self.obs)
        elif kind == "interrupt":
            if self.mode != "STOP":
                fields = {name: event[name] for name in ("ob", "flt_id") if name in event}
                self.adapter.log("interrupt", **fields)
                self.request(event["ob"], **({"flt_id": event["flt_id"]} if "flt_id" in event else {}))
        else:
            raise UnsupportedError(f"no {kind} from outside")

    def clock_set(self, before, to):
        """Delays do not follow the clock."""

    def call(self, name, operands):
        """An SFC of the running OB."""
        sfc = getattr(self, name.lower(), None)
        if sfc is None:
            raise UnsupportedError(f"no {name}")
        result = sfc(**operands)
        ret, *status = result if isinstance(result, tuple) else (result,)
        self.adapter.log(name, **operands, ret=f"16#{ret:04X}", **({"status": f"16#{status[0]:04X}"} if status else {}))
        return ret, *status

    def dis_airt(self):
        """SFC 41."""
        self.disabled += 1
        return self.disabled

    def en_airt(self):
        """SFC 42."""
        if not self.disabled:
            return 0x8080
        self.disabled -= 1
        return self.disabled

    def srt_dint(self, ob, dtime, sign):
        """SFC 32."""
        if ob not in range(20, 24):
            return 0x8090
        if not 1 <= dtime <= 60000:
            return 0x8091
        self.delays[ob] = self.adapter.now + dtime
        return 0

    def can_dint(self, ob):
        """SFC 33."""
        if ob not in range(20, 24):
            return 0x8090
        return 0 if self.delays.pop(ob, None) else 0x80A0

    def qry_dint(self, ob):
        """SFC 34."""
        if ob not in range(20, 24):
            return 0x8090
        return 0, (4 if ob in self.delays else 0) | (16 if ob in self.obs else 0)
