// Reading .obj text in tests.
#pragma once

#include "tests/mesh/check.h"

namespace snell::content::check {

inline MeshResult parse(const std::string& text, ObjAs as = ObjAs::triangles, bool wire = false) {
    MeshResult r = parse_obj(text, as, wire);
    const bool failed = std::any_of(r.issues.begin(), r.issues.end(), [](const MeshIssue& i) { return i.error; });
    EXPECT_EQ(failed, r.mesh.indices.empty());
    if (!failed) expect_sound(r.mesh, -1.1, !has_issue(r, "obj-zero-area"));
    return r;
}
inline Mesh clean(const std::string& text, ObjAs as = ObjAs::triangles, bool wire = false) {
    MeshResult r = parse(text, as, wire);
    for (const MeshIssue& i : r.issues) ADD_FAILURE() << i.code << ": " << i.message;
    return r.mesh;
}

// An .obj with the mesh's positions, texture coordinates and normals.
inline std::string as_obj(const Mesh& m, bool attributes) {
    std::ostringstream out;
    out.precision(9);
    for (const Float3& p : m.positions) out << "v " << p[0] << ' ' << p[1] << ' ' << p[2] << '\n';
    if (attributes) {
        for (const Float3& t : m.texcoords) out << "vt " << t[0] << ' ' << t[1] << '\n';
        for (const Float3& n : m.normals) out << "vn " << n[0] << ' ' << n[1] << ' ' << n[2] << '\n';
    }
    for (std::size_t i = 0; i < m.indices.size(); i += 3) {
        out << 'f';
        for (std::size_t k = 0; k < 3; ++k) {
            const auto v = m.indices[i + k] + 1;
            out << ' ' << v;
            if (attributes) out << '/' << v << '/' << v;
        }
        out << '\n';
    }
    return out.str();
}

inline const std::string square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";
inline const std::string cube =
    "v -1 -1 -1\nv 1 -1 -1\nv 1 1 -1\nv -1 1 -1\nv -1 -1 1\nv 1 -1 1\nv 1 1 1\nv -1 1 1\n"
    "f 1 4 3 2\nf 5 6 7 8\nf 1 2 6 5\nf 4 8 7 3\nf 1 5 8 4\nf 2 3 7 6\n";

}  // namespace snell::content::check
