#!/usr/bin/python3
"""end_to_end.journey: a session from start to end, as people run it who know no terminal.

journey.py INSTRUCTOR TRAINEE [--keyboard] [--size WxH] [--pictures DIR]

Three computers, each with a screen of its own, two of them in a network of their own: the
instructor's console and two trainees' programs, started without options, and operated by mouse, or
by keyboard alone, through their windows. What they show is read over the accessibility interface
and from pictures of the screens.
"""

import argparse
import os
import shutil
import subprocess
import sys
import tempfile

SKIPPED = 77
NEEDED = {"xdotool": "xdotool", "Xvfb": "xvfb", "dbus-daemon": "dbus-daemon", "ip": "iproute2",
          "unshare": "util-linux"}
INSIDE = "CARINA_JOURNEY_INSIDE"


def skip(why):
    print(f"skipped: {why}")
    sys.exit(SKIPPED)


def check_needs():
    if os.geteuid() != 0:
        skip("network namespaces need root: run this test as root")
    for program, package in NEEDED.items():
        if shutil.which(program) is None:
            skip(f"{program} is not here: install the package {package}")
    try:
        import gi  # noqa: F401
        from PIL import ImageGrab  # noqa: F401
    except ImportError as missing:
        skip(f"{missing}: install the packages python3-gi and python3-pil")


def enter_own_network():
    """Goes on in a network namespace of its own, so that nothing of the computer's is touched."""
    if os.environ.get(INSIDE):
        return
    if subprocess.run(["unshare", "--net", "true"], capture_output=True, check=False).returncode:
        skip("network namespaces are not allowed here")
    os.environ[INSIDE] = "1"
    os.execvp("unshare", ["unshare", "--net", sys.executable, "-B", *sys.argv])


def start_bus(folder):
    """A session bus at a path: its usual address is known in one network namespace only."""
    address = f"unix:path={folder}/bus"
    os.environ["XDG_RUNTIME_DIR"] = folder
    os.environ["DBUS_SESSION_BUS_ADDRESS"] = address
    bus = subprocess.Popen(["setpriv", "--pdeathsig", "KILL", "dbus-daemon", "--session",
                            "--nofork", "--nopidfile", f"--address={address}", "--print-address"],
                           stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True)
    bus.stdout.readline()
    return bus


def arguments():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("instructor")
    parser.add_argument("trainee")
    parser.add_argument("--keyboard", action="store_true", help="without a mouse")
    parser.add_argument("--size", default="1280x800", help="of the screens")
    parser.add_argument("--pictures", help="keeps a picture of each step in this folder")
    return parser.parse_args()


def main():
    asked = arguments()
    sys.stdout.reconfigure(line_buffering=True)
    check_needs()
    enter_own_network()
    with tempfile.TemporaryDirectory(prefix="journey", ignore_cleanup_errors=True) as folder:
        bus = start_bus(folder)
        try:
            from story import Story
            Story(asked, folder).tell()
        finally:
            bus.kill()


if __name__ == "__main__":
    sys.exit(main())
