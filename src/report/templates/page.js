"use strict";
(() => {
  const all = [...document.querySelectorAll(".claim")];
  const search = document.getElementById("search");
  const boxes = [...document.querySelectorAll("input[name=verdict]")];
  const found = document.getElementById("found");
  const words = new Map(all.map((claim) => [claim, (claim.id + " " + claim.textContent).toLowerCase()]));
  const filter = () => {
    const wanted = search.value.toLowerCase().split(/\s+/).filter(Boolean);
    const verdicts = new Set(boxes.filter((box) => box.checked).map((box) => box.value));
    let count = 0;
    for (const claim of all) {
      const text = words.get(claim);
      const shown = verdicts.has(claim.dataset.verdict) && wanted.every((word) => text.includes(word));
      claim.hidden = !shown;
      count += shown ? 1 : 0;
    }
    found.textContent = count === all.length ? `${count} claims` : `${count} of ${all.length} claims`;
  };
  search.addEventListener("input", filter);
  boxes.forEach((box) => box.addEventListener("change", filter));
  const button = document.getElementById("all");
  button.addEventListener("click", () => {
    const open = button.textContent === "Open all";
    all.forEach((claim) => { claim.open = open; });
    button.textContent = open ? "Close all" : "Open all";
  });
  // a link to a claim opens it, even where a filter hides it
  const land = () => {
    const target = document.getElementById(decodeURIComponent(location.hash.slice(1)));
    if (!target) return;
    if (target.matches("details")) target.open = true;
    target.hidden = false;
    target.scrollIntoView();
  };
  addEventListener("hashchange", land);
  land();
  addEventListener("beforeprint", () => document.querySelectorAll("details.table").forEach((d) => { d.open = true; }));

  const curves = JSON.parse(document.getElementById("curves").textContent);
  const slider = document.getElementById("cut");
  const output = document.getElementById("gain");
  const make = (parent, name, attributes, text) => {
    const node = document.createElementNS("http://www.w3.org/2000/svg", name);
    for (const key in attributes) node.setAttribute(key, attributes[key]);
    if (text !== undefined) node.textContent = text;
    parent.append(node);
    return node;
  };
  const scene = document.getElementById("live-scene");
  const chart = document.getElementById("live-curve");
  // the floor lies in front of the wall, on which the common edge is
  const project = ([x, y, z]) => [62 + 112 * y + 62 * x, 138 - 112 * z + 52 * x - 18 * y];
  const points = (list) => list.map((point) => project(point).join(",")).join(" ");
  const ink = { stroke: "currentColor", "stroke-width": 1.2, "stroke-linejoin": "round" };
  make(scene, "polygon", { ...ink, fill: "currentColor", "fill-opacity": 0.06, points: points([[0, 0, 0], [0, 1, 0], [0, 1, 1], [0, 0, 1]]) });
  const floor = [make(scene, "polygon", { ...ink, fill: "#0072b2", "fill-opacity": 0.35 }), make(scene, "polygon", { ...ink, fill: "#e69f00", "fill-opacity": 0.35 })];
  const line = make(chart, "polyline", { fill: "none", stroke: "#0072b2", "stroke-width": 2.5 });
  const [left, right, top, bottom] = [52, 408, 14, 190];
  make(chart, "path", { d: `M${left} ${top}V${bottom}H${right}`, fill: "none", stroke: "currentColor" });
  for (const x of [0, 0.2, 0.4, 0.6, 0.8, 1]) make(chart, "text", { x: left + x * (right - left), y: bottom + 18, "font-size": 12, "text-anchor": "middle", fill: "currentColor" }, String(x));
  make(chart, "text", { x: right, y: bottom + 34, "font-size": 12, "text-anchor": "end", fill: "currentColor" }, "position of the cut");
  make(chart, "text", { x: left + 6, y: top + 8, "font-size": 12, fill: "currentColor" }, "gain, bits");
  const highest = Math.max(...curves.parallel.map((point) => point[1]));
  for (const y of [0, 0.01, 0.02, 0.03]) make(chart, "text", { x: left - 6, y: bottom - (y / highest) * 0.9 * (bottom - top) + 4, "font-size": 12, "text-anchor": "end", fill: "currentColor" }, String(y));
  const mark = make(chart, "line", { y1: top, y2: bottom, stroke: "#d55e00", "stroke-width": 1.5, "stroke-dasharray": "5 4" });
  const dot = make(chart, "circle", { r: 6, fill: "#d55e00" });
  const place = ([x, y]) => [left + x * (right - left), bottom - (y / highest) * 0.9 * (bottom - top)];
  const at = (curve, x) => {
    const next = curve.findIndex((point) => point[0] >= x);
    if (next <= 0) return curve[Math.max(next, 0)][1];
    const [a, b] = [curve[next - 1], curve[next]];
    return a[1] + (b[1] - a[1]) * (x - a[0]) / (b[0] - a[0]);
  };
  const draw = () => {
    const isParallel = document.querySelector("input[name=direction]:checked").value === "parallel";
    const curve = isParallel ? curves.parallel : curves.orthogonal;
    const x = Number(slider.value);
    const gain = at(curve, x);
    const corner = (a, b) => (isParallel ? [a, b, 0] : [b, a, 0]);
    floor[0].setAttribute("points", points([corner(0, 0), corner(x, 0), corner(x, 1), corner(0, 1)]));
    floor[1].setAttribute("points", points([corner(x, 0), corner(1, 0), corner(1, 1), corner(x, 1)]));
    line.setAttribute("points", curve.map((point) => place(point).join(",")).join(" "));
    const [cx, cy] = place([x, gain]);
    dot.setAttribute("cx", cx); dot.setAttribute("cy", cy);
    mark.setAttribute("x1", cx); mark.setAttribute("x2", cx);
    const share = (100 * gain / highest).toFixed(1);
    const best = isParallel ? `best: ${curves.best.toFixed(10)}, printed ${curves.printed}` : "the best orthogonal cut gains far less than the best parallel one";
    output.textContent = `cut at ${x.toFixed(2)}: ${gain.toFixed(5)} bit, ${share} % of the most a parallel cut gains; ${best}`;
  };
  slider.addEventListener("input", draw);
  document.querySelectorAll("input[name=direction]").forEach((radio) => radio.addEventListener("change", draw));
  draw();
})();
