// What is text: status, figures, the tether, what was learnt, inputs.
import { worst } from "./alarm_list.js";
import { degrees, duration, figures, force, parameterUnit, UNKNOWN, withBand, withUnit } from "./units.js";

const id = (name) => document.getElementById(name);
const WARNING_SHARE = 0.8, LIKELY = 0.5, POSSIBLE = 0.05;
const LATE = 2, GONE = 10, FORECAST_LIFE = 10;  // [s]

export function drawStatus(state, inputs, alarms) {
  const reason = state.reason === "NONE" ? "" : state.reason.toLowerCase().replace(/_/g, " ");
  id("status").dataset.status = state.status;
  id("status-word").textContent = state.status;
  const cause = inputs && reason ? inputs.summary.replace(/^[A-Z]+: /, "") : reason;
  id("status-text").textContent = state.status === "OK" ? "The estimate holds." : cause;
  const found = worst(alarms), badge = id("status-alarm");
  badge.hidden = !found;
  if (!found) return;
  badge.dataset.severity = found.alarm.severity;
  badge.textContent = found.alarm.severity.toUpperCase() + " " + found.alarm.name.replace(/_/g, " ") + (found.more ? ` and ${found.more} more` : "");
}

function level(element, share) {
  element.closest(".figure").dataset.level = share >= 1 ? "limit" : share >= WARNING_SHARE ? "warning" : "";
}

function drawEnd(state, end) {
  const tension = state[end + "_tension"], low = state[end + "_tension_p05"], high = state[end + "_tension_p95"];
  id(end + "-tension").textContent = force(tension);
  id(end + "-band").textContent = low === null ? "uncertainty not known" : "90 % between " + force(low, high) + " and " + force(high);
  level(id(end + "-tension"), state.max_tension > 0 ? state.working_utilisation * tension / state.max_tension : 0);
}

const isOfNow = (forecast, state) => Boolean(forecast) && forecast.members > 0 && Math.abs(state.t - forecast.t) < FORECAST_LIFE;

// What warnings look at, in the same share as they are told in.
function reach(state) {
  if (state.max_tension_p95 === null || !(state.max_tension > 0)) return "";
  return "; 95 % quantile " + force(state.max_tension_p95) + ", " + figures(100 * state.working_utilisation * state.max_tension_p95 / state.max_tension, 2) + " % of it";
}

export function drawFigures(state, forecast) {
  drawEnd(state, "vessel");
  drawEnd(state, "vehicle");
  id("max-tension").textContent = force(state.max_tension);
  id("max-place").textContent = state.max_tension === null ? ""
    : figures(100 * state.working_utilisation, 2) + " % of the working load, at s = " + Math.round(state.max_tension_s) + " m" + reach(state);
  level(id("max-tension"), state.working_utilisation || 0);
  const isThere = isOfNow(forecast, state);
  const probability = isThere ? forecast.probability_over_tension : null;
  id("probability").textContent = probability === null ? UNKNOWN : figures(100 * probability, 2) + " %";
  id("time-to-limit").textContent = !isThere ? "no forecast" : forecast.time_to_limit !== null ? "limit in " + duration(forecast.time_to_limit)
    : "within " + duration(forecast.horizon) + advice(forecast);
  id("forecast-figure").title = isThere ? forecast.members + " members of the ensemble were carried on" : "";
  id("forecast-figure").dataset.level = probability >= LIKELY ? "limit" : probability >= POSSIBLE ? "warning" : "";
}

function advice(forecast) {
  if (forecast.probability_over_tension < POSSIBLE) return "";
  if (forecast.recommended_vessel_speed !== null) return "; improbable at " + withUnit(forecast.recommended_vessel_speed, "m/s");
  return forecast.recommended_payout_rate !== null ? "; improbable at a pay-out of " + withUnit(forecast.recommended_payout_rate, "m/s") : "";
}

export function drawTether(state, forecast, alarms) {
  const turns = (alarms || []).find((alarm) => alarm.name === "turns");
  const known = (value) => value !== null && value !== undefined;
  const rows = [
    ["deployed", withUnit(state.length, "m", 4)], ["pay-out", withUnit(state.payout_rate, "m/s", 2)],
    ["vessel angle", degrees(state.vessel_end_angle)], ["vehicle angle", degrees(state.vehicle_end_angle)],
    ["turns", turns && known(turns.value) ? (turns.value > 0 ? "+" : "") + figures(turns.value, 2) : UNKNOWN],
    ["tightest bend", state.min_bend_radius > 1000 ? "> 1 km" : withUnit(state.min_bend_radius, "m")],
    ["on the seabed", withUnit(state.seabed_contact_length, "m")],
    ["vehicle known to", withUnit(state.vehicle_position_stddev, "m", 2)],
    ["slack ahead", isOfNow(forecast, state) ? figures(100 * forecast.probability_slack, 2) + " %" : UNKNOWN],
    ["of breaking load", known(state.breaking_utilisation) ? figures(100 * state.breaking_utilisation, 2) + " %" : UNKNOWN]];
  id("tether").querySelector("dl").replaceChildren(...rows.flatMap(([term, text]) => {
    const dt = document.createElement("dt"), dd = document.createElement("dd");
    dt.textContent = term;
    dd.textContent = text;
    return [dt, dd];
  }));
}

export function drawParameters(parameters) {
  const section = id("parameters");
  section.querySelector(".empty").textContent = parameters ? "" : "in mode observed only";
  section.querySelector("tbody").replaceChildren(...(parameters || []).filter((p) => p.configured_stddev > 0).map((p) => {
    const row = document.createElement("tr");
    row.title = p.name;
    const unit = parameterUnit(p.name), name = p.name.replace(/^(tether|environment)\./, "").replace(/[._]/g, " ");
    for (const text of [name + (unit ? ` [${unit}]` : ""), withBand(p.mean, p.stddev), withBand(p.configured, p.configured_stddev)])
      row.insertCell().textContent = text;
    return row;
  }));
}

export function drawInputs(state, inputs) {
  const ages = { vessel: state.vessel_age, vehicle: state.vehicle_age };
  const lamps = [["vessel", ages.vessel], ["vehicle", ages.vehicle]].map(([name, age]) => ({ topic: "pose of the " + name, age, refused: "", text: "" }))
    .concat(inputs ? inputs.lamps : []);
  id("inputs").querySelector("ul").replaceChildren(...lamps.map((lamp) => {
    const entry = document.createElement("li"), light = document.createElement("span");
    const kind = lamp.age === null || lamp.age > GONE ? "lost" : lamp.age > LATE || lamp.refused ? "late" : "";
    light.className = "lamp " + kind;
    entry.title = [lamp.text, lamp.refused && "refused: " + lamp.refused].filter(Boolean).join("; ");
    const words = { "": "", late: lamp.refused ? ", some refused" : ", late", lost: ", gone" }[kind];
    entry.append(light, lamp.topic + " " + (lamp.age === null ? "never" : (lamp.age < 10 ? lamp.age.toFixed(1) : Math.round(lamp.age)) + " s") + words);
    return entry;
  }));
}
