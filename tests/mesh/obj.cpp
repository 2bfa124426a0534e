// Wavefront files, as they should be and as they are.
#include "src/content/mesh/mesh.h"
#include "tests/decimal_comma.h"
#include "tests/mesh/obj_check.h"
#include "tests/sanitized.h"

namespace snell::content {
namespace {

using namespace check;

TEST(Obj, ReadsBackATorus) {
    const Mesh torus = made(Torus{1, .5, 12, 16});
    const Mesh m = clean(as_obj(torus, true));
    EXPECT_EQ(m.topology, Topology::triangles);
    expect_closed(m);
    EXPECT_NEAR(volume(m), volume(torus), 1e-5);
    ASSERT_EQ(m.indices.size(), torus.indices.size());
    EXPECT_EQ(m.positions.size(), torus.positions.size());
    for (std::size_t i = 0; i < m.indices.size(); ++i) {
        EXPECT_EQ(m.positions[m.indices[i]], torus.positions[torus.indices[i]]);
        EXPECT_NEAR(m.texcoords[m.indices[i]][0], torus.texcoords[torus.indices[i]][0], 1e-6);
        EXPECT_NEAR(dot(wide(m.normals[m.indices[i]]), wide(torus.normals[torus.indices[i]])), 1, 1e-6);
    }
}

TEST(Obj, SharesVerticesWithTheSameIndices) {
    EXPECT_EQ(clean(square + "f 1 2 3\nf 1 3 4\n").positions.size(), 4u);
    const std::string uv = "vt 0 0\nvt 1 1\n";
    EXPECT_EQ(clean(square + uv + "f 1/1 2/1 3/1\nf 1/1 3/1 4/1\n").positions.size(), 4u);
    EXPECT_EQ(clean(square + uv + "f 1/1 2/1 3/1\nf 1/2 3/2 4/1\n").positions.size(), 6u);
}

TEST(Obj, TakesEveryFormOfFace) {
    const std::string all = square + "vt .25 .5 .75\nvn 0 0 2\n";
    for (const char* face :
         {"f 1 2 3", "f 1/1 2/1 3/1", "f 1//1 2//1 3//1", "f 1/1/1 2/1/1 3/1/1", "f -4 -3 -2",
          "f -4/-1/-1 -3/-1/-1 -2/-1/-1", "f -4//-1 -3//-1 -2//-1", "  f\t1   2\t3  ", "f 1 2 3 # three"}) {
        const Mesh m = clean(all + face);
        EXPECT_EQ(m.indices.size(), 3u) << face;
        EXPECT_NEAR(area(m), .5, 1e-7) << face;
        for (const Float3& n : m.normals) EXPECT_EQ(n, (Float3{0, 0, 1})) << face;
        const bool has_uv =
            std::string(face).find("/1") != std::string::npos && std::string(face).find("//") == std::string::npos;
        const bool has_negative_uv = std::string(face).find("-4/-1") != std::string::npos;
        EXPECT_EQ(m.texcoords[0], (has_uv || has_negative_uv ? Float3{.25f, .5f, .75f} : Float3{0, 0, 0})) << face;
    }
}

// Negative indices count back from where they stand, not from the end of the file.
TEST(Obj, NegativeIndicesAreRelativeToTheirLine) {
    const Mesh m = clean("v 0 0 0\nv 1 0 0\nv 0 1 0\nf -3 -2 -1\nv 5 5 5\nv 6 5 5\nv 5 6 5\nf -3 -2 -1\n");
    EXPECT_EQ(m.positions[0], (Float3{0, 0, 0}));
    EXPECT_EQ(m.positions[3], (Float3{5, 5, 5}));
}

TEST(Obj, LineEndsCommentsAndOtherStatementsDoNotMatter) {
    const Mesh expected = clean(square + "f 1 2 3 4\n");
    std::string crlf, cr, noisy = "# made by hand\nmtllib nowhere.mtl\no thing\n\n   \n";
    for (const char c : square + "f 1 2 3 4\n") {
        crlf += c == '\n' ? "\r\n" : std::string(1, c);
        cr += c == '\n' ? '\r' : c;
        noisy += c == '\n' ? " # note\ng a b\ns off\nusemtl gold\n" : std::string(1, c);
    }
    const std::string joined = square + "f 1 2 \\\n3 4\n", joined_crlf = square + "f 1 2 \\\r\n3 4\r\n";
    std::string junk = square + "hello world\nvp 1 2\ncurv 0 1\n\x01\x02\xff\nf 1 2 3 4\nfoo 1 2 3\n";
    for (const std::string& text : {crlf, cr, noisy, joined, joined_crlf, junk}) {
        const Mesh m = clean(text);
        EXPECT_EQ(m.positions, expected.positions) << text;
        EXPECT_EQ(m.indices, expected.indices) << text;
    }
}

TEST(Obj, LastLineNeedsNoEnd) { EXPECT_EQ(clean(square + "f 1 2 3").indices.size(), 3u); }

TEST(Obj, IgnoresWAndColoursOfVertices) {
    const Mesh m = clean("v 0 0 0 2\nv 1 0 0 .5 .5 .5\nv 0 1 0 1 0 0 1\nf 1 2 3\n");
    EXPECT_NEAR(area(m), .5, 1e-7);
    EXPECT_TRUE(m.w.empty());
}

TEST(Obj, ReadsNumbersAsTheyAreWritten) {
    const Mesh m = clean("v +1 -.5 2.\nv 1e-3 1E+2 -1.5e1\nv 0.333333343 16777216 123456.789\nf 1 2 3\n");
    EXPECT_EQ(m.positions[0], (Float3{1, -.5f, 2}));
    EXPECT_EQ(m.positions[1], (Float3{1e-3f, 100, -15}));
    EXPECT_FLOAT_EQ(m.positions[2][0], 0.333333343f);
    EXPECT_EQ(m.positions[2][1], 16777216);
    EXPECT_FLOAT_EQ(m.positions[2][2], 123456.789f);
}

TEST(Obj, DecimalCommaLocalesChangeNothing) {
    const DecimalComma locale;
    if (!locale.holds()) GTEST_SKIP() << "no locale with a decimal comma can be made here";
    const Mesh m = clean("v 0.5 0 0\nv 1.25 0 0\nv 0 1.75 0\nf 1 2 3\n");
    EXPECT_EQ(m.positions[0][0], .5f);
    EXPECT_EQ(m.positions[2][1], 1.75f);
}

// ---- polygons ----------------------------------------------------------------------------------------

std::string polygon(const std::vector<D3>& points) {
    std::ostringstream out;
    for (const D3& p : points) out << "v " << p[0] << ' ' << p[1] << ' ' << p[2] << '\n';
    out << 'f';
    for (std::size_t i = 1; i <= points.size(); ++i) out << ' ' << i;
    out << '\n';
    return out.str();
}

// All triangles face the polygon's way, and their areas add up to its own.
void expect_covers(const std::vector<D3>& points, double expected_area, const D3& normal) {
    const Mesh m = clean(polygon(points));
    EXPECT_EQ(m.indices.size(), 3 * (points.size() - 2));
    EXPECT_NEAR(area(m), expected_area, 1e-5 * expected_area);
    for (std::size_t i = 0; i < m.indices.size(); i += 3) EXPECT_GT(dot(area_vector(m, i), normal), 0);
}

TEST(ObjPolygons, AreCoveredByTheirTriangles) {
    expect_covers({{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {0, 1, 0}}, 2, {0, 0, 1});
    // An arrow head, from each of its corners on, in each plane and both ways round.
    std::vector<D3> arrow{{0, 0, 0}, {2, 1, 0}, {0, 2, 0}, {1, 1, 0}};
    for (int turn = 0; turn < 4; ++turn) {
        expect_covers(arrow, 1, {0, 0, 1});
        std::vector<D3> other, reversed(arrow.rbegin(), arrow.rend());
        for (const auto& [x, y, z] : arrow) other.push_back({z, x, y});
        expect_covers(other, 1, {1, 0, 0});
        expect_covers(reversed, 1, {0, 0, -1});
        std::rotate(arrow.begin(), arrow.begin() + 1, arrow.end());
    }
}

TEST(ObjPolygons, StarsCombsAndLettersAreCovered) {
    std::vector<D3> star, comb;
    for (int i = 0; i < 20; ++i) {
        const double angle = std::numbers::pi * i / 10, r = i % 2 ? .4 : 1;
        star.push_back({r * std::cos(angle), r * std::sin(angle), .5});
    }
    expect_covers(star, 10 * .4 * std::sin(std::numbers::pi / 10), {0, 0, 1});
    for (int i = 0; i < 50; ++i) {  // teeth up
        comb.push_back({2. * i + 1, 0, 0});
        comb.push_back({2. * i + 1, -5, 0});
        comb.push_back({2. * i + 2, -5, 0});
        comb.push_back({2. * i + 2, 0, 0});
    }
    comb.push_back({101, 0, 0});
    comb.push_back({101, 1, 0});
    comb.push_back({0, 1, 0});
    comb.push_back({0, 0, 0});
    std::rotate(comb.begin(), comb.begin() + 7, comb.end());
    expect_covers(comb, 101 + 50 * 5, {0, 0, 1});
    const std::vector<D3> letter{{0, 0, 0}, {3, 0, 0}, {3, 1, 0}, {1, 1, 0},
                                 {1, 2, 0}, {3, 2, 0}, {3, 3, 0}, {0, 3, 0}};
    expect_covers(letter, 7, {0, 0, 1});
}

TEST(ObjPolygons, OfManyCornersTakeLittleTime) {
    std::vector<D3> round, jagged, spiral;
    for (int i = 0; i < 3000; ++i) {  // ears are rare: one corner at a time from its end
        const double angle = .05 * i, r = 1 + .002 * i;
        spiral.push_back({r * std::cos(angle), r * std::sin(angle), 0});
    }
    for (int i = 3000; i-- > 0;)
        spiral.push_back(
            {.999 * spiral[static_cast<std::size_t>(i)][0], .999 * spiral[static_cast<std::size_t>(i)][1], 0});
    for (int i = 0; i < 20000; ++i) {
        const double angle = 2 * std::numbers::pi * i / 20000;
        round.push_back({1000 * std::cos(angle), 1000 * std::sin(angle), 0});
        const double r = i % 2 ? 900 : 1000;
        jagged.push_back({r * std::cos(angle), r * std::sin(angle), 0});
    }
    [[maybe_unused]] const std::clock_t start = std::clock();
    EXPECT_EQ(parse(polygon(round)).mesh.indices.size(), 3u * 19998);
    EXPECT_EQ(parse(polygon(spiral)).mesh.indices.size(), 3u * 5998);
    EXPECT_EQ(parse(polygon(jagged)).mesh.indices.size(), 3u * 19998);
#ifdef NDEBUG
    EXPECT_LT(static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC, 5 * patience);
#endif
}

TEST(ObjPolygons, ThatCrossThemselvesEnd) {
    const MeshResult r = parse(polygon({{0, 0, 0}, {1, 1, 0}, {1, 0, 0}, {0, 1, 0}, {.5, -1, 0}}));
    EXPECT_FALSE(r.mesh.indices.empty());
    parse(polygon({{0, 0, 0}, {0, 0, 0}, {0, 0, 0}, {0, 0, 0}, {0, 0, 0}}));
    parse(polygon({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}, {1, 0, 0}}));
}

// ---- normals -----------------------------------------------------------------------------------------

TEST(ObjNormals, MissingOnesAreWeightedByArea) {
    // A large triangle facing +Z and a small one facing +X share the place (0,0,0), written twice.
    const Mesh m = clean("v 0 0 0\nv 4 0 0\nv 0 4 0\nv 0 0 0\nv 0 1 0\nv 0 0 1\nf 1 2 3\nf 4 5 6\n");
    const double expected_x = 1 / std::hypot(1, 16.);  // areas 1/2 and 8
    EXPECT_NEAR(m.normals[0][0], expected_x, 1e-6);
    EXPECT_NEAR(m.normals[0][2], 16 * expected_x, 1e-6);
    EXPECT_EQ(m.normals[0], m.normals[3]);
    EXPECT_EQ(m.normals[1], (Float3{0, 0, 1}));
}

TEST(ObjNormals, OfASphereWithoutAnyAreRadial) {
    const Mesh m = clean(as_obj(made(Sphere{1, 60, 60}), false));
    for (std::size_t i = 0; i < m.positions.size(); ++i)
        EXPECT_GT(dot(wide(m.positions[i]), wide(m.normals[i])), std::cos(.01));
}

TEST(ObjNormals, OddOnesAreReplaced) {
    for (const char* normal : {"0 0 0", "nan nan nan", "inf 0 0", "1e400 0 0", ""}) {
        const Mesh m = parse(square + "vn " + normal + "\nf 1//1 2//1 3//1\n").mesh;
        for (const Float3& n : m.normals) EXPECT_EQ(n, (Float3{0, 0, 1})) << normal;
    }
    // Both sides of a sheet: the sum vanishes.
    for (const Float3& n : clean(square + "f 1 2 3\nf 3 2 1\n").normals) EXPECT_EQ(std::abs(n[2]), 1);
    EXPECT_EQ(clean(square + "vn 0 3 4\nf 1//1 2//1 3//1\n").normals[0], (Float3{0, .6f, .8f}));
}

// ---- bad files ---------------------------------------------------------------------------------------

struct Odd {
    std::string text, code;
    std::size_t triangles;
};

TEST(ObjOdd, CostsTheFaceNotTheFile) {
    const std::string good = "f 1 2 3\n";
    for (const auto& [text, code, triangles] : std::vector<Odd>{
             {square + good + "f 1 2 5\n", "obj-index-out-of-range", 1},
             {square + good + "f 0 1 2\n", "obj-index-out-of-range", 1},
             {square + good + "f -5 1 2\n", "obj-index-out-of-range", 1},
             {square + good + "f 1 2 2147483648\n", "obj-index-out-of-range", 1},
             {square + good + "f 1 2 -2147483648\n", "obj-index-out-of-range", 1},
             {square + good + "f 1 2 99999999999999999999\n", "obj-index-out-of-range", 1},
             {square + good + "f 4294967297 2 3\n", "obj-index-out-of-range", 1},
             {square + good + "f a b c\n", "obj-index-out-of-range", 1},
             {square + good + "f 1 2 3.5.5x 4/ / //\n", "obj-index-out-of-range", 1},
             {square + good + "f 1/9 2/9 3/9\n", "obj-attribute-out-of-range", 2},
             {square + good + "f 1//9 2//9 3//9\n", "obj-attribute-out-of-range", 2},
             {square + good + "f 1 2\nf\nf \n", "obj-face-too-small", 1},
             {square + good + "f 1 2 2\n", "obj-zero-area", 1},
             {square + "v 2 0 0\n" + good + "f 1 2 5\n", "obj-zero-area", 2},
             {square + "v nan 0 0\n" + good + "f 1 2 5\n", "obj-not-a-number", 1},
             {square + "v 0 -inf 0\n" + good + "f 1 2 5\n", "obj-not-a-number", 1},
             {square + "v 0 0 1e400\n" + good + "f 1 2 5\n", "obj-not-a-number", 1},
             {square + "v 0 0 1e39\n" + good + "f 1 2 5\n", "obj-not-a-number", 1},
             {square + "v zero 0 0\n" + good + "f 1 2 5\n", "obj-not-a-number", 1},
             {square + "v 0,5 0 0\n" + good, "obj-malformed-number", 1},
         }) {
        const MeshResult r = parse(text);
        EXPECT_TRUE(has_issue(r, code)) << text;
        EXPECT_EQ(r.mesh.indices.size(), 3 * triangles) << text;
    }
}

TEST(ObjOdd, NamesTheLine) {
    const MeshResult r = parse(square + "# a note\nf 1 2 3\nf 1 2 9\nf 1 2 8\n");
    ASSERT_EQ(r.issues.size(), 1u);
    EXPECT_NE(r.issues[0].message.find("2 faces"), std::string::npos) << r.issues[0].message;
    EXPECT_NE(r.issues[0].message.find("line 7"), std::string::npos) << r.issues[0].message;
}

TEST(ObjOdd, FilesWithoutFacesAreErrors) {
    for (const std::string& text : {std::string(), std::string("\n"), square, std::string("junk\0\0\xff", 7),
                                    std::string("f 1 2 3\n"), square + "l 1 2 3\n", square + "p 1\n"})
        EXPECT_TRUE(has_issue(parse(text), "obj-no-faces")) << text;
}

TEST(ObjOdd, IsolatedVerticesAreLeftOut) {
    EXPECT_EQ(parse("v 9 9 9\n" + square + "v nan 9 9\nf 2 3 4\n").mesh.max, (Float3{1, 1, 0}));
}

TEST(ObjOdd, LimitsHold) {
    EXPECT_TRUE(has_issue(parse_obj(square + "f 1 2 3\n", ObjAs::triangles, false, {3, 1000}), "too-many-vertices"));
    EXPECT_TRUE(has_issue(parse_obj(square + "f 1 2 3\n", ObjAs::triangles, false, {100, 10}), "file-too-large"));
}

// Any cut of a good file and any damaged byte gives a sound mesh or an error.
TEST(ObjOdd, DamagedFilesAreSoundOrRefused) {
    const std::string good = as_obj(made(Torus{1, .5, 3, 4}), true) + "f 1//1 2//2 3//3 4//4\nl 1 2\n";
    for (std::size_t size = 0; size < good.size(); size += 7)
        for (const ObjAs as : {ObjAs::triangles, ObjAs::adjacency}) parse(good.substr(0, size), as);
    std::uint32_t random = 1;
    const auto next = [&] { return random = random * 1664525 + 1013904223, random >> 8; };
    for (int round = 0; round < 500; ++round) {
        std::string text = good;
        for (int k = 0; k < 8; ++k) text[next() % text.size()] = "\n\r /-9f.v\0\\#e"[next() % 14];
        parse(text, ObjAs::adjacency);
        parse(text, ObjAs::triangles, true);
    }
}

// ---- speed -------------------------------------------------------------------------------------------

TEST(Obj, OfAHundredThousandTrianglesIsReadyInTime) {
    const std::string text = as_obj(made(Torus{1, .5, 223, 224}), true);
    const std::clock_t start = std::clock();
    const MeshResult r = parse_obj(text, ObjAs::triangles, false);
    const double seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
    EXPECT_GE(r.mesh.indices.size(), 3u * 99'000);
    RecordProperty("milliseconds", static_cast<int>(seconds * 1000));
#ifdef NDEBUG
    EXPECT_LT(seconds, 1);  // a quarter when the machine is idle; see the benchmark
#endif
}

// ---- ObjAdj, ObjPatch and WireObj.

// For every triangle and edge of a closed mesh, the neighbour is the far corner of the one other triangle
// that has the edge, found here by looking through all of them.
TEST(ObjAdjacency, HoldsItsDefinitionOnAClosedMesh) {
    const Mesh m = clean(as_obj(made(Torus{1, .5, 8, 9}), true), ObjAs::adjacency);
    EXPECT_EQ(m.topology, Topology::triangles_adjacency);
    ASSERT_EQ(m.indices.size(), 6u * 2 * 8 * 9);
    const std::vector<int> place = places(m);
    for (std::size_t i = 0; i < m.indices.size(); i += 6)
        for (std::size_t k = 0; k < 6; k += 2) {
            const int from = place[m.indices[i + k]], to = place[m.indices[i + (k + 2) % 6]];
            const int neighbour = place[m.indices[i + k + 1]];
            int found = 0;
            for (std::size_t j = 0; j < m.indices.size(); j += 6)
                for (std::size_t h = 0; h < 6; h += 2) {
                    if (place[m.indices[j + h]] != to || place[m.indices[j + (h + 2) % 6]] != from) continue;
                    ++found;
                    EXPECT_EQ(place[m.indices[j + (h + 4) % 6]], neighbour);
                }
            EXPECT_EQ(found, 1);
        }
}

TEST(ObjAdjacency, KeepsTheTriangles) {
    const Mesh plain = clean(cube), m = clean(cube, ObjAs::adjacency);
    ASSERT_EQ(m.indices.size(), 2 * plain.indices.size());
    for (std::size_t i = 0; i < plain.indices.size(); ++i) EXPECT_EQ(m.indices[2 * i], plain.indices[i]);
}

TEST(ObjAdjacency, FoldsBordersBack) {
    const Mesh m = clean(square + "f 1 2 3\n", ObjAs::adjacency);
    EXPECT_EQ(m.indices, (std::vector<std::uint32_t>{0, 2, 1, 0, 2, 1}));
}

TEST(ObjAdjacency, CrowdedEdgesPairUpInOrder) {
    // Four triangles on the edge 1 2: two each way. Far corners 3, 4 along it, 5, 6 against it.
    const std::string fins = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nv 0 -1 0\nv 0 0 -1\n";
    const MeshResult r = parse(fins + "f 1 2 3\nf 1 2 4\nf 2 1 5\nf 2 1 6\n", ObjAs::adjacency);
    EXPECT_TRUE(has_issue(r, "obj-not-manifold"));
    const auto across = [&](std::size_t triangle) { return r.mesh.positions[r.mesh.indices[6 * triangle + 1]]; };
    EXPECT_EQ(across(0), (Float3{0, -1, 0}));
    EXPECT_EQ(across(1), (Float3{0, 0, -1}));
    EXPECT_EQ(across(2), (Float3{0, 1, 0}));
    EXPECT_EQ(across(3), (Float3{0, 0, 1}));
    // Three: the one left over takes the first of the other way.
    const MeshResult three = parse(fins + "f 1 2 3\nf 1 2 4\nf 2 1 5\n", ObjAs::adjacency);
    EXPECT_EQ(three.mesh.positions[three.mesh.indices[7]], (Float3{0, -1, 0}));
    // Two that run the same way are each other's neighbours.
    const MeshResult same = parse(fins + "f 1 2 3\nf 1 2 4\n", ObjAs::adjacency);
    EXPECT_TRUE(has_issue(same, "obj-not-manifold"));
    EXPECT_EQ(same.mesh.positions[same.mesh.indices[1]], (Float3{0, 0, 1}));
    EXPECT_EQ(same.mesh.positions[same.mesh.indices[7]], (Float3{0, 1, 0}));
}

TEST(ObjPatch, GivesPatchesOfThree) {
    const Mesh m = clean(cube, ObjAs::patches);
    EXPECT_EQ(m.topology, Topology::patches);
    EXPECT_EQ(m.patch_vertices, 3);
    EXPECT_EQ(m.indices, clean(cube).indices);
}

TEST(WireObj, HasThePolygonsEdgesOnce) {
    const Mesh m = clean(cube, ObjAs::triangles, true);
    EXPECT_EQ(m.topology, Topology::lines);
    EXPECT_EQ(lines_by_place(m).size(), 12u);  // no diagonals
    EXPECT_EQ(m.indices.size(), 24u);
}

TEST(WireObj, DrawsLineElements) {
    const Mesh m = clean(square + "vt .5 .5\nl 1 2 3\nl -1/1 1/1\nl 1 2 # again\n", ObjAs::triangles, true);
    EXPECT_EQ(m.indices.size(), 6u);
    EXPECT_TRUE(has_issue(parse(square + "l 1 9 2\nf 1 2 3\n", ObjAs::triangles, true), "obj-index-out-of-range"));
}

// Many, so that no two of different hashes meet by chance.
TEST(Weld, ZeroIsOnePlaceWhateverItsSign) {
    std::vector<Float3> positions;
    for (int i = 0; i < 32; ++i)
        for (const float zero : {0.f, -0.f}) positions.push_back({zero, static_cast<float>(i), zero});
    const Weld found = weld(positions);
    EXPECT_EQ(found.places, 32u);
    for (std::size_t i = 0; i < positions.size(); ++i) EXPECT_EQ(found.place[i], i / 2);
}

}  // namespace
}  // namespace snell::content
