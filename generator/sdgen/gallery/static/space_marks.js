// Outlines, lines, zones and words over the 3-D view.
"use strict";
{
  const COLOURS = { anomaly: 0xff2a3a, lookalike: 0x3f94ff, thing: 0xffc247 };
  const TICK_M = 0.07;
  const LINE = 0xffc247, LIMIT = 0x7fe0a0, ZONE = 0x35c9b0;

  // The hull of a mesh pushed outwards by some pixels and drawn from behind: its silhouette.
  function hull(colour, seen) {
    return new THREE.ShaderMaterial({
      side: THREE.BackSide, transparent: !seen, depthTest: seen, depthWrite: seen,
      uniforms: { colour: { value: new THREE.Color(colour) }, pixels: { value: 3 }, size: { value: sdgen.size }, share: { value: seen ? 1 : 0.16 } },
      vertexShader: `uniform float pixels; uniform vec2 size;
        void main() {
          vec4 place = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
          vec2 way = (projectionMatrix * vec4(normalize(normalMatrix * normal), 0.0)).xy;
          place.xy += normalize(way + 1e-5) * pixels * 2.0 / size * place.w;
          gl_Position = place;
        }`,
      fragmentShader: `uniform vec3 colour; uniform float share;
        void main() {
          gl_FragColor = vec4(colour, share);
          #include <colorspace_fragment>
        }`,
    });
  }

  sdgen.marks = (scene, overlay) => {
    sdgen.size = new THREE.Vector2(1, 1);
    const materials = new Map();
    const outline = (holder, kind) => {
      if (!materials.has(kind)) materials.set(kind, [hull(COLOURS[kind], true), hull(COLOURS[kind], false)]);
      const meshes = [];
      holder.traverse((one) => { if (one.isMesh && !one.userData.outline) meshes.push(one); });
      const made = [];
      for (const mesh of meshes) {
        for (const material of materials.get(kind)) {
          const shell = new THREE.Mesh(mesh.geometry, material);
          shell.userData.outline = true;
          shell.raycast = () => {};
          shell.renderOrder = material.transparent ? 3 : 1;
          mesh.add(shell);
          made.push(shell);
        }
      }
      return () => made.forEach((shell) => shell.removeFromParent());
    };

    const words = []; // what is written at places of the scene: { node, at }
    const write = (node, at) => { overlay.append(node); const one = { node, at: new THREE.Vector3(...at) }; words.push(one); return one; };
    const remove = (one) => { one.node.remove(); words.splice(words.indexOf(one), 1); };

    const seenThrough = (material) => Object.assign(material, { depthTest: false, depthWrite: false, transparent: true });
    const line = (points, colour, dashed) => {
      const geometry = new THREE.BufferGeometry().setFromPoints(points.map((point) => new THREE.Vector3(...point)));
      const material = dashed ? new THREE.LineDashedMaterial({ color: colour, dashSize: 0.06, gapSize: 0.04 }) : new THREE.LineBasicMaterial({ color: colour });
      const made = new THREE.Line(geometry, seenThrough(material));
      if (dashed) made.computeLineDistances();
      made.renderOrder = 4;
      return made;
    };

    // Draws what was measured of a thing; returns what takes it away again.
    const measures = (marks, boxes, names) => {
      const group = new THREE.Group();
      const said = [];
      const say = (text, at) => { if (text) said.push(write(sdgen.make("span", "said", text), at)); };
      const tick = (x, y, z, colour) => group.add(line([[x - TICK_M, y, z], [x + TICK_M, y, z]], colour), line([[x, y - TICK_M, z], [x, y + TICK_M, z]], colour));
      const draw = {
        line: (mark) => {
          group.add(line([mark.from, mark.to], LINE));
          say(mark.text, mark.from.map((value, k) => (value + mark.to[k]) / 2));
        },
        height: (mark) => {
          const [x, y] = mark.at;
          group.add(line([[x, y, mark.from], [x, y, mark.to]], LINE));
          tick(x, y, mark.from, LINE);
          tick(x, y, mark.to, LINE);
          say(mark.text, [x, y, (mark.from + mark.to) / 2]);
          for (const limit of mark.limits) {
            group.add(line([[x, y, Math.min(mark.from, limit.z)], [x, y, limit.z]], LIMIT, true));
            tick(x, y, limit.z, LIMIT);
            say(limit.text, [x, y, limit.z]);
          }
        },
        zone: (mark) => {
          const shape = new THREE.Shape(mark.polygon.map(([x, y]) => new THREE.Vector2(x, y)));
          const fill = new THREE.Mesh(new THREE.ShapeGeometry(shape), new THREE.MeshBasicMaterial({ color: ZONE, opacity: 0.35, transparent: true, depthWrite: false, side: THREE.DoubleSide }));
          fill.position.z = mark.low + 0.012;
          fill.raycast = () => {};
          const edge = [...mark.polygon, mark.polygon[0]].map(([x, y]) => [x, y, mark.low + 0.014]);
          group.add(fill, line(edge, ZONE));
          say(mark.text, mark.at);
        },
        thing: (mark) => {
          const box = boxes.get(mark.id);
          if (!box) return;
          const edges = new THREE.LineSegments(new THREE.EdgesGeometry(new THREE.BoxGeometry(...box.slice(3))), seenThrough(new THREE.LineBasicMaterial({ color: COLOURS.thing, opacity: 0.8 })));
          edges.position.set(...box.slice(0, 3));
          edges.renderOrder = 4;
          group.add(edges);
          say([sdgen.plain(names.get(mark.id) || ""), mark.text].filter(Boolean).join(": "), [box[0], box[1], box[2] + box[5] / 2]);
        },
      };
      // Two heights of one thing stand side by side.
      let heights = 0;
      for (const mark of marks) {
        const aside = mark.kind === "height" && { at: [mark.at[0] + 0.08 * heights++, mark.at[1]] };
        draw[mark.kind]?.({ ...mark, ...aside });
      }
      scene.add(group);
      return () => { group.removeFromParent(); said.forEach(remove); };
    };

    // Puts the words where their places are seen now, those that would lie on others above them.
    const place = (camera, width, height) => {
      const taken = [];
      const point = new THREE.Vector3();
      const order = words.map((one) => ({ one, z: point.copy(one.at).project(camera).z, x: (point.x + 1) / 2 * width, y: (1 - point.y) / 2 * height }));
      order.sort((a, b) => (b.one.first ? 1 : 0) - (a.one.first ? 1 : 0) || b.y - a.y);
      for (const { one, x, y, z } of order) {
        const hidden = z > 1 || x < -60 || y < -30 || x > width + 60 || y > height + 30;
        one.node.style.visibility = hidden ? "hidden" : "";
        if (hidden) continue;
        one.wide ??= one.node.offsetWidth;
        one.high ??= one.node.offsetHeight;
        let left = Math.min(Math.max(x - one.wide / 2, 2), Math.max(width - one.wide - 2, 2));
        let top = y - one.high / 2 - (one.above || 0);
        for (let tries = 0; tries < 12; tries++) {
          const clash = taken.find(([l, t, r, b]) => left < r && l < left + one.wide && top < b && t < top + one.high);
          if (!clash) break;
          top = clash[1] - one.high - 1;
        }
        taken.push([left, top, left + one.wide, top + one.high]);
        one.node.style.transform = `translate(${left.toFixed(1)}px, ${top.toFixed(1)}px)`;
      }
    };
    return { outline, write, measures, place };
  };
}
