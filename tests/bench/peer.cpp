#define GL_GLEXT_PROTOTYPES
#include "tests/bench/peer.h"

#include "ig/configuration.h"

#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <GL/gl.h>
#include <GL/glext.h>

#include <array>
#include <cstddef>
#include <stdexcept>

namespace linkdig::bench {

namespace {

/// Intensity as the report has it, at the vertices.
constexpr const char* vertex_shader = R"(#version 330 core
layout(location = 0) in vec4 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec4 colour_code;
layout(location = 3) in vec3 light;
uniform mat4 clip_from_world;
uniform vec3 suns[8];
out vec3 colour;
void main() {
    float intensity = light.z < 0.0 ? 1.0 : min(1.0, light.x + light.y * max(0.0, dot(normal, suns[int(light.z)])));
    colour = colour_code.rgb * intensity;
    gl_Position = clip_from_world * position;
})";
constexpr const char* fragment_shader = R"(#version 330 core
in vec3 colour;
out vec4 pixel;
void main() { pixel = vec4(colour, 1.0); })";

GLuint compiled(GLenum kind, const char* text) {
    const GLuint shader = glCreateShader(kind);
    glShaderSource(shader, 1, &text, nullptr);
    glCompileShader(shader);
    GLint good = 0;
    glGetShaderiv(shader, GL_COMPILE_STATUS, &good);
    if (good != 0) return shader;
    std::array<char, 1024> log{};
    glGetShaderInfoLog(shader, static_cast<GLsizei>(log.size()), nullptr, log.data());
    throw std::runtime_error(std::string("the peer's shader does not compile: ") + log.data());
}

/// World to clip space with an infinite far plane; z = near plane is -1. Column by column.
std::array<float, 16> clip_from_world(const ChannelView& view, const Vec3d& measured_from) {
    const Mat3d axes = world_from_body(view.attitude);
    const Vec3d right = -axes[1], up = axes[2], ahead = axes[0];
    const double w = view.right_tangent - view.left_tangent, h = view.top_tangent - view.bottom_tangent;
    const Vec3d rows[4] = {(2.0 / w) * right - ((view.right_tangent + view.left_tangent) / w) * ahead,
                           (2.0 / h) * up - ((view.top_tangent + view.bottom_tangent) / h) * ahead, ahead,
                           ahead};
    const Vec3d from_eye = measured_from - view.eye_m;
    std::array<float, 16> matrix{};
    for (std::size_t row = 0; row < 4; ++row) {
        for (std::size_t column = 0; column < 3; ++column)
            matrix[4 * column + row] = static_cast<float>(rows[row][static_cast<int>(column)]);
        matrix[12 + row] =
            static_cast<float>(glm::dot(rows[row], from_eye) - (row == 2 ? 2.0 * ig::near_plane_m : 0.0));
    }
    return matrix;
}

struct Buffers {
    GLuint array = 0, vertices = 0, indices = 0;
    GLsizei count = 0;
    Vec3d eye_m{0};
};

void attribute(GLuint location, GLint size, GLenum type, GLboolean normalised, std::size_t offset) {
    glEnableVertexAttribArray(location);
    glVertexAttribPointer(location, size, type, normalised, sizeof(WorldVertex),
                          reinterpret_cast<const void*>(offset)); // an offset, by the interface's custom
}

} // namespace

struct Peer::State {
    EGLDisplay display = EGL_NO_DISPLAY;
    EGLContext context = EGL_NO_CONTEXT;
    std::uint32_t width = 0, height = 0;
    GLuint program = 0;
    GLint matrix = -1, suns = -1;
    bool depth_test = false;
    std::vector<Buffers> channels;
    std::vector<std::uint32_t> pixels;

    void open_context() {
        const auto get_display =
            reinterpret_cast<PFNEGLGETPLATFORMDISPLAYEXTPROC>(eglGetProcAddress("eglGetPlatformDisplayEXT"));
        if (get_display == nullptr) throw std::runtime_error("EGL here has no platform displays");
        display = get_display(EGL_PLATFORM_SURFACELESS_MESA, nullptr, nullptr);
        if (display == EGL_NO_DISPLAY || eglInitialize(display, nullptr, nullptr) == EGL_FALSE)
            throw std::runtime_error("EGL's surfaceless platform cannot be opened");
        eglBindAPI(EGL_OPENGL_API);
        static constexpr EGLint wanted[] = {EGL_CONTEXT_MAJOR_VERSION,
                                            3,
                                            EGL_CONTEXT_MINOR_VERSION,
                                            3,
                                            EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                            EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                            EGL_NONE};
        context = eglCreateContext(display, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, wanted);
        if (context == EGL_NO_CONTEXT ||
            eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context) == EGL_FALSE)
            throw std::runtime_error("an OpenGL 3.3 context cannot be made");
    }

    void make_target() const {
        std::array<GLuint, 2> storage{};
        GLuint frame = 0;
        glGenRenderbuffers(2, storage.data());
        glGenFramebuffers(1, &frame);
        glBindFramebuffer(GL_FRAMEBUFFER, frame);
        glBindRenderbuffer(GL_RENDERBUFFER, storage[0]);
        glRenderbufferStorage(GL_RENDERBUFFER, GL_RGBA8, static_cast<GLsizei>(width),
                              static_cast<GLsizei>(height));
        glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, storage[0]);
        if (depth_test) {
            glBindRenderbuffer(GL_RENDERBUFFER, storage[1]);
            glRenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH_COMPONENT24, static_cast<GLsizei>(width),
                                  static_cast<GLsizei>(height));
            glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, storage[1]);
        }
        if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
            throw std::runtime_error("the peer's frame buffer is incomplete");
        glViewport(0, 0, static_cast<GLsizei>(width), static_cast<GLsizei>(height));
    }

    void make_program() {
        program = glCreateProgram();
        glAttachShader(program, compiled(GL_VERTEX_SHADER, vertex_shader));
        glAttachShader(program, compiled(GL_FRAGMENT_SHADER, fragment_shader));
        glLinkProgram(program);
        glUseProgram(program);
        matrix = glGetUniformLocation(program, "clip_from_world");
        suns = glGetUniformLocation(program, "suns");
        glEnable(GL_CULL_FACE);
        if (depth_test) {
            glEnable(GL_DEPTH_TEST);
            glDepthFunc(GL_LEQUAL);
        }
    }
};

Peer::Peer(std::uint32_t width, std::uint32_t height, bool depth_test) : state_(std::make_unique<State>()) {
    state_->width = width;
    state_->height = height;
    state_->depth_test = depth_test;
    state_->pixels.resize(std::size_t{width} * height);
    state_->open_context();
    state_->make_target();
    state_->make_program();
}

Peer::~Peer() {
    eglMakeCurrent(state_->display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    eglDestroyContext(state_->display, state_->context);
}

std::string Peer::renderer() const {
    return reinterpret_cast<const char*>(glGetString(GL_RENDERER)); // bytes, by the interface's custom
}

void Peer::add(const WorldFaces& faces) {
    Buffers made{.count = static_cast<GLsizei>(faces.indices.size()), .eye_m = faces.eye_m};
    glGenVertexArrays(1, &made.array);
    glBindVertexArray(made.array);
    glGenBuffers(1, &made.vertices);
    glBindBuffer(GL_ARRAY_BUFFER, made.vertices);
    glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(faces.vertices.size() * sizeof(WorldVertex)),
                 faces.vertices.data(), GL_STATIC_DRAW);
    glGenBuffers(1, &made.indices);
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, made.indices);
    glBufferData(GL_ELEMENT_ARRAY_BUFFER,
                 static_cast<GLsizeiptr>(faces.indices.size() * sizeof(std::uint32_t)), faces.indices.data(),
                 GL_STATIC_DRAW);
    attribute(0, 4, GL_FLOAT, GL_FALSE, offsetof(WorldVertex, position));
    attribute(1, 3, GL_FLOAT, GL_FALSE, offsetof(WorldVertex, normal));
    attribute(2, 4, GL_UNSIGNED_BYTE, GL_TRUE, offsetof(WorldVertex, colour));
    attribute(3, 3, GL_FLOAT, GL_FALSE, offsetof(WorldVertex, light));
    state_->channels.push_back(made);
}

const std::vector<std::uint32_t>& Peer::draw(const FramePacket& packet, std::size_t channel) {
    const Buffers& buffers = state_->channels[channel];
    const std::array<float, 16> matrix = clip_from_world(packet.channels[channel], buffers.eye_m);
    glClearColor(packet.sky.x, packet.sky.y, packet.sky.z, 1.0F);
    glClear(GL_COLOR_BUFFER_BIT | (state_->depth_test ? GL_DEPTH_BUFFER_BIT : 0U));
    glUniformMatrix4fv(state_->matrix, 1, GL_FALSE, matrix.data());
    glUniform3fv(state_->suns, static_cast<GLsizei>(packet.suns.size()), &packet.suns[0].x);
    glBindVertexArray(buffers.array);
    glDrawElements(GL_TRIANGLES, buffers.count, GL_UNSIGNED_INT, nullptr);
    glFinish();
    glReadPixels(0, 0, static_cast<GLsizei>(state_->width), static_cast<GLsizei>(state_->height), GL_RGBA,
                 GL_UNSIGNED_BYTE, state_->pixels.data());
    return state_->pixels;
}

} // namespace linkdig::bench
