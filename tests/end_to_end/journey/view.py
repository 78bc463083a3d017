"""The windows of one program, as its person sees them."""

from seen import ITEM_ROLES, Accessibility, wait_for

STARTS_S = 180  # on a busy machine: a patient is made first
ANSWERS_S = 90
MOVES_S = 10
SOON_S = 0.7


class View:
    def __init__(self, accessibility, computer):
        self.accessibility: Accessibility = accessibility
        self.computer = computer
        self.bus = None

    def connect(self):
        """Finds the program once it shows something."""
        self.bus = wait_for(f"{self.computer.name} is on the accessibility bus",
                            lambda: self._running() and self.accessibility.program(
                                self.computer.process.pid), STARTS_S)

    def _running(self):
        if self.computer.process.poll() is not None:
            raise AssertionError(f"{self.computer.name} has ended by itself, status "
                                 f"{self.computer.process.returncode}")
        return True

    def tree(self):
        return self.accessibility.tree(self.bus)

    def all(self):
        """All that is in sight: panels behind others lie outside of the screen."""
        return [node for node in self.tree().all()
                if "showing" in node.states and self._is_on_screen(node)]

    def _is_on_screen(self, node):
        width, height = self.computer.screen.size
        return (node.box[0] < width and node.box[1] < height
                and node.box[0] + node.box[2] > 0 and node.box[1] + node.box[3] > 0)

    def reachable(self):
        """All that is in sight, or comes there when its panel is scrolled."""
        return [node for node in self.tree().all() if "showing" in node.states
                and (self._is_on_screen(node) or self._is_scrolled_away(node))]

    def _is_scrolled_away(self, node):
        pane = next((above for above in node.ancestors() if above.role == "frame"), None)
        return node.role != "frame" and pane is not None and self._is_on_screen(pane)

    def find(self, **wanted):
        """The first that is shown and is alike; a name may be a function that tells."""
        return next((node for node in self.reachable() if is_like(node, **wanted)), None)

    def wait(self, what, limit_s=ANSWERS_S, **wanted):
        return wait_for(f"{self.computer.name} shows {what}",
                        lambda: self._running() and self.find(**wanted), limit_s)

    def get(self, **wanted):
        """What is about to be used: it comes when the program has the time."""
        return self.wait(", ".join(f"{key} {value}" for key, value in wanted.items()), **wanted)

    def wait_ready(self, what, limit_s=ANSWERS_S, **wanted):
        """That it can be used, too."""
        def ready():
            node = self._running() and self.find(**wanted)
            return node if node and "sensitive" in node.states else None
        return wait_for(f"{self.computer.name} lets {what} be used", ready, limit_s)

    def wait_for_text(self, field, words):
        wait_for(f"{field} has “{words}”",
                 lambda: self.accessibility.text(field) == words, ANSWERS_S)

    def wait_for_value(self, box, number):
        wait_for(f"{box} has {number}",
                 lambda: abs((self.accessibility.value(box) or 0) - number) < 1e-6, ANSWERS_S)

    def is_selected(self, item):
        return "selected" in self.accessibility.states([item])[0]

    @staticmethod
    def soon(is_there):
        """Whether it becomes true before a person would press once more."""
        try:
            return wait_for("", is_there, SOON_S, 0.02)
        except AssertionError:
            return False

    def beside(self, label, role):
        """The control of this role to the right of a label."""
        nodes = self.reachable()
        words = next(node for node in nodes if is_like(node, role="label", name=label))
        return next(node for node in nodes if node.role == role and node.box[0] > words.box[0]
                    and abs(node.middle[1] - words.middle[1]) < node.box[3] / 2)

    def scroll_bar_of(self, control):
        """That of the nearest panel that has one."""
        for above in control.ancestors():
            for node in above.children:
                bar = next((each for each in node.all() if each.role == "scroll bar"
                            and node is not control), None)
                if bar is not None:
                    return bar
        raise AssertionError(f"no scroll bar for {control}")

    def words(self):
        """All names and texts that are shown."""
        return [node.name for node in self.all() if node.name]

    def controls(self):
        """What can be used, also where Tab scrolls its panel first. Tabs of panels that are shut lie
        outside of the window, in no panel."""
        return [node for node in self.reachable() if node.is_control
                and (self._is_on_screen(node) or self._is_in_panel(node))]

    @staticmethod
    def _is_in_panel(node):
        """Whether a frame within that of its window holds it."""
        return any(above.role == "frame" and above.parent is not None
                   and above.parent.role != "application" for above in node.ancestors())

    def focused(self, nodes):
        """Whichever has the keyboard. Tabs say so of the page that is in front, whoever has it, and
        the chosen item of a list says so beside its list."""
        nodes = [node for node in nodes if node.role not in {"page tab", *ITEM_ROLES}]
        for node, states in zip(nodes, self.accessibility.states(nodes)):
            if "focused" in states:
                return node
        return None

    def tab_until(self, is_there, hands, most, key="Tab"):
        """Presses the key until the focused control is the wanted one."""
        nodes = [node for node in self.controls() if "focusable" in node.states]
        at = self.focused(nodes)
        for _ in range(most):
            if is_there(at):
                return at
            at = self.press_and_see(key, hands, nodes, at)
        return None

    def press_and_see(self, key, hands, nodes, before):
        """The control that has the focus after a key that moves it."""
        hands.key(key)
        try:
            return wait_for("the focus moves", lambda: self._moved(nodes, before), MOVES_S, 0.02)
        except AssertionError:
            return None

    def _moved(self, nodes, before):
        now = self.focused(nodes)
        return now if now is not None and now is not before else None


def is_like(node, role=None, name=None, begins=None, has=None, role_in=None, line=None):
    return ((role is None or node.role == role) and (role_in is None or node.role in role_in) and (name is None or node.name == name)
            and (begins is None or node.name.startswith(begins))
            and (has is None or has in node.name)
            and (line is None or line in node.name.splitlines()))
