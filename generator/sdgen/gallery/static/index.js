// The index: cards of the scenes that pass the filters, which the address keeps (#hazard=spill).
"use strict";
const sdgen = {};
{
  const CHUNK = 48; // cards made at a time; the next ones when the last come near
  const KINDS = { scene: "scenes", twin: "twins", toggle: "with one undone" };
  const form = document.getElementById("filters");
  const cards = document.getElementById("cards");
  const count = document.getElementById("count");
  let rows = [];
  let shown = [];
  let made = 0;

  const plain = (text) => text.replaceAll("_", " ");
  const make = (tag, name, text) => {
    const node = document.createElement(tag);
    if (name) node.className = name;
    if (text !== undefined) node.textContent = text;
    return node;
  };
  const add = (parent, ...children) => { parent.append(...children); return parent; };

  // Called by scenes.js.
  sdgen.index = ({ words, rows: packed }) => {
    rows = packed.map(([id, home, kind, split, household, rooms, hazards, crop, overview, inset, hidden, twins]) => ({
      id, home, crop, overview, inset, hidden, twins,
      kind: words.kind[kind], split: words.split[split], household: words.household[household],
      rooms: rooms.map((k) => words.rooms[k]),
      hazards: new Map(hazards.flatMap((k, n) => n % 2 ? [] : [[words.hazards[k], hazards[n + 1]]])),
    }));
    const first = rows.filter((row) => row.kind === rows[0].kind);
    options("hazard", [...words.hazards, "none"], (row, name) => name === "none" ? !row.hazards.size : row.hazards.has(name), first);
    options("room", words.rooms, (row, name) => row.rooms.includes(name), first);
    options("household", words.household, (row, name) => row.household === name, first);
    options("split", words.split, (row, name) => row.split === name, first);
    const twin = form.elements.twin;
    for (const kind of words.kind) twin.add(new Option(`${KINDS[kind]} (${rows.filter((row) => row.kind === kind).length})`, kind));
    if (words.kind.length > 1) twin.add(new Option("all", "all"));
    twin.closest("label").hidden = words.kind.length < 2 && rows.every((row) => !row.twins);
    twin.dataset.usual = words.kind.includes("scene") ? "scene" : words.kind[0] || "";
    fromAddress();
  };

  function options(name, values, fits, first) {
    const select = form.elements[name];
    select.add(new Option("all", ""));
    for (const value of values) {
      select.add(new Option(`${plain(value)} (${first.filter((row) => fits(row, value)).length})`, value));
    }
  }

  const wishes = () => {
    const wish = Object.fromEntries(new FormData(form));
    if (wish.twin === form.elements.twin.dataset.usual) wish.twin = "";
    return Object.fromEntries(Object.entries(wish).filter(([, value]) => value));
  };

  function fromAddress() {
    const asked = new URLSearchParams(location.hash.slice(1));
    for (const field of form.elements) {
      if (field.name) field.value = asked.get(field.name) ?? "";
      if (field.name && field.value !== (asked.get(field.name) ?? "")) field.value = "";
    }
    const twin = form.elements.twin;
    if (!twin.value) twin.value = twin.dataset.usual;
    show();
  }

  function toAddress(replace) {
    const hash = `#${new URLSearchParams(wishes())}`;
    if (hash === (location.hash || "#")) return;
    if (replace) history.replaceState(null, "", hash);
    else history.pushState(null, "", hash);
  }

  function show() {
    const { hazard, room, household, split, q } = wishes();
    const kind = form.elements.twin.value;
    const text = (q || "").trim().toLowerCase();
    shown = rows.filter((row) =>
      (!hazard || (hazard === "none" ? !row.hazards.size : row.hazards.has(hazard))) &&
      (!room || row.rooms.includes(room)) && (!household || row.household === household) &&
      (!split || row.split === split) && (kind === "all" || !kind || row.kind === kind) &&
      (!text || row.id.includes(text) || plain(row.home).toLowerCase().includes(plain(text))));
    made = 0;
    cards.replaceChildren();
    if (!shown.length) cards.append(make("p", "soft", "No scene is all of this: choose less, or press Escape."));
    more();
    count.textContent = `${shown.length} of ${rows.filter((row) => kind === "all" || row.kind === kind).length}`;
  }

  function more() {
    const part = document.createDocumentFragment();
    for (const row of shown.slice(made, made + CHUNK)) part.append(card(row));
    made = Math.min(made + CHUNK, shown.length);
    cards.append(part);
    if (made < shown.length) watch.observe(cards.lastElementChild);
  }

  const watch = new IntersectionObserver((seen) => {
    for (const one of seen) {
      if (!one.isIntersecting) continue;
      watch.unobserve(one.target);
      more();
    }
  }, { rootMargin: "900px" });

  function card(row) {
    const link = make("a", "card");
    link.href = `${row.id}/index.html`;
    link.dataset.id = row.id;
    link.setAttribute("role", "listitem");
    const wrong = [...row.hazards].map(([name, times]) => plain(name) + (times > 1 ? ` ×${times}` : ""));
    link.setAttribute("aria-label", `scene ${row.id}, ${wrong.join(", ") || "no hazard"}`);
    const shots = add(make("span", "shots"), picture(row, row.crop || row.overview));
    if (row.crop) add(shots, picture(row, row.overview, `inset ${row.inset}`));
    const text = make("span", "text");
    const about = [row.split, plain(row.household), plain(row.home)].join(" · ");
    add(text, add(make("span", "name"), make("strong", "", row.id), " ", make("span", "soft", about)));
    for (const name of wrong) add(text, make("span", "tag bad", name));
    if (!wrong.length) add(text, make("span", "soft", "no hazard"));
    if (row.hidden) add(text, make("span", "tag", "not all visible"));
    add(link, shots, text);
    return link;
  }

  function picture(row, file, name) {
    const image = make("img", name || "");
    image.loading = "lazy";
    image.decoding = "async";
    image.alt = "";
    image.src = `${row.id}/${file}`;
    return image;
  }

  form.addEventListener("change", () => { toAddress(false); show(); });
  form.elements.q.addEventListener("input", () => { toAddress(true); show(); });
  form.addEventListener("submit", (event) => event.preventDefault());
  form.addEventListener("reset", (event) => { event.preventDefault(); clear(); });
  window.addEventListener("popstate", fromAddress);
  window.addEventListener("hashchange", fromAddress);

  function clear() {
    history.pushState(null, "", "#");
    fromAddress();
  }

  document.addEventListener("keydown", (event) => {
    const here = document.activeElement;
    const typing = here.matches("input, select");
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    if (event.key === "Escape") { clear(); here.blur(); return; }
    if (event.key === "/" && !typing) { form.elements.q.focus(); event.preventDefault(); return; }
    if (typing && !(here.type === "search" && event.key === "ArrowDown")) return;
    const all = cards.children;
    const columns = Math.max(1, getComputedStyle(cards).gridTemplateColumns.split(" ").length);
    const step = { ArrowRight: 1, ArrowLeft: -1, ArrowDown: columns, ArrowUp: -columns, Home: -1e9, End: 1e9 }[event.key];
    if (!step || !all.length) return;
    const at = [...all].indexOf(here.closest?.(".card"));
    let next = at < 0 ? 0 : Math.min(Math.max(at + step, 0), all.length - 1);
    if (event.key === "ArrowUp" && at - columns < 0) next = at;
    all[next].focus();
    event.preventDefault();
  });
}
