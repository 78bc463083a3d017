"""What has to hold in each window: names, the order of Tab, the share of the picture."""

# Reached by the arrow keys once one of them has the focus, so that Tab passes by.
BY_ARROWS = {"radio button", "page tab"}
# Texts that can be selected by mouse; a button beside them copies.
NO_STOPS = {"label", "scroll bar"}
# What is read as one before the eye goes on: a box with a title, a bar, a floating or docked panel.
PANE_ROLES = {"panel", "tool bar", "status bar", "frame", "dialog"}
MOST_TABS = 120
MOST_LOST = 2  # presses after which nothing that is known has the focus


def without_name(nodes):
    """Controls that tell nobody what they are. A scroll bar moves only what it stands beside."""
    return [f"has no name: {node}" for node in nodes
            if node.is_control and node.role not in NO_STOPS and not node.name.strip()]


def overlap(low, length, other_low, other_length):
    return min(low + length, other_low + other_length) - max(low, other_low)


def in_one_row(one, other):
    """Whether two controls stand beside each other: they share more than half of the lower one's
    height. Controls of one row have unequal heights (a box beside a button); rows beneath each
    other share nothing but a pixel or two of a frame."""
    shared = overlap(one.box[1], one.box[3], other.box[1], other.box[3])
    return 2 * shared > min(one.box[3], other.box[3])


def pane_of(node):
    """The innermost pane that the control stands in, beneath its window."""
    return next((above for above in node.ancestors()
                 if above.role in PANE_ROLES and above.parent is not None
                 and above.parent.role != "application"), None)


def follows(before, after):
    """Whether a reader comes to the one after the other: in one pane to the right in the row, or
    to a lower row; from pane to pane to the right, or down."""
    pane, next_pane = pane_of(before), pane_of(after)
    if pane is next_pane and pane is not None:
        if in_one_row(before, after):
            return after.box[0] >= before.box[0]
        return after.box[1] >= before.box[1]
    one, other = (pane or before).box, (next_pane or after).box
    return other[0] >= one[0] + one[2] or other[1] >= one[1] + one[3] or contains(one, other) or contains(other, one)


def contains(outer, inner):
    """A box with a title around what is read with it, or a picture and what lies over its edge."""
    return (outer[0] <= inner[0] and outer[1] <= inner[1]
            and outer[0] + outer[2] >= inner[0] + inner[2]
            and outer[1] + outer[3] >= inner[1] + inner[3])


def walk(view, hands):
    """The controls that Tab goes through, until it comes back to the first."""
    nodes = [node for node in view.controls() if "focusable" in node.states]
    if len(nodes) == 1:  # as in a trainee's window: there is nowhere else to go
        hands.key("Tab")
        return nodes, nodes if view.soon(lambda: view.focused(nodes)) else []
    last = view.focused(nodes)
    first = at = view.press_and_see("Tab", hands, nodes, last)
    stops, lost = [], 0
    while len(stops) < MOST_TABS and lost < MOST_LOST:
        lost = lost + 1 if at is None else 0
        stops += [] if at is None else [at]
        last = at or last  # where Tab does not lead on from, nothing moves
        at = view.press_and_see("Tab", hands, nodes, last)
        if at is not None and at is first:
            break
    return nodes, stops


def out_of_order(stops):
    """Steps of Tab against the order of reading.

    The stops are a ring, and the walk begins wherever the keyboard was. So one of its steps leads
    from the last control of the window back to the first, and is no fault: where a single step
    leads back, it is that one, because read from behind it every step follows. Of two, one at
    least is a fault, and both are named. Not found is a single step back in a ring whose own way
    back `follows` takes for one to the right or down, as from a low pane to a high one beside it.
    """
    steps = [(one, other) for one, other in zip(stops, stops[1:] + stops[:1])
             if not follows(one, other)]
    backward = [f"Tab goes from {one} to {other}" for one, other in steps]
    return backward if len(backward) > 1 else []


def not_reached(nodes, stops):
    return [f"Tab never comes to {node}" for node in nodes
            if not any(node is stop for stop in stops) and node.role not in NO_STOPS
            and not (node.role in BY_ARROWS and "checked" not in node.states)]


def share_of(picture, window, cover=None):
    """Without what lies over its edge."""
    covered = cover.box[2] * cover.box[3] if cover else 0
    return (picture.box[2] * picture.box[3] - covered) / (window.box[2] * window.box[3])
