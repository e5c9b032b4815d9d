// The tether from the side or from above, with how far it may be elsewhere, fixes, obstacles and the seabed.
import { add, axes, canvas, legend } from "./svg.js";
import { tick } from "./units.js";

const STDDEVS = 2;
const LONGEST_FORECAST = 5;  // after its time that it is drawn [s]
const CLEARLY = 0.2;  // share of x in the direction of the tether
const SIDES = 16;  // of an ellipse
// Light to dark with the share of the working load, the colour of a limit beyond it.
const RAMP = ["#9ecae1", "#4a90c4", "#225ea8", "#2b2f77"];
const NIGHT_RAMP = ["#2f5d82", "#4a90c4", "#9ecae1", "#eaf4fb"];

export function utilisationColour(share, isNight) {
  if (share >= 1) return "var(--limit)";
  return window.d3.scale.linear().domain([0, 1 / 3, 2 / 3, 1]).range(isNight ? NIGHT_RAMP : RAMP)(Math.max(0, share));
}

// Horizontal direction along the tether that points as x does: what is on the right in plan is on the right in elevation.
// It turns round only when it clearly points the other way.
function chord(position, before) {
  const a = position[0], b = position[position.length - 1];
  const size = Math.hypot(b[0] - a[0], b[1] - a[1]);
  if (size <= 1) return before || [1, 0];
  const u = [(b[0] - a[0]) / size, (b[1] - a[1]) / size];
  const turned = Math.abs(u[0]) < CLEARLY && before ? u[0] * before[0] + u[1] * before[1] < 0 : u[0] < 0;
  return turned ? [-u[0], -u[1]] : u;
}

const VIEWS = {
  elevation: {
    place: (p, origin, u) => [(p[0] - origin[0]) * u[0] + (p[1] - origin[1]) * u[1], p[2]],
    spread: (sd, u) => [Math.hypot(sd[0] * u[0], sd[1] * u[1]), sd[2]]
  },
  plan: {
    place: (p, origin) => [p[0] - origin[0], p[1] - origin[1]],
    spread: (sd) => [sd[0], sd[1]]
  }
};

function ellipse(centre, spread) {
  const points = [];
  for (let k = 0; k < SIDES; ++k) {
    const angle = 2 * Math.PI * k / SIDES;
    points.push([centre[0] + spread[0] * Math.cos(angle), centre[1] + spread[1] * Math.sin(angle)]);
  }
  return points;
}

// The corner points of a box, a cylinder or a sphere (markers 1, 3, 2), turned and in its place.
function outline(marker) {
  const [qx, qy, qz, qw] = marker.orientation, corners = [];
  for (const i of [-0.5, 0.5]) for (const j of [-0.5, 0.5]) for (const k of [-0.5, 0.5]) {
    const v = [i * marker.scale[0], j * marker.scale[1], k * marker.scale[2]];
    const t = [2 * (qy * v[2] - qz * v[1]), 2 * (qz * v[0] - qx * v[2]), 2 * (qx * v[1] - qy * v[0])];
    corners.push([0, 1, 2].map((n) => marker.position[n] + v[n] + qw * t[n] + [qy * t[2] - qz * t[1], qz * t[0] - qx * t[2], qx * t[1] - qy * t[0]][n]));
  }
  return corners;
}

export class ShapeView {
  constructor(section, kind) {
    this.kind = kind;
    this.view = VIEWS[kind];
    this.place = section.querySelector(".chart");
    this.extent = null;
    const place = section.querySelector(".legend");
    if (place) legend(place, [["linear-gradient(90deg," + RAMP.join(",") + ")", "tension, 0 to the working load"], ["var(--limit)", "above it"],
      ["var(--tube)", "may be here (2 standard deviations)"], ["var(--fix)", "measured fixes"],
      ["var(--forecast)", "at the end of the forecast"]]);
  }

  // What is shown grows at once and shrinks slowly, so that the picture does not breathe with the waves.
  bounds(points) {
    const now = [Infinity, -Infinity, Infinity, -Infinity];
    for (const [a, b] of points) {
      now[0] = Math.min(now[0], a); now[1] = Math.max(now[1], a);
      now[2] = Math.min(now[2], b); now[3] = Math.max(now[3], b);
    }
    if (this.kind === "elevation") now[3] = Math.max(now[3], 0);
    const old = this.extent || now;
    this.extent = now.map((value, k) => {
      const grows = k % 2 ? value > old[k] : value < old[k];
      return grows ? value : old[k] + 0.02 * (value - old[k]);
    });
    return this.extent;
  }

  draw(state, scene, isNight, forecast) {
    const picture = canvas(this.place);
    if (!picture || !state || state.position.length < 2) return;
    const { svg, width, height } = picture;
    const origin = state.position[0], u = chord(state.position, this.direction);
    if (this.kind === "elevation" && this.extent && this.direction && u[0] * this.direction[0] + u[1] * this.direction[1] < 0)
      this.extent = [-this.extent[1], -this.extent[0], this.extent[2], this.extent[3]];
    this.direction = u;
    const flat = (p) => this.view.place(p, origin, u);
    const line = state.position.map(flat);
    const spreads = state.position_stddev.map((sd) => this.view.spread(sd.map((value) => STDDEVS * (value || 0)), u));
    const tube = spreads.map((spread, k) => ellipse(line[k], spread));
    const fixes = this.fixes(scene, flat, u);
    const isFresh = forecast && forecast.position && Math.abs(state.t - forecast.t) < LONGEST_FORECAST;
    const ghost = isFresh ? forecast.position.map(flat) : [];
    const extent = this.bounds(line.concat(ghost, ...tube));
    const box = { left: 62, right: width - 24, top: 10, bottom: height - 30 };
    const scale = Math.min((box.right - box.left) / Math.max(1.1 * (extent[1] - extent[0]), 2), (box.bottom - box.top) / Math.max(1.1 * (extent[3] - extent[2]), 2));
    const middle = [(extent[0] + extent[1]) / 2, (extent[2] + extent[3]) / 2];
    const half = [(box.right - box.left) / 2 / scale, (box.bottom - box.top) / 2 / scale];
    const d3 = window.d3;
    const x = d3.scale.linear().domain([middle[0] - half[0], middle[0] + half[0]]).range([box.left, box.right]);
    const y = d3.scale.linear().domain([middle[1] - half[1], middle[1] + half[1]]).range([box.bottom, box.top]);
    const metres = (value) => tick(value, "m");
    axes(svg, x, y, box, { x: metres, y: metres }, { x: width / 90, y: height / 50 });
    const clip = add(add(svg, "clipPath", { id: "clip-" + this.kind }), "rect", { x: box.left, y: box.top, width: box.right - box.left, height: box.bottom - box.top });
    clip.setAttribute("data-kind", this.kind);
    const pen = add(svg, "g", { "clip-path": `url(#clip-${this.kind})` });
    const polygon = (points) => "M" + points.map(([a, b]) => x(a).toFixed(1) + "," + y(b).toFixed(1)).join("L") + "Z";
    if (this.kind === "elevation") {
      add(pen, "line", { class: "surface", x1: box.left, x2: box.right, y1: y(0), y2: y(0) });
      this.drawSeabed(pen, scene, state, flat, x, y);
    }
    for (const marker of scene || []) if (marker.ns === "obstacle")
      add(pen, "path", { class: "obstacle", d: polygon(d3.geom.hull(outline(marker).map(flat))) });
    // One path, so that what overlaps is no darker.
    add(pen, "path", { class: "tube", d: tube.map((points, k) => polygon(d3.geom.hull(k ? points.concat(tube[k - 1]) : points))).join("") });
    if (ghost.length > 1) add(pen, "path", { class: "ghost", d: "M" + ghost.map(([a, b]) => x(a).toFixed(1) + "," + y(b).toFixed(1)).join("L") });
    for (let k = 1; k < line.length; ++k) {
      const share = state.max_tension > 0 && state.working_utilisation > 0
        ? 0.5 * (state.tension[k - 1] + state.tension[k]) * state.working_utilisation / state.max_tension : 0;
      add(pen, "line", { class: "section", x1: x(line[k - 1][0]), y1: y(line[k - 1][1]), x2: x(line[k][0]), y2: y(line[k][1]),
        style: "stroke:" + utilisationColour(share, isNight) });
    }
    for (const fix of fixes) add(pen, "ellipse", { class: "fix", cx: x(fix.at[0]), cy: y(fix.at[1]), rx: Math.max(2, scale * fix.spread[0]), ry: Math.max(2, scale * fix.spread[1]) });
    const first = line[0], last = line[line.length - 1];
    add(pen, "rect", { class: "vessel-mark", x: x(first[0]) - 8, y: y(first[1]) - 8, width: 16, height: 16 });
    add(pen, "circle", { class: "vehicle-mark", cx: x(last[0]), cy: y(last[1]), r: 8 });
  }

  // Each is drawn as three lines of one standard deviation to either side.
  fixes(scene, flat, u) {
    const found = [];
    for (const marker of scene || []) {
      if (marker.ns !== "fixes") continue;
      for (let k = 0; k + 5 < marker.points.length; k += 6) {
        const [west, east, south, north, low, high] = marker.points.slice(k, k + 6);
        const sd = [(east[0] - west[0]) / 2, (north[1] - south[1]) / 2, (high[2] - low[2]) / 2];
        const centre = [(east[0] + west[0]) / 2, (east[1] + west[1]) / 2, (east[2] + west[2]) / 2];
        found.push({ at: flat(centre), spread: this.view.spread(sd, u) });
      }
    }
    return found;
  }

  drawSeabed(pen, scene, state, flat, x, y) {
    const marker = (scene || []).find((m) => m.ns === "seabed" && m.points.length > 0);
    if (!marker) return;
    const profile = state.position.map((p) => {
      let nearest = marker.points[0], least = Infinity;
      for (const q of marker.points) {
        const distance = (q[0] - p[0]) ** 2 + (q[1] - p[1]) ** 2;
        if (distance < least) { least = distance; nearest = q; }
      }
      return [flat(p)[0], nearest[2]];
    }).sort((a, b) => a[0] - b[0]);
    add(pen, "path", { class: "seabed", d: "M" + profile.map(([a, b]) => x(a).toFixed(1) + "," + y(b).toFixed(1)).join("L") });
  }
}
