// A scene's page: which pictures and boxes are shown, twins wiped over their scene, keys, 3-D on demand.
"use strict";
const sdgen = { models: new Map(), surfaces: new Map() };
{
  const main = document.querySelector("main");
  const layer = document.getElementById("layer");
  const masks = document.getElementById("masks");
  const other = document.getElementById("other");
  const figures = [...document.querySelectorAll(".stack")].filter((stack) => stack.querySelector("img"));

  // Called by data.js, last of the scripts.
  sdgen.scene = (data) => {
    sdgen.data = data;
    sdgen.graph(data);
    fromAddress();
  };
  sdgen.model = (name, model) => sdgen.models.set(name, model);
  sdgen.surface = (name, surface) => sdgen.surfaces.set(name, surface);
  sdgen.make = (tag, name, text) => {
    const node = document.createElement(tag);
    if (name) node.className = name;
    if (text !== undefined) node.textContent = text;
    return node;
  };
  sdgen.plain = (text) => text.replaceAll("_", " ");
  // A script beside the page, or of the gallery; true when it is there.
  const asked = new Map();
  sdgen.load = (path) => {
    if (!asked.has(path)) {
      asked.set(path, new Promise((done) => {
        const script = document.createElement("script");
        script.src = path;
        script.onload = () => { script.remove(); done(true); };
        script.onerror = () => { script.remove(); done(false); };
        document.head.append(script);
      }));
    }
    return asked.get(path);
  };

  for (const box of document.querySelectorAll("[data-show]")) {
    const apply = () => document.body.classList.toggle(`show-${box.dataset.show}`, box.checked);
    box.addEventListener("change", apply);
    apply(); // a browser may remember what was ticked
  }

  function over(stack, name, source) {
    stack.querySelector(`.over.${name}`)?.remove();
    if (!source) return;
    const image = sdgen.make("img", `over ${name}`);
    image.src = source;
    image.alt = "";
    image.loading = "lazy";
    stack.insertBefore(image, stack.querySelector("svg"));
  }

  function pictures() {
    for (const stack of figures) {
      const image = stack.querySelector(".picture");
      const source = image.dataset[layer.value] || image.dataset.rgb || image.dataset.depth || image.dataset.mask;
      if (image.getAttribute("src") !== source) image.src = source;
      over(stack, "mask", masks.checked && image.dataset.mask);
      wipe(stack, image);
    }
  }

  function wipe(stack, image) {
    for (const old of stack.querySelectorAll(".wipe, .edge, .side")) old.remove();
    const source = other?.value && image.getAttribute(`data-other-${other.value}`);
    over(stack, "wiped", source);
    stack.classList.toggle("comparing", Boolean(source));
    if (!source) return;
    const slider = sdgen.make("input", "wipe");
    slider.type = "range";
    slider.max = 1000;
    slider.value = 500;
    slider.setAttribute("aria-label", `${image.alt}: this scene on the left, ${other.selectedOptions[0].text} on the right`);
    const move = () => stack.style.setProperty("--wipe", `${slider.value / 10}%`);
    slider.addEventListener("input", move);
    move();
    const left = sdgen.make("span", "side", "this scene");
    const right = sdgen.make("span", "side", other.selectedOptions[0].text);
    left.style.left = right.style.right = "8px";
    stack.append(slider, sdgen.make("span", "edge"), left, right);
  }

  for (const control of [layer, masks, other]) control?.addEventListener("change", pictures);
  if (layer) pictures();

  // 3-D: its scripts, and the models, are loaded when it is asked for.
  const stage = document.getElementById("stage");
  let opening;
  sdgen.openSpace = (objectId) => {
    opening ??= (async () => {
      stage.replaceChildren(sdgen.make("span", "progress", "loading …"));
      // All at once: the models arrive while the view gets ready to draw.
      const scripts = ["three.min.js", "space_models.js", "space_shell.js", "space_marks.js", "space_controls.js", "space.js"];
      const there = scripts.map((name) => sdgen.load(`../${name}`));
      for (const name of sdgen.data.models) sdgen.load(`../models/${encodeURIComponent(name)}.js`);
      for (const name of sdgen.data.surfaces) sdgen.load(`../surfaces/${encodeURIComponent(name)}.js`);
      if (!(await Promise.all(there)).every(Boolean)) throw new Error("its scripts are not there");
      return sdgen.space(sdgen.data, stage, document.getElementById("panel"));
    })().catch((error) => {
      stage.replaceChildren(sdgen.make("p", "progress", `No 3-D here: ${error.message}.`));
      return null;
    });
    return opening.then((space) => { if (space && objectId) space.choose(objectId, true); return space; });
  };
  document.getElementById("open-space").addEventListener("click", () => sdgen.openSpace());

  function fromAddress() {
    const asked = location.hash.match(/^#3d(?:=(\d+))?$/);
    if (!asked) return;
    document.getElementById("space").scrollIntoView();
    sdgen.openSpace(Number(asked[1] || 0));
  }
  window.addEventListener("hashchange", fromAddress);

  document.addEventListener("keydown", (event) => {
    if (event.ctrlKey || event.metaKey || event.altKey || event.defaultPrevented) return;
    if (document.activeElement.closest("input, select, #stage, #tree")) return;
    const way = { ArrowLeft: 'a[rel="prev"]', ArrowRight: 'a[rel="next"]', Escape: "#all" }[event.key];
    const link = way && document.querySelector(way);
    if (link) link.click();
  });
  main.dataset.ready = "";
}
