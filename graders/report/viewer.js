/* The interactive view of a scene (graders/render/README.md): the mesh with its marks in the
   renderer's colours, turned with mouse, finger or keyboard. The library three.js, viewer_scene.js
   (what makes the things of a scene) and the scene are loaded when a view is asked for, by script
   elements, because a page on file:// may load nothing else. */
"use strict";

(function () {
  const library = ["three.min.js", "OrbitControls.js", "LineSegmentsGeometry.js", "LineMaterial.js", "LineSegments2.js", "viewer_scene.js"];
  const assets = document.currentScript.src.replace(/[^/]*$/, "");
  const most_views = 6;
  const backdrop = 0xeef2f6;
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
    const group = window.meshgrade_build(data, lines);
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
        if (home) group.updateMatrixWorld();
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
