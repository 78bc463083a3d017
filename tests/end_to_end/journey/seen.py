"""What a program shows, read over the accessibility interface (AT-SPI) from outside of it.

All calls for a level of the tree are sent before the first answer is awaited: a program that draws
answers between two frames, and one call after the other would take a frame each.
"""

import dataclasses
import time

from gi.repository import Gio, GLib

ROOT = "/org/a11y/atspi/accessible/root"
REGISTRY = "org.a11y.atspi.Registry"
ACCESSIBLE = "org.a11y.atspi.Accessible"
NULL = "/org/a11y/atspi/null"
CALL_MS = 60_000  # of a program that is busy with something else
# Places in the bits of the state, from the AT-SPI specification.
STATES = {"checked": 4, "editable": 7, "enabled": 8, "expanded": 10, "focusable": 11, "focused": 12,
          "selected": 23, "sensitive": 24, "showing": 25, "visible": 30}
# What a control offers besides to be focused.
PASSIVE_ACTIONS = {"SetFocus", "ScrollUp", "ScrollDown", "ScrollLeft", "ScrollRight", "ShowMenu"}
ITEM_ROLES = {"list item", "table cell", "cell", "tree item", "column header", "row header"}


@dataclasses.dataclass(eq=False)
class Node:
    """An accessible object as it was when it was read."""

    bus: str
    path: str
    parent: "Node | None" = None
    role: str = ""
    name: str = ""
    states: frozenset = frozenset()
    box: tuple = (0, 0, 0, 0)  # x, y, width, height on the screen
    actions: tuple = ()
    interfaces: tuple = ()
    children: list = dataclasses.field(default_factory=list)

    def all(self):
        yield self
        for child in self.children:
            yield from child.all()

    def ancestors(self):
        node = self.parent
        while node is not None:
            yield node
            node = node.parent

    @property
    def is_in_sight(self):
        """Whether nothing that it stands in cuts it off, as a panel does that is scrolled."""
        x, y = self.middle
        for above in self.ancestors():
            left, top, width, height = above.box
            if above.role == "combo box":  # its list is a window of its own
                return True
            if any(above.box) and not (left <= x < left + width and top <= y < top + height):
                return False
        return True

    @property
    def middle(self):
        x, y, width, height = self.box
        return x + width // 2, y + height // 2

    @property
    def is_control(self):
        """Whether a person can do something with it, now."""
        return (self.role not in ITEM_ROLES and "showing" in self.states
                and "sensitive" in self.states
                and ("focusable" in self.states or bool(set(self.actions) - PASSIVE_ACTIONS)))

    def __str__(self):
        return f"{self.role} “{self.name}” at {self.box}"


class Accessibility:
    """The bus on which programs tell what they show."""

    def __init__(self):
        session = Gio.bus_get_sync(Gio.BusType.SESSION)
        address = session.call_sync("org.a11y.Bus", "/org/a11y/bus", "org.a11y.Bus", "GetAddress",
                                    None, None, Gio.DBusCallFlags.NONE, CALL_MS).unpack()[0]
        self.connection = Gio.DBusConnection.new_for_address_sync(
            address, Gio.DBusConnectionFlags.AUTHENTICATION_CLIENT
            | Gio.DBusConnectionFlags.MESSAGE_BUS_CONNECTION)
        # The registry counts as a program's assistant only who asks for events.
        self.ask([(REGISTRY, "/org/a11y/atspi/registry", REGISTRY, "RegisterEvent",
                   GLib.Variant("(s)", ("object:state-changed:focused",)))])

    def ask(self, calls):
        """The answers to (bus, path, interface, method, parameters); None where there was none."""
        answers = [None] * len(calls)
        left = len(calls)

        def take(connection, result, place):
            nonlocal left
            left -= 1
            try:
                answers[place] = connection.call_finish(result).unpack()
            except GLib.Error:
                pass  # it is gone meanwhile

        for place, (bus, path, interface, method, parameters) in enumerate(calls):
            self.connection.call(bus, path, interface, method, parameters, None,
                                 Gio.DBusCallFlags.NONE, CALL_MS, None, take, place)
        while left:
            GLib.MainContext.default().iteration(True)
        return answers

    def program(self, process):
        """The bus name of a process; None while it has none."""
        answer = self.ask([(REGISTRY, ROOT, ACCESSIBLE, "GetChildren", None)])[0]
        names = [bus for bus, _ in answer[0]] if answer else []
        calls = [("org.freedesktop.DBus", "/org/freedesktop/DBus", "org.freedesktop.DBus",
                  "GetConnectionUnixProcessID", GLib.Variant("(s)", (name,))) for name in names]
        for name, owner in zip(names, self.ask(calls)):
            if owner and owner[0] == process:
                return name
        return None

    def tree(self, bus, path=ROOT):
        """All that the program shows."""
        top = Node(bus, path)
        level = [top]
        while level:
            self._fill(level)
            below = [node for node in level
                     if node.path == ROOT or "showing" in node.states or node.role == "application"]
            answers = self.ask([(node.bus, node.path, ACCESSIBLE, "GetChildren", None)
                                for node in below])
            level = []
            for node, answer in zip(below, answers):
                node.children = [Node(child_bus, child, node)
                                 for child_bus, child in (answer[0] if answer else [])
                                 if child != NULL]
                level += node.children
        return top

    def _fill(self, nodes):
        kinds = [
            (ACCESSIBLE, "GetRoleName", None), (ACCESSIBLE, "GetState", None),
            ("org.freedesktop.DBus.Properties", "Get", GLib.Variant("(ss)", (ACCESSIBLE, "Name"))),
            ("org.a11y.atspi.Component", "GetExtents", GLib.Variant("(u)", (0,))),
            ("org.a11y.atspi.Action", "GetActions", None), (ACCESSIBLE, "GetInterfaces", None)]
        answers = self.ask([(node.bus, node.path, *kind) for node in nodes for kind in kinds])
        for place, node in enumerate(nodes):
            role, state, name, box, actions, interfaces = answers[6 * place:6 * place + 6]
            node.role = role[0] if role else ""
            node.states = states_of(state)
            node.name = name[0] if name else ""
            node.box = tuple(box[0]) if box else (0, 0, 0, 0)
            node.actions = tuple(action[0] for action in actions[0]) if actions else ()
            node.interfaces = tuple(interfaces[0]) if interfaces else ()

    def read_again(self, node):
        """The node as it is now."""
        self._fill([node, *node.ancestors()])
        return node

    def states(self, nodes):
        """The present states of these."""
        answers = self.ask([(node.bus, node.path, ACCESSIBLE, "GetState", None) for node in nodes])
        return [states_of(answer) for answer in answers]

    def value(self, node):
        """The number of a slider or spin box."""
        answer = self.ask([(node.bus, node.path, "org.freedesktop.DBus.Properties", "Get",
                            GLib.Variant("(ss)", ("org.a11y.atspi.Value", "CurrentValue")))])[0]
        return answer[0] if answer else None

    def text(self, node):
        """The words in a field."""
        answer = self.ask([(node.bus, node.path, "org.a11y.atspi.Text", "GetText",
                            GLib.Variant("(ii)", (0, -1)))])[0]
        return answer[0] if answer else None


def states_of(answer):
    if not answer:
        return frozenset()
    low, high = (list(answer[0]) + [0, 0])[:2]
    bits = low | high << 32
    return frozenset(name for name, place in STATES.items() if bits >> place & 1)


def wait_for(what, condition, limit_s, pause_s=0.1):
    """What the condition gives once it is true; fails with a sentence after the limit."""
    deadline = time.monotonic() + limit_s
    while True:
        found = condition()
        if found:
            return found
        if time.monotonic() > deadline:
            raise AssertionError(f"not within {limit_s} s: {what}")
        time.sleep(pause_s)
