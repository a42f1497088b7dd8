"""ABB's EGM messages against Google's protobuf: what it writes, pieper reads and writes again, byte for byte.

    cargo xtask test        runs this among the checks against independent programs

The messages are those of egm.proto beside this file, written from the table of field numbers.
"""

import math
import os
import random
import subprocess
import sys
import tempfile

from google.protobuf import descriptor_pb2, descriptor_pool, message_factory
from grpc_tools import protoc

HERE = os.path.dirname(os.path.abspath(__file__))
COUNT = 1000


def classes():
    """The two messages, compiled from egm.proto."""
    with tempfile.TemporaryDirectory() as folder:
        compiled = os.path.join(folder, "egm.pb")
        if protoc.main(["protoc", f"-I{HERE}", f"--descriptor_set_out={compiled}", os.path.join(HERE, "egm.proto")]) != 0:
            sys.exit("egm.proto was not compiled")
        with open(compiled, "rb") as file:
            files = descriptor_pb2.FileDescriptorSet.FromString(file.read())
    pool = descriptor_pool.DescriptorPool()
    for file in files.file:
        pool.Add(file)
    find = lambda name: message_factory.GetMessageClass(pool.FindMessageTypeByName(f"abb.egm.{name}"))
    return find("EgmRobot"), find("EgmSensor")


def number(pick):
    """A double: of any size, and now and then one that is special."""
    return pick.choice([0.0, -0.0, 1e-300, math.inf, -1.5, pick.uniform(-400, 400), pick.uniform(-1e9, 1e9)])


def fill_header(header, pick):
    header.seqno, header.tm, header.mtype = pick.choice([0, 1, 127, 128, 2**32 - 1]), pick.getrandbits(32), pick.randrange(5)


def fill_planned(planned, pick):
    """Joints, a pose, external axes and a clock, or some of them."""
    if pick.random() < 0.8:
        planned.joints.joints.extend(number(pick) for _ in range(pick.choice([0, 5, 6, 7, 12])))
    if pick.random() < 0.6:
        pose = planned.cartesian
        pose.pos.x, pose.pos.y, pose.pos.z = (number(pick) for _ in range(3))
        if pick.random() < 0.7:
            pose.orient.u0, pose.orient.u1, pose.orient.u2, pose.orient.u3 = (number(pick) for _ in range(4))
        if pick.random() < 0.5:
            pose.euler.x, pose.euler.y, pose.euler.z = (number(pick) for _ in range(3))
    if pick.random() < 0.4:
        planned.externalJoints.joints.extend(number(pick) for _ in range(pick.randrange(1, 7)))
    if pick.random() < 0.5:
        planned.time.sec, planned.time.usec = pick.getrandbits(63), pick.randrange(1_000_000)


def messages(pick):
    robots, sensors = classes()
    for _ in range(COUNT):
        robot = robots()
        fill_header(robot.header, pick)
        if pick.random() < 0.9:
            fill_planned(robot.feedBack, pick)
        if pick.random() < 0.5:
            fill_planned(robot.planned, pick)
        robot.motorState.state = pick.randrange(3)
        robot.mciState.state = pick.randrange(4)
        robot.mciConvergenceMet = pick.random() < 0.5
        robot.rapidExecState.state = pick.randrange(3)
        if pick.random() < 0.5:
            robot.utilizationRate = number(pick)
        yield "EgmRobot", robot.SerializeToString(deterministic=True)
        sensor = sensors()
        fill_header(sensor.header, pick)
        if pick.random() < 0.9:
            fill_planned(sensor.planned, pick)
        if pick.random() < 0.4:
            sensor.speedRef.joints.joints.extend(number(pick) for _ in range(6))
        yield "EgmSensor", sensor.SerializeToString(deterministic=True)


def main():
    asked = list(messages(random.Random(20)))
    lines = "".join(f"{name} {data.hex()}\n" for name, data in asked)
    command = ["cargo", "run", "--quiet", "--release", "-p", "pieper-link", "--example", "egm_messages"]
    told = subprocess.run(command, input=lines, capture_output=True, text=True, check=True).stdout.split()
    wrong = [(name, data.hex(), again) for (name, data), again in zip(asked, told, strict=True) if data.hex() != again]
    for name, data, again in wrong[:5]:
        print(f"{name}\n  protobuf {data}\n  pieper   {again}")
    print(f"{len(asked)} messages, {len(wrong)} differ")
    sys.exit(1 if wrong else 0)


main()
