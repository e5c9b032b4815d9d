"""The files that tether_replay writes, as arrays."""
import csv
import json
import os

import numpy as np


class ReplayError(Exception):
    """A folder that cannot be reported on; its text says why."""


def number(text):
    return float(text) if text else np.nan


class Table:
    """A CSV file by columns."""

    def __init__(self, path, required):
        try:
            with open(path, newline="", encoding="utf-8") as source:
                rows = list(csv.reader(source))
        except (OSError, UnicodeDecodeError) as error:
            raise ReplayError("cannot read %s: %s" % (path, error)) from error
        if len(rows) < 2:
            raise ReplayError("%s has no rows" % path)
        self.names = rows[0]
        missing = [name for name in required if name not in self.names]
        if missing:
            raise ReplayError("%s has no column %s" % (path, ", ".join(missing)))
        if any(len(row) != len(self.names) for row in rows):
            raise ReplayError("%s: not every row has %d fields" % (path, len(self.names)))
        self.path = path
        self.rows = rows[1:]

    def __contains__(self, name):
        return name in self.names

    def text(self, name):
        k = self.names.index(name)
        return [row[k] for row in self.rows]

    def __getitem__(self, name):
        try:
            return np.array([number(text) for text in self.text(name)])
        except ValueError as error:
            raise ReplayError("%s: column %s: %s" % (self.path, name, error)) from error

    def groups(self, column):
        """Every text of a column, in order of appearance, with the rows that have it."""
        texts = np.array(self.text(column))
        return [(text, texts == text) for text in dict.fromkeys(texts.tolist())]


class ReplayFolder:
    """Tension, shape, alarms, parameters and forecasts of one dive. What a replay did not write is None."""

    def __init__(self, path):
        self.path = path
        if not os.path.isdir(path):
            raise ReplayError("%s is no folder" % path)
        self.ends = Table(self.file("ends.csv"), ["t", "vessel_fx", "vehicle_fx", "max_tension", "max_tension_s", "status"])
        self.t = self.ends["t"]
        self.status = self.ends.text("status")
        self.vessel = self.force("vessel")
        self.vehicle = self.force("vehicle")
        self.alarms = self.optional("alarms.csv", ["t", "name", "state", "severity", "value", "limit", "s"])
        self.parameters = self.optional("parameters.csv", ["t", "name", "mean", "stddev", "configured", "configured_stddev"])
        self.forecast = self.optional("forecast.csv", ["t"])
        self.contacts = self.optional("contacts.csv", ["t", "obstacle", "s"])
        self.inputs = self.optional("inputs.csv", ["t", "topic", "messages", "refused", "delay", "longest_gap"])
        self.shape = self.shapes()
        self.summary = self.summed_up()

    def file(self, name):
        return os.path.join(self.path, name)

    def optional(self, name, required):
        if not os.path.exists(self.file(name)):
            return None
        try:
            return Table(self.file(name), required)
        except ReplayError as error:
            if "has no rows" in str(error):
                return None
            raise

    def force(self, end):
        return np.sqrt(sum(self.ends["%s_f%s" % (end, axis)] ** 2 for axis in "xyz"))

    def summed_up(self):
        try:
            with open(self.file("summary.json"), encoding="utf-8") as text:
                return json.load(text)
        except (OSError, ValueError) as error:
            raise ReplayError("cannot read %s: %s" % (self.file("summary.json"), error)) from error

    def shapes(self):
        table = self.optional("shape.csv", ["t", "s", "x", "y", "z", "tension"])
        return None if table is None else Shapes(table)


class Shapes:
    """Places and tensions along the tether: a row for each time, a column for each station."""

    def __init__(self, table):
        t = table["t"]
        starts = np.flatnonzero(np.r_[True, np.diff(t) > 0.0])
        counts = np.diff(np.r_[starts, len(t)])
        stations = np.bincount(counts).argmax()  # while the mesh is chosen there may be others
        keep = starts[counts == stations]
        index = keep[:, None] + np.arange(stations)[None, :]
        self.t = t[keep]
        self.s, self.x, self.y, self.z, self.tension = (table[name][index] for name in ("s", "x", "y", "z", "tension"))
