// The scene graph as a tree: rooms, what stands in them, what is on and in that; other relations of
// the chosen node are drawn across it.
"use strict";
{
  const SVG = "http://www.w3.org/2000/svg";
  const ROW = 26, COLUMN = 205, WIDE = 176;

  sdgen.relations = (data) => {
    // By node: its relations in words, both ways, without nearness.
    const of = new Map();
    const add = (from, text, to) => { if (!of.has(from)) of.set(from, []); of.get(from).push([text, to]); };
    for (const [from, to, relation] of data.edges) {
      add(from, relation, to);
      add(to, `${relation} of`, from);
    }
    return of;
  };

  sdgen.names = (data) => {
    const names = new Map(data.rooms.map((room) => [room.id, sdgen.plain(room.name)]));
    for (const [id, [category]] of Object.entries(data.structures)) names.set(Number(id), category);
    for (const thing of data.things) names.set(thing.id, `${sdgen.plain(thing.category)} ${thing.id}`);
    return names;
  };

  sdgen.graph = (data) => {
    const holder = document.getElementById("tree");
    const panel = document.getElementById("node");
    const find = document.getElementById("find");
    const found = document.getElementById("found");
    const names = sdgen.names(data);
    const relations = sdgen.relations(data);
    const labels = new Map();
    for (const label of data.labels) {
      if (labels.get(label.id)?.kind !== "anomaly") labels.set(label.id, label);
    }
    const nodes = new Map();
    for (const room of data.rooms) nodes.set(room.id, { id: room.id, text: sdgen.plain(room.name), kind: "room", below: [], words: `${room.name} ${room.type} ${room.id}` });
    for (const thing of data.things) {
      const states = thing.states ? ` ${thing.states.join(" ")}` : "";
      nodes.set(thing.id, { id: thing.id, text: sdgen.plain(thing.category) + states, kind: labels.get(thing.id)?.kind || "thing",
        relation: thing.relation, up: thing.up, below: [], words: `${thing.category} ${sdgen.plain(thing.category)}${states} ${thing.id}` });
    }
    for (const node of nodes.values()) nodes.get(node.up)?.below.push(node);
    const roots = data.rooms.map((room) => nodes.get(room.id));
    const opened = new Set(roots.map((room) => room.id));
    const shut = (node) => node.below.length && !opened.has(node.id);
    const upwards = (node) => { const way = []; for (let up = nodes.get(node.up); up; up = nodes.get(up.up)) way.push(up); return way; };
    for (const id of labels.keys()) {
      if (labels.get(id).kind === "anomaly" && nodes.has(id)) upwards(nodes.get(id)).forEach((up) => opened.add(up.id));
    }
    let hits = new Set(), chosen = null;

    function element(tag, attributes, text) {
      const made = document.createElementNS(SVG, tag);
      for (const [name, value] of Object.entries(attributes)) made.setAttribute(name, value);
      if (text !== undefined) made.textContent = text;
      return made;
    }

    function draw() {
      const rows = [];
      const walk = (node, depth) => {
        node.x = 8 + depth * COLUMN;
        node.y = 8 + rows.length * ROW;
        rows.push(node);
        if (opened.has(node.id)) node.below.forEach((one) => walk(one, depth + 1));
      };
      roots.forEach((room) => walk(room, 0));
      const wide = Math.max(...rows.map((node) => node.x)) + WIDE + 90, high = rows.length * ROW + 16;
      const svg = element("svg", { width: wide, height: high, viewBox: `0 0 ${wide} ${high}`, role: "tree", "aria-label": "scene graph" });
      for (const node of rows) {
        const up = nodes.get(node.up);
        if (!up) continue;
        const x = up.x + 14, y = node.y + 11;
        svg.append(element("path", { d: `M${x} ${up.y + 22}V${y}H${node.x}` }));
        if (node.relation) svg.append(element("text", { x: node.x - 8, y: y - 1, class: "soft", "text-anchor": "end", style: "font-size:10px" }, node.relation));
      }
      for (const node of rows) svg.append(drawn(node));
      if (chosen) across(svg, new Set(rows));
      holder.replaceChildren(svg);
    }

    function drawn(node) {
      const marks = [node.kind, hits.has(node) ? "hit" : "", chosen === node ? "chosen" : ""].join(" ");
      const group = element("g", { class: marks, role: "treeitem", tabindex: chosen === node || (!chosen && node === roots[0]) ? 0 : -1, "data-id": node.id, "aria-label": names.get(node.id) });
      if (node.below.length) group.setAttribute("aria-expanded", opened.has(node.id));
      const more = node.below.length ? `${opened.has(node.id) ? "▾" : "▸"} ` : "";
      const text = more + node.text + (shut(node) ? ` (${node.below.length})` : "");
      group.append(element("rect", { x: node.x, y: node.y, width: WIDE, height: 22 }));
      group.append(element("text", { x: node.x + 8, y: node.y + 12 }, text.length > 23 ? `${text.slice(0, 22)}…` : text));
      group.append(element("title", {}, names.get(node.id)));
      group.addEventListener("click", () => { if (chosen === node || node.kind === "room") toggle(node); choose(node); });
      return group;
    }

    function across(svg, rows) {
      const ends = new Map((relations.get(chosen.id) || []).map(([relation, id]) => [id, relation]));
      for (const [id, relation] of ends) {
        const end = nodes.get(id);
        if (!end || !rows.has(end) || end === nodes.get(chosen.up) || end.up === chosen.id) continue;
        const x = chosen.x + WIDE, to = end.x + WIDE, bend = Math.max(x, to) + 26 + Math.abs(chosen.y - end.y) / 12;
        svg.append(element("path", { class: "other", d: `M${x} ${chosen.y + 11}C${bend} ${chosen.y + 11} ${bend} ${end.y + 11} ${to} ${end.y + 11}` }));
        svg.append(element("text", { x: to + 6, y: end.y + 4, class: "soft", style: "font-size:10px" }, relation));
      }
    }

    const toggle = (node) => { if (!opened.delete(node.id)) opened.add(node.id); };

    function choose(node) {
      chosen = node;
      draw();
      holder.querySelector(`[data-id="${node.id}"]`)?.focus({ preventScroll: true });
      panel.replaceChildren(...sdgen.about(data, node.id, names, relations, choose_id));
    }
    function choose_id(id) {
      const node = nodes.get(id);
      if (!node) return;
      upwards(node).forEach((up) => opened.add(up.id));
      choose(node);
      const at = holder.querySelector(`[data-id="${id}"]`).getBoundingClientRect(), frame = holder.getBoundingClientRect();
      holder.scrollTop += at.top - frame.top - frame.height / 3;
    }
    sdgen.chooseNode = choose_id;

    find.addEventListener("input", () => {
      const text = find.value.trim().toLowerCase();
      hits = new Set(text ? [...nodes.values()].filter((node) => node.words.toLowerCase().includes(text)) : []);
      for (const node of hits) upwards(node).forEach((up) => opened.add(up.id));
      found.textContent = text ? `${hits.size} found` : "";
      draw();
      const first = holder.querySelector(".hit");
      if (first) holder.scrollTop += first.getBoundingClientRect().top - holder.getBoundingClientRect().top - 60;
    });
    find.addEventListener("keydown", (event) => { if (event.key === "Enter" && hits.size) choose_id([...hits][0].id); });
    document.getElementById("unfold").addEventListener("click", () => { nodes.forEach((node) => opened.add(node.id)); draw(); });
    document.getElementById("fold").addEventListener("click", () => { opened.clear(); draw(); });
    holder.addEventListener("keydown", (event) => {
      const all = [...holder.querySelectorAll("[data-id]")];
      const at = all.indexOf(document.activeElement);
      if (at < 0) return;
      const node = nodes.get(Number(all[at].dataset.id));
      if (event.key === "ArrowDown" || event.key === "ArrowUp") {
        const next = all[at + (event.key === "ArrowDown" ? 1 : -1)];
        if (next) { choose(nodes.get(Number(next.dataset.id))); holder.querySelector(".chosen").scrollIntoView({ block: "nearest" }); }
      } else if (event.key === "ArrowRight") { opened.add(node.id); choose(node); }
      else if (event.key === "ArrowLeft") { if (opened.has(node.id)) opened.delete(node.id); else if (nodes.has(node.up)) return choose_id(node.up); choose(node); }
      else if (event.key === "Enter" || event.key === " ") { toggle(node); choose(node); }
      else return;
      event.preventDefault();
    });
    draw();
  };

  // What a node is, in words: what it is labelled as (the card of the page), its states, relations.
  sdgen.about = (data, id, names, relations, choose) => {
    const { make, plain } = sdgen;
    const thing = data.things.find((one) => one.id === id);
    const out = [make("h3", "", names.get(id))];
    const room = thing && names.get(thing.room);
    if (thing) out.push(make("p", "soft", [room, thing.model, ...(thing.states || [])].join(" · ")));
    const labels = data.labels.filter((label) => label.id === id);
    for (const label of labels) {
      const card = document.getElementById(label.key).cloneNode(true);
      card.removeAttribute("id");
      card.querySelector(".links")?.remove();
      for (const one of card.querySelectorAll("details")) one.open = true;
      out.push(card);
    }
    if (thing && !labels.length) out.push(make("p", "", "Nothing is wrong with it: no hazard's rule holds of it."));
    const box = thing && data.boxes[thing.model];
    if (box) out.push(make("p", "bad", `A box stands for its model, which is ${box.why}.`));
    const rows = relations.get(id) || [];
    if (rows.length) {
      const list = make("ul");
      for (const [relation, to] of rows.slice(0, 60)) {
        const item = make("li", "", `${relation} `);
        const link = make("a", "", names.get(to) || `node ${to}`);
        link.href = "#graph";
        link.addEventListener("click", (event) => { event.preventDefault(); choose(to); });
        item.append(link);
        list.append(item);
      }
      if (rows.length > 60) list.append(make("li", "soft", `and ${rows.length - 60} more`));
      out.push(make("h3", "", "Relations"), list);
    }
    if (thing) {
      const at = data.things.indexOf(thing);
      const near = new Set(data.close[at] || []);
      for (const [k, others] of Object.entries(data.close)) if (others.includes(at)) near.add(Number(k));
      if (near.size) out.push(make("p", "soft", `CLOSE to ${near.size} things: ${[...near].slice(0, 12).map((k) => plain(data.things[k].category)).join(", ")}${near.size > 12 ? " …" : ""}`));
    }
    return out;
  };
}
