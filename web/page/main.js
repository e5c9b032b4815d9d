// Keeps the newest of every kind of message and draws it; covers the page when nothing new comes.
import { AlarmList, gravest } from "./alarm_list.js";
import { drawFigures, drawInputs, drawParameters, drawStatus, drawTether } from "./panels.js";
import { ShapeView } from "./shape_view.js";
import { Sound } from "./sound.js";
import { TensionChart } from "./tension_chart.js";

const id = (name) => document.getElementById(name);
const SILENCE = 1500;     // [ms] until the page is covered
const RECONNECT = 1000;   // [ms]
// Alarms whose limits are shares of a load: which, and what to call them.
const LIMITS = {
  over_tension_warning: ["working_utilisation", "warning"], over_tension: ["working_utilisation", "limit"], breaking: ["breaking_utilisation", "breaking"]
};

const latest = {};
let socket = null, heard = 0, isLost = false, isDirty = false;

function setLight(light) {
  document.documentElement.dataset.light = light;
  id("night").textContent = light === "night" ? "Day" : "Night";
}
const stored = () => { try { return localStorage.getItem("light"); } catch { return null; } };
const query = new URLSearchParams(location.search).get("light");
setLight(query || stored() || (matchMedia("(prefers-color-scheme: dark)").matches ? "night" : "day"));
id("night").addEventListener("click", () => {
  const light = document.documentElement.dataset.light === "night" ? "day" : "night";
  setLight(light);
  try { localStorage.setItem("light", light); } catch { /* it is asked for again the next time */ }
  isDirty = true;
});

const chart = new TensionChart(id("tension"));
const views = [new ShapeView(id("elevation"), "elevation"), new ShapeView(id("plan"), "plan")];
const sound = new Sound(id("sound"));
const alarms = new AlarmList(id("alarms"), (action, name, seconds) =>
  socket.send(JSON.stringify({ action, name, seconds, key: id("key").value })));
id("key-form").addEventListener("submit", (event) => event.preventDefault());

const take = {
  welcome(values) {
    id("monitor").textContent = values.monitor;
    document.title = values.monitor;
    alarms.mayAct = values.may_act;
    id("key-form").hidden = !values.may_act;
  },
  history(values) { chart.begin(values); },
  state(values) { chart.append(values); },
  pulse(values) {
    isLost = values.lost;
    socket.send(JSON.stringify({ frame: values.frame }));
  },
  alarms() { warn(); },
  answer(values) { id("answer").textContent = (values.succeeded ? "Done: " : "Not done: ") + values.text; }
};

function connect() {
  const scheme = location.protocol === "https:" ? "wss:" : "ws:";
  socket = new WebSocket(`${scheme}//${location.host}/live`);
  socket.onmessage = (event) => {
    const { kind, values } = JSON.parse(event.data);
    heard = performance.now();
    latest[kind] = values;
    if (take[kind]) take[kind](values);
    isDirty = true;
  };
  socket.onclose = () => setTimeout(connect, RECONNECT);
}

function cover() {
  const isSilent = performance.now() - heard > SILENCE;
  id("cover").hidden = !isSilent && !isLost && Boolean(latest.state);
  id("cover-word").textContent = isSilent ? "No connection" : "The monitor is silent";
  id("cover-text").textContent = isSilent ? "The server of this page does not answer. Nothing below is of now."
    : "No new estimate. Take the tether for over-tensioned until it is back.";
}

// In N, where the tension is largest.
function forceLimits(known, state) {
  return known.filter((alarm) => LIMITS[alarm.name] && alarm.limit !== null && state[LIMITS[alarm.name][0]] > 0).map((alarm) => {
    const [utilisation, text] = LIMITS[alarm.name];
    return { value: alarm.limit * state.max_tension / state[utilisation], text };
  });
}

function draw() {
  const state = latest.state;
  if (!state) return;
  const known = latest.alarms || [];
  const limits = forceLimits(known, state);
  const isNight = document.documentElement.dataset.light === "night";
  id("clock").textContent = state.t > 1e8 ? new Date(1000 * state.t).toISOString().slice(11, 19) + " UTC" : state.t.toFixed(0) + " s";
  drawStatus(state, latest.inputs, known);
  drawFigures(state, latest.forecast);
  drawTether(state, latest.forecast, latest.alarms);
  drawParameters(latest.parameters);
  drawInputs(state, latest.inputs);
  alarms.draw(known, state.t);
  chart.draw(state, latest.forecast, limits);
  views.forEach((view) => view.draw(state, latest.scene, isNight, latest.forecast));
}

// Silence is as grave as anything. Also called with every message: timers of a page in the background are slow.
function warn() {
  const isBlind = latest.state && !id("cover").hidden;
  sound.update(isBlind ? 0 : latest.alarms ? gravest(latest.alarms) : null);
}

function refresh() {
  cover();
  warn();
  if (!isDirty || document.hidden) return;
  isDirty = false;
  try {
    draw();
  } catch (error) {
    console.error(error);
    id("cover").hidden = false;
    id("cover-word").textContent = "This page has failed";
    id("cover-text").textContent = "What is below may be of any time. Load the page again.";
  }
}

connect();
setInterval(refresh, 200);
