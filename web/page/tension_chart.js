// Tension at both ends a minute back, and the forecast half a minute ahead.
import { add, axes, canvas, legend } from "./svg.js";
import { force, tick } from "./units.js";

const BACK = 60, AHEAD = 30;  // [s]
const TEXT_HEIGHT = 18;

const isKnown = (value) => value !== null && value !== undefined;

export class TensionChart {
  constructor(section) {
    this.place = section.querySelector(".chart");
    legend(section.querySelector(".legend"), [["var(--vessel)", "vessel end"], ["var(--vehicle)", "vehicle end"],
      ["var(--forecast)", "largest along the tether, forecast"], ["var(--limit)", "limits of the alarms"]]);
    this.legend = section.querySelector(".legend");
    this.past = [];
  }

  begin(history) { this.past = history; }

  append(state) {
    const last = this.past[this.past.length - 1];
    if (last && state.t < last.t) this.past = [];
    this.past.push(state);
    while (state.t - this.past[0].t > BACK) this.past.shift();
  }

  // What the axis has to reach: not a limit that is far away.
  top(forecast, limits) {
    let most = 1;
    for (const p of this.past) for (const name of ["vessel_tension", "vessel_tension_p95", "vehicle_tension", "vehicle_tension_p95", "max_tension"])
      if (isKnown(p[name])) most = Math.max(most, p[name]);
    if (forecast) for (const name of ["median", "p95"]) most = Math.max(most, ...forecast[name].filter(isKnown).slice(0, 60), 1);
    const lowest = Math.min(...limits.map((limit) => limit.value));
    return 1.08 * (Number.isFinite(lowest) && lowest < 3 * most ? Math.max(most, lowest) : most);
  }

  draw(state, forecast, limits) {
    const picture = canvas(this.place);
    if (!picture || !state) return;
    const { svg, width, height } = picture;
    const box = { left: 78, right: width - 28, top: 12, bottom: height - 30 };
    const top = this.top(forecast, limits);
    const d3 = window.d3;
    const x = d3.scale.linear().domain([-BACK, AHEAD]).range([box.left, box.right]);
    const y = d3.scale.linear().domain([0, top]).range([box.bottom, box.top]);
    axes(svg, x, y, box, { x: (t) => (t > 0 ? "+" : "") + t + " s", y: (n) => top >= 1000 ? tick(n, "kN", 1000) : tick(n, "N") },
      { x: width / 70, y: height / 50 });
    for (const end of ["vessel", "vehicle"]) {
      const name = end + "_tension";
      const at = (p) => x(p.t - state.t);
      add(svg, "path", { class: "band " + end, d: d3.svg.area().defined((p) => isKnown(p[name + "_p05"]) && isKnown(p[name + "_p95"]))
        .x(at).y0((p) => y(p[name + "_p05"])).y1((p) => y(p[name + "_p95"]))(this.past) || "" });
      add(svg, "path", { class: "curve " + end, d: d3.svg.line().defined((p) => isKnown(p[name])).x(at).y((p) => y(p[name]))(this.past) || "" });
    }
    if (forecast && forecast.members > 0) {
      const points = forecast.time.map((t, k) => ({ t: forecast.t + t - state.t, low: forecast.p05[k], mid: forecast.median[k], high: forecast.p95[k] }))
        .filter((p) => p.t >= 0 && p.t <= AHEAD && isKnown(p.low) && isKnown(p.high) && isKnown(p.mid));
      const at = (p) => x(p.t), held = (value) => y(Math.min(value, top));
      add(svg, "path", { class: "band forecast", d: d3.svg.area().x(at).y0((p) => held(p.low)).y1((p) => held(p.high))(points) || "" });
      add(svg, "path", { class: "curve forecast", d: d3.svg.line().x(at).y((p) => held(p.mid))(points) || "" });
    }
    add(svg, "line", { class: "now", x1: x(0), x2: x(0), y1: box.top, y2: box.bottom });
    for (const limit of limits) {
      if (limit.value > top) continue;
      add(svg, "line", { class: "limit", x1: box.left, x2: box.right, y1: y(limit.value), y2: y(limit.value) });
      const above = y(limit.value) - 5, isRoom = above - TEXT_HEIGHT > 0;
      add(svg, "text", { class: "limit-text", x: box.left + 8, y: isRoom ? above : above + TEXT_HEIGHT + 7 }, limit.text + " " + force(limit.value));
    }
  }
}
