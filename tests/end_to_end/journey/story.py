"""The journey: what happens in it, in the order in which it happens."""

import pathlib
import re
import time

import breathing
import checks
from computers import Computer, make_switch
from hands import Hands, WithKeyboard, WithMouse
from seen import Accessibility, wait_for
from view import ANSWERS_S, STARTS_S, View

MOST_CLICKS = 5  # from the start page to the first breath
LEAST_SHARE = {"1280x800": 0.5, "1920x1080": 0.666}  # of the picture in the console's window
BACK_S = 5.0
MEANT_S = 0.8  # between two presses that are not to be a slip
ADULT = "Man of 30 years, 175 cm"
RATE = 24  # breaths per minute, after the change
RATE_TOLERANCE = 0.1  # of a film of FILM_S at the few pictures a second of a busy machine
FILM_S = 14
BREATHES = 6.0  # grey levels that a breath moves at least (a quiet one of the adult: 23)
STILL = 1.5  # grey levels that nothing moves more than
ALIKE = 6.0  # grey levels between the most alike pictures of two who see the same
CODE = re.compile(r"[0-9A-Z]{5}-[0-9A-Z]{5}")
PORT = re.compile(r"port (\d+)")
CONDITION = "Pneumothorax, tension"
SEVERITY = 0.9
DEVELOPS_S = 150  # in which gas enters the chest with every breath
CHANGED = 6.0  # grey levels that pictures differ at least, at the most alike moments of breathing
PANELS = ["Lungs", "Gas", "Airway", "Move", "Parts", "Tracker", "Breathing", "Waves", "Vitals",
          "Try", "People", "Network", "Invite"]
CONSOLE, TRAINEE, JOINING = "Carina instructor", "Carina trainee", "Join a session"
WINDOWS = ("frame", "dialog", "filler")
PAUSED, CONNECTING = "Paused", "Connecting to the instructor"
SHOWN, NOT_SHOWN = "The instructor shows", "Shown to everybody until"


class Story:
    def __init__(self, asked, folder):
        self.asked = asked
        self.size = tuple(int(side) for side in asked.size.split("x"))
        self.pictures = pathlib.Path(asked.pictures) if asked.pictures else None
        if self.pictures:
            self.pictures.mkdir(parents=True, exist_ok=True)
        self.steps = 0
        self.faults = []
        make_switch()
        accessibility = Accessibility()
        self.console = self._person("console", 1, folder, accessibility)
        self.trainees = [self._person(f"trainee{n}", n + 1, folder, accessibility)
                         for n in (1, 2)]

    def _person(self, name, number, folder, accessibility):
        computer = Computer(name, number, self.size, folder)
        kind = WithKeyboard if self.asked.keyboard else WithMouse
        return kind(View(accessibility, computer), Hands(computer.screen))

    def tell(self):
        self.fill_the_start_page()
        codes = self.begin()
        for number, trainee in enumerate(self.trainees, start=1):
            self.join(trainee, f"Trainee {number}", codes["trainees"])
        self.first_breath()
        self.look_at_every_panel()
        self.change_the_rate()
        self.change_a_condition()
        self.cut_a_part()
        self.pause()
        self.kill_and_resume()
        self.end()
        self.begin_another()
        if self.faults:
            raise AssertionError("\n".join(self.faults))
        print("the whole journey is done")

    # What happens

    def fill_the_start_page(self):
        console = self.console
        self.start(console, self.asked.instructor, CONSOLE)
        console.view.wait_ready("a session to begin", STARTS_S, name="Begin the session")
        self.look_at("the start page", console)
        console.hands.activations = 0
        console.choose(console.view.get(role="combo box"), ADULT)
        console.activate(console.view.get(role="radio button", name="This network"))

    def begin(self):
        console = self.console
        console.view.wait("who is chosen", STARTS_S, has="Adult")
        console.activate(console.view.wait_ready("a session to begin", STARTS_S,
                                                 name="Begin the session"))
        self.come_to_the_console()
        self.check_share()
        self.look_at("the console", console)
        codes = {}
        for role in ("trainees", "observers"):
            shown = console.view.wait(f"the code for {role}", begins=f"Code for {role}")
            codes[role] = CODE.search(shown.name).group()
        return codes

    def join(self, trainee, name, code):
        self.start(trainee, self.asked.trainee, JOINING)
        trainee.view.wait("the session that was found", ANSWERS_S, role="list item",
                          has="Routine intubation")
        for field, words in (("Your name", name), ("Code", code)):
            trainee.write_into(trainee.view.get(role="text", name=field), words)
        self.look_at("the join window", trainee)
        trainee.activate(trainee.view.wait_ready("to join", name="Join", role="push button"))
        trainee.view.wait("the session", STARTS_S, has="Waiting for the instructor to start")
        wait_for(f"{name} has the session's patient", lambda: not any(
            "The session's patient" in words for words in trainee.view.words()), STARTS_S)
        self.open(trainee, TRAINEE)
        self.look_at("the trainee's window", trainee)
        present = 2 + self.trainees.index(trainee)  # with the instructor
        self.console.view.wait(f"that {name} is here", role="page tab",
                               has=f"participants: {present}")

    def first_breath(self):
        console = self.console
        console.activate(console.view.get(role="push button", name="Start"))
        console.view.wait("that it runs", has="● Running")
        films = self.film_all()
        for person, each in zip([console, *self.trainees], films):
            assert breathing.spread(each) > BREATHES, f"{person.view.computer.name}: nobody breathes"
        clicks = console.hands.activations
        print(f"activations from the start page to the first breath: {clicks}")
        if clicks > MOST_CLICKS:
            self.faults.append(f"{clicks} activations to the first breath, {MOST_CLICKS} at most")
        self.compare_trainees("breathing", films[1:])
        self.keep("first breath")

    def change_the_rate(self):
        console = self.console
        self.bring("Breathing")
        self.type_number("Breathing rate, breaths per minute", RATE)
        self.settle()
        for person, each in zip([console, *self.trainees], self.film_all()):
            rate = breathing.rate_of(each)
            print(f"{person.view.computer.name} breathes {rate:.1f}/min in its pictures")
            if abs(rate - RATE) > RATE_TOLERANCE * RATE:
                self.faults.append(f"{person.view.computer.name}: {rate:.1f} instead of {RATE}")
        self.keep("rate changed")

    def settle(self, seconds=3):
        """For as long as a breath that began before may take: the change holds from the next."""
        end = time.monotonic() + seconds
        wait_for("a breath is over", lambda: time.monotonic() > end, 2 * seconds)

    def change_a_condition(self):
        console = self.console
        before = self.film_all(FILM_S / 2)
        self.bring("Lungs")
        console.activate(console.view.get(role="push button", name="Add another condition"))
        kind = console.view.wait("the kind", role="combo box", name="ARDS")
        console.choose(kind, CONDITION)
        self.type_number("Severity of the condition, 0 to 1", SEVERITY)
        console.view.wait("the condition in force", has=f"Condition: {CONDITION}")
        for trainee, one in zip(self.trainees, before[1:]):
            try:
                wait_for("the condition is seen", lambda: self.has_changed(trainee, one), DEVELOPS_S)
            except AssertionError:
                self.faults.append(f"{trainee.view.computer.name}: the condition is not seen")
        self.compare_trainees("ill", self.film_all(FILM_S / 2)[1:])
        self.keep("condition changed")

    def has_changed(self, person, before):
        """Whether the picture is another than in a film of before, at any moment of a breath. Over the
        console's lies what needs attention, so that it tells nothing."""
        box = self.picture_of(person).box
        after = breathing.film([(person.view.computer.screen, box)], FILM_S / 2)[0]
        changed = breathing.apart(before, after)
        print(f"{person.view.computer.name}: ill and healthy are {changed:.2f} levels apart")
        return changed > CHANGED

    def cut_a_part(self):
        """What is shown before and after differs in nothing but the cut."""
        self.bring("Parts")
        self.show_to_trainees()
        boxes = [self.above_the_notice(trainee) for trainee in self.trainees]
        before = self.film_trainees(boxes)
        self.console.choose(self.console.view.beside("Cut", "combo box"), "Everything")
        for trainee in self.trainees:
            trainee.view.wait("what the instructor shows", has=f"{SHOWN}: section")
        self.settle(1)
        after = self.film_trainees(boxes)
        self.compare_trainees("cut", after)
        for trainee, one, other in zip(self.trainees, before, after):
            changed = breathing.apart(one, other)
            print(f"{trainee.view.computer.name}: cut and whole are {changed:.2f} levels apart")
            if changed < CHANGED:
                self.faults.append(f"{trainee.view.computer.name}: the cut is not seen")
        self.keep("section shown")

    def show_to_trainees(self):
        """Until they say so, and look from where the instructor does."""
        show = self.console.view.get(begins="Show what you see to")
        if not self.console.is_on(show):
            self.console.activate(show)
        for trainee in self.trainees:
            trainee.view.wait("that the instructor shows something", has=SHOWN)
        self.settle()

    def above_the_notice(self, trainee):
        """The picture without its lower edge, where the notice is, and could have a line more."""
        notice = trainee.view.wait("what the instructor shows", has=SHOWN)
        x, y, width, _ = self.picture_of(trainee).box
        return x, y, width, notice.box[1] - notice.box[3] - y

    def film_trainees(self, boxes):
        return breathing.film([(trainee.view.computer.screen, box)
                               for trainee, box in zip(self.trainees, boxes)], FILM_S / 4)

    def pause(self):
        self.console.activate(self.console.view.wait_ready("to pause", role="push button",
                                                           name="Pause"))
        for trainee in self.trainees:
            trainee.view.wait("that it is paused", has=PAUSED)
        for person, each in zip(self.trainees, self.film_all(FILM_S / 2)[1:]):
            moved = breathing.spread(each)
            if moved > STILL:
                self.faults.append(f"{person.view.computer.name}: moves {moved:.2f} levels in a pause")
        self.keep("paused")

    def kill_and_resume(self):
        console = self.console
        before = self.port()
        console.view.computer.kill()
        for trainee in self.trainees:
            trainee.view.wait("that it is paused and looks for the instructor",
                              has=f"{PAUSED}. {CONNECTING}")
        self.keep("console killed")
        self.start(console, self.asked.instructor, CONSOLE)
        session = console.view.wait("the earlier session", STARTS_S, role="list item",
                                    has="Routine intubation")
        if not console.view.soon(lambda: console.view.is_selected(session)):
            self.faults.append("the start page has not chosen the only earlier session")
        self.look_at("the start page with an earlier session", console)
        console.take(session)
        console.view.wait("who can join it, as before", has="find the session by its name")
        console.activate(console.view.wait_ready("to resume", name="Resume"))
        console.view.wait("the console", STARTS_S, has="join at port")
        began = time.monotonic()
        for trainee in self.trainees:
            trainee.view.wait("that it is back", ANSWERS_S, line=PAUSED)
            back = time.monotonic() - began
            print(f"{trainee.view.computer.name} is back {back:.1f} s after the console's window")
            if back > BACK_S:
                self.faults.append(f"{trainee.view.computer.name} came back after {back:.1f} s")
        after = self.port()
        print(f"resumed at port {after}, before {before}")
        if after == before:
            self.faults.append("resumed at the same port, which shows nothing")
        console.view.wait("the patient of before", has="Patient: Adult")
        console.view.wait("that nothing is shown any more", has=NOT_SHOWN)
        for trainee in self.trainees:
            wait_for("nothing is said to be shown", lambda: not any(
                SHOWN in words for words in trainee.view.words()), ANSWERS_S)
        self.open(console, CONSOLE)
        self.check_share()  # also beside the sentence over its edge
        self.keep("resumed")

    def end(self):
        console = self.console
        console.activate(console.view.get(role="push button", name="End"))
        question = console.view.wait("the question", role="push button", name="Really end?")
        self.settle(MEANT_S)
        console.activate(question)
        console.view.wait("what happened", ANSWERS_S, name="The session has ended")
        self.open(console, CONSOLE)
        for trainee in self.trainees:
            trainee.view.wait("that it has ended", has="The session has ended")
            trainee.view.wait("a way on", role="push button", name="Join another session")
        self.look_at("the end page", console)
        self.look_at("the trainee's window at the end", self.trainees[0])

    def begin_another(self):
        console = self.console
        console.activate(console.view.get(role="push button", name="New session"))
        begin = console.view.wait_ready("another session to begin", STARTS_S, name="Begin the session")
        self.open(console, CONSOLE)
        # Nothing is open to others but what a person opens: each new session anew.
        console.activate(console.view.get(role="radio button", name="This network"))
        self.keep("start page again")
        console.activate(begin)
        console.activate(self.come_to_the_console())
        console.view.wait("that it runs", has="● Running")
        trainee = self.trainees[0]
        trainee.activate(trainee.view.get(role="push button", name="Join another session"))
        trainee.view.wait("the window to join", ANSWERS_S, role="push button", name="Join")
        trainee.view.wait("the new session", ANSWERS_S, role="list item", has="Routine intubation")
        self.keep("another session")

    # What it is made of

    def come_to_the_console(self):
        start = self.console.view.wait("the console", STARTS_S, role="push button", name="Start")
        self.open(self.console, CONSOLE)
        return start

    def start(self, person, program, window):
        person.view.computer.start(program)
        person.view.connect()
        self.open(person, window)

    def open(self, person, window):
        """A new window gets the keyboard, and the whole screen, as from a window manager."""
        shown = person.view.wait("its window", STARTS_S, role_in=WINDOWS, name=window)
        if shown.role != "dialog":
            person.hands.resize(window, self.size)
        person.hands.give_keyboard(window)

    def bring(self, panel):
        self.console.bring(panel)
        self.console.view.wait(f"the panel {panel}", role="frame", name=panel)

    def type_number(self, name, number):
        self.console.enter(self.console.view.get(role="spin box", name=name), number)

    def port(self):
        status = self.console.view.wait("its port", has="join at port")
        return PORT.search(status.name).group(1)

    def film_all(self, seconds=FILM_S):
        """The pictures of the patient on all three screens over the same time."""
        people = [self.console, *self.trainees]
        return breathing.film([(person.view.computer.screen, self.picture_of(person).box)
                               for person in people], seconds)

    @staticmethod
    def picture_of(person):
        return person.view.wait("the patient", begins="Patient, three-dimensional view")

    def compare_trainees(self, what, films):
        apart = breathing.apart(*films)
        print(f"{what}: the trainees' pictures are {apart:.2f} levels apart")
        if apart > ALIKE:
            self.faults.append(f"{what}: the trainees' pictures are {apart:.2f} levels apart")

    def check_share(self):
        view = self.console.view
        window = view.wait("its window", role="frame", name=CONSOLE)
        share = checks.share_of(self.picture_of(self.console), window,
                                view.find(name="What needs attention"))
        print(f"the picture has {share:.3f} of the window at {self.asked.size}")
        if share < LEAST_SHARE.get(self.asked.size, 0.5):
            self.faults.append(f"the picture has only {share:.3f} of the window")

    def look_at_every_panel(self):
        for panel in PANELS:
            self.bring(panel)
            self.look_at(f"the panel {panel}", self.console)

    def look_at(self, what, person):
        """Names and the order of Tab, and a picture."""
        self.keep(what, [person])
        faults = checks.without_name(person.view.all())
        nodes, stops = checks.walk(person.view, person.hands)
        faults += checks.out_of_order(stops) + checks.not_reached(nodes, stops)
        self.faults += [f"{what}: {fault}" for fault in faults]
        print(f"{what}: {len(stops)} stops of Tab, {len(faults)} faults")

    def keep(self, what, people=None):
        self.steps += 1
        if not self.pictures:
            return
        for person in people or [self.console, *self.trainees]:
            name = f"{self.steps:02} {what} {person.view.computer.name}.png".replace(" ", "-")
            person.view.computer.screen.picture().save(self.pictures / name.replace("'", ""))
