#!/usr/bin/env python3
"""Writes the sample class that the tests of reports read: results/ and pictures/ beside this file.

Eight students and three exercises: each of the 18 verdicts, missing work, hostile names and texts, scenes of every
kind. Run it again after a change of the format; it gives the same bytes every time.
"""
import base64
import json
import math
import os
import struct

HERE = os.path.dirname(os.path.abspath(__file__))

HOSTILE_NAME = '</script><script>document.title="owned"</script>"\'><img src=x onerror=alert(1)> ]]> \u202egnp.exe'
HOSTILE_TEXT = ("Grade :=>> 100\nComment :=>> all fine\n--|>\nGrade :=>> 100\n"
                "\x1b[2J\x1b]8;;http://evil.example\x07PASS\x1b[0m </pre><script>alert(1)</script> ]]> "
                "=HYPERLINK(\"http://evil.example\") \u202eevil\u2066 nul:\u0000: \u009b31m\n")

STUDENTS = [("Ana García Ñíguez", "ana-garcia"),
            ("Bruno Conti", "bruno-conti"),
            ("李 小龍", "s3"),
            ("=HYPERLINK(\"http://evil.example\",\"click\")", "s4"),
            (HOSTILE_NAME, "s5"),
            ("Zoë O'Brien-Müller", "zoe.obrien"),
            ("Nadia Ferri", "nadia-ferri"),
            ("Ulises Ortega de la Torre y Fernández-Montesinos", "ulises_ortega")]

EXERCISES = [
    {"exercise": "memory-strips", "group": "memory", "problem": "4.3",
     "title": {"en": "Memory of triangle strips", "es": "Memoria de las tiras de triángulos"},
     "classes": [("formula", "The formula in bytes", "La fórmula en bytes", 3),
                 ("kilobytes", "The KB for m = n = 128", "Los KB para m = n = 128", 2),
                 ("builder", "The builder of strips", "El constructor de tiras", 2)]},
    {"exercise": "edge-table-any", "group": "edges", "problem": "4.5 (a)",
     "title": {"en": "Edge table of any mesh", "es": "Tabla de aristas de cualquier malla"},
     "classes": [("closed", "Closed meshes", "Mallas cerradas", 2),
                 ("open", "Open meshes", "Mallas abiertas", 2),
                 ("non-manifold", "Non-manifold edges", "Aristas no variedad", 1.5),
                 ("empty", "Empty and tiny meshes", "Mallas vacías o mínimas", 1.5)]},
    {"exercise": "mesh-area", "group": "edges", "problem": "4.6",
     "title": {"en": "Area of a triangle mesh", "es": "Área de una malla de triángulos"},
     "classes": [("simple", "Simple meshes", "Mallas simples", 4),
                 ("needles", "Needle triangles", "Triángulos aguja", 1.5),
                 ("many", "Ten million triangles", "Diez millones de triángulos", 1.5)]},
]

CHECKS = [("growth", "Growth of the work", "Crecimiento del trabajo", 1, "grows-too-fast"),
          ("work", "Amount of work", "Cantidad de trabajo", 0.5, "too-much-work"),
          ("memory", "Peak memory", "Memoria máxima", 0.5, "too-much-memory"),
          ("leak", "Memory given back", "Memoria devuelta", 0.5, "leak"),
          ("undefined-behaviour", "No undefined behaviour", "Sin comportamiento indefinido", 0.5,
           "undefined-behaviour")]

# One verdict a cell: student by exercise. The second column of a cell: classes that fail.
TABLE = [
    [("passed", []), ("wrong-answer", ["open"]), ("passed", [])],
    [("too-much-memory", []), ("wrong-answer", ["open", "non-manifold"]), ("cpu-time", ["many"])],
    [("wrong-answer", ["kilobytes", "builder"]), ("grows-too-fast", []), ("undefined-behaviour", [])],
    [("too-much-output", ["builder"]), ("crash", ["non-manifold", "empty"]), ("leak", [])],
    [("forbidden-operation", ["formula", "kilobytes", "builder"]),
     ("compile-error", ["closed", "open", "non-manifold", "empty"]), ("flagged", [])],
    [("out-of-memory", ["builder"]), ("fault", []), ("too-much-work", [])],
    [("too-many-processes", ["builder"]), ("idle-time", ["open"]), ("too-much-disk", ["needles"])],
    [("wrong-answer", ["formula", "builder"])],
]
SENTENCES = {
    "passed": ("Everything is right.", "Todo es correcto."),
    "forbidden-operation": ("The program tried to open a socket, which is not allowed.",
                            "El programa intentó abrir un socket, lo que no está permitido."),
    "out-of-memory": ("The builder asked for more than 256 MB.", "El constructor pidió más de 256 MB."),
    "too-many-processes": ("The program tried to start a process.", "El programa intentó crear un proceso."),
    "too-much-output": ("The program wrote more than 1 MB of output.",
                        "El programa escribió más de 1 MB de salida."),
    "too-much-disk": ("The program wrote more than 1 MB of files.", "El programa escribió más de 1 MB en ficheros."),
    "cpu-time": ("The area of ten million triangles took longer than 8 times the reference, twice.",
                 "El área de diez millones de triángulos tardó más de 8 veces la referencia, dos veces."),
    "idle-time": ("The program waited for 10 s and used 0.008 s of CPU.",
                  "El programa esperó 10 s y usó 0.008 s de CPU."),
    "crash": ("Segmentation fault: address 0x0 was read when the mesh has no triangle.",
              "Violación de segmento: se leyó la dirección 0x0 cuando la malla no tiene triángulos."),
    "undefined-behaviour": ("Signed integer overflow in area.c line 14.",
                            "Desbordamiento de entero con signo en area.c, línea 14."),
    "wrong-answer": ("An answer is wrong.", "Una respuesta es incorrecta."),
    "leak": ("4096 bytes were allocated and never freed.", "4096 bytes se reservaron y no se liberaron."),
    "grows-too-fast": ("98 % of the work is quadratic at 8192 triangles with the inputs fan; at most n lg n is allowed.",
                       "El 98 % del trabajo es cuadrático con 8192 triángulos de las entradas fan; "
                       "se admite como mucho n lg n."),
    "too-much-work": ("The answer needs 61 times the work of the reference; 40 times are allowed.",
                      "La respuesta necesita 61 veces el trabajo de la referencia; se permiten 40."),
    "too-much-memory": ("The answer takes 11.5 times the memory of the reference; 8 times are allowed.",
                        "La respuesta ocupa 11.5 veces la memoria de la referencia; se permiten 8."),
    "compile-error": ("edges.c does not compile: syntax error in line 12.",
                      "edges.c no compila: error de sintaxis en la línea 12."),
    "fault": ("The judge did not answer, twice; staff must look. No mark was given.",
              "El juez no respondió, dos veces; el profesorado debe mirarlo. No se puso nota."),
    "flagged": ("The score is withheld until a person has looked: the answer is faster than memory allows.",
                "La nota se retiene hasta que una persona lo mire: es más rápida de lo que permite la memoria."),
}

CASES = {
    "open": [("disc", "duplicate-edge", "edge 41 (0,17)",
              "Edge (0,17) lies on the boundary and is listed twice, at 41 and 58.",
              "La arista (0,17) está en el borde y aparece dos veces, en 41 y 58."),
             ("grid-hole", "missing-edge", "edge (12,25)",
              "Edge (12,25) of the boundary is missing; 18 edges are.",
              "Falta la arista (12,25) del borde; faltan 18 aristas.")],
    "non-manifold": [("two-cubes-at-an-edge", "duplicate-edge", "edge 9 (2,6)",
                      "Edge (2,6) belongs to four triangles and is listed twice.",
                      "La arista (2,6) pertenece a cuatro triángulos y aparece dos veces.")],
    "closed": [("torus", "missing-edge", "edge (1,2)", "Edge (1,2) is missing.", "Falta la arista (1,2).")],
    "empty": [("no-triangle", "wrong-count", "", "A mesh without triangles has no edges.",
               "Una malla sin triángulos no tiene aristas.")],
    "formula": [("formula-16", "wrong-number", "m = 16, n = 16", "For m = n = 16 it is 6660 bytes, not 6656.",
                 "Para m = n = 16 son 6660 bytes, no 6656.")],
    "kilobytes": [("kb-128", "kilobyte-of-1000", "m = 128, n = 128",
                   "397316 bytes are 388.00 KB (1 KB = 1024 bytes), not 397.32.",
                   "397316 bytes son 388.00 KB (1 KB = 1024 bytes), no 397.32.")],
    "builder": [("strips-4x6", "flipped-triangle", "strip 1, triangle 3",
                 "Triangle 3 of strip 1 has the wrong winding.",
                 "El triángulo 3 de la tira 1 tiene la orientación equivocada."),
                ("voxels-12", "wrong-voxel", "cell (3,4,5)", "Cell (3,4,5) lies inside the sphere and is empty.",
                 "La celda (3,4,5) está dentro de la esfera y está vacía.")],
    "simple": [("cube", "wrong-area", "", "The area of the cube is 6.", "El área del cubo es 6.")],
    "needles": [("needles-1e-6", "wrong-area", "triangle 7", "Relative error 3e-3.", "Error relativo 3e-3.")],
    "many": [("grid-2236", "time-limit", "", "No answer within the limit.", "Sin respuesta dentro del límite.")],
}

# Names of causes; a verdict's are its words.
CAUSE_NAMES = {
    "duplicate-edge": ("duplicate edge", "arista duplicada"), "missing-edge": ("missing edge", "falta una arista"),
    "wrong-count": ("wrong count", "número equivocado"), "wrong-number": ("wrong number", "número incorrecto"),
    "kilobyte-of-1000": ("kilobyte of 1000", "KB de 1000 bytes"),
    "flipped-triangle": ("flipped triangle", "triángulo invertido"), "wrong-voxel": ("wrong voxel", "vóxel incorrecto"),
    "wrong-area": ("wrong area", "área incorrecta"), "time-limit": ("time limit", "límite de tiempo"),
}
NOUNS = {"edge": "arista", "strip": "tira", "triangle": "triángulo", "cell": "celda"}


def in_both(words):
    return {"en": words[0], "es": words[1]}


def name_cause(part, folder):
    """Gives a case, check or result the name of its cause; results of s3 are of an earlier version."""
    if part["cause"] and folder != "s3":
        slug = part["cause"]
        part["cause_name"] = in_both(CAUSE_NAMES.get(slug, (slug.replace("-", " "), VERDICTS.get(slug, slug))))
    return part


def element_of(english, folder):
    if folder == "s3":
        return english
    return in_both((english, " ".join(NOUNS.get(word, word) for word in english.split(" "))))


VERDICTS = {"forbidden-operation": "operación prohibida", "out-of-memory": "memoria agotada",
            "too-many-processes": "demasiados procesos", "too-much-output": "demasiada salida",
            "too-much-disk": "demasiado disco", "cpu-time": "límite de tiempo de CPU",
            "idle-time": "límite de tiempo de espera", "crash": "el programa se rompió",
            "undefined-behaviour": "comportamiento indefinido", "leak": "fuga de memoria",
            "grows-too-fast": "crece demasiado", "too-much-work": "demasiado trabajo",
            "too-much-memory": "demasiada memoria", "compile-error": "no compila",
            "fault": "fallo del corrector", "flagged": "pendiente de revisión", "not-reached": "no se llegó"}


def packed(kind, values):
    return base64.b64encode(struct.pack("<%d%s" % (len(values), kind), *values)).decode()


def mesh(positions, triangles):
    return {"vertex_count": len(positions) // 3, "triangle_count": len(triangles) // 3,
            "positions": packed("f", positions), "triangles": packed("i", triangles)}


def disc(rings, sectors):
    positions, triangles = [0.0, 0.0, 0.35], []
    for r in range(1, rings + 1):
        for s in range(sectors):
            a = 2 * math.pi * s / sectors
            d = r / rings
            positions += [d * math.cos(a), d * math.sin(a), 0.35 * math.cos(d * 1.4) * (1 + 0.2 * math.cos(3 * a))]
    ring = lambda r, s: 1 + (r - 1) * sectors + s % sectors
    for s in range(sectors):
        triangles += [0, ring(1, s), ring(1, s + 1)]
        for r in range(1, rings):
            triangles += [ring(r, s), ring(r + 1, s), ring(r + 1, s + 1), ring(r, s), ring(r + 1, s + 1), ring(r, s + 1)]
    return positions, triangles


def edge_scene():
    positions, triangles = disc(5, 24)
    outer = lambda s: 1 + 4 * 24 + s % 24
    inner = lambda s: 1 + 2 * 24 + s % 24
    marks = [{"kind": "duplicate", "element": "edge", "vertex": [outer(s), outer(s + 1)]} for s in range(0, 24, 2)]
    marks += [{"kind": "boundary", "element": "edge", "vertex": [outer(s), outer(s + 1)]} for s in range(1, 24, 2)]
    marks += [{"kind": "missing", "element": "edge", "vertex": [inner(s), inner(s + 1)]} for s in (2, 3, 9)]
    marks += [{"kind": "extra", "element": "edge", "vertex": [inner(5), outer(12)]},
              {"kind": "wrong", "element": "vertex", "vertex": [0]},
              {"kind": "degenerate", "element": "triangle", "vertex": [0, 1, 2]}]
    return {"kind": "mesh", "mesh": mesh(positions, triangles), "marks": marks,
            "mark_counts": {"missing": 3, "duplicate": 12, "extra": 1, "boundary": 12, "wrong": 1, "degenerate": 1},
            "ok_count": 333, "cut": False}


def strips_scene():
    strips = []
    for row in range(4):
        positions = []
        for i in range(14):
            x, y = i // 2 / 6.0, (row + (i + 1) % 2) / 4.0
            positions += [x, y, 0.15 * math.sin(5 * x + 3 * y)]
        if row == 1:
            positions[9:12], positions[12:15] = positions[12:15], positions[9:12]
        strips.append({"vertex_count": 14, "positions": packed("f", positions)})
    return {"kind": "strips", "strips": strips, "marks": [], "mark_counts": {"flipped": 2}, "ok_count": 46,
            "cut": False}


def sphere(n):
    positions, triangles = [], []
    for i in range(n + 1):
        for j in range(n):
            t, p = math.pi * i / n, 2 * math.pi * j / n
            positions += [0.5 * math.sin(t) * math.cos(p), 0.5 * math.sin(t) * math.sin(p), 0.5 * math.cos(t)]
    for i in range(n):
        for j in range(n):
            a, b, c, d = i * n + j, (i + 1) * n + j, (i + 1) * n + (j + 1) % n, i * n + (j + 1) % n
            triangles += [a, b, c, a, c, d]
    return positions, triangles


def voxel_scene(k):
    bits = bytearray((k ** 3 + 7) // 8)
    for z in range(k):
        for y in range(k):
            for x in range(k):
                c = [(v + 0.5) / k - 0.5 for v in (x, y, z)]
                if sum(v * v for v in c) <= 0.25:
                    i = x + k * (y + k * z)
                    bits[i // 8] |= 1 << i % 8
    positions, triangles = sphere(12)
    return {"kind": "voxels", "voxels": {"per_side": k, "bits": base64.b64encode(bytes(bits)).decode()},
            "mesh": mesh(positions, triangles), "marks": [], "mark_counts": {"wrong": 1}, "cut": False}


def chart_scene():
    xs = [16 * 2 ** i for i in range(7)]
    return {"kind": "chart", "x_label": "k", "y_label": "bytes",
            "curves": [{"name": "voxels", "x": xs, "y": [x ** 3 / 8 for x in xs], "exponent": 3},
                       {"name": "mesh", "x": xs, "y": [36 * x * x for x in xs], "exponent": 2},
                       {"name": "submission", "x": xs, "y": [37.5 * x * x for x in xs], "exponent": 2}]}


SCENES = {"disc": edge_scene, "grid-hole": edge_scene, "two-cubes-at-an-edge": edge_scene,
          "strips-4x6": strips_scene, "voxels-12": lambda: voxel_scene(12), "formula-16": chart_scene}


def growth(verdict, folder):
    sizes = [128 * 2 ** i for i in range(7)]
    families = []
    for name, factor in (("grid-scrambled", 1.0), ("fan", 1.25)):
        reference = [int(210 * n + 4000) for n in sizes]
        quadratic = verdict == "grows-too-fast" and name == "fan"
        own = [int(6.5 * n * n + 300 * n) if quadratic else int(factor * 325 * n + 9000) for n in sizes]
        fit = {"class": "n^2" if quadratic else "n", "exponent": 1.94 if quadratic else 0.99,
               "excess_percent": 97.5 if quadratic else 0.0}
        families.append({"name": name, "sizes": sizes, "instructions": own, "reference_instructions": reference,
                         "fit": fit})
    counted = {"element": {"en": "triangle", "es": "triángulo"}} if folder == "s3" else {
        "elements": {"en": "triangles", "es": "triángulos"}}
    return {"allowed": "n lg n", **counted, "families": families}


def measures(verdict, folder):
    greedy = verdict == "too-much-memory"
    peak = 753664 if greedy else 131072
    sizes = [128 * 2 ** i for i in range(7)]
    return {"growth": growth(verdict, folder),
            "work": {"ratio": 61.25 if verdict == "too-much-work" else 1.52, "band": 40,
                     "instruction_ratio": 1.61, "miss_ratio": 1.1},
            "memory": {"size": 8192, "peak_bytes": peak, "reference_peak_bytes": 65536, "ratio": peak / 65536,
                       "band": 8, "allocations": 12, "stack_bytes": 416, "static_bytes": 0,
                       "families": [{"name": "grid-scrambled", "sizes": sizes,
                                     "peak_bytes": [peak * n // 8192 for n in sizes],
                                     "reference_peak_bytes": [8 * n for n in sizes]}]}}


def classes_and_cases(exercise, verdict, failing, student_folder):
    classes, cases = [], []
    for name, en, es, points in exercise["classes"]:
        failed = CASES[name] if name in failing else []
        ran = verdict != "compile-error"
        for slug, cause, element, message, spanish in CASES[name]:
            bad = name in failing
            case = {"name": slug, "class": name,
                    "verdict": ("passed" if not bad else verdict) if ran else "not-reached",
                    "cause": (cause if verdict == "wrong-answer" else verdict) if bad and ran else "",
                    "message": {"en": message if verdict == "wrong-answer" else SENTENCES[verdict][0],
                                "es": spanish if verdict == "wrong-answer" else SENTENCES[verdict][1]}
                    if bad and ran else {"en": "", "es": ""},
                    "seed": "20250917", "public": True,
                    "reproduce": "meshgrade check %s FILE... --case %s" % (exercise["exercise"], slug)}
            if bad and ran:
                case["element"] = element_of(element if verdict == "wrong-answer" else "", student_folder)
                if slug in SCENES and verdict == "wrong-answer":
                    case["scene"] = True
                    write_scene(student_folder, exercise["exercise"], slug)
            cases.append(name_cause(case, student_folder))
        cases.append({"name": name + "-basic", "class": name,
                      "verdict": "passed" if ran else "not-reached", "cause": "",
                      "message": {"en": "", "es": ""}, "seed": "7", "public": name == "open",
                      "reproduce": "meshgrade check %s FILE... --case %s-basic" % (exercise["exercise"], name)})
        given = 0 if failed or not ran else points
        classes.append({"name": name, "title": {"en": en, "es": es}, "points": given, "max_points": points,
                        "passed": (len(CASES[name]) + 1 - len(failed)) if ran else 0, "cases": len(CASES[name]) + 1})
    return classes, cases


def write_scene(folder, exercise, case):
    scene = SCENES[case]()
    scene["title"] = in_both((case.replace("-", " "), case.replace("-", " ") + " (es)"))
    scene["subtitle"] = exercise
    scene["metadata"] = {"exercise": exercise, "case": case, "verdict": "wrong-answer", "seed": "20250917",
                         "student": HOSTILE_NAME}
    write("pictures/%s/%s/%s.json" % (folder, exercise, case), scene)


def checks_of(verdict, basic, folder):
    checks = []
    for name, en, es, points, failure in CHECKS:
        own = verdict if verdict == failure else "passed"
        if not basic:
            own = "not-reached"
        message = SENTENCES[failure] if own == failure else ("", "")
        check = {"name": name, "title": {"en": en, "es": es}, "points": points if own == "passed" else 0,
                 "max_points": points, "verdict": own, "cause": "" if own == "passed" else own,
                 "message": in_both(message)}
        checks.append(name_cause(check, folder))
    return checks


def result(student, folder, exercise, verdict, failing):
    classes, cases = classes_and_cases(exercise, verdict, failing, folder)
    basic = exercise["classes"][0][0] not in failing and verdict not in ("compile-error", "fault")
    checks = checks_of(verdict, basic, folder)
    score = sum(part["points"] for part in classes + checks)
    causes = [case["cause"] for case in cases if case["cause"]]
    sentence = SENTENCES[verdict]
    if verdict == "wrong-answer":
        sentence = next((c["message"]["en"], c["message"]["es"]) for c in cases if c["cause"])
    hostile = folder in ("s4", "s5")
    diagnostics = ("edges.c:12:5: error: expected ';' before 'return'\n   12 |     return\n      |     ^~~~~~\n"
                   if verdict == "compile-error" else "")
    return name_cause({
        "schema": "meshgrade-result-1", "student": student, "student_folder": folder,
        "exercise": exercise["exercise"], "group": exercise["group"],
        "course": {"en": "Computer graphics", "es": "Informática gráfica"},
        "title": exercise["title"], "problem": exercise["problem"], "verdict": verdict,
        "cause": "" if verdict == "passed" else causes[0] if causes else verdict,
        "score": None if verdict in ("fault", "flagged") else score, "max_score": 10,
        "summary": {"en": sentence[0], "es": sentence[1]},
        "classes": classes, "checks": checks, "cases": cases,
        "measures": measures(verdict, folder) if basic and verdict != "fault" else {},
        "build": {"ok": verdict != "compile-error", "cause": "syntax" if verdict == "compile-error" else "",
                  "diagnostics": diagnostics + (HOSTILE_TEXT if hostile else "")},
        "output": HOSTILE_TEXT if hostile else "visited 128 triangles\n" if verdict == "passed" else "",
        "protections": {"active": ["user-namespace", "pid-namespace", "private-root", "no-new-privileges",
                                   "seccomp", "rlimits"],
                        "inactive": {"landlock": "the kernel has no Landlock", "cgroup-memory": "not writable"}},
        "not_measured": [{"name": "cache-misses", "reason": "valgrind is not installed"}] if folder == "s3" else [],
        "submission": {"files": [{"name": exercise["exercise"] + ".c", "bytes": 1834, "sha256": "0" * 64}]
                       + ([{"name": "<img src=x onerror=alert(2)>.c", "bytes": 3, "sha256": "1" * 64}] if hostile else [])},
        "engine": {"version": "0.1", "compiler": "gcc 12.2.0", "seed": "1"},
    }, folder)


def write(path, value):
    path = os.path.join(HERE, path)
    os.makedirs(os.path.dirname(path), exist_ok=True)
    with open(path, "w", encoding="ascii") as file:
        json.dump(value, file, indent=1)
        file.write("\n")


def main():
    for (student, folder), row in zip(STUDENTS, TABLE):
        for exercise, (verdict, failing) in zip(EXERCISES, row):
            write("results/%s/%s.json" % (folder, exercise["exercise"]),
                  result(student, folder, exercise, verdict, failing))


main()
