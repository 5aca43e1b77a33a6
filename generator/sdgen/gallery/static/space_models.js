// Models for the 3-D view: read from their scripts once, put where the things of a scene stand.
"use strict";
{
  function bytes(text) {
    if (Uint8Array.fromBase64) return Uint8Array.fromBase64(text).buffer;
    const letters = atob(text);
    const out = new Uint8Array(letters.length);
    for (let k = 0; k < out.length; k++) out[k] = letters.charCodeAt(k);
    return out.buffer;
  }

  // Geometry and material of each part of a model, from its script.
  const read = new Map();
  sdgen.readModel = (name, loader) => {
    if (!read.has(name)) {
      read.set(name, (async () => {
        if (!(await sdgen.load(`../models/${encodeURIComponent(name)}.js`))) return null;
        const model = sdgen.models.get(name);
        const { scene } = await loader.parseAsync(bytes(model.glb), "");
        const found = new Map();
        model.glb = null;
        scene.children[0].children.forEach((mesh, k) => {
          const [part, [r, g, b, opacity]] = model.parts[k];
          const material = new THREE.MeshLambertMaterial({ map: mesh.material.map, color: new THREE.Color(r, g, b) });
          // 0.999 marks what is seen through its texture.
          if (opacity < 0.99) Object.assign(material, { transparent: true, opacity, depthWrite: false });
          found.set(part, { geometry: mesh.geometry, material });
        });
        return { found, variants: model.variants };
      })().catch(() => null));
    }
    return read.get(name);
  };

  const boxMaterial = () => new THREE.MeshLambertMaterial({ color: 0xb0a590 });

  // A thing as it stands; a box where its model is not there.
  sdgen.placed = (thing, model, size) => {
    const holder = new THREE.Group();
    holder.position.set(...thing.at);
    holder.quaternion.set(...thing.turn);
    holder.userData.id = thing.id;
    if (!model) {
      const mesh = new THREE.Mesh(new THREE.BoxGeometry(...size), boxMaterial());
      mesh.position.z = size[2] / 2;
      return holder.add(mesh);
    }
    for (const part of model.variants[thing.variant || "default"] || []) {
      const { geometry, material } = model.found.get(part) || {};
      if (!geometry) continue;
      const mesh = new THREE.Mesh(geometry, material);
      const moved = thing.parts?.[part];
      if (moved) {
        mesh.matrixAutoUpdate = false;
        mesh.matrix.set(...moved);
      }
      holder.add(mesh);
    }
    return holder;
  };
}
