// The interactive views of a page. Each takes its data from views.py and draws with Plotly.
"use strict";

const COLORS = ["#1f5fa8", "#c0392b", "#2e8b57", "#d98200", "#7d4fa3", "#6b6b6b", "#00868b", "#8b5a2b"];
const STATES = [[0, "#f4f4f4"], [0.3333, "#f4f4f4"], [0.3333, "#1f5fa8"], [0.6667, "#1f5fa8"], [0.6667, "#c0392b"], [1, "#c0392b"]];
const VIEWS = {};  // by id: what was drawn, for other views and for tests

const CONFIG = {responsive: true, displaylogo: false};
const FONT = {family: "sans-serif", size: 12};

function control(view, label, element) {
  const holder = document.createElement("label");
  holder.append(label + " ", element);
  document.querySelector(`#${view.id} .controls`).append(holder);
  return element;
}

function choice(view, name, label, options, redraw) {
  const select = document.createElement("select");
  select.name = name;
  for (const [value, text] of options) select.add(new Option(text, value));
  select.onchange = redraw;
  return options.length > 1 ? control(view, label, select) : select;
}

function slider(view, name, least, most, step, value, describe, redraw) {
  const input = document.createElement("input"), text = document.createElement("output");
  Object.assign(input, {type: "range", name, min: least, max: most, step, value});
  const show = () => { text.textContent = describe(Number(input.value)); };
  input.oninput = () => { show(); redraw(); };
  show();
  if (most > least) control(view, "", input).parentNode.append(text);
  return input;
}

function tickbox(view, name, label, checked, redraw) {
  const input = document.createElement("input");
  Object.assign(input, {type: "checkbox", name, checked});
  input.onchange = redraw;
  control(view, label, input);
  return input;
}

function plotOf(view) { return document.querySelector(`#${view.id} .plot`); }

// the part of the width that one of n pictures side by side takes, with room for the scale on the right
function domain(k, n) {
  const gap = 0.09, width = (1 - gap * (n - 1)) / n;
  return [k * (width + gap), k * (width + gap) + width];
}

function tickOf(source, number) { return source.ticks[Math.min(number, source.ticks.length - 1)]; }

// the patches with some room around their edges, in which the blocks of the nodes around them lie as a whole
function limits(ticks) {
  const ends = (k, places) => {
    const values = ticks.flatMap(t => t.edge[k].filter(v => v !== null)), low = Math.min(...values), high = Math.max(...values);
    const room = Math.max(0.05 * (high - low), ...ticks.map(t => 1.5 * Math.abs(t[places][1] - t[places][0])));
    return [low - room, high + room];
  };
  return {s: ends(0, "s").reverse(), along: ends(1, "along")};
}

function scaleOf(field) {
  if (field.kind === "states") return {zmin: 0, zmax: 2, colorscale: STATES, colorbar: {tickvals: [0.33, 1, 1.67], ticktext: ["open", "stick", "slip"]}};
  if (field.kind === "signed") return {zmin: -field.top, zmax: field.top, colorscale: "RdBu", reversescale: false};
  return {zmin: 0, zmax: field.top, colorscale: field.key === "pressure" ? "Viridis" : "YlOrRd", reversescale: true};
}

// arrows of the shear traction as one line with gaps
function arrows(tick, top) {
  const x = [], y = [], dz = Math.abs(tick.along[1] - tick.along[0]), ds = Math.abs(tick.s[1] - tick.s[0]);
  const rows = Math.max(1, Math.round(1 / dz)), columns = Math.max(1, Math.round(1 / ds)), length = 1.5 * rows * dz / top;
  for (let i = 0; i < tick.along.length; i += rows)
    for (let j = 0; j < tick.s.length; j += columns) {
      const a = tick.fields.shear_along[i][j], l = tick.fields.shear_lateral[i][j];
      if (a === null || Math.hypot(a, l) < 0.03 * top) continue;
      const u = l * length, v = a * length, X = tick.s[j] + u, Y = tick.along[i] + v;
      x.push(tick.s[j], X, X - 0.35 * u + 0.15 * v, null, X, X - 0.35 * u - 0.15 * v, null);
      y.push(tick.along[i], Y, Y - 0.35 * v - 0.15 * u, null, Y, Y - 0.35 * v + 0.15 * u, null);
    }
  return {x, y, mode: "lines", line: {color: "#1a1a1a", width: 1.1}, hoverinfo: "skip", showlegend: false};
}

function sides(id) {
  const common = {xref: `x${id} domain`, yref: `y${id} domain`, y: 1.02, yanchor: "bottom", showarrow: false, font: {color: "#6b6b6b", size: 12}};
  return [{...common, x: 0, xanchor: "left", text: "<b>G.C.</b>"}, {...common, x: 1, xanchor: "right", text: "<b>F.S.</b>"}];
}

// all around the patch, to be laid over the blocks of the outermost nodes, half of which lie beyond its edge
function around(edge, range) {
  const [s0, s1] = range.s, [z0, z1] = range.along, ds = s0 - s1, dz = z1 - z0;
  let path = `M${s0 + ds},${z0 - dz}L${s1 - ds},${z0 - dz}L${s1 - ds},${z1 + dz}L${s0 + ds},${z1 + dz}Z`, open = true;
  edge[0].forEach((s, k) => {
    if (s === null) { path += "Z"; open = true; return; }
    path += `${open ? "M" : "L"}${s},${edge[1][k]}`;
    open = false;
  });
  return path;
}

// values of the loaded nodes, with those of their neighbours in the ring around them
function widened(rows) {
  const at = (i, j) => rows[i] === undefined || rows[i][j] === undefined ? null : rows[i][j];
  return rows.map((row, i) => row.map((value, j) => {
    if (value !== null && value !== 0) return value;
    for (const [a, b] of [[1, 0], [-1, 0], [0, 1], [0, -1], [1, 1], [-1, 1], [1, -1], [-1, -1]]) {
      const near = at(i + a, j + b);
      if (near !== null && near !== 0) return near;
    }
    return value;
  }));
}

// the rail head with the patch, the gauge side on the left as in the maps; returns the height that it takes
function railHead(head, traces, layout, id, from, to) {
  const axes = {xaxis: "x" + id, yaxis: "y" + id, hoverinfo: "skip", showlegend: false}, [x, y] = head.rail;
  const right = Math.max(...x) + 4, left = Math.min(...x) - 4;
  traces.push({x, y, mode: "lines", fill: "toself", fillcolor: "#e9edf2", line: {color: "#6b6b6b", width: 1.5}, ...axes});
  traces.push({x: head.patch[0], y: head.patch[1], mode: "lines", line: {color: "#c0392b", width: 6}, ...axes});
  traces.push({x: [head.face[0]], y: [head.face[1]], mode: "markers", marker: {color: "#6b6b6b", symbol: "line-ns-open", size: 12}, ...axes});
  layout["xaxis" + id] = {domain: [0, 0.42], range: [right, left], title: "X from the running circle [mm]", zeroline: false, anchor: "y" + id};
  layout["yaxis" + id] = {domain: [from, to], range: [-30, 6], zeroline: false, scaleanchor: "x" + id, anchor: "x" + id, constrain: "domain", showticklabels: false};
  const words = head.words.replaceAll(", ", ",<br>");
  layout.annotations.push({xref: "paper", yref: "paper", x: 0.46, y: (from + to) / 2, xanchor: "left", yanchor: "middle", showarrow: false, align: "left", text: `<b>Patch on the rail head</b><br>${words}`},
    {xref: "x" + id, yref: "y" + id, x: right, y: 5, xanchor: "left", yanchor: "top", showarrow: false, text: "gauge side", font: {color: "#6b6b6b", size: 11}},
    {xref: "x" + id, yref: "y" + id, x: left, y: 5, xanchor: "right", yanchor: "top", showarrow: false, text: "field side", font: {color: "#6b6b6b", size: 11}});
}

function patchMaps(view, field, number, withArrows) {
  const n = view.sources.length, ticks = view.sources.map(source => tickOf(source, number)), range = limits(ticks);
  const traces = [], layout = {font: FONT, margin: {l: 55, r: 20, t: 60, b: 50}, annotations: [], shapes: [], showlegend: false};
  const shear = view.fields.find(f => f.key === "shear");
  ticks.forEach((tick, k) => {
    const id = k ? String(k + 1) : "", axes = {xaxis: "x" + id, yaxis: "y" + id};
    const scale = scaleOf(field), bar = {title: {text: field.unit ? `${field.label}, up to ${field.top} ${field.unit}` : field.label, side: "right"}, thickness: 14, ...scale.colorbar};
    traces.push({type: "heatmap", x: tick.s, y: tick.along, z: widened(tick.fields[field.key]), ...scale, ...axes, colorbar: bar, showscale: k === n - 1, hoverongaps: false,
      hovertemplate: "s %{x} mm, along %{y} mm<br>%{text}<extra></extra>",
      text: tick.fields[field.key].map(row => row.map(v => field.kind === "states" ? ["open", "stick", "slip"][v] : v === null ? "open" : `${v} ${field.unit}`))});
    traces.push({x: tick.edge[0], y: tick.edge[1], mode: "lines", line: {color: "black", width: 1.5}, hoverinfo: "skip", ...axes});
    if (withArrows) traces.push({...arrows(tick, shear.top), ...axes});
    if (field === shear)
      traces.push({x: [tick.peak_shear[0]], y: [tick.peak_shear[1]], mode: "markers", marker: {color: "#1f5fa8", symbol: "cross-thin-open", size: 12, line: {width: 2}}, ...axes,
        hovertemplate: `peak ${tick.peak_shear[2]} MPa<extra></extra>`, showlegend: false});
    layout["xaxis" + id] = {domain: domain(k, n), range: range.s, title: "lateral s [mm]", zeroline: false, anchor: "y" + id, constrain: "domain"};
    layout["yaxis" + id] = {range: range.along, title: k ? "" : "along the rail, rolling direction \u2191 [mm]", zeroline: false, scaleanchor: "x" + id, anchor: "x" + id, constrain: "domain"};
    layout.shapes.push({type: "path", path: around(tick.edge, range), fillrule: "evenodd", fillcolor: "white", line: {width: 0}, xref: "x" + id, yref: "y" + id});
    const dash = {type: "line", line: {color: "#1a3fbf", width: 1, dash: "dash"}};
    layout.shapes.push({...dash, xref: "x" + id, yref: "y" + id, x0: tick.places.AA, x1: tick.places.AA, y0: range.along[0], y1: range.along[1]});
    layout.shapes.push({...dash, xref: "x" + id, yref: "y" + id, x0: range.s[0], x1: range.s[1], y0: tick.places.BB, y1: tick.places.BB});
    const mark = {showarrow: false, font: {color: "#1a3fbf", size: 11}, xref: "x" + id, yref: "y" + id};
    layout.annotations.push({...mark, x: tick.places.AA, y: range.along[0], text: "AA", yanchor: "bottom", xanchor: "right"});
    layout.annotations.push({...mark, x: range.s[1], y: tick.places.BB, text: "BB", yanchor: "bottom", xanchor: "right"});
    if (view.sources[k].name)
      layout.annotations.push({xref: "paper", yref: "paper", x: (domain(k, n)[0] + domain(k, n)[1]) / 2, y: 1, yshift: 26, xanchor: "center", yanchor: "bottom", showarrow: false, text: `<b>${view.sources[k].name}</b>`});
    layout.annotations.push(...sides(id));
  });
  const width = plotOf(view).clientWidth, ratio = (range.along[1] - range.along[0]) / (range.s[0] - range.s[1]);
  layout.height = Math.round(Math.min(640, Math.max(300, 120 + ratio * (width - 160) / n)));
  const head = ticks[0].head;
  if (head) {
    const room = 230, part = room / (layout.height + room);  // the part of the height that the head takes
    ticks.forEach((_, k) => { layout["yaxis" + (k ? String(k + 1) : "")].domain = [part + 0.06, 1]; });
    layout.height += room;
    railHead(head, traces, layout, "9", 0, part - 0.08);
  }
  return [traces, layout];
}

function patchSurfaces(view, field, number) {
  const n = view.sources.length, traces = [], layout = {font: FONT, margin: {l: 0, r: 0, t: 30, b: 10}, height: 500, annotations: []};
  view.sources.forEach((source, k) => {
    const tick = tickOf(source, number), id = k ? String(k + 1) : "", scale = scaleOf(field), range = limits([tick]);
    const height = field.kind === "states" ? view.fields.find(f => f.key === "pressure") : field;  // stick and slip colour the pressure
    const states = field === height ? null : widened(tick.fields.state);  // ends at the patch: no third state between slip and open
    const z = tick.fields[height.key].map((row, i) => row.map((v, j) => states && !states[i][j] ? null : v ?? 0)), low = height.kind === "signed" ? -height.top : 0;
    const x = range.s[0] - range.s[1], y = range.along[1] - range.along[0], most = Math.max(x, y);
    traces.push({type: "surface", x: tick.s, y: tick.along, z, surfacecolor: states ?? z, scene: "scene" + id,
      cmin: scale.zmin, cmax: scale.zmax, colorscale: scale.colorscale, reversescale: scale.reversescale, showscale: k === n - 1,
      colorbar: {title: {text: field.unit ? `${field.label}, up to ${field.top} ${field.unit}` : field.label, side: "right"}, thickness: 14, ...scale.colorbar},
      hovertemplate: `s %{x} mm, along %{y} mm<br>%{z} ${height.unit}<extra></extra>`});
    layout["scene" + id] = {domain: {x: domain(k, n)}, aspectmode: "manual",
      aspectratio: {x: 1.3 * x / most, y: 1.3 * y / most, z: 0.7}, camera: {eye: {x: 1.2, y: -1.7, z: 1.0}, center: {x: 0, y: 0, z: -0.12}},
      xaxis: {title: "s [mm]", range: range.s}, yaxis: {title: "along [mm]", range: range.along},
      zaxis: {title: `${height.label} [${height.unit}]`, range: [low, Math.max(height.top, ...z.flat())]}};
    if (source.name) layout.annotations.push({xref: "paper", yref: "paper", x: (domain(k, n)[0] + domain(k, n)[1]) / 2, y: 1, xanchor: "center", yanchor: "bottom", showarrow: false, text: `<b>${source.name}</b>`});
  });
  return [traces, layout];
}

async function drawPatch(view) {
  const most = Math.max(...view.sources.map(source => source.ticks.length)) - 1;
  const longest = view.sources.find(source => source.ticks.length === most + 1);
  const redraw = () => {
    const field = view.fields.find(f => f.key === fieldChoice.value), number = Number(tick.value);
    const [traces, layout] = surface.checked ? patchSurfaces(view, field, number) : patchMaps(view, field, number, arrowBox.checked);
    return Plotly.react(plotOf(view), traces, layout, CONFIG);
  };
  const fieldChoice = choice(view, "field", "Field", view.fields.map(f => [f.key, f.label]), redraw);
  const tick = slider(view, "tick", 0, most, 1, view.start, k => longest.ticks[k].label, redraw);
  const arrowBox = tickbox(view, "arrows", "Arrows of shear", false, redraw);
  const surface = tickbox(view, "surface", "Three-dimensional", false, redraw);
  VIEWS[view.id] = view;
  return redraw();
}

// points [position, value] of a field on a line of the patch, interpolated between the rows of nodes; on AA also the points
// between nodes at which shear peaks
function onLine(tick, key, plane, place) {
  const across = plane === "AA" ? tick.s : tick.along;
  let k = 0;
  while (k < across.length - 2 && across[k + 1] <= place) ++k;
  const w = Math.min(1, Math.max(0, (place - across[k]) / (across[k + 1] - across[k])));
  const value = (i, j) => (plane === "AA" ? tick.fields[key][i][j] : tick.fields[key][j][i]) ?? 0;
  const points = (plane === "AA" ? tick.along : tick.s).map((x, i) => [x, (1 - w) * value(i, k) + w * value(i, k + 1)]);
  if (plane === "AA")
    tick.between.lateral.forEach((s, i) => {
      if (Math.abs(s - place) < 0.5 * Math.abs(tick.s[1] - tick.s[0])) points.push([tick.between.along[i], tick.between[key][i]]);
    });
  return points.sort((a, b) => a[0] - b[0]);
}

async function drawCuts(view) {
  const patch = VIEWS[view.patch], most = Math.max(...patch.sources.map(source => source.ticks.length)) - 1;
  const longest = patch.sources.find(source => source.ticks.length === most + 1);
  const range = limits(patch.sources.flatMap(source => source.ticks));
  let place;
  const settle = () => {  // the slider of the place follows the plane
    const own = tickOf(patch.sources[0], Number(tick.value)).places[plane.value], ends = plane.value === "AA" ? range.s.slice().reverse() : range.along;
    Object.assign(place, {min: Math.ceil(20 * ends[0]) / 20, max: Math.floor(20 * ends[1]) / 20, step: 0.01, value: own});
    place.oninput();
  };
  const redraw = () => {
    const traces = [], AA = plane.value === "AA", number = Number(tick.value);
    patch.sources.forEach((source, k) => {
      const t = tickOf(source, number), name = source.name ? ", " + source.name : "";
      const line = key => onLine(t, key, plane.value, Number(place.value));
      const style = {mode: "lines+markers", marker: {size: 4}, line: {color: COLORS[k], width: 2}, hovertemplate: "%{x} mm: %{y:.6} MPa<extra>%{fullData.name}</extra>"};
      const pressure = line("pressure"), x = pressure.map(p => p[0]);
      traces.push({x, y: pressure.map(p => p[1]), name: "pressure" + name, ...style});
      traces.push({x, y: line("shear").map(p => p[1]), name: "shear traction" + name, ...style, yaxis: "y2"});
      const friction = t.friction ?? view.friction;  // of a study each case has its own
      if (friction !== null)
        traces.push({x, y: pressure.map(p => friction * p[1]), name: "bound" + name, yaxis: "y2", mode: "lines", line: {color: COLORS[k], dash: "dash", width: 1.2}, hovertemplate: style.hovertemplate});
    });
    const layout = {font: FONT, height: 520, margin: {l: 60, r: 20, t: 20, b: 50}, legend: {orientation: "h", y: -0.14},
      xaxis: {title: AA ? "along the rail, rolling direction \u2192 [mm]" : "lateral s (G.C. on the left) [mm]", range: AA ? range.along : range.s, anchor: "y2"},
      yaxis: {title: "pressure [MPa]", domain: [0.54, 1], rangemode: "tozero"}, yaxis2: {title: "shear [MPa]", domain: [0, 0.46], rangemode: "tozero"}};
    return Plotly.react(plotOf(view), traces, layout, CONFIG);
  };
  const plane = choice(view, "plane", "Plane", [["AA", "AA, along the rail"], ["BB", "BB, across the rail"]], () => settle());
  const tick = slider(view, "tick", 0, most, 1, view.start, k => longest.ticks[k].label, () => redraw());
  place = slider(view, "place", -1, 1, 0.05, 0, v => (plane.value === "AA" ? `s = ${v.toFixed(2)} mm` : `${v.toFixed(2)} mm ahead of the contact point`), () => redraw());
  return settle();
}

async function drawSlices(view) {
  const names = Object.keys(view.planes), cases = view.cases ?? [view];  // of a study, one after the other
  const redraw = () => {
    const plane = cases[Number(caseSlider.value)].planes[planeChoice.value], kind = fieldChoice.value, AA = planeChoice.value[0] === "A", n = plane.sources.length, traces = [];
    const layout = {font: FONT, margin: {l: 55, r: 20, t: 65, b: 50}, annotations: [], shapes: []};
    const top = plane.top[kind], power = 10 ** Math.floor(Math.log10(top / 14)), size = [1, 2, 5, 10].map(f => f * power).find(step => step >= top / 14);
    const last = size * Math.floor(top / size), ends = AA ? plane.view : [plane.view[1], plane.view[0]];
    plane.sources.forEach((source, k) => {
      const id = k ? String(k + 1) : "", axes = {xaxis: "x" + id, yaxis: "y" + id};
      source.bodies.forEach((body, b) => traces.push({type: "contour", x: body.position, y: body.depth, z: body.fields[kind], ...axes, zmin: kind === "shear" ? -top : 0, zmax: top,
        autocontour: false, contours: {coloring: "heatmap", start: kind === "shear" ? -last : 0, end: last, size}, line: {width: 0.5, color: "#555"},
        colorscale: kind === "shear" ? "RdBu" : "Viridis", reversescale: kind !== "shear", showscale: k === n - 1 && b === 0, colorbar: {title: {text: `${kind === "shear" ? plane.shear : "von Mises stress"}, up to ${top} MPa`, side: "right"}, thickness: 14},
        hovertemplate: `%{x} mm, %{y} mm from the surface<br>%{z} MPa<extra>${body.name}</extra>`}));
      layout["xaxis" + id] = {domain: domain(k, n), range: ends, title: AA ? "along the rail, rolling direction \u2192 [mm]" : "lateral s (G.C. on the left) [mm]", anchor: "y" + id};
      layout["yaxis" + id] = {range: [-10, 10], title: k ? "" : "from the surface: wheel +, rail \u2212 [mm]", scaleanchor: "x" + id, anchor: "x" + id, constrain: "domain"};
      layout.shapes.push({type: "line", xref: "x" + id, yref: "y" + id, x0: plane.view[0], x1: plane.view[1], y0: 0, y1: 0, line: {width: 1.5}});
      const where = AA ? `s = ${source.offset.toFixed(2)} mm` : `${source.offset.toFixed(2)} mm ahead of the contact point`;
      layout.annotations.push({xref: "paper", yref: "paper", x: (domain(k, n)[0] + domain(k, n)[1]) / 2, y: 1.02, xanchor: "center", yanchor: "bottom", showarrow: false, text: (source.name ? `<b>${source.name}</b><br>` : "") + where});
    });
    const width = plotOf(view).clientWidth;
    layout.height = Math.round(Math.min(640, Math.max(320, 100 + 20 / (plane.view[1] - plane.view[0]) * (width - 160) / n)));
    return Plotly.react(plotOf(view), traces, layout, CONFIG);
  };
  const planeChoice = choice(view, "plane", "Plane", names.map(name => [name, name.slice(0, 2) + (name.length > 2 ? "" : " through the first contact point")]), redraw);
  const caseSlider = slider(view, "case", 0, cases.length - 1, 1, 0, k => cases[k].label, redraw);
  const fieldChoice = choice(view, "field", "Field", [["von Mises", "von Mises stress"], ["shear", "shear stress"]], redraw);
  return redraw();
}

async function drawCurves(view) {
  const redraw = () => {
    const group = view.groups[Number(groupChoice.value)];
    const unit = view.unit ?? " mm";
    const traces = group.curves.map((curve, k) => ({x: curve.x, y: curve.y, name: curve.name, mode: view.marks ? "lines+markers" : "lines",
      marker: {size: 7, symbol: curve.symbol ?? "circle"}, line: {color: COLORS[(curve.color ?? k) % COLORS.length], width: 1.4, dash: curve.dash ?? "solid"},
      hovertemplate: `%{x}${unit}: %{y}<extra>%{fullData.name}</extra>`}));
    group.curves.forEach((curve, k) => {
      if (!curve.mean) return;
      traces.push({x: [curve.mean[1], curve.mean[2]], y: [curve.mean[0], curve.mean[0]], name: `mean of ${curve.name}`, mode: "lines",
        line: {color: COLORS[(curve.color ?? k) % COLORS.length], width: 2.5, dash: "dash"}, hovertemplate: "mean %{y}<extra>%{fullData.name}</extra>"});
    });
    return Plotly.react(plotOf(view), traces, {font: FONT, height: 380, margin: {l: 70, r: 20, t: 20, b: 50}, legend: {orientation: "h", y: -0.2}, showlegend: true,
      xaxis: {title: view.abscissa ?? "rolled distance [mm]"}, yaxis: {title: group.label, exponentformat: "power"}}, CONFIG);
  };
  const groupChoice = choice(view, "group", "Show", view.groups.map((group, k) => [String(k), group.title]), redraw);
  return redraw();
}

// curves one below the other over one axis, with a line under the cursor through all of them
async function drawStack(view) {
  const n = view.rows.length, gap = 0.25 / Math.max(n, 1), traces = [];
  const layout = {font: FONT, height: 80 + 150 * n, margin: {l: 60, r: 20, t: 50, b: 50}, annotations: [], hovermode: "x", legend: {orientation: "h", x: 1, xanchor: "right", y: 1, yanchor: "bottom"},
    xaxis: {title: view.abscissa, anchor: n > 1 ? "y" + n : "y", showspikes: true, spikemode: "across", spikesnap: "cursor", spikethickness: 1, spikecolor: "#555", spikedash: "solid"}};
  const height = (1 - gap * (n - 1)) / n, named = new Set();
  view.rows.forEach((row, k) => {
    const id = k ? String(k + 1) : "", top = 1 - k * (height + gap);
    layout["yaxis" + id] = {domain: [Math.max(0, top - height), top], anchor: "x", zeroline: true, zerolinecolor: "#bbb"};
    layout.annotations.push({xref: "paper", yref: "paper", x: 0, y: top, xanchor: "left", yanchor: "bottom", showarrow: false, text: row.label});
    for (const curve of row.curves) {
      traces.push({x: view.x, y: curve.y, name: curve.name, legendgroup: curve.name, showlegend: Boolean(curve.name) && !named.has(curve.name), xaxis: "x", yaxis: "y" + id, mode: "lines",
        line: {color: COLORS[curve.color], width: 1.4, dash: curve.dash ?? "solid"}, hovertemplate: `%{y:.5g}<extra>${curve.name}</extra>`});
      named.add(curve.name);
    }
  });
  return Plotly.react(plotOf(view), traces, layout, CONFIG);
}

function drawView(view) {
  return {patch: drawPatch, cuts: drawCuts, slices: drawSlices, curves: drawCurves, stack: drawStack}[view.type](view);
}
