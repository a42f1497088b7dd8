# Runs a person's script in a process of its own: `mathmodel` inside it speaks to the studio over two pipes.
import builtins
import json
import math
import os
import signal
import sys
import threading
import traceback
import types

_requests = os.fdopen(3, "w", encoding="utf-8")
_replies = os.fdopen(4, "r", encoding="utf-8")
_lock = threading.Lock()

try:  # The script dies with the studio, even inside a loop of its own.
    import ctypes
    ctypes.CDLL(None).prctl(1, 9)
except Exception:
    pass


def _call(name, *arguments):
    with _lock:
        _requests.write(json.dumps([name, *arguments]) + "\n")
        _requests.flush()
        line = _replies.readline()
    if not line:
        os._exit(1)
    reply = json.loads(line)
    if "error" in reply:
        raise RuntimeError(reply["error"])
    return reply["value"]


def _number(value):
    # numpy's numbers and arrays of one are numbers too.
    number = float(value)
    if not math.isfinite(number):
        raise ValueError(f"{number}: a finite number was expected")
    return number


def _numbers(values):
    return [_number(value) for value in values]


mathmodel = types.ModuleType("mathmodel", "The arm in the studio. Degrees and millimetres; matrices in metres.")


def _public(function):
    function.__module__ = "mathmodel"
    setattr(mathmodel, function.__name__, function)
    return function


@_public
def joint(number, value=None):
    """The value of a joint (counted from 1), or sets it: degrees, millimetres for one that slides."""
    return _call("joint", int(number)) if value is None else _call("set_joint", int(number), _number(value))


@_public
def joints(values=None):
    """All joint values, or sets them."""
    return _call("joints") if values is None else _call("set_joints", _numbers(values))


@_public
def tool():
    """Where the tool is: x, y, z in millimetres, roll, pitch, yaw in degrees."""
    return _call("tool")


@_public
def matrix():
    """The tool's pose as four rows, in metres."""
    return _call("matrix")


@_public
def move(x, y, z, roll=None, pitch=None, yaw=None):
    """Brings the tool there by the nearest solution; what is left out of the orientation stays. An error says why it cannot."""
    turn = [None if value is None else _number(value) for value in (roll, pitch, yaw)]
    return _call("move", _numbers([x, y, z]), turn)


@_public
def solutions():
    """Every set of joint values that brings the tool where it is."""
    return _call("solutions")


@_public
def pause(milliseconds):
    """Waits; the speed of playback scales it."""
    return _call("pause", _number(milliseconds))


@_public
def time():
    """Seconds since the script began."""
    return _call("time")


@_public
def keyframe(t=None):
    """Adds the present posture to the motion, at a time in seconds or after the last one."""
    return _call("keyframe", None if t is None else _number(t))


@_public
def limits():
    """The lower and upper limit of every joint."""
    return _call("limits")


def _chain(number):
    def chain(angle):
        return _call("set_joint", number, _number(angle))
    chain.__name__ = f"chain{number}"
    chain.__doc__ = f"Sets joint {number}, in degrees."
    return _public(chain)


for _k in range(1, 13):
    _chain(_k)

sys.modules["mathmodel"] = mathmodel


def _failed(error):
    line = getattr(error, "lineno", None) if isinstance(error, SyntaxError) else None
    for frame in traceback.extract_tb(error.__traceback__):
        if frame.filename == "script.py":
            line = frame.lineno
    text = traceback.format_exception_only(type(error), error)[-1].strip()
    _call("failed", line, text)


def _interrupted(*_):
    # Once is enough: a second one would fall into the clearing up after the first.
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    raise KeyboardInterrupt


def _unraisable(report):
    # Python drops what is raised inside a destructor or a weakref's callback: the script would go on.
    if report.exc_type is KeyboardInterrupt:
        os._exit(130)
    sys.__unraisablehook__(report)


def _run():
    source = _call("source")
    scope = {"__name__": "__main__", "__builtins__": builtins, "__file__": "script.py"}
    try:
        exec(compile(source, "script.py", "exec"), scope)
        check = scope.get("checkScript")
        if check is not None and not check():
            raise RuntimeError("checkScript() says that the script is not fit to run")
        control = scope.get("CRoboControl")
        if control is not None:
            # Declared without self, and called on the class.
            rate = getattr(control, "getRefreshRate", None)
            if rate is not None:
                _call("refresh_rate", _number(rate()))
            control.RunScript()
    except (KeyboardInterrupt, SystemExit):
        raise
    except BaseException as error:
        _failed(error)
        sys.exit(1)


# The studio interrupts no script that has not asked for its source yet: from here on it is this handler that hears it.
sys.unraisablehook = _unraisable
signal.signal(signal.SIGINT, _interrupted)
try:
    _run()
except KeyboardInterrupt:
    sys.exit(130)
