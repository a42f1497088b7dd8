#!/usr/bin/env python3
"""Compare link frames of public URDF and xacro files with Pinocchio's.

    pip install pin example-robot-data rtb-data xacro numpy
    tests/urdf_peer.py --bin target/release/pieper [--only WORD] [--verbose]

Every .urdf of example-robot-data and every .urdf and .xacro robot of rtb-data goes through `pieper fk FILE --frames`
at several seeded configurations; Pinocchio, given the file itself or what the xacro program makes of it, must
agree on every link frame to 1e-12. Prints one line per file with the worst deviation (for arms over a metre: relative
to the largest coordinate) and the plain closing line 'N passed, N failed, N skipped'. A file that Pinocchio or the
xacro program does not read is skipped, with the reason.
"""
import argparse, contextlib, glob, io, json, math, os, subprocess, sys, tempfile
from xml.etree import ElementTree

import numpy as np
import pinocchio as pin

CONFIGURATIONS = 8
TOLERANCE = 1e-12


def workspace(root, folder):
    """Lays the packages under `root` side by side in `folder`, by links, as in a ROS workspace: name -> folder.

    Some folders of rtb-data are not called like the packages they hold.
    """
    found = {}
    for path, folders, _ in os.walk(root):
        if "urdf" in folders or "robots" in folders or "meshes" in folders or os.path.exists(os.path.join(path, "package.xml")):
            found.setdefault(os.path.basename(path), path)
    for name, path in list(found.items()):
        found.setdefault(f"{name}_support", path)
        found.setdefault(name.removesuffix("_description"), path)
        if name == "data" and "xarm" in path:
            found.setdefault("armer_xarm", os.path.dirname(path))
    for name, path in found.items():
        os.symlink(path, os.path.join(folder, name))
    return {name: os.path.join(folder, name) for name in found}


def within(path, found):
    """The same file as seen in the workspace."""
    real = {os.path.realpath(folder): folder for folder in sorted(found.values(), key=len)}
    folder = os.path.realpath(os.path.dirname(path))
    while folder not in real:
        if folder == os.path.dirname(folder):
            return path
        folder = os.path.dirname(folder)
    return os.path.join(real[folder], os.path.relpath(os.path.realpath(path), folder))


def expand(path, found):
    """What the xacro program makes of a file."""
    import xacro, xacro.substitution_args

    def find(name):
        if name not in found:
            raise RuntimeError(f"no package {name}")
        return found[name]

    xacro.substitution_args._eval_find = find
    with contextlib.redirect_stderr(io.StringIO()):
        return xacro.process_file(path).toxml()


def canonical(element):
    """What must be equal of two elements: all but spaces between tags and the order of attributes."""
    text = (element.text or "").strip()
    return element.tag, sorted(element.attrib.items()), text, [canonical(child) for child in element]


def cases(count):
    """The cases of the library's tests, put to the xacro program: what the tests expect is what it does."""
    import xacro

    folder = os.path.join(os.path.dirname(os.path.abspath(__file__)), os.pardir, "crates", "pieper", "tests", "data")
    wrap = '<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">{}</robot>'.format
    pairs = []
    for line in open(os.path.join(folder, "expressions.txt")).read().splitlines()[1:]:
        expression, expected = line.split(" ~ ")
        text, quoted = [x.replace("&", "&amp;").replace("<", "&lt;") for x in (expression, expected)]
        pairs.append((expression, wrap("<t>[${" + text + "}]</t>"), wrap(f"<t>[{quoted}]</t>")))
    for case in open(os.path.join(folder, "xacro.txt")).read().split("\n== ")[1:]:
        title, case = case.split("\n", 1)
        text, expected = case.split("\n--\n")
        pairs.append((title, wrap(text), wrap(expected)))
    for title, text, expected in pairs:
        with contextlib.redirect_stderr(io.StringIO()):
            xacro.init_stacks(os.path.join(folder, "case.xacro"))
            document = xacro.parse(text)
            try:
                xacro.process_doc(document)
                got = document.toxml()
            except Exception as error:
                got = wrap(f"<error/>{type(error).__name__}: {error}".replace("<", "&lt;"))
        same = canonical(ElementTree.fromstring(got)) == canonical(ElementTree.fromstring(expected))
        count["passed" if same else "failed"] += 1
        if not same:
            print(f"failed   case {title}: {got}")
    print(f"passed   {len(pairs)} cases of xacro.txt and expressions.txt, unless said otherwise")


def joints(model):
    """(name, index in q, number of entries) of every joint that moves."""
    return [(model.names[i], model.joints[i].idx_q, model.joints[i].nq) for i in range(1, model.njoints)]


def followers(text):
    """Of every mimic joint: the joint it follows, multiplier, offset. Pinocchio's own mimic joints need an order."""
    found = {}
    for joint in ElementTree.fromstring(text).findall("joint"):
        mimic = joint.find("mimic")
        if mimic is not None and joint.get("type") != "fixed":
            found[joint.get("name")] = (mimic.get("joint"), float(mimic.get("multiplier", 1)), float(mimic.get("offset", 0)))
    return found


def value(name, values, follows):
    """A joint's displacement, given those of the independent joints."""
    if name not in follows:
        return values[name]
    leader, multiplier, offset = follows[name]
    return multiplier * value(leader, values, follows) + offset


def reference(model, values, follows):
    """Every link's frame, by link name."""
    q = pin.neutral(model)
    for name, index, entries in joints(model):
        x = value(name, values, follows)
        q[index:index + entries] = [math.cos(x), math.sin(x)] if entries == 2 else [x]
    data = model.createData()
    pin.framesForwardKinematics(model, data, q)
    frames = {}
    for i, frame in enumerate(model.frames):
        if frame.type == pin.FrameType.BODY:
            frames[frame.name] = data.oMf[i].homogeneous
    return frames


def ours(binary, path, configurations):
    lines = "".join(json.dumps({"id": str(i), "q": q}) + "\n" for i, q in enumerate(configurations))
    command = [binary, "fk", path, "--input", "-", "--output", "-", "--frames"]
    done = subprocess.run(command, input=lines, capture_output=True, text=True, timeout=600)
    answers = [json.loads(line) for line in done.stdout.splitlines()]
    if done.returncode or len(answers) != len(configurations):
        raise RuntimeError(done.stderr.strip()[:400] or str([a.get("error") for a in answers])[:400])
    return answers


def compare(binary, path, text):
    """Worst relative deviation over all links and configurations, number of links, number of joints."""
    model = pin.buildModelFromXML(text)
    follows = followers(text)
    moving = {name for name, _, _ in joints(model)}
    for name, (leader, _, _) in follows.items():
        if leader not in moving:
            raise LookupError(f"its joint {name} mimics {leader}, which it does not have")
    names = [name for name, _, _ in joints(model) if name not in follows]
    if any(entries > 2 for _, _, entries in joints(model)):
        raise LookupError("it has a floating or planar joint")
    if not names:
        raise LookupError("no joint of it moves")
    random = np.random.default_rng(20260101)
    configurations = [{name: 0.0 for name in names}]
    configurations += [{name: float(random.uniform(-3, 3)) for name in names} for _ in range(CONFIGURATIONS - 1)]
    worst = 0.0
    for q, answer in zip(configurations, ours(binary, path, configurations)):
        expected = reference(model, q, follows)
        got = {name: np.array(frame) for name, frame in answer["frames"].items()}
        if set(expected) != set(got):
            raise RuntimeError(f"links differ: {sorted(set(expected) ^ set(got))[:6]}")
        scale = max(1.0, max(np.abs(frame[:3, 3]).max() for frame in expected.values()))
        worst = max(worst, max(np.abs(expected[name] - got[name]).max() for name in expected) / scale)
    return worst, len(expected), len(names)


def sources():
    """(label, path) of every description."""
    import rtbdata

    # example-robot-data ships files only; they lie beside the module that carries Pinocchio.
    prefix = os.path.abspath(os.path.join(os.path.dirname(pin.__file__), *[os.pardir] * 4))
    roots = [os.path.join(prefix, "share", "example-robot-data"), os.path.dirname(rtbdata.__file__)]
    for root in roots:
        files = glob.glob(os.path.join(root, "**", "*.urdf"), recursive=True)
        files += glob.glob(os.path.join(root, "**", "*.xacro"), recursive=True)
        for path in sorted(files):
            yield root, path


def main():
    p = argparse.ArgumentParser()
    p.add_argument("--bin", required=True)
    p.add_argument("--only", default="", help="only files whose path contains this")
    p.add_argument("--verbose", action="store_true", help="say why files are skipped")
    a = p.parse_args()
    count = {"passed": 0, "failed": 0, "skipped": 0}
    if not a.only:
        cases(count)
    known = {}
    scratch = tempfile.TemporaryDirectory()
    for root, path in sources():
        label = os.path.relpath(path, root)
        if a.only not in label:
            continue
        try:
            text = open(path).read()
            if path.endswith(".xacro") or "xacro:" in text:
                if root not in known:
                    known[root] = workspace(root, tempfile.mkdtemp(dir=scratch.name))
                path = within(path, known[root])
                text = expand(path, known[root])
            pin.buildModelFromXML(text)
        except Exception as error:  # whatever stops the peers: the file is then no reference
            count["skipped"] += 1
            if a.verbose:
                print(f"skipped  {label}: {type(error).__name__}: {str(error).strip().splitlines()[0][:120] if str(error).strip() else ''}")
            continue
        try:
            worst, links, moving = compare(a.bin, path, text)
            verdict = "passed" if worst <= TOLERANCE else "failed"
            print(f"{verdict}  {worst:.1e}  {links:3} links {moving:3} joints  {label}")
        except LookupError as error:
            verdict = "skipped"
            print(f"skipped  {label}: {error}")
        except RuntimeError as error:
            verdict = "failed"
            print(f"failed   {label}: {error}")
        count[verdict] += 1
    print(f"{count['passed']} passed, {count['failed']} failed, {count['skipped']} skipped")
    sys.exit(1 if count["failed"] or not count["passed"] else 0)


if __name__ == "__main__":
    main()
