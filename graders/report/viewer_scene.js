/* The things of a scene for viewer.js: surfaces, marks, numbers, vectors, voxels as three.js sees them. */
"use strict";

(function () {
  const colours = {
    missing: 0xd6202f, duplicate: 0xf08a10, extra: 0xbe19a0, degenerate: 0x0068be,
    boundary: 0xf0c400, flipped: 0xa83e16, wrong: 0x3c2878, right: 0x008060,
    "turn-0": 0x426eaa, "turn-1": 0x927030, "turn-2": 0x68b2d6, "turn-3": 0x707a8a, "turn-4": 0x78843e, "turn-5": 0xb47c98
  };
  const few_vertices = 36, path_heads = 14, most_vectors = 800;
  const scale_colours = [0x440154, 0x472d7b, 0x3b528b, 0x2c728e, 0x21918c, 0x28ae80, 0x5ec962, 0xaddc30, 0xfde725];
  const no_value_colour = 0xb0b4ba;
  const strip_colours = [0x56a0d3, 0xf0ba5c, 0x9e96ce, 0xece280, 0xd68cb2, 0xb2c0ca];
  const front_colour = 0xdfe5ee, back_colour = 0xf2c28f, voxel_colour = 0x8fb3d3;
  const words = {
    input: { en: "input", es: "entrada" },
    answer: { en: "answer", es: "respuesta" }
  };

  function bytes_of(base64) {
    const text = atob(base64);
    const bytes = new Uint8Array(text.length);
    for (let i = 0; i < text.length; i++) bytes[i] = text.charCodeAt(i);
    return bytes;
  }
  const floats_of = (base64) => new Float32Array(bytes_of(base64).buffer);
  const indices_of = (base64) => new Uint32Array(bytes_of(base64).buffer);

  /* ------------------------------------------------------------ surfaces and edges */

  /* Front and back of a surface as two meshes: a back in another colour shows holes and flipped
     triangles at once. */
  function add_surface(group, geometry, colour, colour_behind) {
    geometry.computeVertexNormals();
    const has_colours = Boolean(geometry.attributes.color);
    if (has_colours) colour = colour_behind = 0xffffff;
    for (const [side, side_colour] of [[THREE.FrontSide, colour], [THREE.BackSide, colour_behind]]) {
      const material = new THREE.MeshPhongMaterial({
        color: side_colour, side: side, specular: has_colours ? 0 : 0x222222, shininess: 22,
        vertexColors: has_colours ? THREE.VertexColors : THREE.NoColors,
        polygonOffset: true, polygonOffsetFactor: 1, polygonOffsetUnits: 1
      });
      group.add(new THREE.Mesh(geometry, material));
    }
  }

  function geometry_of(positions, triangles) {
    const geometry = new THREE.BufferGeometry();
    geometry.setAttribute("position", new THREE.BufferAttribute(positions, 3));
    if (triangles) geometry.setIndex(new THREE.BufferAttribute(triangles, 1));
    return geometry;
  }

  /* Every edge once, as pairs of positions. */
  function edges_of(positions, triangles) {
    const seen = new Set();
    const points = [];
    const count = positions.length / 3;
    for (let i = 0; i < triangles.length; i++) {
      const a = triangles[i], b = triangles[i % 3 === 2 ? i - 2 : i + 1];
      const key = Math.min(a, b) * count + Math.max(a, b);
      if (a === b || seen.has(key)) continue;
      seen.add(key);
      points.push(...point(positions, a), ...point(positions, b));
    }
    return points;
  }

  const point = (positions, i) => [positions[3 * i], positions[3 * i + 1], positions[3 * i + 2]];

  /* How opaque edges should be: those of dense meshes fade, so that they do not blacken the surface. As
     in the renderer, long edges close together count by the area that they share. */
  function wire_opacity(points, area) {
    const box = new THREE.Box3().setFromArray(points), from = new THREE.Vector3(), to = new THREE.Vector3();
    const view_pixels = 420, opaque_spacing = 28;
    let sum = 0;
    for (let i = 0; i + 5 < points.length; i += 6) sum += from.fromArray(points, i).distanceTo(to.fromArray(points, i + 3));
    const mean = sum / (points.length / 6), by_area = sum > 0 ? area / sum * 2 * Math.sqrt(3) : 0;
    const spacing = Math.min(mean, by_area) / box.getSize(new THREE.Vector3()).length();
    return Math.max(0.01, Math.min(0.5, spacing * view_pixels / opaque_spacing));
  }

  function area_of(positions, triangles) {
    const a = new THREE.Vector3(), b = new THREE.Vector3(), c = new THREE.Vector3();
    let sum = 0;
    for (let i = 0; i + 2 < triangles.length; i += 3) {
      a.fromArray(positions, 3 * triangles[i]);
      b.fromArray(positions, 3 * triangles[i + 1]).sub(a);
      sum += b.cross(c.fromArray(positions, 3 * triangles[i + 2]).sub(a)).length() / 2;
    }
    return sum;
  }

  function add_edges(group, points, opacity) {
    const geometry = new THREE.BufferGeometry();
    geometry.setAttribute("position", new THREE.Float32BufferAttribute(points, 3));
    group.add(new THREE.LineSegments(geometry, new THREE.LineBasicMaterial({ color: 0x1a2433, transparent: true, opacity: opacity })));
  }

  /* ------------------------------------------------------------ marks */

  /* Marks are drawn twice: as they are, and pale through the surface, so that those behind show. Not
     those of what is no fault and would only hide what lies before it. */
  function add_twice(group, make, has_ghost) {
    group.add(make(1, true));
    if (has_ghost === false) return;
    const ghost = make(0.22, false);
    ghost.renderOrder = 1;
    group.add(ghost);
  }

  function add_edge_marks(group, points, colour, lines, has_ghost, width) {
    const geometry = new THREE.LineSegmentsGeometry();
    geometry.setPositions(points);
    add_twice(group, function (opacity, depth_test) {
      const material = new THREE.LineMaterial({ color: colour, linewidth: width || 5, transparent: true, opacity: opacity, depthTest: depth_test });
      lines.push(material);
      return new THREE.LineSegments2(geometry, material);
    }, has_ghost);
  }

  function disc_texture() {
    const canvas = document.createElement("canvas");
    canvas.width = canvas.height = 64;
    const context = canvas.getContext("2d");
    context.beginPath();
    context.arc(32, 32, 28, 0, 2 * Math.PI);
    context.fillStyle = "#fff";
    context.fill();
    return new THREE.CanvasTexture(canvas);
  }

  function add_vertex_marks(group, points, colour) {
    const geometry = new THREE.BufferGeometry();
    geometry.setAttribute("position", new THREE.Float32BufferAttribute(points, 3));
    const texture = disc_texture();
    add_twice(group, (opacity, depth_test) => new THREE.Points(geometry, new THREE.PointsMaterial({
      color: colour, size: 13, sizeAttenuation: false, map: texture, alphaTest: 0.1, transparent: true,
      opacity: opacity, depthTest: depth_test
    })));
  }

  function add_triangle_marks(group, points, colour, has_ghost) {
    const geometry = new THREE.BufferGeometry();
    geometry.setAttribute("position", new THREE.Float32BufferAttribute(points, 3));
    add_twice(group, (opacity, depth_test) => new THREE.Mesh(geometry, new THREE.MeshBasicMaterial({
      color: colour, side: THREE.DoubleSide, transparent: true, opacity: depth_test ? 0.85 : opacity, depthTest: depth_test,
      polygonOffset: true, polygonOffsetFactor: -1, polygonOffsetUnits: -1
    })), has_ghost);
  }

  /* Heads of arrows, [tip side, way] each, as cones of one size. */
  function add_heads(group, heads, colour, size, has_ghost) {
    if (heads.length === 0) return;
    const cone = new THREE.ConeBufferGeometry(size / 2.3, size, 12).toNonIndexed();
    const points = [], up = new THREE.Vector3(0, 1, 0);
    for (const head of heads) {
      const turn = new THREE.Quaternion().setFromUnitVectors(up, head.way.clone().normalize());
      const corner = new THREE.Vector3(), from = cone.attributes.position;
      for (let i = 0; i < from.count; i++) {
        corner.fromBufferAttribute(from, i).multiplyScalar(head.scale).applyQuaternion(turn).add(head.at);
        points.push(corner.x, corner.y, corner.z);
      }
    }
    const geometry = geometry_of(new Float32Array(points));
    add_twice(group, (opacity, depth_test) => new THREE.Mesh(geometry, new THREE.MeshBasicMaterial({
      color: colour, transparent: true, opacity: opacity, depthTest: depth_test
    })), has_ghost);
  }

  const vector_at = (positions, i) => new THREE.Vector3(...point(positions, i));

  /* A half edge lies a little inside its face: its two ends. */
  function half_edge_ends(corners) {
    const a = corners[0], b = corners[1], normal = new THREE.Vector3();
    for (let i = 0; i < corners.length; i++)
      normal.add(corners[i].clone().sub(a).cross(corners[(i + 1) % corners.length].clone().sub(a)));
    const along = b.clone().sub(a), inwards = normal.clone().cross(along).normalize();
    const depth = Math.max(...corners.map((corner) => corner.clone().sub(a).dot(inwards)));
    const aside = inwards.multiplyScalar(Math.min(0.3 * depth, 0.08 * along.length()));
    return [a.clone().addScaledVector(along, 0.1).add(aside), b.clone().addScaledVector(along, -0.1).add(aside)];
  }

  /* The lines and heads of an arrow, a half edge, a path or a loop. */
  function add_steps(batch, mark, positions, size) {
    let places = mark.vertex.map((v) => vector_at(positions, v));
    if (mark.element === "half-edge") places = half_edge_ends(places);
    if (mark.element === "loop") places.push(places[0]);
    const is_path = mark.element === "path" || mark.element === "loop";
    let since = is_path ? path_heads * size / 4 : 0;
    for (let i = 0; i + 1 < places.length; i++) {
      const way = places[i + 1].clone().sub(places[i]), step = way.length();
      batch.segments.push(...places[i].toArray(), ...places[i + 1].toArray());
      since += step;
      const is_last = i + 2 === places.length;
      if (step === 0 || (is_path && since < path_heads * size / 2 && !(is_last && batch.heads.length === 0))) continue;
      const scale = is_path ? 1 : Math.min(1, 0.45 * step / size);
      const at = is_path ? places[i].clone().addScaledVector(way, 0.5)
        : places[i + 1].clone().addScaledVector(way, -scale * size / 2 / step);
      batch.heads.push({ at: at, way: way, scale: scale });
      since = 0;
    }
  }

  function add_marks(group, marks, positions, lines, has_colours) {
    const batches = {};
    const count = positions.length / 3;
    const box = new THREE.Box3().setFromArray(positions);
    const size = 0.03 * box.getSize(new THREE.Vector3()).length(); /* of a head */
    for (const mark of marks || []) {
      if (!(mark.kind in colours) || mark.vertex.some((v) => !(v >= 0 && v < count))) continue;
      const solid = mark.kind.startsWith("turn") && (mark.element === "face" || mark.element === "triangle" || mark.element === "half-edge");
      const key = mark.kind + (solid ? " solid" : "");
      const is_outline = has_colours && (mark.element === "face" || mark.element === "triangle"); /* the colours under it must be seen */
      const batch = batches[key] = batches[key] || { vertices: [], segments: [], heads: [], triangles: [] };
      const corners = (list) => [].concat(...list.map((v) => point(positions, v)));
      if (mark.element === "vertex" || (mark.element === "edge" && mark.vertex[0] === mark.vertex[1]))
        batch.vertices.push(...point(positions, mark.vertex[0]));
      else if (is_outline)
        mark.vertex.forEach((v, i) => batch.segments.push(...corners([v, mark.vertex[(i + 1) % mark.vertex.length]])));
      else if (mark.element === "edge") batch.segments.push(...corners(mark.vertex));
      else if (mark.element === "triangle") batch.triangles.push(...corners(mark.vertex));
      else if (mark.element === "face") batch.triangles.push(...corners(mark.fill || mark.vertex));
      else add_steps(batch, mark, positions, size);
    }
    for (const key of Object.keys(batches)) {
      const [kind, solid] = key.split(" "), batch = batches[key], colour = colours[kind];
      if (batch.vertices.length) add_vertex_marks(group, batch.vertices, colour);
      if (batch.segments.length) add_edge_marks(group, batch.segments, colour, lines, !solid);
      if (batch.triangles.length) add_triangle_marks(group, batch.triangles, colour, !solid);
      add_heads(group, batch.heads, colour, size, !solid);
    }
  }

  /* ------------------------------------------------------------ numbers */

  /* A number as a picture: plain for a vertex, in a box for an edge, in a circle for a face. */
  function number_texture(text, element) {
    const canvas = document.createElement("canvas"), context = canvas.getContext("2d");
    const style = "600 40px sans-serif";
    context.font = style;
    const width = Math.max(64, Math.ceil(context.measureText(text).width) + 28);
    canvas.width = width;
    canvas.height = 64;
    const round = element === "edge" ? 6 : 30;
    context.beginPath();
    context.moveTo(4 + round, 4);
    context.arcTo(width - 4, 4, width - 4, 60, round);
    context.arcTo(width - 4, 60, 4, 60, round);
    context.arcTo(4, 60, 4, 4, round);
    context.arcTo(4, 4, width - 4, 4, round);
    context.fillStyle = element === "vertex" ? "rgba(255,255,255,0.75)" : "#fff";
    context.fill();
    context.lineWidth = 4;
    context.strokeStyle = "#1a212e";
    if (element !== "vertex") context.stroke();
    context.font = style;
    context.fillStyle = "#1a212e";
    context.textAlign = "center";
    context.textBaseline = "middle";
    context.fillText(text, width / 2, 34);
    const texture = new THREE.CanvasTexture(canvas);
    texture.minFilter = THREE.LinearFilter;
    return { texture: texture, wide: width / 64 };
  }

  /* A number where an element is; of vertices behind the surface it is pale. The view keeps it a little nearer
     to the eye than the surface (userData.home). */
  function add_number(group, at, text, element) {
    const picture = number_texture(text, element), high = element === "vertex" ? 0.018 : 0.022;
    add_twice(group, function (opacity, depth_test) {
      const sprite = new THREE.Sprite(new THREE.SpriteMaterial({
        map: picture.texture, sizeAttenuation: false, transparent: true, depthTest: depth_test, opacity: depth_test ? 1 : 0.3
      }));
      if (element === "vertex") sprite.center.set(0.5, -0.35);
      sprite.scale.set(high * picture.wide, high, 1);
      sprite.position.copy(at);
      sprite.userData.home = at.clone();
      return sprite;
    }, element === "vertex");
  }

  function middle_of(positions, vertices) {
    const sum = new THREE.Vector3();
    for (const v of vertices) sum.add(vector_at(positions, v));
    return sum.multiplyScalar(1 / vertices.length);
  }

  /* A place inside a face: the middle of its corners, or of its largest triangle when it is concave. */
  function place_of(positions, label) {
    if (!label.fill) return middle_of(positions, label.vertex);
    let best = null, most = -1;
    for (let i = 0; i + 2 < label.fill.length; i += 3) {
      const corners = label.fill.slice(i, i + 3), [a, b, c] = corners.map((v) => vector_at(positions, v));
      const area = b.clone().sub(a).cross(c.clone().sub(a)).length();
      if (area > most) { most = area; best = middle_of(positions, corners); }
    }
    return label.vertex.length > 4 ? best : middle_of(positions, label.vertex);
  }

  function add_numbers(group, scene, positions) {
    const count = positions.length / 3, named = new Set();
    for (const label of scene.labels || []) {
      if (label.vertex.some((v) => !(v >= 0 && v < count))) continue;
      if (label.element === "vertex") named.add(label.vertex[0]);
      add_number(group, place_of(positions, label), String(label.number), label.element);
    }
    for (let v = 0; v < count && count <= few_vertices && !scene.cut; v++)
      if (!named.has(v)) add_number(group, vector_at(positions, v), String(v), "vertex");
  }

  /* ------------------------------------------------------------ kinds of scene */

  /* The outlines of polygons, as pairs of positions. */
  function outlines_of(positions, polygons) {
    const sizes = indices_of(polygons.sizes), corners = indices_of(polygons.corners), points = [];
    let first = 0;
    for (const size of sizes) {
      for (let i = 0; i < size; i++)
        points.push(...point(positions, corners[first + i]), ...point(positions, corners[first + (i + 1) % size]));
      first += size;
    }
    return points;
  }

  function scale_colour(value, scale) {
    if (!isFinite(value)) return new THREE.Color(no_value_colour);
    const share = scale.high > scale.low ? (value - scale.low) / (scale.high - scale.low) : 0;
    const at = Math.min(1, Math.max(0, share)) * (scale_colours.length - 1), low = Math.min(Math.floor(at), scale_colours.length - 2);
    return new THREE.Color(scale_colours[low]).lerp(new THREE.Color(scale_colours[low + 1]), at - low);
  }

  /* The colour of corner i of the triangles, by the scene's values or parts; null: it has none. */
  function corner_colours(scene, triangles) {
    if (scene.values) {
      const numbers = floats_of(scene.values.numbers), of_vertices = scene.values.of === "vertex";
      return (i) => scale_colour(numbers[of_vertices ? triangles[i] : Math.floor(i / 3)], scene.values);
    }
    if (!scene.parts) return null;
    const groups = bytes_of(scene.parts), plain = new THREE.Color(front_colour);
    return function (i) {
      const turn = colours["turn-" + groups[Math.floor(i / 3)]];
      return turn === undefined ? plain : plain.clone().lerp(new THREE.Color(turn), 0.72);
    };
  }

  function add_corner_colours(geometry, colour_of) {
    const count = geometry.attributes.position.count, rgb = new Float32Array(3 * count);
    for (let i = 0; i < count; i++) colour_of(i).toArray(rgb, 3 * i);
    geometry.setAttribute("color", new THREE.BufferAttribute(rgb, 3));
  }

  /* Arrows at the vertices, at most so many, all of one scale. */
  function add_vectors(group, scene, positions, lines) {
    const size = 0.02 * new THREE.Box3().setFromArray(positions).getSize(new THREE.Vector3()).length();
    const count = positions.length / 3, step = Math.ceil(count / most_vectors);
    const sets = scene.vectors.map((set) => floats_of(set.xyz));
    const named = scene.marks && scene.marks.length ? scene.marks[0].vertex : [];
    const shown = [];
    for (let v = 0; v < count; v++) if ((Math.imul(v, 0x9e3779b1) >>> 8) % step === 0 || named.includes(v)) shown.push(v);
    const is_arrow = (vector) => isFinite(vector.length()) && vector.length() > 0;
    const lengths = [].concat(...sets.map((xyz) => shown.map((v) => vector_at(xyz, v)).filter(is_arrow).map((vector) => vector.length())));
    lengths.sort((a, b) => a - b);
    const usual = lengths[Math.floor(0.9 * lengths.length)] || 1;
    scene.vectors.forEach(function (set, i) {
      if (!(set.kind in colours)) return;
      const segments = [], heads = [], zeros = [];
      for (const v of shown) {
        const at = vector_at(positions, v), vector = vector_at(sets[i], v);
        if (vector.length() === 0) zeros.push(...at.toArray());
        if (!is_arrow(vector)) continue;
        vector.setLength(Math.min(5 * size * vector.length() / usual, 10 * size));
        const tip = at.clone().add(vector), scale = Math.min(1, 0.45 * vector.length() / size);
        segments.push(...at.toArray(), ...tip.toArray());
        heads.push({ at: tip.addScaledVector(vector, -scale * size / 2 / vector.length()), way: vector, scale: scale });
      }
      if (segments.length) add_edge_marks(group, segments, colours[set.kind], lines, false, 2.5);
      add_heads(group, heads, colours[set.kind], size, false);
      if (zeros.length) add_vertex_marks(group, zeros, colours[set.kind]);
    });
  }

  function add_mesh(group, scene, lines) {
    const positions = floats_of(scene.mesh.positions), triangles = indices_of(scene.mesh.triangles);
    if (positions.length > 0 && triangles.length > 0) {
      const geometry = geometry_of(positions, triangles); /* polygons and few faces are flat */
      const colour_of = corner_colours(scene, triangles);
      const flat = scene.polygons || colour_of || triangles.length < 3 * few_vertices;
      const surface = flat ? geometry.toNonIndexed() : geometry;
      if (colour_of) add_corner_colours(surface, colour_of);
      add_surface(group, surface, front_colour, back_colour);
      const wire = scene.polygons ? outlines_of(positions, scene.polygons) : edges_of(positions, triangles);
      add_edges(group, wire, wire_opacity(wire, area_of(positions, triangles)));
    }
    add_marks(group, scene.marks, positions, lines, Boolean(scene.values || scene.parts));
    if (scene.vectors) add_vectors(group, scene, positions, lines);
    add_numbers(group, scene, positions);
  }

  /* Two meshes side by side as the camera first sees them, moved apart by their sizes. */
  function add_pair(group, scene, lines) {
    const aside = new THREE.Vector3(0.82, 0.57, 0); /* to the right as the camera sees it */
    const language = document.documentElement.lang === "es" ? "es" : "en";
    const sides = [[scene, words.input], [scene.answer, words.answer]].map(function ([mesh, name]) {
      const side = new THREE.Group();
      add_mesh(side, mesh, lines);
      const box = new THREE.Box3().setFromArray(floats_of(mesh.mesh.positions));
      return { group: side, box: box, radius: box.isEmpty() ? 0 : box.getSize(new THREE.Vector3()).length() / 2, name: name[language] };
    });
    const apart = Math.max(sides[0].radius, sides[1].radius) * 1.05;
    sides.forEach(function (side, i) {
      const centre = side.box.isEmpty() ? new THREE.Vector3() : side.box.getCenter(new THREE.Vector3());
      const below = new THREE.Vector3(centre.x, centre.y, side.box.isEmpty() ? 0 : side.box.min.z - 0.16 * apart);
      add_number(side.group, below, side.name, "edge");
      side.group.position.copy(aside).multiplyScalar(i === 0 ? -apart : apart).sub(centre);
      group.add(side.group);
    });
  }

  /* Strips in turn colours; a triangle with the wrong winding shows its back, in the mark's colour. */
  function add_strips(group, strips) {
    strips.forEach(function (strip, number) {
      const positions = floats_of(strip.positions);
      const triangles = [];
      for (let i = 0; i + 2 < positions.length / 3; i++)
        triangles.push(i, ...(i % 2 ? [i + 2, i + 1] : [i + 1, i + 2]));
      const flat = geometry_of(positions, new Uint32Array(triangles)).toNonIndexed();
      add_surface(group, flat, strip_colours[number % strip_colours.length], colours.flipped);
      const wire = edges_of(positions, triangles);
      add_edges(group, wire, wire_opacity(wire, area_of(positions, triangles)));
    });
  }

  const cube_faces = [
    [[1, 0, 0], [[1, 0, 0], [1, 1, 0], [1, 1, 1], [1, 0, 1]]], [[-1, 0, 0], [[0, 0, 0], [0, 0, 1], [0, 1, 1], [0, 1, 0]]],
    [[0, 1, 0], [[0, 1, 0], [0, 1, 1], [1, 1, 1], [1, 1, 0]]], [[0, -1, 0], [[0, 0, 0], [1, 0, 0], [1, 0, 1], [0, 0, 1]]],
    [[0, 0, 1], [[0, 0, 1], [1, 0, 1], [1, 1, 1], [0, 1, 1]]], [[0, 0, -1], [[0, 0, 0], [0, 1, 0], [1, 1, 0], [1, 0, 0]]]
  ];

  /* The faces of full cells towards empty ones, of the cube [-1/2, 1/2]^3. Cells that are wrong have
     the colour of what sticks out or is missing, and the named one has a frame. */
  function add_voxels(group, voxels, lines) {
    const k = voxels.per_side, bits = bytes_of(voxels.bits), wrong = voxels.wrong ? bytes_of(voxels.wrong) : null;
    const is_set = function (of, x, y, z) {
      if (of === null || Math.min(x, y, z) < 0 || Math.max(x, y, z) >= k) return false;
      const i = x + k * (y + k * z);
      return (of[i >> 3] >> (i & 7) & 1) === 1;
    };
    const kind_of = function (x, y, z) { /* 0: empty */
      const full = is_set(bits, x, y, z);
      return is_set(wrong, x, y, z) ? (full ? "extra" : "missing") : full ? "full" : 0;
    };
    const place = (x, y, z) => [x / k - 0.5, y / k - 0.5, z / k - 0.5];
    const points = { full: [], extra: [], missing: [] }, outlines = [];
    for (let z = 0; z < k; z++) for (let y = 0; y < k; y++) for (let x = 0; x < k; x++) {
      const kind = kind_of(x, y, z);
      if (!kind) continue;
      for (const [[dx, dy, dz], corners] of cube_faces) {
        const beside = kind_of(x + dx, y + dy, z + dz);
        if (beside === kind || (kind !== "missing" && beside && beside !== "missing")) continue;
        const at = corners.map((c) => place(x + c[0], y + c[1], z + c[2]));
        for (const i of [0, 1, 2, 0, 2, 3]) points[kind].push(...at[i]);
        for (let i = 0; i < 4; i++) outlines.push(...at[i], ...at[(i + 1) % 4]);
      }
    }
    const paints = { full: voxel_colour, extra: colours.extra, missing: colours.missing };
    for (const kind of Object.keys(points))
      if (points[kind].length) add_surface(group, geometry_of(new Float32Array(points[kind])), paints[kind], paints[kind]);
    if (outlines.length) add_edges(group, outlines, Math.max(0.1, Math.min(0.5, 8 / k)));
    if (!(voxels.named >= 0)) return;
    const x = voxels.named % k, y = Math.floor(voxels.named / k) % k, z = Math.floor(voxels.named / k / k), frame = [];
    for (const [, corners] of cube_faces)
      for (let i = 0; i < 4; i++)
        for (const c of [corners[i], corners[(i + 1) % 4]]) frame.push(...place(x + c[0], y + c[1], z + c[2]));
    add_edge_marks(group, frame, colours.wrong, lines);
  }

  function build(scene, lines) {
    const group = new THREE.Group();
    if (scene.kind === "strips") {
      add_strips(group, scene.strips || []);
      if (scene.mesh) add_marks(group, scene.marks, floats_of(scene.mesh.positions), lines); /* what marks name */
      return group;
    }
    if (scene.kind === "voxels") {
      const cells = new THREE.Group(), beside = new THREE.Group();
      add_voxels(cells, scene.voxels, lines);
      const aside = new THREE.Vector3(0.49, 0.34, 0); /* to the right as the camera sees it */
      if (scene.mesh) cells.position.copy(aside).negate();
      group.add(cells);
      if (scene.mesh) {
        add_mesh(beside, scene, lines);
        beside.position.copy(aside);
        group.add(beside);
      }
      return group;
    }
    if (scene.mesh && scene.answer) add_pair(group, scene, lines);
    else if (scene.mesh) add_mesh(group, scene, lines);
    return group;
  }

  window.meshgrade_build = build;
})();
