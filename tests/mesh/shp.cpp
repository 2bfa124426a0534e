// ESRI shape files, written by shapelib itself.
#include <shapefil.h>

#include "tests/mesh/check.h"
#include "tests/scratch.h"

namespace snell::content {
namespace {

using namespace check;

struct Record {
    int type;
    std::vector<int> starts;
    std::vector<D3> points;
};

// The bytes of a .shp with these records.
std::string shp(int type, const std::vector<Record>& records) {
    const Scratch folder;
    const std::string path = folder.path("lines.shp");
    const SHPHandle file = SHPCreate(path.c_str(), type);
    for (const Record& r : records) {
        std::vector<double> x, y, z;
        for (const D3& p : r.points) x.push_back(p[0]), y.push_back(p[1]), z.push_back(p[2]);
        SHPObject* object = SHPCreateObject(r.type, -1, static_cast<int>(r.starts.size()), r.starts.data(), nullptr,
                                            static_cast<int>(r.points.size()), x.data(), y.data(), z.data(), nullptr);
        SHPWriteObject(file, -1, object);
        SHPDestroyObject(object);
    }
    SHPClose(file);
    return bytes_of(path);
}

const std::vector<D3> zigzag{{0, 0, 5}, {1, 2, 6}, {3, 1, 7}, {10, 10, 8}, {11, 10, 9}};

std::string two_parts() { return shp(SHPT_ARC, {{SHPT_ARC, {0, 3}, zigzag}}); }

TEST(Shp, PolylinesBecomeLinesPartByPart) {
    const MeshResult r = parse_shp(two_parts());
    EXPECT_TRUE(r.issues.empty());
    EXPECT_EQ(r.mesh.topology, Topology::lines);
    expect_sound(r.mesh);
    EXPECT_EQ(r.mesh.indices, (std::vector<std::uint32_t>{0, 1, 1, 2, 3, 4}));
    EXPECT_EQ(r.mesh.positions[1], (Float3{1, 2, 0}));
    EXPECT_EQ(r.mesh.max, (Float3{11, 10, 0}));
    EXPECT_EQ(r.mesh.texcoords[1][0], .5f);
    EXPECT_EQ(r.mesh.texcoords[4][0], 1);
}

TEST(Shp, EveryKindOfLineIsRead) {
    const std::vector<D3> ring{{0, 0, 1}, {0, 4, 2}, {4, 4, 3}, {4, 0, 2}, {0, 0, 1}};
    for (const int type : {SHPT_ARC, SHPT_ARCZ, SHPT_ARCM, SHPT_POLYGON, SHPT_POLYGONZ, SHPT_POLYGONM}) {
        const MeshResult r = parse_shp(shp(type, {{type, {0}, ring}, {type, {0}, ring}}));
        EXPECT_TRUE(r.issues.empty()) << type;
        EXPECT_EQ(r.mesh.indices.size(), 16u) << type;
        const bool z = type == SHPT_ARCZ || type == SHPT_POLYGONZ;
        EXPECT_EQ(r.mesh.max, (Float3{4, 4, z ? 3.f : 0.f})) << type;
    }
}

TEST(Shp, PointsAndNothingAreReported) {
    EXPECT_TRUE(has_issue(parse_shp(shp(SHPT_POINT, {{SHPT_POINT, {}, {{1, 2, 0}}}})), "shp-no-lines"));
    EXPECT_TRUE(has_issue(parse_shp(shp(SHPT_ARC, {})), "shp-empty"));
}

TEST(Shp, NumbersThatAreNoneAreSaid) {
    const auto lines = [](D3 wrong) {
        return parse_shp(shp(SHPT_ARCZ, {{SHPT_ARCZ, {0}, {{0, 0, 1}, wrong}}, {SHPT_ARCZ, {0}, zigzag}}));
    };
    EXPECT_TRUE(lines({1, 1, 1}).issues.empty());
    for (const double wrong : {std::nan(""), HUGE_VAL, -HUGE_VAL, 1e300}) {
        for (const D3& place : {D3{wrong, 0, 1}, D3{0, wrong, 1}}) {
            const MeshResult r = lines(place);
            EXPECT_TRUE(has_issue(r, "shp-not-a-number")) << wrong;
            EXPECT_EQ(r.mesh.positions.size(), zigzag.size()) << "the line is left out";
        }
        const MeshResult r = lines({1, 1, wrong});
        EXPECT_TRUE(has_issue(r, "shp-not-a-number")) << wrong;
        ASSERT_EQ(r.mesh.positions.size(), 2 + zigzag.size());
        EXPECT_EQ(r.mesh.positions[1], (Float3{1, 1, 0}));
    }
}

TEST(Shp, OtherFilesAreRefused) {
    for (const std::string& text :
         {std::string(), std::string("PK\3\4"), std::string(200, 'x'), std::string(200, '\0')})
        EXPECT_TRUE(has_issue(parse_shp(text), "shp-not-a-shape-file"));
    EXPECT_TRUE(has_issue(parse_shp(two_parts(), {3, 1 << 20}), "too-many-vertices"));
    EXPECT_TRUE(has_issue(parse_shp(two_parts(), {100, 50}), "file-too-large"));
}

TEST(Shp, TruncatedFilesKeepTheirWholeRecords) {
    const std::string good = shp(SHPT_ARC, {{SHPT_ARC, {0, 3}, zigzag}, {SHPT_ARC, {0}, zigzag}});
    for (std::size_t size = 0; size < good.size(); ++size) {
        const MeshResult r = parse_shp(good.substr(0, size));
        if (r.mesh.indices.empty())
            EXPECT_TRUE(r.issues.back().error) << size;
        else
            EXPECT_TRUE(has_issue(r, "shp-truncated")) << size;
    }
    EXPECT_EQ(parse_shp(good.substr(0, good.size() - 1)).mesh.indices.size(), 6u);
}

TEST(Shp, DamagedFilesAreSoundOrRefused) {
    const std::string good = shp(SHPT_POLYGONZ, {{SHPT_POLYGONZ, {0, 3}, zigzag}, {SHPT_POLYGONZ, {0}, zigzag}});
    std::uint32_t random = 1;
    const auto next = [&] { return random = random * 1664525 + 1013904223, random >> 8; };
    for (int round = 0; round < 5000; ++round) {
        std::string bytes = good;
        const unsigned changes = 1 + next() % 4;
        for (unsigned k = 0; k < changes; ++k) {
            const char value = round % 2 ? static_cast<char>(next()) : "\0\xff\x7f\x80"[next() % 4];
            bytes[next() % bytes.size()] = value;
        }
        const MeshResult r = parse_shp(bytes);
        if (r.mesh.indices.empty())
            EXPECT_TRUE(!r.issues.empty() && r.issues.back().error);
        else
            expect_sound(r.mesh);
    }
}

}  // namespace
}  // namespace snell::content
