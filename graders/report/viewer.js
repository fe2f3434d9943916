/* The interactive view of a scene (graders/render/README.md): the mesh with its marks in the
   renderer's colours, turned with mouse, finger or keyboard. The library three.js and the scene are
   loaded when a view is asked for, by script elements, because a page on file:// may load nothing
   else. */
"use strict";

(function () {
  const library = ["three.min.js", "OrbitControls.js", "LineSegmentsGeometry.js", "LineMaterial.js", "LineSegments2.js"];
  const assets = document.currentScript.src.replace(/[^/]*$/, "");
  const most_views = 6;
  const colours = {
    missing: 0xd6202f, duplicate: 0xf08a10, extra: 0xbe19a0, degenerate: 0x0068be,
    boundary: 0xf0c400, flipped: 0xa83e16, wrong: 0x3c2878, right: 0x008060,
    "turn-0": 0x426eaa, "turn-1": 0x927030, "turn-2": 0x68b2d6, "turn-3": 0x707a8a, "turn-4": 0x78843e, "turn-5": 0xb47c98
  };
  const few_vertices = 36, path_heads = 14;
  const strip_colours = [0x56a0d3, 0xf0ba5c, 0x5cb896, 0xd68cb2, 0xece280, 0x9e96ce];
  const front_colour = 0xdfe5ee, back_colour = 0xf2c28f, voxel_colour = 0x8fb3d3, backdrop = 0xeef2f6;
  const words = {
    failed: { en: "The 3D view could not be shown here (no WebGL?).", es: "La vista 3D no se pudo mostrar aquí (¿sin WebGL?)." },
    label: {
      en: "3D view: drag or use the arrow keys to turn, + and - to zoom",
      es: "Vista 3D: arrastra o usa las flechas para girar, + y - para acercar"
    }
  };
  const scenes = {};
  const open_views = [];

  /* ------------------------------------------------------------ loading */

  function load_script(url) {
    return new Promise(function (resolve, reject) {
      const script = document.createElement("script");
      script.src = url;
      script.onload = resolve;
      script.onerror = function () { reject(new Error("cannot load " + url)); };
      document.head.append(script);
    });
  }

  let library_ready = null;
  function load_library() {
    if (!library_ready)
      library_ready = library.reduce((before, name) => before.then(() => load_script(assets + name)), Promise.resolve());
    return library_ready;
  }

  /* Each scene's script calls this with what it holds. */
  window.meshgrade_scene = function (key, scene) { scenes[key] = scene; };

  function load_scene(view) {
    const key = view.dataset.key;
    if (scenes[key]) return Promise.resolve(scenes[key]);
    return load_script(view.dataset.scene).then(() => scenes[key]);
  }

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
    for (const [side, side_colour] of [[THREE.FrontSide, colour], [THREE.BackSide, colour_behind]]) {
      const material = new THREE.MeshPhongMaterial({
        color: side_colour, side: side, specular: 0x222222, shininess: 22,
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

  function add_edges(group, points) {
    const geometry = new THREE.BufferGeometry();
    geometry.setAttribute("position", new THREE.Float32BufferAttribute(points, 3));
    const opacity = Math.max(0.1, Math.min(0.5, 900 / Math.sqrt(points.length + 1) / 28));
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

  function add_edge_marks(group, points, colour, lines, has_ghost) {
    const geometry = new THREE.LineSegmentsGeometry();
    geometry.setPositions(points);
    add_twice(group, function (opacity, depth_test) {
      const material = new THREE.LineMaterial({ color: colour, linewidth: 5, transparent: true, opacity: opacity, depthTest: depth_test });
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

  function add_marks(group, marks, positions, lines) {
    const batches = {};
    const count = positions.length / 3;
    const box = new THREE.Box3().setFromArray(positions);
    const size = 0.03 * box.getSize(new THREE.Vector3()).length(); /* of a head */
    for (const mark of marks || []) {
      if (!(mark.kind in colours) || mark.vertex.some((v) => !(v >= 0 && v < count))) continue;
      const solid = mark.kind.startsWith("turn") && (mark.element === "face" || mark.element === "triangle" || mark.element === "half-edge");
      const key = mark.kind + (solid ? " solid" : "");
      const batch = batches[key] = batches[key] || { vertices: [], segments: [], heads: [], triangles: [] };
      const corners = (list) => [].concat(...list.map((v) => point(positions, v)));
      if (mark.element === "vertex" || (mark.element === "edge" && mark.vertex[0] === mark.vertex[1]))
        batch.vertices.push(...point(positions, mark.vertex[0]));
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

  function add_mesh(group, scene, lines) {
    const positions = floats_of(scene.mesh.positions), triangles = indices_of(scene.mesh.triangles);
    if (positions.length > 0 && triangles.length > 0) {
      const geometry = geometry_of(positions, triangles); /* polygons and few faces are flat */
      const flat = scene.polygons || triangles.length < 3 * few_vertices;
      add_surface(group, flat ? geometry.toNonIndexed() : geometry, front_colour, back_colour);
      add_edges(group, scene.polygons ? outlines_of(positions, scene.polygons) : edges_of(positions, triangles));
    }
    add_marks(group, scene.marks, positions, lines);
    add_numbers(group, scene, positions);
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
      add_edges(group, edges_of(positions, triangles));
    });
  }

  const cube_faces = [
    [[1, 0, 0], [[1, 0, 0], [1, 1, 0], [1, 1, 1], [1, 0, 1]]], [[-1, 0, 0], [[0, 0, 0], [0, 0, 1], [0, 1, 1], [0, 1, 0]]],
    [[0, 1, 0], [[0, 1, 0], [0, 1, 1], [1, 1, 1], [1, 1, 0]]], [[0, -1, 0], [[0, 0, 0], [1, 0, 0], [1, 0, 1], [0, 0, 1]]],
    [[0, 0, 1], [[0, 0, 1], [1, 0, 1], [1, 1, 1], [0, 1, 1]]], [[0, 0, -1], [[0, 0, 0], [0, 1, 0], [1, 1, 0], [1, 0, 0]]]
  ];

  /* The faces of full cells towards empty ones, of the cube [-1/2, 1/2]^3. */
  function add_voxels(group, voxels) {
    const k = voxels.per_side, bits = bytes_of(voxels.bits);
    const is_full = function (x, y, z) {
      if (Math.min(x, y, z) < 0 || Math.max(x, y, z) >= k) return false;
      const i = x + k * (y + k * z);
      return (bits[i >> 3] >> (i & 7) & 1) === 1;
    };
    const points = [], outlines = [];
    for (let z = 0; z < k; z++) for (let y = 0; y < k; y++) for (let x = 0; x < k; x++) {
      if (!is_full(x, y, z)) continue;
      for (const [[dx, dy, dz], corners] of cube_faces) {
        if (is_full(x + dx, y + dy, z + dz)) continue;
        const at = corners.map((c) => [(x + c[0]) / k - 0.5, (y + c[1]) / k - 0.5, (z + c[2]) / k - 0.5]);
        for (const i of [0, 1, 2, 0, 2, 3]) points.push(...at[i]);
        for (let i = 0; i < 4; i++) outlines.push(...at[i], ...at[(i + 1) % 4]);
      }
    }
    if (points.length === 0) return;
    add_surface(group, geometry_of(new Float32Array(points)), voxel_colour, back_colour);
    add_edges(group, outlines);
  }

  function build(scene, lines) {
    const group = new THREE.Group();
    if (scene.kind === "strips") {
      add_strips(group, scene.strips || []);
      if (scene.mesh) add_marks(group, scene.marks, floats_of(scene.mesh.positions), lines); /* what marks name */
    } else if (scene.kind === "voxels") {
      const cells = new THREE.Group(), beside = new THREE.Group();
      add_voxels(cells, scene.voxels);
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
    if (scene.mesh) add_mesh(group, scene, lines);
    return group;
  }

  /* ------------------------------------------------------------ a view */

  /* The distance from which every corner of the box lies inside the picture. */
  function fitting_distance(camera, box, centre, direction, aspect) {
    const half = 0.94 * Math.tan(camera.fov * Math.PI / 360);
    const right = camera.up.clone().cross(direction).normalize();
    const upward = direction.clone().cross(right);
    let distance = 0;
    for (let i = 0; i < 8; i++) {
      const corner = new THREE.Vector3(i & 1 ? box.max.x : box.min.x, i & 2 ? box.max.y : box.min.y, i & 4 ? box.max.z : box.min.z).sub(centre);
      const wide = Math.abs(corner.dot(right)) / aspect, high = Math.abs(corner.dot(upward));
      distance = Math.max(distance, corner.dot(direction) + Math.max(wide, high) / half);
    }
    return distance;
  }

  function place_camera(camera, group, aspect) {
    const box = new THREE.Box3().setFromObject(group);
    const centre = box.getCenter(new THREE.Vector3());
    const size = box.getSize(new THREE.Vector3());
    const is_flat = size.z < 0.25 * Math.max(size.x, size.y);
    const azimuth = -55 * Math.PI / 180, elevation = (is_flat ? 48 : 24) * Math.PI / 180;
    const direction = new THREE.Vector3(Math.cos(elevation) * Math.cos(azimuth), Math.cos(elevation) * Math.sin(azimuth), Math.sin(elevation));
    const distance = Math.max(fitting_distance(camera, box, centre, direction, aspect), 1e-6);
    camera.position.copy(centre).addScaledVector(direction, distance);
    camera.near = distance / 100;
    camera.far = distance * 20;
    camera.lookAt(centre);
    camera.updateProjectionMatrix();
    return centre;
  }

  function add_lights(scene, camera) {
    const key = new THREE.DirectionalLight(0xfff8ee, 0.52), fill = new THREE.DirectionalLight(0xe8f0ff, 0.24);
    key.position.set(0.7, 0.9, 1);
    fill.position.set(-1, -0.4, 0.6);
    camera.add(key, fill);
    scene.add(camera, new THREE.AmbientLight(0xffffff, 0.36));
  }

  /* How many of the pixels just drawn are not the backdrop. */
  function count_drawn(renderer) {
    const gl = renderer.getContext();
    const width = gl.drawingBufferWidth, height = gl.drawingBufferHeight;
    const pixels = new Uint8Array(4 * width * height);
    gl.readPixels(0, 0, width, height, gl.RGBA, gl.UNSIGNED_BYTE, pixels);
    let drawn = 0;
    for (let i = 0; i < pixels.length; i += 4)
      if (Math.abs(pixels[i] - pixels[0]) + Math.abs(pixels[i + 1] - pixels[1]) + Math.abs(pixels[i + 2] - pixels[2]) > 12) drawn++;
    return drawn;
  }

  /* Browsers keep some sixteen drawings alive; the oldest makes room. */
  function close_oldest() {
    if (open_views.length < most_views) return;
    const oldest = open_views.shift();
    oldest.renderer.dispose();
    oldest.renderer.forceContextLoss();
    oldest.canvas.remove();
    oldest.view.classList.remove("shown");
    oldest.view.querySelector(".turn").hidden = false;
    const picture = oldest.view.parentElement.querySelector(".picture");
    if (picture) picture.hidden = false;
  }

  function turn_by_key(event, controls, camera, draw) {
    const step = 0.12;
    const turns = { ArrowLeft: [-step, 0], ArrowRight: [step, 0], ArrowUp: [0, -step], ArrowDown: [0, step] };
    const zooms = { "+": 0.88, "=": 0.88, "-": 1.14 };
    const offset = camera.position.clone().sub(controls.target);
    if (event.key in turns) {
      const axis = new THREE.Vector3(0, 0, 1).cross(offset).normalize();
      const raised = offset.clone().applyAxisAngle(axis, turns[event.key][1]);
      if (Math.abs(raised.z) < 0.999 * raised.length()) offset.copy(raised);
      offset.applyAxisAngle(new THREE.Vector3(0, 0, 1), turns[event.key][0]);
    } else if (event.key in zooms) {
      offset.multiplyScalar(zooms[event.key]);
    } else {
      return;
    }
    event.preventDefault();
    camera.position.copy(controls.target).add(offset);
    controls.update();
    draw();
  }

  function show(view, data) {
    close_oldest();
    view.classList.add("shown");
    const canvas = document.createElement("canvas");
    canvas.tabIndex = 0;
    canvas.setAttribute("role", "img");
    const spanish = document.documentElement.lang === "es";
    canvas.setAttribute("aria-label", spanish ? words.label.es : words.label.en);
    view.prepend(canvas);

    const lines = [];
    const renderer = new THREE.WebGLRenderer({ canvas: canvas, antialias: true });
    const scene = new THREE.Scene();
    const camera = new THREE.PerspectiveCamera(26, 4 / 3, 0.1, 100);
    camera.up.set(0, 0, 1);
    scene.background = new THREE.Color(backdrop);
    add_lights(scene, camera);
    const group = build(data, lines);
    scene.add(group);
    const centre = place_camera(camera, group, 4 / 3);
    const controls = new THREE.OrbitControls(camera, canvas);
    controls.target.copy(centre);
    controls.enableKeys = false;
    controls.enableZoom = false; /* the wheel scrolls the page until the view has the focus */

    function draw() {
      const width = view.clientWidth, height = view.clientHeight;
      renderer.setPixelRatio(Math.min(window.devicePixelRatio || 1, 2));
      renderer.setSize(width, height, false);
      camera.aspect = width / height;
      camera.updateProjectionMatrix();
      for (const material of lines) material.resolution.set(width, height);
      group.traverse(function (thing) {
        const home = thing.userData.home;
        if (home) thing.position.copy(home).addScaledVector(thing.parent.worldToLocal(camera.position.clone()).sub(home), 0.02);
      });
      renderer.render(scene, camera);
    }
    controls.update();
    controls.addEventListener("change", draw);
    canvas.addEventListener("keydown", (event) => turn_by_key(event, controls, camera, draw));
    canvas.addEventListener("pointerdown", () => canvas.focus({ preventScroll: true }));
    canvas.addEventListener("focus", () => { controls.enableZoom = true; });
    canvas.addEventListener("blur", () => { controls.enableZoom = false; });
    window.addEventListener("resize", () => { if (canvas.isConnected) draw(); });
    open_views.push({ view: view, canvas: canvas, renderer: renderer });
    draw();
    view.dataset.drawn = String(count_drawn(renderer));
  }

  function say_failed(view, error) {
    view.classList.remove("shown");
    const canvas = view.querySelector("canvas");
    if (canvas) canvas.remove();
    const note = document.createElement("p");
    note.className = "view-note";
    for (const language of ["en", "es"]) {
      const text = document.createElement("span");
      text.lang = language;
      text.textContent = words.failed[language];
      note.append(text);
    }
    view.append(note);
    view.dataset.failed = error.message;
  }

  function open(view) {
    const button = view.querySelector(".turn");
    const picture = view.parentElement.querySelector(".picture");
    if (button.hidden) return;
    button.hidden = true;
    load_library().then(() => load_scene(view)).then(function (scene) {
      show(view, scene);
      if (picture) picture.hidden = true;
    }).catch((error) => say_failed(view, error));
  }

  /* Without a picture the view opens when it comes into sight; with one, when it is asked for, by its
     button or by the page's address (#exercise.case). */
  const when_seen = new IntersectionObserver(function (entries) {
    for (const entry of entries) {
      if (!entry.isIntersecting) continue;
      when_seen.unobserve(entry.target);
      open(entry.target);
    }
  });

  function open_addressed() {
    const target = document.getElementById(decodeURIComponent(location.hash.slice(1)));
    const view = target && target.classList.contains("case") ? target.querySelector(".view") : null;
    if (view) open(view);
  }

  for (const view of document.querySelectorAll(".view[data-scene]")) {
    const button = view.querySelector(".turn");
    button.hidden = false;
    button.addEventListener("click", () => open(view));
    if (!view.parentElement.querySelector(".picture")) when_seen.observe(view);
  }
  window.addEventListener("hashchange", open_addressed);
  open_addressed();
})();
