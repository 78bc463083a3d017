"""Computers as the journey needs them: a screen, a network and a folder of their own each.

Nothing of them is left when the journey ends: network namespaces live as long as the process that
holds them, and every process is told to end with the one that started it.
"""

import os
import pathlib
import subprocess

from PIL import ImageGrab

SWITCH = "carina0"
END_WITH_PARENT = ["setpriv", "--pdeathsig", "KILL"]
START_S = 30


def run(*words):
    subprocess.run(words, check=True, capture_output=True, text=True)


def make_switch():
    """The network that connects them; this process is in a namespace of its own."""
    run("ip", "link", "set", "lo", "up")
    run("ip", "link", "add", SWITCH, "type", "bridge")
    run("ip", "address", "add", "10.77.0.1/24", "broadcast", "10.77.0.255", "dev", SWITCH)
    run("ip", "link", "set", SWITCH, "up")


class Network:
    """A network namespace that is connected with the switch; the first is this process's own."""

    def __init__(self, number):
        self.number = number
        self.holder = None
        if number == 1:
            return
        self.holder = subprocess.Popen(END_WITH_PARENT + ["unshare", "--net", "sh", "-c",
                                                          "echo made; exec cat"],
                                       stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True)
        self.holder.stdout.readline()
        here, there = f"carina{number}", "eth0"
        run("ip", "link", "add", here, "type", "veth", "peer", "name", there, "netns",
            str(self.holder.pid))
        run("ip", "link", "set", here, "master", SWITCH, "up")
        for words in (["link", "set", "lo", "up"],
                      ["address", "add", f"10.77.0.{number}/24", "broadcast", "10.77.0.255", "dev",
                       there],
                      ["link", "set", there, "up"]):
            run(*self.within(), "ip", *words)

    def within(self):
        """The words before a command that run it in this network."""
        return ["nsenter", "--net", "--target", str(self.holder.pid)] if self.holder else []


class Screen:
    """An X server of its own."""

    def __init__(self, size):
        self.size = size
        reading, writing = os.pipe()
        width, height = size
        self.server = subprocess.Popen(
            END_WITH_PARENT + ["Xvfb", "-displayfd", str(writing), "-screen", "0",
                               f"{width}x{height}x24", "+extension", "GLX", "-nolisten", "tcp"],
            pass_fds=[writing], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        os.close(writing)
        with os.fdopen(reading) as number:
            self.display = ":" + number.readline().strip()

    def picture(self):
        return ImageGrab.grab(xdisplay=self.display)


class Computer:
    """A computer on which a person starts one program."""

    def __init__(self, name, number, size, folder):
        self.name = name
        self.network = Network(number)
        self.screen = Screen(size)
        self.home = pathlib.Path(folder) / name
        self.home.mkdir()
        self.process = None
        self.log = None

    def environment(self):
        home = self.home
        return dict(os.environ, HOME=str(home), XDG_DATA_HOME=str(home / "data"),
                    XDG_CONFIG_HOME=str(home / "settings"), XDG_CACHE_HOME=str(home / "cache"),
                    DISPLAY=self.screen.display, QT_QPA_PLATFORM="xcb", LIBGL_ALWAYS_SOFTWARE="1",
                    QT_ACCESSIBILITY="1", QT_LINUX_ACCESSIBILITY_ALWAYS_ON="1", LANG="C.UTF-8",
                    LC_ALL="C.UTF-8")

    def start(self, program):
        self.log = open(self.home / "log", "ab")
        self.process = subprocess.Popen(END_WITH_PARENT + self.network.within() + [program],
                                        env=self.environment(), stdout=self.log,
                                        stderr=subprocess.STDOUT)

    def kill(self):
        """As kill -9: no time for a word."""
        self.process.kill()
        self.process.wait()
