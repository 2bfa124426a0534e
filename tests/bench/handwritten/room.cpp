#include "tests/bench/handwritten/room.h"

#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/type_ptr.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <memory>
#include <numbers>
#include <stdexcept>
#include <vector>

#include "tests/bench/handwritten/shaders.h"

namespace by_hand {
namespace {

GLuint shader(GLenum stage, std::vector<const char*> text) {
    const GLuint id = glCreateShader(stage);
    glShaderSource(id, static_cast<GLsizei>(text.size()), text.data(), nullptr);
    glCompileShader(id);
    return id;
}

GLuint program(GLuint vertex, GLuint fragment) {
    const GLuint id = glCreateProgram();
    for (const GLuint part : {vertex, fragment}) {
        glAttachShader(id, part);
        glDeleteShader(part);
    }
    glLinkProgram(id);
    GLint linked = 0;
    glGetProgramiv(id, GL_LINK_STATUS, &linked);
    if (!linked) throw std::runtime_error("a program does not link");
    return id;
}

// Of 256 x 256 texels of 24 bits behind a header of 54 bytes, which is what these files are. The bottom row first.
constexpr int side = 256;
std::vector<std::uint8_t> bmp(const std::string& path) {
    std::vector<std::uint8_t> bytes(54 + side * side * 3);
    const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(path.c_str(), "rb"), std::fclose);
    if (!file || std::fread(bytes.data(), 1, bytes.size(), file.get()) != bytes.size())
        throw std::runtime_error("can't read " + path);
    bytes.erase(bytes.begin(), bytes.begin() + 54);
    return bytes;
}

void filter(GLenum target) {
    glTexParameteri(target, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glTexParameteri(target, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    for (const GLenum axis : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T, GL_TEXTURE_WRAP_R})
        glTexParameteri(target, axis, GL_CLAMP_TO_EDGE);
}

void texels(GLenum target, const std::uint8_t* bgr) {
    glTexImage2D(target, 0, GL_RGBA8, side, side, 0, GL_BGR, GL_UNSIGNED_BYTE, bgr);
}

// Each in the order that makes a strip; x y z s t.
constexpr float wall_vertices[] = {
    5,  -5, -5, 1, 0, 5,  -5, 5,  0, 0, 5,  5,  -5, 1, 1, 5,  5,  5,  0, 1,  // +X
    -5, -5, -5, 0, 0, -5, -5, 5,  1, 0, -5, 5,  -5, 0, 1, -5, 5,  5,  1, 1,  // -X
    -5, 5,  5,  0, 0, 5,  5,  5,  1, 0, -5, 5,  -5, 0, 1, 5,  5,  -5, 1, 1,  // +Y
    -5, -5, 5,  0, 1, 5,  -5, 5,  1, 1, -5, -5, -5, 0, 0, 5,  -5, -5, 1, 0,  // -Y
    -5, -5, 5,  0, 0, 5,  -5, 5,  1, 0, -5, 5,  5,  0, 1, 5,  5,  5,  1, 1,  // +Z
    -5, -5, -5, 1, 0, 5,  -5, -5, 0, 0, -5, 5,  -5, 1, 1, 5,  5,  -5, 0, 1,  // -Z
};

GLuint vertex_array(const void* vertices, std::size_t bytes, int second, GLsizei stride) {
    GLuint array = 0, buffer = 0;
    glGenVertexArrays(1, &array);
    glBindVertexArray(array);
    glGenBuffers(1, &buffer);
    glBindBuffer(GL_ARRAY_BUFFER, buffer);
    glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(bytes), vertices, GL_STATIC_DRAW);
    glVertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, stride, nullptr);
    glVertexAttribPointer(1, second, GL_FLOAT, GL_FALSE, stride, reinterpret_cast<const void*>(3 * sizeof(float)));
    glEnableVertexAttribArray(0);
    glEnableVertexAttribArray(1);
    return array;
}

// A ball of radius 1: positions are normals.
struct Ball {
    std::vector<float> vertices;
    std::vector<std::uint16_t> indices;
};
Ball make_ball(int slices, int stacks) {
    Ball ball;
    for (int j = 0; j <= stacks; ++j)
        for (int i = 0; i <= slices; ++i) {
            const double around = 2 * std::numbers::pi * i / slices, up = std::numbers::pi * j / stacks;
            const double x = -std::cos(around) * std::sin(up), y = -std::cos(up), z = std::sin(around) * std::sin(up);
            for (int twice = 0; twice < 2; ++twice)
                for (const double part : {x, y, z}) ball.vertices.push_back(static_cast<float>(part));
        }
    for (int j = 0; j < stacks; ++j)
        for (int i = 0; i < slices; ++i) {
            const int a = j * (slices + 1) + i, d = a + slices + 1;
            const auto triangle = [&](int p, int q, int r) {
                for (const int index : {p, q, r}) ball.indices.push_back(static_cast<std::uint16_t>(index));
            };
            if (j > 0) triangle(a, a + 1, d + 1);
            if (j + 1 < stacks) triangle(a, d + 1, d);
        }
    return ball;
}

}  // namespace

Room::Room(const std::string& folder, bool sliders) {
    walls_ = program(shader(GL_VERTEX_SHADER, {wall_vertex}), shader(GL_FRAGMENT_SHADER, {wall_fragment}));
    glass_ = program(shader(GL_VERTEX_SHADER, {glass_vertex}),
                     shader(GL_FRAGMENT_SHADER, {sliders ? glass_sliders : glass_constants, glass_fragment}));
    wall_clip_ = glGetUniformLocation(walls_, "toClip");
    ball_clip_ = glGetUniformLocation(glass_, "toClip");
    ball_eye_ = glGetUniformLocation(glass_, "fromClip");
    glUseProgram(glass_);
    if (sliders) {
        glUniform1f(glGetUniformLocation(glass_, "refraction"), 1.5F);
        glUniform1i(glGetUniformLocation(glass_, "bothSides"), 1);
        glUniform1i(glGetUniformLocation(glass_, "nearWalls"), 1);
    }

    wall_quads_ = vertex_array(wall_vertices, sizeof wall_vertices, 2, 5 * sizeof(float));
    const Ball ball = make_ball(160, 160);
    ball_ = vertex_array(ball.vertices.data(), ball.vertices.size() * sizeof(float), 3, 6 * sizeof(float));
    GLuint indices = 0;
    glGenBuffers(1, &indices);
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices);
    ball_indices_ = static_cast<GLsizei>(ball.indices.size());
    glBufferData(GL_ELEMENT_ARRAY_BUFFER, ball_indices_ * GLsizeiptr{2}, ball.indices.data(), GL_STATIC_DRAW);

    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glGenTextures(6, pictures_);
    glGenTextures(1, &cube_);
    glBindTexture(GL_TEXTURE_CUBE_MAP, cube_);
    filter(GL_TEXTURE_CUBE_MAP);
    glEnable(GL_TEXTURE_CUBE_MAP_SEAMLESS);
    const char* names[] = {"posx", "negx", "posy", "negy", "posz", "negz"};
    for (unsigned i = 0; i < 6; ++i) {
        std::vector<std::uint8_t> picture = bmp(folder + "/" + names[i] + ".bmp");
        glBindTexture(GL_TEXTURE_2D, pictures_[i]);
        filter(GL_TEXTURE_2D);
        texels(GL_TEXTURE_2D, picture.data());
        for (int y = 0; y < side / 2; ++y)  // a cube map's faces have their top row first
            std::swap_ranges(&picture[static_cast<std::size_t>(y * side * 3)],
                             &picture[static_cast<std::size_t>(y * side * 3)] + side * 3,
                             &picture[static_cast<std::size_t>((side - 1 - y) * side * 3)]);
        texels(GL_TEXTURE_CUBE_MAP_POSITIVE_X + i, picture.data());
    }
}

// The camera stands still: the matrices change with the shape of the picture only.
void Room::aim(int width, int height) {
    const double half = std::tan(glm::radians(32.5)), aspect = static_cast<double>(width) / height;
    const double x = .1 * half * std::max(aspect, 1.0), y = .1 * half / std::min(aspect, 1.0);
    const glm::dmat4 clip = glm::frustum(-x, x, -y, y, .1, 1000.0) *
                            glm::lookAt(glm::dvec3(1.3, .75, 3.5), glm::dvec3(0), glm::dvec3(0, 1, 0));
    const glm::mat4 to(clip), from(glm::inverse(clip));
    glUseProgram(walls_);
    glUniformMatrix4fv(wall_clip_, 1, GL_FALSE, glm::value_ptr(to));
    glUseProgram(glass_);
    glUniformMatrix4fv(ball_clip_, 1, GL_FALSE, glm::value_ptr(to));
    glUniformMatrix4fv(ball_eye_, 1, GL_FALSE, glm::value_ptr(from));
    width_ = width;
    height_ = height;
}

void Room::draw(GLuint framebuffer, int width, int height) {
    if (width != width_ || height != height_) aim(width, height);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    glViewport(0, 0, width, height);
    glEnable(GL_DEPTH_TEST);
    glClearColor(0, 0, 0, 1);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glActiveTexture(GL_TEXTURE0);
    glUseProgram(walls_);
    glBindVertexArray(wall_quads_);
    for (int i = 0; i < 6; ++i) {
        glBindTexture(GL_TEXTURE_2D, pictures_[i]);
        glDrawArrays(GL_TRIANGLE_STRIP, 4 * i, 4);
    }
    glUseProgram(glass_);
    glBindVertexArray(ball_);
    glBindTexture(GL_TEXTURE_CUBE_MAP, cube_);
    glDrawElements(GL_TRIANGLES, ball_indices_, GL_UNSIGNED_SHORT, nullptr);
}

}  // namespace by_hand
