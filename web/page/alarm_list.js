// Alarms that are not normal, gravest first; acknowledged or shelved where the server was given a key.
import { duration, valueWithUnit } from "./units.js";

const ORDER = { critical: 0, alarm: 1, warning: 2 };
const WORDS = {
  UNACKNOWLEDGED: "active", ACKNOWLEDGED: "active, acknowledged", RETURNED_UNACKNOWLEDGED: "over, not acknowledged", LATCHED: "latched",
  SHELVED: "shelved", SUPPRESSED_BY_DESIGN: "suppressed", OUT_OF_SERVICE: "out of service"
};
const SHELVING = 600;  // [s]
const isNew = (alarm) => alarm.state === "UNACKNOWLEDGED" || alarm.state === "RETURNED_UNACKNOWLEDGED";

// The gravest that is neither normal nor put aside, and how many more there are.
export function worst(alarms) {
  const active = alarms.filter((alarm) => ["UNACKNOWLEDGED", "ACKNOWLEDGED", "RETURNED_UNACKNOWLEDGED", "LATCHED"].includes(alarm.state))
    .sort((a, b) => ORDER[a.severity] - ORDER[b.severity] || isNew(b) - isNew(a));
  return active.length ? { alarm: active[0], more: active.length - 1 } : null;
}

function cell(row, text, small = "") {
  const td = row.insertCell();
  td.textContent = text;
  if (small) {
    const quiet = document.createElement("small");
    quiet.textContent = small;
    td.appendChild(quiet);
  }
  return td;
}

export class AlarmList {
  // act(action, name, seconds)
  constructor(section, act) {
    this.body = section.querySelector("tbody");
    this.act = act;
    this.mayAct = false;
    this.drawn = "";
  }

  draw(alarms, now) {
    const shown = alarms.filter((alarm) => alarm.state !== "NORMAL")
      .sort((a, b) => isNew(b) - isNew(a) || ORDER[a.severity] - ORDER[b.severity] || a.onset - b.onset);
    // Only when something has changed: a button must not move away under the finger.
    const drawn = JSON.stringify([shown, this.mayAct, Math.floor(now / 5)]);
    if (drawn === this.drawn) return;
    this.drawn = drawn;
    this.body.replaceChildren();
    for (const alarm of shown) this.row(alarm, now);
    if (!shown.length) cell(this.body.insertRow(), "no alarm").colSpan = 7;
  }

  row(alarm, now) {
    const row = this.body.insertRow();
    row.title = alarm.text;
    row.className = isNew(alarm) ? "unacknowledged" : "";
    const mark = document.createElement("span");
    mark.className = "priority " + alarm.severity;
    mark.textContent = alarm.severity;
    row.insertCell().appendChild(mark);
    const notes = [WORDS[alarm.state], alarm.first_out ? "came first" : "", alarm.chattering ? "chatters" : ""].filter(Boolean).join(", ");
    cell(row, alarm.name.replace(/_/g, " "), notes);
    cell(row, valueWithUnit(alarm.value, alarm.unit), alarm.s === null ? "" : "s = " + Math.round(alarm.s) + " m").className = "value";
    cell(row, valueWithUnit(alarm.limit, alarm.unit)).className = "value";
    cell(row, valueWithUnit(alarm.peak, alarm.unit)).className = "value";
    cell(row, duration(alarm.onset > 0 ? now - alarm.onset : null)).className = "value";
    const actions = row.insertCell();
    if (alarm.advice) {
      const advice = this.body.insertRow();
      advice.className = "advice";
      advice.insertCell();
      cell(advice, alarm.advice).colSpan = 6;
    }
    if (!this.mayAct) return;
    actions.className = "actions";
    const choices = alarm.state === "SHELVED" ? [["Unshelve", "unshelve", 0]]
      : [isNew(alarm) ? ["Acknowledge", "acknowledge", 0] : null, alarm.state === "LATCHED" ? ["Reset", "reset", 0] : null,
         ["Shelve", "shelve", SHELVING]].filter(Boolean);
    for (const [text, action, seconds] of choices) {
      const button = document.createElement("button");
      button.textContent = text;
      button.dataset.action = action;
      button.title = action === "shelve" ? "for ten minutes" : "";
      button.addEventListener("click", () => this.act(action, alarm.name, seconds));
      actions.appendChild(button);
    }
  }
}

export function countNew(alarms) {
  return alarms.filter(isNew).length;
}

export function gravest(alarms) {
  const fresh = alarms.filter(isNew).map((alarm) => ORDER[alarm.severity]);
  return fresh.length ? Math.min(...fresh) : null;
}
