// A home in 3-D: turn it, come closer, click a thing to be told what it is and why it is a hazard.
"use strict";
{
  const LOW_WALLS_M = 1.3;

  sdgen.space = async (data, stage, panel) => {
    const began = performance.now();
    const canvas = document.createElement("canvas");
    canvas.tabIndex = 0;
    canvas.setAttribute("aria-label", "the home in 3-D: arrow keys turn it, plus and minus come closer and go away, Escape lets go of a thing");
    const renderer = new THREE.WebGLRenderer({ canvas, antialias: true, alpha: true });
    renderer.localClippingEnabled = true;
    renderer.setPixelRatio(Math.min(devicePixelRatio, 2));
    const scene = new THREE.Scene();
    scene.add(new THREE.HemisphereLight(0xffffff, 0xcfc6b8, 2.3));
    const sun = new THREE.DirectionalLight(0xffffff, 1.3);
    sun.position.set(3, -4, 10);
    scene.add(sun);
    const camera = new THREE.PerspectiveCamera(42, 1, 0.03, 200);
    camera.up.set(0, 0, 1);
    const controls = new THREE.OrbitControls(camera, canvas);
    controls.maxPolarAngle = Math.PI * 0.495;
    controls.minDistance = 0.25;
    controls.zoomToCursor = true;

    // Models come side by side; what is not there is a box.
    const loader = new THREE.GLTFLoader();
    const progress = stage.querySelector(".progress");
    let done = 0;
    const names = [...data.models];
    const models = new Map();
    await Promise.all([
      ...data.surfaces.map((name) => sdgen.load(`../surfaces/${encodeURIComponent(name)}.js`)),
      ...names.map(async (name) => {
        models.set(name, await sdgen.readModel(name, loader));
        done += 1;
        if (progress && done % 16 === 0) progress.textContent = `loading ${done} of ${names.length} models …`;
      }),
    ]);
    const shell = sdgen.shell(data); 
    scene.add(shell.group);
    const things = new Map();
    const boxes = new Map(data.things.map((thing) => [thing.id, thing.box]));
    const everything = new THREE.Group();
    for (const thing of data.things) {
      const size = data.boxes[thing.model]?.size || thing.box.slice(3);
      const holder = sdgen.placed(thing, models.get(thing.model), size);
      things.set(thing.id, holder);
      everything.add(holder);
    }
    scene.add(everything);
    // What hangs from a ceiling comes and goes with it, unless it is what people came for.
    const tall = new Map(data.rooms.map((room) => [room.id, room.height]));
    const told = new Set(data.labels.map((label) => label.id));
    const hung = data.things.filter(({ id, room, box: [, , z, , , dz] }) => !told.has(id) && z + dz / 2 > tall.get(room) - 0.06 && z - dz / 2 > 1.4).map(({ id }) => things.get(id));
    for (const holder of hung) holder.visible = false;
    scene.updateMatrixWorld(true);

    const overlay = sdgen.make("div", "overlay");
    const tools = sdgen.make("div", "tools");
    stage.replaceChildren(canvas, overlay, tools);
    const marks = sdgen.marks(scene, overlay);
    const called = sdgen.names(data);
    const relations = sdgen.relations(data);

    // By thing, its labels; anomalies before lookalikes.
    const labelled = new Map();
    for (const label of data.labels) labelled.set(label.id, [...(labelled.get(label.id) || []), label]);
    let number = 0;
    for (const [id, labels] of labelled) {
      const holder = things.get(id);
      if (!holder) continue;
      const kind = labels.some((label) => label.kind === "anomaly") ? "anomaly" : "lookalike";
      marks.outline(holder, kind);
      const of = labels.filter((label) => label.kind === kind);
      const title = kind === "anomaly" ? of.map((label) => `${++number} ${sdgen.plain(label.hazard)}`).join(", ") : `${called.get(id)}: near miss of ${sdgen.plain(of[0].hazard)}`;
      const pin = sdgen.make("button", `pin ${kind}${kind === "lookalike" ? " small" : ""}`, title);
      pin.type = "button";
      pin.title = title;
      pin.addEventListener("click", () => choose(id, true));
      const box = boxes.get(id);
      const one = marks.write(pin, [box[0], box[1], box[2] + box[5] / 2]);
      one.first = kind === "anomaly";
      one.above = kind === "anomaly" ? 20 : 0;
    }

    let asked = false;
    const redraw = () => { if (!asked) { asked = true; requestAnimationFrame(render); } };
    sdgen.redraw = redraw;
    let walls = "low";
    function render() {
      asked = false;
      const width = stage.clientWidth, height = stage.clientHeight;
      for (const wall of shell.walls) {
        // A wall is cut away where one looks at its back.
        const before = (camera.position.getComponent(wall.axis) - wall.at) * wall.way > 0;
        wall.holder.visible = walls === "all" || (walls !== "none" && before);
      }
      renderer.render(scene, camera);
      marks.place(camera, width, height);
    }
    const lowered = [new THREE.Plane(new THREE.Vector3(0, 0, -1), LOW_WALLS_M)];
    function setWalls(wish) {
      walls = wish;
      for (const material of shell.wallMaterials) material.clippingPlanes = wish === "low" ? lowered : null;
      redraw();
    }
    setWalls("low");
    function resize() {
      const width = stage.clientWidth, height = stage.clientHeight;
      renderer.setSize(width, height, false);
      canvas.style.width = `${width}px`;
      canvas.style.height = `${height}px`;
      sdgen.size.set(width, height);
      camera.aspect = width / height;
      camera.updateProjectionMatrix();
      redraw();
    }
    new ResizeObserver(resize).observe(stage);
    controls.addEventListener("change", redraw);

    function look(at, from) {
      controls.target.set(...at);
      camera.position.set(...from);
      controls.update();
      redraw();
    }
    function overall() {
      const box = new THREE.Box3();
      for (const room of data.rooms) for (const [x, y] of room.polygon) box.expandByPoint(new THREE.Vector3(x, y, 0.6));
      const middle = box.getCenter(new THREE.Vector3());
      const corners = data.rooms.flatMap((room) => room.polygon.flatMap(([x, y]) => [0, 1.5].map((z) => new THREE.Vector3(x, y, z))));
      const outside = () => corners.some((corner) => { const { x, y } = corner.clone().project(camera); return Math.abs(x) > 0.95 || Math.abs(y) > 0.9; });
      // Further away until all of it is seen.
      for (let far = 4; far < 200; far *= 1.06) {
        look(middle.toArray(), [middle.x + far * 0.14, middle.y - far * 0.56, middle.z + far * 0.8]);
        camera.updateMatrixWorld();
        if (!outside()) break;
      }
    }
    function near(id) {
      const [x, y, z, dx, dy, dz] = boxes.get(id);
      const thing = data.things.find((one) => one.id === id);
      const polygon = data.rooms.find((room) => room.id === thing.room)?.polygon || [[x, y - 1]];
      const middle = polygon.reduce(([a, b], [px, py]) => [a + px / polygon.length, b + py / polygon.length], [0, 0]);
      let way = [middle[0] - x, middle[1] - y];
      const long = Math.hypot(...way);
      way = long > 0.3 ? way.map((one) => one / long) : [0.2, -0.98];
      // So far off that what was measured of it is in the picture, too.
      const heights = (labelled.get(id) || []).flatMap((label) => label.marks).flatMap((mark) => mark.kind === "height" ? [mark.from, ...mark.limits.map((limit) => limit.z)] : mark.kind === "line" ? [mark.to[2]] : []);
      const zoned = (labelled.get(id) || []).some((label) => label.marks.some((mark) => mark.kind === "zone"));
      const reach = Math.max(0, ...heights.map((one) => Math.abs(one - z)));
      const far = Math.max(1.4, 3 * Math.max(dx, dy, dz), 1.9 * reach, zoned ? 2.6 : 0);
      look([x, y, z], [x + way[0] * far * 0.72, y + way[1] * far * 0.72, z + far * 0.62]);
    }

    let chosen = null, undo = [];
    function letGo() {
      undo.forEach((one) => one());
      undo = [];
      chosen = null;
      const list = sdgen.make("div", "choose");
      for (const [id, labels] of labelled) {
        const button = sdgen.make("button", labels[0].kind, labels[0].kind === "anomaly" ? `${labels.map((label) => label.title).join(", ")}: ${called.get(id)}` : `${called.get(id)}: no ${sdgen.plain(labels[0].hazard)}`);
        button.type = "button";
        button.addEventListener("click", () => choose(id, true));
        list.append(button);
      }
      const missing = Object.keys(data.boxes).length;
      panel.replaceChildren(sdgen.make("p", "soft", "Turn it, come closer, click a thing."), list);
      if (missing) panel.append(sdgen.make("p", "soft", `${missing} of ${missing + data.models.length} models are drawn as boxes: ${[...new Set(Object.values(data.boxes).map((box) => box.why))].join("; ")}.`));
      if (data.others) panel.append(sdgen.make("p", "soft", "The library at hand is not the one this data set was built with: textures may differ."));
      stage.dataset.chosen = "";
      redraw();
    }
    function choose(id, fly) {
      if (!things.has(id)) return;
      letGo();
      chosen = id;
      const labels = labelled.get(id) || [];
      if (!labels.length) undo.push(marks.outline(things.get(id), "thing"));
      for (const label of labels) undo.push(marks.measures(label.marks, boxes, called));
      const back = sdgen.make("button", "", "back to all");
      back.type = "button";
      back.addEventListener("click", () => { letGo(); canvas.focus({ preventScroll: true }); });
      const graph = sdgen.make("a", "", "in the graph");
      graph.href = "#graph";
      graph.addEventListener("click", () => sdgen.chooseNode?.(id));
      panel.replaceChildren(back, " ", graph, ...sdgen.about(data, id, called, relations, (to) => choose(to, true)));
      panel.scrollTop = 0;
      stage.dataset.chosen = id;
      if (fly) near(id);
      redraw();
    }

    const ray = new THREE.Raycaster();
    let down = null;
    canvas.addEventListener("pointerdown", (event) => { down = [event.clientX, event.clientY]; });
    canvas.addEventListener("pointerup", (event) => {
      if (!down || Math.hypot(event.clientX - down[0], event.clientY - down[1]) > 5) return;
      const frame = canvas.getBoundingClientRect();
      ray.setFromCamera(new THREE.Vector2(2 * (event.clientX - frame.left) / frame.width - 1, 1 - 2 * (event.clientY - frame.top) / frame.height), camera);
      const [hit] = ray.intersectObject(everything, true);
      let node = hit?.object;
      while (node && node.userData.id === undefined) node = node.parent;
      if (node) choose(node.userData.id, false);
      else letGo();
    });
    sdgen.controls({ canvas, camera, controls, tools, stage, redraw, letGo, overall, setWalls, hidden: [...shell.ceilings, ...hung] });

    resize();
    overall();
    letGo();
    render();renderer.getContext().finish(); 
    stage.dataset.ready = Math.round(performance.now() - began);
    return {
      choose,
      // Where a thing is on the page, for tests.
      where: (id) => {
        const [x, y, z] = boxes.get(id), frame = canvas.getBoundingClientRect();
        const at = new THREE.Vector3(x, y, z).project(camera);
        return [frame.left + (at.x + 1) / 2 * frame.width, frame.top + (1 - at.y) / 2 * frame.height];
      },
    };
  };
}
