"""What a person does with mouse and keyboard: events that the X server makes (XTest)."""

import subprocess

MOST_TABS = 150
MOST_ENTRIES = 30  # of a list that drops down
MOST_NOTCHES = 40  # of the wheel


class Hands:
    """Types, and counts what is activated: a press of a button, a choice, a tick."""

    def __init__(self, screen):
        self.screen = screen
        self.activations = 0

    def _do(self, *words):
        subprocess.run(["xdotool", *map(str, words)], check=True, capture_output=True,
                       env={"DISPLAY": self.screen.display, "PATH": "/usr/bin:/bin"})

    def key(self, *keys):
        self._do("key", "--delay", 20, *keys)

    def write(self, words):
        self._do("type", "--delay", 20, words)

    def point_at(self, node):
        self._do("mousemove", *node.middle)

    def click(self, node):
        self.point_at(node)
        self._do("click", 1)

    def give_keyboard(self, window):
        self._do("search", "--onlyvisible", "--name", window, "windowfocus")

    def resize(self, window, size):
        self._do("search", "--onlyvisible", "--name", window, "windowsize", "--sync", *size)

    def wheel(self, down):
        self._do("click", 5 if down else 4)


def arrow_between(one, other):
    """The arrow key that leads from one control towards another."""
    right, down = (b - a for a, b in zip(one.middle, other.middle))
    if abs(right) > abs(down):
        return "Right" if right > 0 else "Left"
    return "Down" if down > 0 else "Up"


class Person:
    """Someone at a window who sees it and has hands."""

    def __init__(self, view, hands):
        self.view = view
        self.hands = hands

    def write_into(self, field, words):
        """What is typed arrives when the program comes to it."""
        self.focus(field)
        self.hands.key("ctrl+a")
        self.hands.write(words)
        self.view.wait_for_text(field, words)

    def enter(self, box, number):
        self.focus(box)
        self.hands.key("ctrl+a")
        self.hands.write(str(number))
        self.hands.key("Return")
        self.view.wait_for_value(box, number)

    def is_on(self, switch):
        self.view.accessibility.read_again(switch)
        return "checked" in switch.states


class WithMouse(Person):
    """Clicks everything that can be clicked."""

    def activate(self, control):
        self.hands.activations += 1
        self.focus(control)

    def focus(self, field):
        self._scroll_to(field)
        self.hands.click(field)

    def _scroll_to(self, control):
        """With the wheel over the scroll bar of the panel that cuts it off."""
        for _ in range(MOST_NOTCHES):
            if control.is_in_sight:
                return
            bar = self.view.scroll_bar_of(control)
            self.hands.point_at(bar)
            self.hands.wheel(control.middle[1] > bar.middle[1])
            self.view.accessibility.read_again(control)
        raise AssertionError(f"cannot be scrolled to: {control}")

    def choose(self, box, entry):
        """An entry of a list that drops down."""
        self.activate(box)
        self.activate(self.view.wait(f"the entry {entry}", role="list item", name=entry))

    def take(self, item):
        """An item of a list."""
        self.activate(item)

    def bring(self, panel):
        """A panel that stands behind others."""
        self.activate(self.view.get(role="page tab", name=panel))


class WithKeyboard(Person):
    """Has no mouse."""

    def activate(self, control):
        self.hands.activations += 1
        if control.role == "radio button":
            self._go_to_radio_button(control)
        else:
            self.focus(control)
            self.hands.key("space")

    def _go_to_radio_button(self, button):
        """Tab comes to the one that is chosen, and arrows go on from there."""
        buttons = [each for each in button.parent.children if each.role == button.role]
        chosen = next(each for each in buttons if "checked" in each.states)
        self.focus(chosen)
        self._press_until(arrow_between(chosen, button), lambda: self.is_on(button), len(buttons),
                          button)

    def _press_until(self, key, is_there, most, what):
        for _ in range(most):
            if self.view.soon(is_there):
                return
            self.hands.key(key)
        if not self.view.soon(is_there):
            raise AssertionError(f"{key} does not come to {what}")

    def focus(self, field):
        if not self.view.tab_until(lambda node: node is not None and node.path == field.path,
                                   self.hands, MOST_TABS):
            raise AssertionError(f"Tab does not come to {field}")

    def choose(self, box, entry):
        self.hands.activations += 2  # as with the mouse: open, and take
        self.focus(box)
        self.hands.key("alt+Down")
        item = self.view.wait(f"the entry {entry}", role="list item", name=entry)
        self.hands.key("Home")
        self._press_until("Down", lambda: self.view.is_selected(item), MOST_ENTRIES, item)
        self.hands.key("Return")

    def take(self, item):
        self.hands.activations += 1
        self.focus(item.parent)
        self.hands.key("Home")

    def bring(self, panel):
        tab = self.view.get(role="page tab", name=panel)
        tabs = [each for each in tab.parent.children if each.role == "page tab"]
        front = next(place for place, each in enumerate(tabs) if "focused" in each.states)
        steps = tabs.index(tab) - front
        if steps:
            self.hands.activations += 1
            self.focus(tab.parent)
            self.hands.key(*["Right" if steps > 0 else "Left"] * abs(steps))
