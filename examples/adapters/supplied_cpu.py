"""What awlsim has not: SFC 28 to 34 and 39 to 42, start events and the order of OBs, OB 80 and 85, STOP and restart.

Written from docs/rules/requirements.md. Where that leaves a question open, this CPU keeps to one reading: a run that
waits is withdrawn by a call (AMB-11), a second event of an OB that waits is merged with the first (AMB-18), every
start event from outside is kept (AMB-67, AMB-77). It has no request buffer that could be full, no HOLD and no
diagnostic buffer.
"""

import calendar
from datetime import MAXYEAR, datetime, timedelta

from toy_cpu import CLASSES, HIGHEST, NEVER, STARTUP, ToyCpu, UnsupportedError

TODS, DELAYS = range(10, 18), range(20, 24)
ASYNCHRONOUS, STOPPING = range(80, 88), {80: "16#4568", 82: None, 83: None, 85: "16#456D", 86: None}
SFC_39 = {10: TODS, 20: DELAYS, 30: range(30, 39), 40: range(40, 48), 50: range(55, 58), 60: (60,), 70: (70, 72)}
SFC_39 |= {80: ASYNCHRONOUS}
"""The classes of SFC 39 and 40 [IRT-11]."""

PERIODS = {
    0x0201: timedelta(minutes=1),
    0x0401: timedelta(hours=1),
    0x1001: timedelta(days=1),
    0x1201: timedelta(weeks=1),
    0x1202: timedelta(weeks=1),
}
ONCE, MONTHLY, YEARLY, END_OF_MONTH = 0x0000, 0x1401, 0x1801, 0x2001
EXECUTIONS = {"once": ONCE, "minute": 0x0201, "hourly": 0x0401, "daily": 0x1001, "weekly": 0x1201, "monthly": MONTHLY}
EXECUTIONS |= {"yearly": YEARLY, "end_of_month": END_OF_MONTH}
MINUTE = timedelta(minutes=1)
OK, NOT_DELAYED, BAD_OB, BAD_VALUE, BAD_PERIOD, NOT_SET, PAST = 0, 0x8080, 0x8090, 0x8091, 0x8092, 0x80A0, 0x80A1
OVERLAP, SKIPPED = 0x02, 0x05


def first_point(start, period, moment):
    """The first start point that is not before `moment` [TINT-32]; None where there is none up to 2089."""
    if moment <= start and period != END_OF_MONTH:
        return start
    if period == ONCE:
        return None
    if period in PERIODS:
        return last_reading(start - (start - moment) // PERIODS[period] * PERIODS[period])
    month = max(start, moment).replace(day=1, hour=start.hour, minute=start.minute, second=0, microsecond=0)
    while month.year < MAXYEAR:
        length = calendar.monthrange(month.year, month.month)[1]
        day = length if period == END_OF_MONTH else start.day
        if day <= length and (period != YEARLY or month.month == start.month):
            point = month.replace(day=day)
            if point >= max(start, moment):
                return last_reading(point)
        month += timedelta(days=length)
    return None


def last_reading(point):
    """The point, unless the clock cannot show it."""
    return point if point.year < 2090 else None


class Tod:
    """A time-of-day interrupt that is set."""

    def __init__(self, start, period):
        self.start, self.period = start, period
        self.active, self.next = False, None

    def arm(self, moment):
        """The next start point is the first that is not before `moment`."""
        self.next = first_point(self.start, self.period, moment)


class SuppliedCpu(ToyCpu):
    """Tells its adapter what happens, as the toy CPU does."""

    lacks = ("cycle",)

    def __init__(self, header, adapter):
        self.classes = {int(ob): level for ob, level in header.get("priority", {}).items()}
        parts = header.get("step7", {})
        self.step7 = {int(ob): given for ob, given in parts.get("tod", {}).items()}
        deselected = (given.get("deselected") for part in parts.values() for given in part.values())
        if 0 in self.classes.values() or any(deselected):
            raise UnsupportedError("no deselected OBs")
        self.tods, self.blocked = {}, set()
        super().__init__(header, adapter)
        self.tods = self.configured(header.get("mode") == "STARTUP")

    def configured(self, restarted):
        """What STEP 7 has set. A one-shot interrupt in the past is called after a restart [OBS-56], else it is over."""
        tods = {}
        for ob, given in self.step7.items():
            if given.get("execution", "none") == "none":
                continue
            tod = Tod(datetime.fromisoformat(given["start"]), EXECUTIONS[given["execution"]])
            if given.get("active"):
                tod.active = True
                tod.arm(self.clock())
                if tod.next is None and not restarted:
                    continue
                if tod.next is None:
                    self.put_once(ob, self.shown(tod, tod.start))
            tods[ob] = tod
        return tods

    def clock(self):
        """The reading of the CPU clock."""
        return self.adapter.clock + timedelta(milliseconds=self.adapter.now)

    def level(self, ob):
        """The priority class of table 7.1; 28 for OB 80 to 87 in STARTUP [OBS-43]."""
        if ob in ASYNCHRONOUS and self.mode == "STARTUP":
            return 28
        if ob in self.classes:
            return self.classes[ob]
        if ob in TODS or ob in SFC_39[50]:
            return 2
        if ob in CLASSES:
            return CLASSES[ob]
        fixed = {60: 25, 70: 25, 72: 28, 100: 27, 102: 27}
        return fixed.get(ob, HIGHEST if ob == 80 or self.family == "S7-300" else 25)

    # ---- start events

    def request(self, ob, **info):
        """A start event; nothing comes of it if SFC 39 blocks the OB [IRT-01, IRT-04]."""
        if ob in self.blocked:
            return
        if ob in self.obs or ob not in (*ASYNCHRONOUS, *SFC_39[70]):
            self.waiting.append((ob, info))
        elif ob in STOPPING:
            self.to_stop(STOPPING[ob])

    def happened(self, ob, **info):
        """A start event of OB 10 to 23, which may come while the OB runs [TINT-14, DINT-10] or waits."""
        if ob in self.blocked:
            self.used_up(ob)
        elif ob in self.frames:
            cause = f"16#{0x1111 + ob - 10 if ob in TODS else 0x1121 + ob - 20:04X}"
            self.request(80, flt_id=OVERLAP, error_info=info.get("period", info.get("sign")), ev=cause, ev_ob=ob)
            if self.mode != "STOP":
                self.put_once(ob, info)
        else:
            self.put_once(ob, info)

    def put_once(self, ob, info):
        """One run waits at the most."""
        if not self.waits(ob):
            self.waiting.append((ob, info))

    def waits(self, ob):
        """Whether a run of the OB waits."""
        return any(one == ob for one, _ in self.waiting)

    def withdraw(self, ob):
        """No run of the OB waits any more."""
        self.waiting = [one for one in self.waiting if one[0] != ob]

    def used_up(self, ob):
        """A one-shot interrupt is over when its OB is called, or could not be [TINT-08, AMB-12, AMB-46]."""
        tod = self.tods.get(ob)
        if tod and tod.period == ONCE and tod.next is None:
            del self.tods[ob]

    def dispatch(self):
        """Starts the waiting OB of the highest class, or OB 85 in its place; False where none may start."""
        allowed = [(ob, info) for ob, info in self.waiting if self.mode == "RUN" or ob in ASYNCHRONOUS]
        if self.mode not in ("RUN", "STARTUP") or self.disabled or not allowed:
            return False
        first = max(allowed, key=lambda one: self.level(one[0]))
        if self.frames and self.level(first[0]) <= self.level(self.frames[-1]):
            return False
        self.waiting.remove(first)
        ob, info = first
        self.used_up(ob)
        if ob in self.obs:
            self.enter(ob, **info)
        elif ob in ASYNCHRONOUS or ob in SFC_39[70]:  # deleted while it waited
            if ob in STOPPING:
                self.to_stop(STOPPING[ob])
        else:
            self.request(85, flt_id=0xA2 if ob in TODS or ob in DELAYS else 0xA1)
        return True

    # ---- time

    def poll(self):
        """What the time has brought about."""
        for ob, (due, dtime, sign) in list(self.delays.items()):
            if due <= self.adapter.now:
                del self.delays[ob]
                self.happened(ob, dtime=dtime, sign=f"16#{sign:04X}")
        for ob, tod in sorted(self.tods.items()):
            while tod.active and tod.next and tod.next <= self.clock() and self.mode != "STOP":
                point = tod.next
                tod.next = None if tod.period == ONCE else first_point(tod.start, tod.period, point + MINUTE)
                self.happened(ob, **self.shown(tod, point))
        if self.cycle <= self.adapter.now and self.mode == "RUN" and not self.frames:
            self.cycle = NEVER
            self.enter(1)

    def shown(self, tod, point):
        """The start information of a time-of-day OB [CLK-07]."""
        return {"period": f"16#{tod.period:04X}", "time": point.isoformat(timespec="milliseconds")}

    def next_moment(self):
        """When `poll` has something to do."""
        points = [tod.next - self.adapter.clock for tod in self.tods.values() if tod.active and tod.next]
        moments = [point // timedelta(milliseconds=1) for point in points]
        moments += [due for due, _, _ in self.delays.values()]
        return min([NEVER] if self.mode == "STOP" else [*moments, NEVER if self.frames else self.cycle])

    def clock_set(self, before, to):
        """The clock is moved [CLK-02, CLK-10]; delays do not follow it."""
        skipped, late = [], 0
        for ob, tod in sorted(self.tods.items()):
            if not tod.active or self.mode == "STOP":
                continue
            if tod.next and tod.next < to:
                point = tod.next
                tod.arm(to)
                if ob in self.blocked:
                    self.used_up(ob)
                else:
                    skipped.append((ob, self.shown(tod, point)))
                    late |= 1 << ob - TODS.start
            elif to < before and self.family == "S7-300" and tod.period != ONCE:
                tod.arm(to)
        if late and self.mode == "RUN":
            after = to.isoformat(timespec="milliseconds")
            self.request(80, flt_id=SKIPPED, error_info=f"16#{late:04X}", time=after)  # [CLK-06]
        for ob, info in skipped if self.mode != "STOP" else []:
            self.put_once(ob, info)

    # ---- modes

    def enter(self, ob, logged=True, **info):
        """An OB begins; without a startup OB it is RUN at once."""
        if ob in STARTUP.values() and ob not in self.obs:
            self.mode = "RUN"
            self.adapter.log("run")
            ob = 1
        super().enter(ob, logged, **info)

    def to_stop(self, cause="16#4303"):
        """Mode STOP, which a restart with nothing set or blocked follows [OBS-50, OBS-52, OBS-53]."""
        if self.mode != "STOP":
            self.mode, self.cycle = "STOP", NEVER
            self.frames, self.waiting, self.delays, self.disabled = [], [], {}, 0
            self.tods, self.blocked = {}, set()
            self.adapter.stop()
            self.adapter.log("stop", **({"cause": cause} if cause else {}))

    def outside(self, event):
        """An event from outside."""
        kind = event["event"]
        if kind in ("load", "delete"):
            if kind == "load" or event["ob"] in self.obs:  # a loaded block may be loaded again
                self.obs ^= {event["ob"]} - (self.obs if kind == "load" else set())
                self.adapter.log(kind, ob=event["ob"])
        elif kind == "restart":
            self.to_stop()
            self.tods = self.configured(True)
            super().outside(event)
        else:
            super().outside(event)

    # ---- SFC 28 to 31

    def set_tint(self, ob, sdt, period):
        """SFC 28."""
        if ob not in TODS:
            return BAD_OB
        if period not in (ONCE, MONTHLY, YEARLY, END_OF_MONTH, *PERIODS):
            return BAD_PERIOD
        try:
            start = datetime.fromisoformat(sdt).replace(second=0, microsecond=0)  # [TINT-11]
        except ValueError:
            return BAD_VALUE
        if not 1990 <= start.year < 2090 or (period == MONTHLY and start.day > 28):
            return BAD_VALUE
        if period == ONCE and start < self.clock():
            return PAST
        self.withdraw(ob)
        self.tods[ob] = Tod(start, period)
        return OK

    def can_tint(self, ob):
        """SFC 29."""
        if ob not in TODS:
            return BAD_OB
        if ob not in self.tods:
            return NOT_SET
        self.withdraw(ob)
        del self.tods[ob]
        return OK

    def act_tint(self, ob):
        """SFC 30."""
        if ob not in TODS:
            return BAD_OB
        tod = self.tods.get(ob)
        if tod is None:
            return NOT_SET
        if not tod.active:
            if tod.period == ONCE and tod.start < self.clock():
                return PAST
            tod.active = True
            tod.arm(self.clock())
        return OK

    def qry_tint(self, ob):
        """SFC 31."""
        return self.status(ob, ob in self.tods and self.tods[ob].active) if ob in TODS else BAD_OB

    def status(self, ob, active):
        """STATUS of SFC 31 and 34 [TINT-72 to TINT-79]."""
        bits = (self.mode == "STARTUP", ob in self.blocked, active, False, ob in self.obs)
        return OK, sum(1 << place for place, bit in enumerate(bits) if bit)

    # ---- SFC 32 to 34

    def srt_dint(self, ob, dtime, sign):
        """SFC 32."""
        if ob not in DELAYS:
            return BAD_OB
        if not 1 <= dtime <= 60000:
            return BAD_VALUE
        self.withdraw(ob)
        self.delays[ob] = (self.adapter.now + dtime, dtime, sign)
        return OK

    def can_dint(self, ob):
        """SFC 33."""
        if ob not in DELAYS:
            return BAD_OB
        started = self.delays.pop(ob, None) or self.waits(ob)
        self.withdraw(ob)
        return OK if started else NOT_SET

    def qry_dint(self, ob):
        """SFC 34."""
        return self.status(ob, ob in self.delays) if ob in DELAYS else BAD_OB

    # ---- SFC 39 and 40

    def dis_irt(self, mode, ob):
        """SFC 39; without a diagnostic buffer MODE 80 to 82 are as 00 to 02."""
        return self.select(mode & 0x7F if mode in (0x80, 0x81, 0x82) else mode, ob, self.blocked.update)

    def en_irt(self, mode, ob):
        """SFC 40."""
        return self.select(mode, ob, self.blocked.difference_update)

    def select(self, mode, ob, change):
        """Changes the OBs that MODE and OB_NR mean [IRT-06 to IRT-08]."""
        every = {one for obs in SFC_39.values() for one in obs}
        if mode not in (0, 1, 2):
            return BAD_VALUE
        if mode and ob not in (SFC_39 if mode == 1 else every):
            return BAD_OB
        change(every if mode == 0 else SFC_39[ob] if mode == 1 else {ob})
        return OK
