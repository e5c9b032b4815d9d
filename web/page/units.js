// Numbers as people read them: three figures and a unit.

export const UNKNOWN = "–";

export function figures(value, count = 3) {
  if (value === null || value === undefined || !Number.isFinite(value)) return UNKNOWN;
  if (value === 0) return "0";
  const whole = Math.floor(Math.log10(Math.abs(value))) + 1;
  return whole > count ? String(Math.round(value)) : value.toFixed(Math.min(Math.max(count - whole, 0), 6));
}

export function withUnit(value, unit, count) {
  const text = figures(value, count);
  return text === UNKNOWN || !unit || unit === "-" ? text : text + " " + unit;
}

// N or kN: whichever its largest companion wants, so that what stands together can be compared.
export function force(value, companion = value) {
  const size = Math.max(Math.abs(value || 0), Math.abs(companion || 0));
  return size >= 1000 ? withUnit(value === null ? null : value / 1000, "kN") : withUnit(value, "N");
}

// Of an axis: no more digits than the number has.
export function tick(value, unit, divisor = 1) {
  return (String(Number((value / divisor).toPrecision(6))) + " " + unit).trim();
}

export function degrees(angle) {
  return angle === null ? UNKNOWN : figures(angle * 180 / Math.PI) + "°";
}

export function valueWithUnit(value, unit) {
  if (unit === "N") return force(value);
  if (unit.startsWith("fraction of")) return value === null ? UNKNOWN : figures(100 * value) + " %";
  if (unit === "rad") return degrees(value);
  return value === null ? UNKNOWN : tick(Number(value.toPrecision(3)), unit === "-" ? "" : unit);
}

// With as many decimals as its standard deviation has in two figures.
export function withBand(value, stddev) {
  if (value === null || stddev === null) return UNKNOWN;
  const decimals = stddev > 0 ? Math.min(Math.max(1 - Math.floor(Math.log10(stddev)), 0), 6) : 3;
  return value.toFixed(decimals) + " ± " + stddev.toFixed(decimals);
}

// Of what the estimator has learnt; drag coefficients and the factor on the vehicle's drag have none.
const PARAMETER_UNITS = [[/^environment\.current/, "m/s"], [/^vehicle\.force|^tension\.bias/, "N"], [/mass_per_length$/, "kg/m"], [/length$/, "m"]];

export function parameterUnit(name) {
  const found = PARAMETER_UNITS.find(([pattern]) => pattern.test(name));
  return found ? found[1] : "";
}

export function duration(seconds) {
  if (seconds === null || !Number.isFinite(seconds)) return UNKNOWN;
  if (seconds < 100) return Math.round(seconds) + " s";
  return seconds < 6000 ? Math.round(seconds / 60) + " min" : figures(seconds / 3600) + " h";
}
