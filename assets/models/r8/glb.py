"""A glTF 2.0 binary writer for triangle meshes: standard library only, the same bytes every time."""

import json
import struct

import png


class Part:
    """Triangles of one material."""

    def __init__(self):
        self.vertices = []  # (position, normal, uv)
        self.indices = []


class Node:
    def __init__(self, name, translation=(0.0, 0.0, 0.0), rotation=None):
        self.name, self.translation, self.rotation = name, translation, rotation
        self.parts = {}  # material name -> Part, in order of first use
        self.children = []

    def part(self, material):
        return self.parts.setdefault(material, Part())

    def add(self, child):
        self.children.append(child)
        return child

    def triangles(self):
        own = sum(len(p.indices) // 3 for p in self.parts.values())
        return own + sum(c.triangles() for c in self.children)


def rounded(vector, digits):
    # Fixed decimals take away the last bits in which the C libraries of machines differ; + 0.0 takes
    # away the sign of a zero.
    return tuple(round(c, digits) + 0.0 for c in vector)


class Writer:
    def __init__(self, materials, images):
        self.data = bytearray()
        self.views, self.accessors, self.meshes, self.nodes = [], [], [], []
        self.materials, self.images = materials, images
        self.material_index = {m["name"]: i for i, m in enumerate(materials)}

    def view(self, payload, target=None):
        self.data += b"\0" * (-len(self.data) % 4)
        view = {"buffer": 0, "byteOffset": len(self.data), "byteLength": len(payload)}
        if target:
            view["target"] = target
        self.data += payload
        self.views.append(view)
        return len(self.views) - 1

    def accessor(self, rows, kind, width):
        flat = [c for row in rows for c in row]
        payload = struct.pack("<%df" % len(flat), *flat)
        accessor = {"bufferView": self.view(payload, 34962), "componentType": 5126,
                    "count": len(rows), "type": kind}
        if width == 3:
            stored = struct.unpack("<%df" % len(flat), payload)
            accessor["min"] = [min(stored[i::3]) for i in range(3)]
            accessor["max"] = [max(stored[i::3]) for i in range(3)]
        self.accessors.append(accessor)
        return len(self.accessors) - 1

    def primitive(self, material, part):
        positions = self.accessor([rounded(v[0], 5) for v in part.vertices], "VEC3", 3)
        normals = self.accessor([rounded(v[1], 5) for v in part.vertices], "VEC3", 3)
        uvs = self.accessor([rounded(v[2], 5) for v in part.vertices], "VEC2", 2)
        short = len(part.vertices) < 65535
        payload = struct.pack("<%d%s" % (len(part.indices), "H" if short else "I"), *part.indices)
        self.accessors.append({"bufferView": self.view(payload, 34963),
                               "componentType": 5123 if short else 5125,
                               "count": len(part.indices), "type": "SCALAR",
                               "min": [min(part.indices)], "max": [max(part.indices)]})
        return {"attributes": {"POSITION": positions, "NORMAL": normals, "TEXCOORD_0": uvs},
                "indices": len(self.accessors) - 1, "material": self.material_index[material],
                "mode": 4}

    def node(self, node):
        index = len(self.nodes)
        entry = {"name": node.name}
        self.nodes.append(entry)
        if any(node.translation):
            entry["translation"] = list(rounded(node.translation, 5))
        if node.rotation:
            entry["rotation"] = list(rounded(node.rotation, 7))
        if node.parts:
            entry["mesh"] = len(self.meshes)
            mesh = {"name": node.name}
            self.meshes.append(mesh)
            mesh["primitives"] = [self.primitive(m, p) for m, p in node.parts.items()]
        if node.children:
            entry["children"] = [self.node(c) for c in node.children]
        return index

    def write(self, file, root, extras):
        scene = self.node(root)
        images = [{"name": name, "mimeType": "image/png", "bufferView": self.view(png.encode(*image))}
                  for name, image in self.images.items()]
        self.data += b"\0" * (-len(self.data) % 4)
        document = {
            "asset": {"version": "2.0", "generator": "make_r8.py", "extras": extras},
            "scene": 0,
            "scenes": [{"nodes": [scene]}],
            "nodes": self.nodes,
            "meshes": self.meshes,
            "materials": self.materials,
            "accessors": self.accessors,
            "bufferViews": self.views,
            "buffers": [{"byteLength": len(self.data)}],
        }
        if images:
            document["images"] = images
            document["samplers"] = [{"magFilter": 9729, "minFilter": 9987, "wrapS": 10497,
                                     "wrapT": 10497}]
            document["textures"] = [{"sampler": 0, "source": i} for i in range(len(images))]
        text = json.dumps(document, separators=(",", ":")).encode()
        text += b" " * (-len(text) % 4)
        with open(file, "wb") as out:
            out.write(struct.pack("<III", 0x46546C67, 2, 28 + len(text) + len(self.data)))
            out.write(struct.pack("<II", len(text), 0x4E4F534A) + text)
            out.write(struct.pack("<II", len(self.data), 0x004E4942) + bytes(self.data))
