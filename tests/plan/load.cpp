// Meshes, pictures and cube maps of scenes, good files and bad.
#include <sys/stat.h>

#include "src/content/image/noise.h"
#include "src/plan/plan.h"
#include "tests/hard_case.h"
#include "tests/plan/uniforms.h"
#include "tests/scratch.h"
#include "tests/std.h"

namespace snell {
namespace {

using content::Image;

std::string little(std::uint64_t value, int bytes) {
    std::string text;
    for (int i = 0; i < bytes; ++i) text += static_cast<char>(value >> (8 * i));
    return text;
}

// A 24-bit BMP whose pixel (x, y), from the top left, is (x, y, blue).
std::string bmp(int width, int height, int blue = 0) {
    const std::size_t row = (static_cast<std::size_t>(width) * 3 + 3) / 4 * 4;
    const auto size = static_cast<std::uint32_t>(row * static_cast<std::size_t>(height));
    std::string text = "BM" + little(54 + size, 4) + little(0, 4) + little(54, 4) + little(40, 4) +
                       little(static_cast<std::uint32_t>(width), 4) + little(static_cast<std::uint32_t>(height), 4) +
                       little(1, 2) + little(24, 2) + little(0, 4) + little(size, 4) + little(2835, 4) +
                       little(2835, 4) + little(0, 8);
    for (int y = height - 1; y >= 0; --y) {
        std::string line;
        for (int x = 0; x < width; ++x) {
            line += static_cast<char>(blue);
            line += static_cast<char>(y);
            line += static_cast<char>(x);
        }
        line.resize(row);
        text += line;
    }
    return text;
}

// A raw texture of bytes: sizes, then RGBA.
std::string tex(const std::vector<std::uint32_t>& sizes, char value) {
    std::string text;
    std::size_t texels = 1;
    for (const std::uint32_t size : sizes) {
        text += little(size, 4);
        texels *= size;
    }
    return text + std::string(texels * 4, value);
}

Image top_first(const Image& image) { return image.bottom_first ? content::flipped(image) : image; }

// From the top left.
std::array<int, 3> pixel(const Image& any, int x, int y) {
    const Image image = content::to_rgba(top_first(any));
    const std::size_t at =
        (static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) + static_cast<std::size_t>(x)) *
        image.pixel_bytes();
    return {std::to_integer<int>(image.pixels[at]), std::to_integer<int>(image.pixels[at + 1]),
            std::to_integer<int>(image.pixels[at + 2])};
}

bool is_checkerboard(const Image& image) {
    const Image checks = content::to_rgba(content::checkerboard(image.width));
    return content::to_rgba(top_first(image)).pixels == checks.pixels;
}

class Loading : public testing::Test {
protected:
    Index texture(TextureTarget target, const std::vector<std::string>& names) {
        Texture made;
        made.target = target;
        made.span = {0, 100, 200};
        std::uint32_t at = 110;
        for (const std::string& name : names) {
            made.files.push_back({name, {0, at, at + 5}});
            at += 10;
        }
        scene.textures.push_back(made);
        return static_cast<Index>(scene.textures.size() - 1);
    }
    Image load(TextureTarget target, const std::string& name) {
        diagnostics = {};
        return load_texture(scene, texture(target, {name}), files, diagnostics);
    }
    content::CubeFaces cube(const std::vector<std::string>& names) {
        diagnostics = {};
        return load_cube(scene, texture(TextureTarget::cube, names), files, diagnostics);
    }

    Scratch folder;
    Files files{folder.path()};
    Diagnostics diagnostics;
    Scene scene;
};

const std::vector<std::string> six{"px.bmp", "nx.bmp", "py.bmp", "ny.bmp", "pz.bmp", "nz.bmp"};

TEST_F(Loading, Picture) {
    folder.write("wall.bmp", bmp(5, 3));
    const Image image = load(TextureTarget::d2, "wall.bmp");
    EXPECT_TRUE(diagnostics.empty());
    EXPECT_EQ(image.width, 5);
    EXPECT_EQ(image.height, 3);
    EXPECT_EQ(pixel(image, 4, 2), (std::array{4, 2, 0}));
}

// Raw textures have their first row at t = 0, pictures their top row first, and faces of cube maps are uploaded so.
TEST_F(Loading, ReadyToUpload) {
    folder.write("picture.bmp", bmp(2, 4));
    std::string raw = little(2, 4) + little(4, 4);
    for (const char y : {0, 1, 2, 3}) raw += std::string{0, y, 0, 9, 1, y, 0, 9};
    folder.write("raw.tex", raw);
    for (const bool is_raw : {false, true}) {
        const Image image = load(TextureTarget::d2, is_raw ? "raw.tex" : "picture.bmp");
        EXPECT_EQ(image.channels, 4);
        EXPECT_TRUE(image.bottom_first);
        ASSERT_EQ(image.pixels.size(), 32U);
        for (std::size_t row = 0; row < 4; ++row)
            EXPECT_EQ(std::to_integer<std::size_t>(image.pixels[8 * row + 1]), is_raw ? row : 3 - row);
    }
    EXPECT_TRUE(load(TextureTarget::d2, "missing.bmp").bottom_first);
    EXPECT_EQ(load(TextureTarget::d1, "missing.bmp").pixels.size(), 256U);
    EXPECT_TRUE(load_noise(2, 16, files, diagnostics).bottom_first);
    folder.write("square.bmp", bmp(4, 4));
    folder.write("square.tex", little(4, 4) + little(4, 4) + std::string(48, 3) + std::string(16, 7));
    const content::CubeFaces faces =
        cube({"square.bmp", "square.tex", "square.bmp", "square.bmp", "square.bmp", "square.bmp"});
    for (const Image& face : faces) {
        EXPECT_EQ(face.channels, 4);
        EXPECT_FALSE(face.bottom_first);
    }
    EXPECT_EQ(std::to_integer<int>(faces[0].pixels[1]), 0) << "the top row";
    EXPECT_EQ(std::to_integer<int>(faces[1].pixels[1]), 7) << "the last row of the file";
}

TEST_F(Loading, PictureThatCannotBeReadIsAVisibleCheckerboard) {
    folder.write("junk.bmp", "\x01\x02\x03");
    folder.write("short.bmp", bmp(64, 64).substr(0, 60));
    folder.write("empty.bmp", "");
    folder.write("page.png", "<!DOCTYPE html><html></html>");
    for (const char* name : {"junk.bmp", "empty.bmp", "page.png"}) {
        EXPECT_TRUE(is_checkerboard(load(TextureTarget::d2, name))) << name;
        ASSERT_EQ(diagnostics.errors(), 1U) << name;
        EXPECT_NE(diagnostics.items()[0].message.find(name), std::string::npos);
        EXPECT_EQ(diagnostics.items()[0].span, (Span{0, 110, 115}));
    }
    load(TextureTarget::d2, "short.bmp");
    EXPECT_FALSE(diagnostics.empty());
    EXPECT_TRUE(is_checkerboard(load(TextureTarget::d2, "missing.bmp")));
    EXPECT_EQ(codes_of(diagnostics), Codes{"file-not-found"});
}

TEST_F(Loading, OneDimensionTakesTheBottomRow) {
    folder.write("ramp.bmp", bmp(8, 4));
    const Image image = load(TextureTarget::d1, "ramp.bmp");
    EXPECT_EQ(image.height, 1);
    EXPECT_EQ(pixel(image, 7, 0), (std::array{7, 3, 0}));
    EXPECT_EQ(codes_of(diagnostics), Codes{"image-cut"});
    folder.write("row.bmp", bmp(8, 1));
    load(TextureTarget::d1, "row.bmp");
    EXPECT_TRUE(diagnostics.empty());
}

TEST_F(Loading, VolumeForAPictureGivesItsFirstSlice) {
    folder.write("cloud.tex", tex({4, 4, 4}, 9));
    EXPECT_EQ(load(TextureTarget::d3, "cloud.tex").depth, 4);
    EXPECT_TRUE(diagnostics.empty());
    const Image slice = load(TextureTarget::d2, "cloud.tex");
    EXPECT_EQ(slice.depth, 1);
    EXPECT_EQ(slice.pixels.size(), 64U);
    EXPECT_EQ(codes_of(diagnostics), Codes{"image-cut"});
}

TEST_F(Loading, CacheDecodesEachFileOnce) {
    for (std::size_t i = 0; i < 6; ++i) folder.write(six[i], bmp(8, 8, static_cast<int>(i)));
    ImageCache cache;
    const Index sky = texture(TextureTarget::cube, six);
    for (const std::string& name : six) {
        load_texture(scene, texture(TextureTarget::d2, {name}), files, diagnostics, &cache);
    }
    load_cube(scene, sky, files, diagnostics, &cache);
    EXPECT_EQ(files.counters().opened, 6U);
    cache.clear();
    load_cube(scene, sky, files, diagnostics, &cache);
    EXPECT_EQ(files.counters().opened, 12U);
}

TEST_F(Loading, SixFacesInOrder) {
    for (std::size_t i = 0; i < 6; ++i) folder.write(six[i], bmp(16, 16, static_cast<int>(10 * i)));
    const content::CubeFaces faces = cube(six);
    EXPECT_TRUE(diagnostics.empty());
    for (std::size_t i = 0; i < 6; ++i) {
        EXPECT_EQ(faces[i].width, 16);
        EXPECT_EQ(pixel(faces[i], 3, 11), (std::array{3, 11, static_cast<int>(10 * i)}));
    }
}

TEST_F(Loading, FacesOfTheSideThatIsSaidToBeTheOthersAreKept) {
    for (std::size_t i = 0; i < 6; ++i) {
        const int side = i < 3 ? 64 : 32;
        folder.write(six[i], bmp(side, side, static_cast<int>(10 * i)));
    }
    const content::CubeFaces faces = cube(six);
    EXPECT_EQ(codes_of(diagnostics), Codes(3, "cube-faces-unequal"));
    EXPECT_NE(diagnostics.items()[0].message.find("but the other faces are 64 x 64"), std::string::npos);
    for (std::size_t i = 0; i < 6; ++i) {
        EXPECT_EQ(faces[i].width, 64);
        EXPECT_EQ(is_checkerboard(faces[i]), i >= 3) << i;
    }
}

TEST_F(Loading, SameFileForAllFacesIsReadOnce) {
    folder.write("px.bmp", bmp(16, 16));
    cube(std::vector<std::string>(6, "px.bmp"));
    EXPECT_TRUE(diagnostics.empty());
    EXPECT_EQ(files.counters().opened, 1U);
}

TEST_F(Loading, OneCorruptFaceIsACheckerboardThereOnly) {
    for (std::size_t i = 0; i < 6; ++i) folder.write(six[i], bmp(16, 16, static_cast<int>(10 * i)));
    folder.write("py.bmp", "junk");
    const content::CubeFaces faces = cube(six);
    EXPECT_EQ(diagnostics.errors(), 1U);
    EXPECT_EQ(diagnostics.items()[0].span, (Span{0, 130, 135})) << "at the third name";
    for (std::size_t i = 0; i < 6; ++i) {
        EXPECT_EQ(faces[i].width, 16);
        EXPECT_EQ(faces[i].channels, faces[0].channels);
        EXPECT_EQ(is_checkerboard(faces[i]), i == 2);
    }
    int lost = 0;
    for (std::size_t i = 0; i < 6; ++i) lost += i != 2 && is_checkerboard(faces[i]);
    test::hard_case({"19", "one corrupt face of a cube map: a checkerboard there, and an error at its name",
                     "of 5 other faces lost", 0, static_cast<double>(lost), std::nullopt});
}

TEST_F(Loading, UnequalFacesAreAnErrorThatNamesThem) {
    for (const std::string& name : six) folder.write(name, bmp(16, 16));
    folder.write("ny.bmp", bmp(16, 12));
    folder.write("nz.bmp", bmp(8, 8));
    const content::CubeFaces faces = cube(six);
    EXPECT_TRUE(diagnostics.has_errors());
    std::string all;
    for (const Diagnostic& diagnostic : diagnostics.items()) all += diagnostic.message + diagnostic.help;
    EXPECT_NE(all.find("ny.bmp"), std::string::npos) << all;
    EXPECT_NE(all.find("nz.bmp"), std::string::npos) << all;
    for (std::size_t i = 0; i < 6; ++i) {
        EXPECT_EQ(faces[i].width, 16);
        EXPECT_EQ(faces[i].height, 16);
        EXPECT_EQ(is_checkerboard(faces[i]), i == 3 || i == 5);
    }
}

TEST_F(Loading, FacesOfDifferentFormatsBecomeAlike) {
    for (const std::string& name : six) folder.write(name, bmp(4, 4, 200));
    folder.write("float.tex", little(4, 4) + little(4, 4) + std::string(4 * 4 * 16, '\0'));
    std::vector<std::string> names = six;
    names[1] = "float.tex";
    const content::CubeFaces faces = cube(names);
    for (const Image& face : faces) {
        EXPECT_EQ(face.type, faces[0].type);
        EXPECT_EQ(face.channels, faces[0].channels);
        EXPECT_EQ(face.pixels.size(), faces[0].pixels.size());
        EXPECT_FALSE(face.bottom_first);
    }
    ASSERT_EQ(faces[0].type, content::PixelType::f16);
    std::uint16_t blue = 0;
    std::copy_n(faces[0].pixels.begin() + 4, 2, reinterpret_cast<std::byte*>(&blue));
    EXPECT_NEAR(content::half_to_float(blue), 200. / 255, 1e-3);
}

TEST_F(Loading, SixFilesByConvention) {
    const std::array ends{"posx", "negx", "posy", "negy", "posz", "negz"};
    for (std::size_t i = 0; i < 6; ++i) {
        folder.write(std::string("room_") + ends[i] + ".bmp", bmp(4, 4, static_cast<int>(i)));
    }
    const content::CubeFaces faces = cube({"room.bmp"});
    EXPECT_TRUE(diagnostics.empty());
    for (std::size_t i = 0; i < 6; ++i) EXPECT_EQ(pixel(faces[i], 0, 0)[2], static_cast<int>(i));
}

TEST_F(Loading, OneFileByLayout) {
    folder.write("strip.bmp", bmp(24, 4));
    const content::CubeFaces faces = cube({"strip.bmp"});
    EXPECT_TRUE(diagnostics.empty());
    for (int i = 0; i < 6; ++i) {
        EXPECT_EQ(faces[static_cast<std::size_t>(i)].width, 4);
        EXPECT_EQ(pixel(faces[static_cast<std::size_t>(i)], 1, 2), (std::array{4 * i + 1, 2, 0}));
    }
    folder.write("odd.bmp", bmp(7, 5));
    EXPECT_TRUE(is_checkerboard(cube({"odd.bmp"})[0]));
    EXPECT_EQ(codes_of(diagnostics), Codes{"cube-layout"});
    EXPECT_TRUE(is_checkerboard(cube({"missing.bmp"})[5]));
    EXPECT_EQ(codes_of(diagnostics), Codes{"file-not-found"});
}

TEST_F(Loading, NoiseFileBesideTheSceneIsUsed) {
    Files before{folder.path()};
    const Image generated = load_noise(2, 32, before, diagnostics);
    EXPECT_EQ(generated.pixels, content::make_noise(2, 32).pixels);
    folder.write(content::noise_file_name(2, 32), tex({32, 32}, 77));
    folder.write(content::noise_file_name(3, 8), tex({8, 8, 8}, 78));
    EXPECT_EQ(std::to_integer<int>(load_noise(2, 32, files, diagnostics).pixels[5]), 77);
    EXPECT_EQ(std::to_integer<int>(load_noise(3, 8, files, diagnostics).pixels[5]), 78);
    EXPECT_EQ(load_noise(2, 16, files, diagnostics).width, 16) << "another resolution is generated";
    EXPECT_TRUE(diagnostics.empty());
    folder.write(content::noise_file_name(2, 32), "junk");
    EXPECT_EQ(load_noise(2, 32, files, diagnostics).pixels, generated.pixels);
    folder.write(content::noise_file_name(2, 32), tex({16, 16}, 77));
    EXPECT_EQ(load_noise(2, 32, files, diagnostics).width, 32);
    EXPECT_EQ(codes_of(diagnostics), (Codes{"noise-file", "noise-file"}));
    // Of floats, one of which is NaN.
    std::string floats = tex({8, 8}, 0);
    floats.resize(8 + 8 * 8 * 16);
    const float nan = std::numeric_limits<float>::quiet_NaN();
    std::memcpy(floats.data() + 8 + 64, &nan, sizeof nan);
    folder.write(content::noise_file_name(2, 8), floats);
    load_noise(2, 8, files, diagnostics);
    EXPECT_EQ(codes_of(diagnostics).back(), "image-non-finite") << "it is told, and not what was read for it";
}

TEST_F(Loading, NoiseThatMayNotBeReadIsTold) {
    const Scratch elsewhere;
    elsewhere.write("secret.tex", tex({16, 16}, 77));
    std::filesystem::create_symlink(elsewhere.path("secret.tex"), folder.path(content::noise_file_name(2, 16)));
    ASSERT_EQ(mkfifo(folder.path(content::noise_file_name(3, 8)).c_str(), 0600), 0);
    Access access;
    access.confine = folder.path("");
    Files confined(folder.path(), access);
    const Span statement{0, 4, 14};
    const auto told = [&](int dimensions, int size, std::string_view why) {
        Diagnostics said;
        EXPECT_EQ(load_noise(dimensions, size, confined, said, statement).pixels,
                  content::make_noise(dimensions, size).pixels);
        ASSERT_EQ(codes_of(said), Codes{"noise-file"});
        EXPECT_EQ(said.items()[0].span, statement);
        EXPECT_NE(said.items()[0].message.find(why), std::string::npos) << said.items()[0].message;
    };
    told(2, 16, "it is outside of the folder");
    told(3, 8, "it is a pipe");
    EXPECT_EQ(std::to_integer<int>(load_noise(2, 16, files, diagnostics).pixels[5]), 77) << "links are followed";
    EXPECT_TRUE(diagnostics.empty());
    // A scene that names it says which line.
    const Index named = texture(TextureTarget::d3, {content::noise_file_name(3, 8)});
    load_texture(scene, named, confined, diagnostics);
    EXPECT_EQ(codes_of(diagnostics), Codes{"file-unreadable"});
}

TEST_F(Loading, Meshes) {
    folder.write("tri.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    folder.write("bad.obj", "f 1 2 9\n");
    ASSERT_EQ(mkfifo(folder.path("pipe.obj").c_str(), 0600), 0);
    scene.files = {{"tri.obj", {0, 10, 17}}, {"bad.obj", {0, 20, 27}}, {"pipe.obj", {0, 30, 38}}};
    scene.vertex_lists.resize(1);
    scene.vertex_lists[0].vertices.resize(3);
    scene.vertex_lists[0].vertices[1].position = {1, 0, 0, 1};
    scene.vertex_lists[0].vertices[2].position = {0, 1, 0, 1};
    for (Shape shape : {Shape(ObjFile{0, {}}), Shape(ObjFile{1, {}}), Shape(ObjFile{2, {}}), Shape(VertexList{0}),
                        Shape(Sphere{}), Shape(VertexList{7}), Shape(ObjFile{9, {}})}) {
        Draw draw;
        draw.shape = shape;
        draw.span = {0, 40, 50};
        scene.draws.push_back(draw);
    }
    Sources sources;
    const Plan plan = make_plan(scene, files, sources, diagnostics);
    EXPECT_EQ(codes_of(diagnostics), Codes{"file-unreadable"}) << "a pipe is no file";
    EXPECT_EQ(load_mesh(plan, 0, files, diagnostics).indices.size(), 3U);
    EXPECT_EQ(diagnostics.errors(), 1U);
    load_mesh(plan, 1, files, diagnostics);
    ASSERT_EQ(diagnostics.errors(), 2U);
    EXPECT_EQ(diagnostics.items().back().span, scene.files[1].span);
    EXPECT_NE(diagnostics.items().back().message.find("bad.obj"), std::string::npos);
    EXPECT_EQ(load_mesh(plan, 3, files, diagnostics).indices.size(), 3U);
    EXPECT_GT(load_mesh(plan, 4, files, diagnostics).indices.size(), 1000U);
    EXPECT_TRUE(load_mesh(plan, 5, files, diagnostics).positions.empty());
    EXPECT_TRUE(load_mesh(plan, 6, files, diagnostics).positions.empty());
    EXPECT_TRUE(load_mesh(plan, 99, files, diagnostics).positions.empty());
}

}  // namespace
}  // namespace snell
