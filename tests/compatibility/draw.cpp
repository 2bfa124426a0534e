#include "tests/compatibility/draw.h"

#include <epoxy/gl.h>
#include <glm/glm.hpp>
#include <glm/gtc/constants.hpp>
#include <glm/gtc/type_ptr.hpp>

#include "tests/compatibility/uniforms.h"
#include "tests/std.h"

namespace snell::oracle {
namespace {

struct Vertex {
    glm::vec4 position, normal;
    glm::vec4 color, texcoord;
    glm::vec3 tangent;
    glm::vec4 secondary;
    float fog;
    GLint id;
};

Vertex sphere_vertex(float s, float t) {
    const float lng = glm::pi<float>() * (2 * s - 1), lat = glm::pi<float>() * (t - .5f);
    const glm::vec3 p(std::cos(lng) * std::cos(lat), std::sin(lat), -std::sin(lng) * std::cos(lat));
    const glm::vec3 tangent(-std::cos(lng) * std::sin(lat), std::cos(lat), std::sin(lng) * std::sin(lat));
    return {glm::vec4(p, 1),
            glm::vec4(p, 0),
            glm::vec4(.5f + .5f * p.x, .5f + .4f * p.y, .5f - .3f * p.z, 1),
            glm::vec4(s, t, .25f + .5f * s, 1),
            tangent,
            glm::vec4(.2f + .3f * t, .6f - .3f * s, .3f, 1),
            .5f + .3f * p.y,
            0};
}

std::vector<Vertex> sphere(int slices, int stacks) {
    std::vector<Vertex> triangles;
    const auto at = [&](int i, int j) {
        return sphere_vertex(static_cast<float>(i) / static_cast<float>(slices),
                             static_cast<float>(j) / static_cast<float>(stacks));
    };
    for (int j = 0; j < stacks; ++j)
        for (int i = 0; i < slices; ++i) {
            if (j > 0) triangles.insert(triangles.end(), {at(i, j), at(i + 1, j), at(i + 1, j + 1)});
            if (j < stacks - 1) triangles.insert(triangles.end(), {at(i, j), at(i + 1, j + 1), at(i, j + 1)});
        }
    for (std::size_t i = 0; i < triangles.size(); ++i) triangles[i].id = static_cast<GLint>(i);
    return triangles;
}

// Smooth colours, so that a texture coordinate off by a rounding error stays within a step.
std::vector<std::uint8_t> smooth_texels(int n, int depth, double phase) {
    std::vector<std::uint8_t> texels;
    for (int z = 0; z < depth; ++z)
        for (int y = 0; y < n; ++y)
            for (int x = 0; x < n; ++x) {
                const double turn = 2 * glm::pi<double>();
                texels.push_back(static_cast<std::uint8_t>(128 + 100 * std::sin(turn * x / n + phase)));
                texels.push_back(static_cast<std::uint8_t>(128 + 100 * std::sin(turn * y / n + 2 * phase)));
                texels.push_back(static_cast<std::uint8_t>(128 + 100 * std::cos(turn * (x + y + z) / n)));
                texels.push_back(255);
            }
    return texels;
}

void smooth_filter(GLenum target, GLint wrap) {
    glTexParameteri(target, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
    glTexParameteri(target, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    for (const GLenum axis : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T, GL_TEXTURE_WRAP_R})
        glTexParameteri(target, axis, wrap);
    glGenerateMipmap(target);
}

void fill_unit(int unit, bool lines, std::vector<GLuint>& names) {
    constexpr int n = 32, volume = 16;
    const double phase = unit == 2 || unit == 3 ? .5 : 1. + unit;
    const auto bind = [&](GLenum target) {
        GLuint name = 0;
        glGenTextures(1, &name);
        glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
        glBindTexture(target, name);
        names.push_back(name);
    };
    const auto flat = smooth_texels(n, 1, phase), solid = smooth_texels(volume, volume, phase);
    if (lines) {  // OpenGL ES has none
        bind(GL_TEXTURE_1D);
        glTexImage1D(GL_TEXTURE_1D, 0, GL_RGBA8, n, 0, GL_RGBA, GL_UNSIGNED_BYTE, flat.data());
        smooth_filter(GL_TEXTURE_1D, GL_REPEAT);
    }
    bind(GL_TEXTURE_2D);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, n, n, 0, GL_RGBA, GL_UNSIGNED_BYTE, flat.data());
    smooth_filter(GL_TEXTURE_2D, GL_REPEAT);
    bind(GL_TEXTURE_3D);
    glTexImage3D(GL_TEXTURE_3D, 0, GL_RGBA8, volume, volume, volume, 0, GL_RGBA, GL_UNSIGNED_BYTE, solid.data());
    smooth_filter(GL_TEXTURE_3D, GL_REPEAT);
    bind(GL_TEXTURE_CUBE_MAP);
    for (GLenum face = 0; face < 6; ++face) {
        const auto side = smooth_texels(n, 1, phase + .2 * face);
        glTexImage2D(GL_TEXTURE_CUBE_MAP_POSITIVE_X + face, 0, GL_RGBA8, n, n, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                     side.data());
    }
    smooth_filter(GL_TEXTURE_CUBE_MAP, GL_CLAMP_TO_EDGE);
}

GLuint depth_texture() {
    constexpr int n = 16;
    std::vector<float> depths;
    for (int i = 0; i < n * n; ++i) depths.push_back(i % n < n / 2 ? .25f : .75f);
    GLuint name = 0;
    glGenTextures(1, &name);
    glActiveTexture(GL_TEXTURE0 + shadow_unit);
    glBindTexture(GL_TEXTURE_2D, name);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT32F, n, n, 0, GL_DEPTH_COMPONENT, GL_FLOAT, depths.data());
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE);
    return name;
}

const void* offset(std::size_t bytes) { return reinterpret_cast<const void*>(bytes); }

GLenum shader_kind(Stage stage) {
    switch (stage) {
        case Stage::vertex:
            return GL_VERTEX_SHADER;
        case Stage::tess_control:
            return GL_TESS_CONTROL_SHADER;
        case Stage::tess_evaluation:
            return GL_TESS_EVALUATION_SHADER;
        case Stage::geometry:
            return GL_GEOMETRY_SHADER;
        case Stage::fragment:
            return GL_FRAGMENT_SHADER;
    }
    return 0;
}

std::string log_of(GLuint name, decltype(glGetShaderInfoLog) get) {
    std::string log(4096, '\0');
    GLsizei length = 0;
    get(name, static_cast<GLsizei>(log.size()), &length, log.data());
    log.resize(static_cast<std::size_t>(length));
    return log;
}

}  // namespace

Program::~Program() {
    if (id) glDeleteProgram(id);
}

Program build(const Texts& texts) {
    Program program;
    const GLuint id = glCreateProgram();
    bool ok = true;
    for (const auto& [stage, text] : texts) {
        const GLuint shader = glCreateShader(shader_kind(stage));
        const char* source = text.c_str();
        const GLint length = static_cast<GLint>(text.size());
        glShaderSource(shader, 1, &source, &length);
        glCompileShader(shader);
        GLint compiled = 0;
        glGetShaderiv(shader, GL_COMPILE_STATUS, &compiled);
        if (!compiled) program.log += log_of(shader, glGetShaderInfoLog);
        ok = ok && compiled;
        glAttachShader(id, shader);
        glDeleteShader(shader);
    }
    for (const glsl::AttributeName& a : glsl::attribute_names())
        glBindAttribLocation(id, static_cast<GLuint>(a.attribute), std::string(a.name).c_str());
    GLint linked = 0;
    if (ok) {
        glLinkProgram(id);
        glGetProgramiv(id, GL_LINK_STATUS, &linked);
        if (!linked) program.log += log_of(id, glGetProgramInfoLog);
    }
    if (linked) {
        program.id = id;
    } else {
        glDeleteProgram(id);
    }
    return program;
}

Stand::Stand(Kind kind) : kind_(kind) {
    glGenVertexArrays(1, &vao_);
    glBindVertexArray(vao_);
    glGenBuffers(1, &buffer_);
    arrays();
    for (int unit = 0; unit < shadow_unit; ++unit) fill_unit(unit, kind_ != Kind::es, textures_);
    textures_.push_back(depth_texture());

    glGenFramebuffers(1, &framebuffer_);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
    glGenRenderbuffers(4, targets_.data());
    for (GLenum i = 0; i < 4; ++i) {
        glBindRenderbuffer(GL_RENDERBUFFER, targets_[i]);
        glRenderbufferStorage(GL_RENDERBUFFER, GL_RGBA8, picture_size, picture_size);
        glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0 + i, GL_RENDERBUFFER, targets_[i]);
    }
    glGenRenderbuffers(1, &depth_);
    glBindRenderbuffer(GL_RENDERBUFFER, depth_);
    glRenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH_COMPONENT24, picture_size, picture_size);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, depth_);
}

Stand::~Stand() {
    glDeleteTextures(static_cast<GLsizei>(textures_.size()), textures_.data());
    glDeleteRenderbuffers(4, targets_.data());
    glDeleteRenderbuffers(1, &depth_);
    glDeleteFramebuffers(1, &framebuffer_);
    glDeleteBuffers(1, &buffer_);
    glDeleteVertexArrays(1, &vao_);
}

// Generic arrays everywhere; the legacy ones beside them in a compatibility context.
void Stand::arrays() {
    const std::vector<Vertex> vertices = sphere(24, 12);
    vertices_ = static_cast<int>(vertices.size());
    glBindBuffer(GL_ARRAY_BUFFER, buffer_);
    glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(vertices.size() * sizeof(Vertex)), vertices.data(),
                 GL_STATIC_DRAW);
    const auto generic = [](glsl::Attribute a, GLint size, std::size_t at) {
        glEnableVertexAttribArray(static_cast<GLuint>(a));
        glVertexAttribPointer(static_cast<GLuint>(a), size, GL_FLOAT, GL_FALSE, sizeof(Vertex), offset(at));
    };
    using enum glsl::Attribute;
    generic(vertex, 4, offsetof(Vertex, position));
    generic(normal, 4, offsetof(Vertex, normal));
    generic(color, 4, offsetof(Vertex, color));
    generic(texcoord, 4, offsetof(Vertex, texcoord));
    generic(tangent, 3, offsetof(Vertex, tangent));
    generic(secondary_color, 4, offsetof(Vertex, secondary));
    generic(fog_coord, 1, offsetof(Vertex, fog));
    glEnableVertexAttribArray(static_cast<GLuint>(vertex_id));
    glVertexAttribIPointer(static_cast<GLuint>(vertex_id), 1, GL_INT, sizeof(Vertex), offset(offsetof(Vertex, id)));
    if (kind_ != Kind::compatibility) return;
    constexpr GLsizei stride = sizeof(Vertex);
    glEnableClientState(GL_VERTEX_ARRAY);
    glVertexPointer(4, GL_FLOAT, stride, offset(offsetof(Vertex, position)));
    glEnableClientState(GL_NORMAL_ARRAY);
    glNormalPointer(GL_FLOAT, stride, offset(offsetof(Vertex, normal)));
    glEnableClientState(GL_COLOR_ARRAY);
    glColorPointer(4, GL_FLOAT, stride, offset(offsetof(Vertex, color)));
    glEnableClientState(GL_SECONDARY_COLOR_ARRAY);
    glSecondaryColorPointer(3, GL_FLOAT, stride, offset(offsetof(Vertex, secondary)));
    glEnableClientState(GL_FOG_COORD_ARRAY);
    glFogCoordPointer(GL_FLOAT, stride, offset(offsetof(Vertex, fog)));
    for (GLenum unit = 0; unit < 8; ++unit) {
        glClientActiveTexture(GL_TEXTURE0 + unit);
        glEnableClientState(GL_TEXTURE_COORD_ARRAY);
        glTexCoordPointer(4, GL_FLOAT, stride, offset(offsetof(Vertex, texcoord)));
    }
}

// Lights, materials and fog stay as OpenGL has them at first: the defaults that the translation documents.
void Stand::fixed_function(const Needs& needs) {
    const auto load = [](GLenum mode, const glm::dmat4& matrix) {
        glMatrixMode(mode);
        glLoadMatrixf(glm::value_ptr(glm::mat4(matrix)));
    };
    load(GL_MODELVIEW, model_view());
    load(GL_PROJECTION, projection());
    glActiveTexture(GL_TEXTURE0);
    load(GL_TEXTURE, texture_matrix());
    glEnable(GL_POINT_SPRITE);
    (needs.two_sided ? glEnable : glDisable)(GL_VERTEX_PROGRAM_TWO_SIDE);
}

Picture Stand::draw(const Program& program, const Needs& needs, const glsl::Translation& translation) {
    constexpr GLenum buffers[] = {GL_COLOR_ATTACHMENT0, GL_COLOR_ATTACHMENT1, GL_COLOR_ATTACHMENT2,
                                  GL_COLOR_ATTACHMENT3};
    glDrawBuffers(needs.targets, buffers);
    glViewport(0, 0, picture_size, picture_size);
    glEnable(GL_DEPTH_TEST);
    if (kind_ != Kind::es) {  // there it is always so
        glEnable(GL_PROGRAM_POINT_SIZE);
        glEnable(GL_TEXTURE_CUBE_MAP_SEAMLESS);
    }
    glClearColor(0, 0, 0, 0);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    if (kind_ == Kind::compatibility) fixed_function(needs);
    glUseProgram(program.id);
    set_uniforms(program.id, translation, kind_ == Kind::es);
    if (needs.primitive == GL_PATCHES) glPatchParameteri(GL_PATCH_VERTICES, needs.patch_vertices);
    glDrawArrays(needs.primitive, 0, vertices_);
    glUseProgram(0);
    Picture picture;
    constexpr std::size_t bytes = 4u * picture_size * picture_size;
    picture.pixels.resize(bytes * static_cast<std::size_t>(needs.targets));
    for (int i = 0; i < needs.targets; ++i) {
        glReadBuffer(buffers[i]);
        glReadPixels(0, 0, picture_size, picture_size, GL_RGBA, GL_UNSIGNED_BYTE,
                     picture.pixels.data() + bytes * static_cast<std::size_t>(i));
    }
    return picture;
}

Difference difference(const Picture& a, const Picture& b) {
    Difference d;
    if (a.pixels.size() != b.pixels.size()) return {.differing = 1, .drawn = 0, .pixels = 1, .largest = 255};
    for (std::size_t i = 0; i < a.pixels.size(); i += 4) {
        int largest = 0, sum = 0;
        for (std::size_t c = i; c < i + 4; ++c) {
            largest = std::max(largest, std::abs(int(a.pixels[c]) - int(b.pixels[c])));
            sum += a.pixels[c];
        }
        ++d.pixels;
        if (sum > 0) ++d.drawn;
        if (largest > 1) ++d.differing;
        d.largest = std::max(d.largest, largest);
    }
    return d;
}

}  // namespace snell::oracle
