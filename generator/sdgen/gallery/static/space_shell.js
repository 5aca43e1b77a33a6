// Floors, walls and ceilings of a home for the 3-D view, as boxes whose surfaces run on in metres.
"use strict";
{
  const PLAIN = { floor: 0xb9a88c, wall: 0xe9e4da, ceiling: 0xf2f0ec };
  // Side of a box: the axis it looks along, which way, and the axes of its surface.
  const SIDES = [[0, 1, 1, 2], [0, -1, 1, 2], [1, 1, 0, 2], [1, -1, 0, 2], [2, 1, 0, 1], [2, -1, 0, 1]];
  const FACING = { "+x": SIDES[0], "-x": SIDES[1], "+y": SIDES[2], "-y": SIDES[3] };
  const BAND_M = 0.0015; // how far bands lie before their wall

  function quad(into, [axis, way, across, up], at, low, high) {
    const first = into.points.length / 3;
    const normal = [0, 0, 0];
    normal[axis] = way;
    for (const [a, b] of [[low[0], low[1]], [high[0], low[1]], [high[0], high[1]], [low[0], high[1]]]) {
      const point = [0, 0, 0];
      point[axis] = at;
      point[across] = a;
      point[up] = b;
      into.points.push(...point);
      into.normals.push(...normal);
      into.uvs.push(a, b);
    }
    // Counter-clockwise seen from where it looks.
    const turned = (way > 0) === (axis !== 1);
    const corners = turned ? [0, 1, 2, 0, 2, 3] : [0, 2, 1, 0, 3, 2];
    into.faces.push(...corners.map((k) => first + k));
  }

  function faces(one) {
    const by = new Map();
    const into = (surface) => {
      if (!by.has(surface)) by.set(surface, { points: [], normals: [], uvs: [], faces: [] });
      return by.get(surface);
    };
    for (const [x, y, z, dx, dy, dz] of one.pieces) {
      const middle = [x, y, z], half = [dx / 2, dy / 2, dz / 2];
      for (const side of SIDES) {
        const [axis, way, across, up] = side;
        const low = [middle[across] - half[across], middle[up] - half[up]];
        const high = [middle[across] + half[across], middle[up] + half[up]];
        const at = middle[axis] + way * half[axis];
        quad(into(one.surface), side, at, low, high);
        one.bands.forEach(([surface, facing, ...edges], number) => {
          if (FACING[facing] !== side) return;
          const a = [Math.max(low[0], edges[0]), Math.max(low[1], edges[1])];
          const b = [Math.min(high[0], edges[2]), Math.min(high[1], edges[3])];
          // Of bands that overlap the first is seen.
          const before = at + way * BAND_M * (1 + (one.bands.length - number) / one.bands.length);
          if (a[0] < b[0] && a[1] < b[1]) quad(into(surface), side, before, a, b);
        });
      }
    }
    return by;
  }

  // Which way a wall looks into its room: [axis, way].
  function inward(one, rooms) {
    const [, facing] = one.bands[0] || [];
    if (FACING[facing]) return FACING[facing].slice(0, 2);
    const [x, y, , dx, dy] = one.pieces[0];
    const axis = dx < dy ? 0 : 1;
    const polygon = rooms.get(one.room)?.polygon || [[x, y]];
    const middle = polygon.reduce((sum, point) => sum + point[axis], 0) / polygon.length;
    return [axis, middle > (axis ? y : x) ? 1 : -1];
  }

  sdgen.shell = (data) => {
    const rooms = new Map(data.rooms.map((room) => [room.id, room]));
    const materials = new Map();
    const material = (surface, category) => {
      const key = `${surface}/${category}`;
      if (materials.has(key)) return materials.get(key);
      const known = sdgen.surfaces.get(surface);
      const made = new THREE.MeshLambertMaterial({ color: known ? 0xffffff : PLAIN[category] });
      if (known) {
        made.map = new THREE.TextureLoader().load(known.picture, () => sdgen.redraw?.());
        made.map.colorSpace = THREE.SRGBColorSpace;
        made.map.wrapS = made.map.wrapT = THREE.RepeatWrapping;
        made.map.repeat.set(1 / known.size, 1 / known.size);
        made.map.anisotropy = 4;
      }
      materials.set(key, made);
      return made;
    };
    const group = new THREE.Group();
    const walls = [], ceilings = [];
    for (const one of data.shell) {
      const holder = new THREE.Group();
      for (const [surface, made] of faces(one)) {
        const geometry = new THREE.BufferGeometry();
        for (const [name, values, size] of [["position", made.points, 3], ["normal", made.normals, 3], ["uv", made.uvs, 2]]) {
          geometry.setAttribute(name, new THREE.BufferAttribute(new Float32Array(values), size));
        }
        geometry.setIndex(made.faces);
        holder.add(new THREE.Mesh(geometry, material(surface, one.category)));
      }
      group.add(holder);
      if (one.category === "ceiling") { ceilings.push(holder); holder.visible = false; }
      if (one.category === "wall" && one.pieces.length) {
        const [axis, way] = inward(one, rooms);
        walls.push({ holder, axis, way, at: one.pieces[0][axis] });
      }
    }
    const wallMaterials = [...materials].filter(([key]) => key.endsWith("/wall")).map(([, made]) => made);
    return { group, walls, ceilings, wallMaterials };
  };
}
