"""Breathing as it is seen: how often per minute pictures of a patient come and go."""

import math
import time

SIDE = 64  # pixels of a picture that is looked at
PART = 50  # the fiftieth part of them is compared
SLOWEST, FASTEST, STEP = 8.0, 45.0, 0.25  # breaths per minute that are tried


class Film:
    """Small grey pictures of a region of a screen, with their times."""

    def __init__(self, screen, box):
        self.screen = screen
        self.box = box
        self.times = []
        self.pictures = []

    def take(self):
        x, y, width, height = self.box
        picture = self.screen.picture().crop((x, y, x + width, y + height))
        self.times.append(time.monotonic())
        self.pictures.append(list(picture.convert("L").resize((SIDE, SIDE)).getdata()))


def film(screens_and_boxes, seconds, pause_s=0.1):
    """Films of several screens over the same time."""
    films = [Film(screen, box) for screen, box in screens_and_boxes]
    end = time.monotonic() + seconds
    while time.monotonic() < end:
        for each in films:
            each.take()
        time.sleep(pause_s)
    return films


def difference(one, other):
    """Difference of two pictures, in grey levels: the mean over the part that differs most. A chest
    is a small part of a picture, and the rest of it is still."""
    most = sorted((abs(a - b) for a, b in zip(one, other)), reverse=True)[:len(one) // PART]
    return sum(most) / len(most)


def course(pictures):
    """One number for each picture: how far it is along what changes most among them."""
    count, size = len(pictures), len(pictures[0])
    mean = [sum(picture[i] for picture in pictures) / count for i in range(size)]
    moved = [[value - middle for value, middle in zip(picture, mean)] for picture in pictures]
    # The first principal component, from the small matrix of products.
    products = [[sum(a * b for a, b in zip(one, other)) for other in moved] for one in moved]
    along = [1.0 + i % 3 for i in range(count)]
    for _ in range(60):
        along = [sum(row[i] * along[i] for i in range(count)) for row in products]
        length = math.sqrt(sum(value * value for value in along)) or 1.0
        along = [value / length for value in along]
    return along


def unexplained(times, values, rate):
    """What two harmonics of a rate leave of the values: sum of squares."""
    angle = 2 * math.pi * rate / 60
    columns = [[1.0] * len(times)]
    for harmonic in (1, 2):
        columns.append([math.cos(harmonic * angle * t) for t in times])
        columns.append([math.sin(harmonic * angle * t) for t in times])
    left = list(values)
    basis = []
    for column in columns:
        for other in basis:
            shared = sum(a * b for a, b in zip(column, other))
            column = [a - shared * b for a, b in zip(column, other)]
        length = math.sqrt(sum(a * a for a in column))
        if length < 1e-6:
            continue
        column = [a / length for a in column]
        basis.append(column)
        shared = sum(a * b for a, b in zip(left, column))
        left = [a - shared * b for a, b in zip(left, column)]
    return sum(value * value for value in left)


def rate_of(one):
    """Breaths per minute in a film."""
    began = one.times[0]
    times = [t - began for t in one.times]
    values = course(one.pictures)
    rates = [SLOWEST + STEP * i for i in range(int((FASTEST - SLOWEST) / STEP) + 1)]
    return min(rates, key=lambda rate: unexplained(times, values, rate))


def spread(one):
    """How much the pictures of a film differ from its first, in grey levels."""
    return max(difference(one.pictures[0], picture) for picture in one.pictures)


def apart(one, other):
    """How far the most alike pictures of two films are, in grey levels."""
    return min(difference(a, b) for a in one.pictures for b in other.pictures)
