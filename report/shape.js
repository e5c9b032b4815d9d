// Plan and elevation of the tether at the time of the slider.
"use strict";
(function () {
  const data = JSON.parse(document.getElementById("shape-data").textContent);
  const slider = document.getElementById("shape-time");
  const label = document.getElementById("shape-label");
  const views = [
    { canvas: document.getElementById("shape-elevation"), across: "r", up: "z", names: ["horizontal distance from the vessel [m]", "z [m]"] },
    { canvas: document.getElementById("shape-plan"), across: "x", up: "y", names: ["x from the vessel [m]", "y [m]"] }];
  const most = data.most;

  function tickStep(span) {
    const raw = span / 6, power = Math.pow(10, Math.floor(Math.log10(raw)));
    return [1, 2, 5, 10].map((k) => k * power).find((step) => step >= raw);
  }

  function draw(view, frame) {
    const canvas = view.canvas, pen = canvas.getContext("2d");
    const width = canvas.width, height = canvas.height, margin = 60;
    const box = data.box[view.across + view.up];
    const scale = Math.min((width - 2 * margin) / (box[1] - box[0]), (height - 2 * margin) / (box[3] - box[2]));
    const x = (a) => margin + (a - box[0]) * scale;
    const y = (b) => height - margin - (b - box[2]) * scale;
    pen.fillStyle = "white";
    pen.fillRect(0, 0, width, height);
    pen.font = "17px sans-serif";
    pen.fillStyle = "#333";
    pen.strokeStyle = "#ddd";
    const step = tickStep(Math.max(box[1] - box[0], box[3] - box[2]));
    pen.beginPath();
    for (let a = Math.ceil(box[0] / step) * step; a <= box[1]; a += step) {
      pen.moveTo(x(a), margin); pen.lineTo(x(a), height - margin);
      pen.fillText(String(Math.round(a * 1e6) / 1e6), x(a) - 8, height - margin + 22);
    }
    for (let b = Math.ceil(box[2] / step) * step; b <= box[3]; b += step) {
      pen.moveTo(margin, y(b)); pen.lineTo(width - margin, y(b));
      pen.fillText(String(Math.round(b * 1e6) / 1e6), 4, y(b) + 4);
    }
    pen.stroke();
    pen.fillText(view.names[0], width / 2 - 120, height - 8);
    pen.fillText(view.names[1], 4, margin - 16);
    const across = frame[view.across], up = frame[view.up];
    pen.lineWidth = 3;
    for (let i = 1; i < across.length; ++i) {
      const share = Math.min(1, frame.tension[i] / most);
      pen.strokeStyle = "hsl(205,75%," + (78 - 60 * share) + "%)";
      pen.beginPath();
      pen.moveTo(x(across[i - 1]), y(up[i - 1]));
      pen.lineTo(x(across[i]), y(up[i]));
      pen.stroke();
    }
    pen.fillStyle = "#0072B2";
    pen.fillRect(x(across[0]) - 6, y(up[0]) - 6, 12, 12);
    pen.fillStyle = "#E69F00";
    pen.beginPath();
    pen.arc(x(across[across.length - 1]), y(up[up.length - 1]), 6, 0, 2 * Math.PI);
    pen.fill();
  }

  function show() {
    const frame = data.frames[Number(slider.value)];
    views.forEach((view) => draw(view, frame));
    const largest = Math.max(...frame.tension);
    label.textContent = "t = " + frame.t.toFixed(1) + " s, largest tension " + (largest / data.size).toPrecision(3) + " " + data.unit;
  }

  slider.max = data.frames.length - 1;
  slider.addEventListener("input", show);
  show();
})();
