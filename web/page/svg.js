// Little helpers to draw with.

const SVG = "http://www.w3.org/2000/svg";

export function add(parent, name, attributes = {}, text = null) {
  const element = document.createElementNS(SVG, name);
  for (const key of Object.keys(attributes)) element.setAttribute(key, attributes[key]);
  if (text !== null) element.textContent = text;
  parent.appendChild(element);
  return element;
}

// An empty picture as large as its place; null while that is not shown.
export function canvas(place) {
  const width = place.clientWidth, height = place.clientHeight;
  let svg = place.querySelector("svg");
  if (!svg) svg = add(place, "svg");
  svg.setAttribute("viewBox", `0 0 ${width} ${height}`);
  svg.replaceChildren();
  return width > 40 && height > 40 ? { svg, width, height } : null;
}

export function axes(svg, x, y, box, format, count) {
  const across = add(svg, "g", { class: "axis", transform: `translate(0,${box.bottom})` });
  window.d3.select(across).call(window.d3.svg.axis().scale(x).orient("bottom").ticks(count.x).tickFormat(format.x)
    .innerTickSize(box.top - box.bottom).tickPadding(6));
  const up = add(svg, "g", { class: "axis", transform: `translate(${box.left},0)` });
  window.d3.select(up).call(window.d3.svg.axis().scale(y).orient("left").ticks(count.y).tickFormat(format.y)
    .innerTickSize(box.left - box.right).tickPadding(6));
}

export function legend(place, entries) {
  place.replaceChildren(...entries.map(([colour, text]) => {
    const entry = document.createElement("span"), sample = document.createElement("i");
    sample.style.background = colour;
    entry.append(sample, text);
    return entry;
  }));
}
