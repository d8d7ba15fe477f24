#include "bare_frame.h"

#define EGL_NO_X11
#include <EGL/egl.h>

#include <algorithm>
#include <cstring>

namespace bench {
namespace {

constexpr std::array kSwitches{GL_DEPTH_TEST,   GL_BLEND,       GL_CULL_FACE,         GL_STENCIL_TEST,
                               GL_SCISSOR_TEST, GL_MULTISAMPLE, GL_PROGRAM_POINT_SIZE};
constexpr std::array kBlending{GL_BLEND_SRC_RGB, GL_BLEND_DST_RGB, GL_BLEND_SRC_ALPHA, GL_BLEND_DST_ALPHA};
constexpr std::array kDepthAndCulling{GL_DEPTH_FUNC, GL_CULL_FACE_MODE, GL_FRONT_FACE};

bool isNoting = false;
std::vector<Call> noted;

GLint number(GLenum name) {
    GLint value = 0;
    glGetIntegerv(name, &value);
    return value;
}

std::pair<GLenum, GLenum> samplerOf(GLenum type) {
    switch (type) {
        case GL_SAMPLER_1D:
            return {GL_TEXTURE_1D, GL_TEXTURE_BINDING_1D};
        case GL_SAMPLER_2D:
            return {GL_TEXTURE_2D, GL_TEXTURE_BINDING_2D};
        case GL_SAMPLER_3D:
            return {GL_TEXTURE_3D, GL_TEXTURE_BINDING_3D};
        case GL_SAMPLER_CUBE:
            return {GL_TEXTURE_CUBE_MAP, GL_TEXTURE_BINDING_CUBE_MAP};
        default:
            return {0, 0};
    }
}

bool isOfIntegers(GLenum type) {
    return type == GL_INT || type == GL_BOOL || samplerOf(type).first != 0;
}

void noteUniforms(State& state) {
    const auto program = static_cast<GLuint>(state.program);
    GLint count = 0;
    glGetProgramiv(program, GL_ACTIVE_UNIFORMS, &count);
    for (GLint i = 0; i < count; ++i) {
        std::array<char, 256> name{};
        GLint size = 0;
        GLenum type = 0;
        glGetActiveUniform(program, static_cast<GLuint>(i), name.size(), nullptr, &size, &type, name.data());
        const GLint location = glGetUniformLocation(program, name.data());
        if (location < 0) continue;
        State::Uniform& uniform = state.uniforms[location];
        uniform.type = type;
        if (isOfIntegers(type))
            glGetUniformiv(program, location, uniform.integers.data());
        else
            glGetUniformfv(program, location, uniform.numbers.data());
        const auto [target, binding] = samplerOf(type);
        if (target == 0) continue;
        const GLint unit = uniform.integers[0];
        const GLint before = number(GL_ACTIVE_TEXTURE);
        glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
        state.textures[unit] = {target, number(binding), number(GL_SAMPLER_BINDING)};
        glActiveTexture(static_cast<GLenum>(before));
    }
}

State now() {
    State state;
    state.program = number(GL_CURRENT_PROGRAM);
    state.vertexArray = number(GL_VERTEX_ARRAY_BINDING);
    state.framebuffer = number(GL_DRAW_FRAMEBUFFER_BINDING);
    glGetIntegerv(GL_VIEWPORT, state.viewport.data());
    for (const GLenum each : kSwitches) state.enabled[each] = glIsEnabled(each) != 0;
    for (std::size_t i = 0; i < kBlending.size(); ++i) state.blending[i] = number(kBlending[i]);
    for (std::size_t i = 0; i < kDepthAndCulling.size(); ++i)
        state.depthAndCulling[i] = number(kDepthAndCulling[i]);
    state.writesDepth = number(GL_DEPTH_WRITEMASK) != 0;
    if (state.program != 0) noteUniforms(state);
    return state;
}

void note(Call call) {
    if (!isNoting) return;
    call.state = now();
    noted.push_back(std::move(call));
}

// What glibra calls in place of GL's functions of these names.
void GLAPIENTRY drawElements(GLenum mode, GLsizei count, GLenum type, const void* offset) {
    note({.kind = Call::Kind::elements, .mode = mode, .count = count, .type = type, .offset = offset});
    glDrawElements(mode, count, type, offset);
}
void GLAPIENTRY drawArrays(GLenum mode, GLint first, GLsizei count) {
    note({.kind = Call::Kind::arrays, .mode = mode, .first = first, .count = count});
    glDrawArrays(mode, first, count);
}
void GLAPIENTRY clearBufferfv(GLenum buffer, GLint index, const GLfloat* value) {
    Call call{.kind = Call::Kind::clearFloats, .mode = buffer, .first = index};
    std::copy_n(value, buffer == GL_COLOR ? 4 : 1, call.floats.begin());
    note(std::move(call));
    glClearBufferfv(buffer, index, value);
}
void GLAPIENTRY clearBufferfi(GLenum buffer, GLint index, GLfloat depth, GLint stencil) {
    note({.kind = Call::Kind::clearBoth,
          .mode = buffer,
          .first = index,
          .floats = {depth},
          .stencil = stencil});
    glClearBufferfi(buffer, index, depth, stencil);
}
void GLAPIENTRY clearBufferiv(GLenum buffer, GLint index, const GLint* value) {
    note({.kind = Call::Kind::clearIntegers, .mode = buffer, .first = index, .stencil = *value});
    glClearBufferiv(buffer, index, value);
}

void put(GLint location, const State::Uniform& value) {
    const float* numbers = value.numbers.data();
    switch (value.type) {
        case GL_FLOAT:
            return glUniform1fv(location, 1, numbers);
        case GL_FLOAT_VEC2:
            return glUniform2fv(location, 1, numbers);
        case GL_FLOAT_VEC3:
            return glUniform3fv(location, 1, numbers);
        case GL_FLOAT_VEC4:
            return glUniform4fv(location, 1, numbers);
        case GL_FLOAT_MAT3:
            return glUniformMatrix3fv(location, 1, GL_FALSE, numbers);
        case GL_FLOAT_MAT4:
            return glUniformMatrix4fv(location, 1, GL_FALSE, numbers);
        default:
            return glUniform1iv(location, 1, value.integers.data());
    }
}

}  // namespace

void* notingLoader(const char* name) {
    static const std::pair<const char*, void (*)()> kNoted[] = {
        {"glDrawElements", reinterpret_cast<void (*)()>(drawElements)},
        {"glDrawArrays", reinterpret_cast<void (*)()>(drawArrays)},
        {"glClearBufferfv", reinterpret_cast<void (*)()>(clearBufferfv)},
        {"glClearBufferfi", reinterpret_cast<void (*)()>(clearBufferfi)},
        {"glClearBufferiv", reinterpret_cast<void (*)()>(clearBufferiv)},
    };
    for (const auto& [each, function] : kNoted)
        if (std::strcmp(each, name) == 0) return reinterpret_cast<void*>(function);
    return reinterpret_cast<void*>(eglGetProcAddress(name));
}

void BareFrame::begin() {
    noted.clear();
    isNoting = true;
}

BareFrame BareFrame::end() {
    isNoting = false;
    BareFrame frame;
    frame.calls_ = std::move(noted);
    return frame;
}

/// The calls that turn one state into the other.
Calls BareFrame::change(const State& from, const State& to) {
    Calls calls;
    const auto name = [](GLint value) { return static_cast<GLuint>(value); };
    if (from.framebuffer != to.framebuffer)
        calls.push_back([f = name(to.framebuffer)] { glBindFramebuffer(GL_FRAMEBUFFER, f); });
    if (from.viewport != to.viewport)
        calls.push_back([v = to.viewport] { glViewport(v[0], v[1], v[2], v[3]); });
    for (const auto& [each, isOn] : to.enabled)
        if (const auto was = from.enabled.find(each); was == from.enabled.end() || was->second != isOn)
            calls.push_back([each, isOn] { isOn ? glEnable(each) : glDisable(each); });
    if (from.blending != to.blending)
        calls.push_back([b = to.blending] {
            glBlendFuncSeparate(static_cast<GLenum>(b[0]), static_cast<GLenum>(b[1]),
                                static_cast<GLenum>(b[2]), static_cast<GLenum>(b[3]));
        });
    if (from.depthAndCulling != to.depthAndCulling)
        calls.push_back([d = to.depthAndCulling] {
            glDepthFunc(static_cast<GLenum>(d[0]));
            glCullFace(static_cast<GLenum>(d[1]));
            glFrontFace(static_cast<GLenum>(d[2]));
        });
    if (from.writesDepth != to.writesDepth)
        calls.push_back([on = to.writesDepth] { glDepthMask(on ? GL_TRUE : GL_FALSE); });
    if (from.program != to.program) calls.push_back([p = name(to.program)] { glUseProgram(p); });
    if (from.vertexArray != to.vertexArray)
        calls.push_back([a = name(to.vertexArray)] { glBindVertexArray(a); });
    for (const auto& [unit, texture] : to.textures) {
        if (const auto was = from.textures.find(unit); was != from.textures.end() && was->second == texture)
            continue;
        calls.push_back([unit, texture, name] {
            glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
            glBindTexture(texture.target, name(texture.name));
            glBindSampler(name(unit), name(texture.sampler));
        });
    }
    return calls;
}

void BareFrame::prepare(const std::string& value, int width, int height) {
    width_ = width;
    height_ = height;
    steps_.clear();
    // What a clear does does not depend on programs and textures.
    for (std::size_t i = 1; i < calls_.size(); ++i) {
        State& state = calls_[i].state;
        if (calls_[i].kind == Call::Kind::elements || calls_[i].kind == Call::Kind::arrays) continue;
        const State& before = calls_[i - 1].state;
        state.program = before.program;
        state.vertexArray = before.vertexArray;
        state.textures = before.textures;
        state.uniforms = before.uniforms;
    }
    if (calls_.empty()) return;
    calls_.front().state.program = calls_.back().state.program;
    calls_.front().state.vertexArray = calls_.back().state.vertexArray;
    calls_.front().state.textures = calls_.back().state.textures;
    calls_.front().state.uniforms = calls_.back().state.uniforms;
    // Textures that a draw does not read stay bound.
    std::map<GLint, State::Texture> bound;
    for (int round = 0; round < 2; ++round)
        for (Call& call : calls_) {
            for (const auto& [unit, texture] : call.state.textures) bound[unit] = texture;
            call.state.textures = bound;
        }
    // The uniforms of a program keep their values from draw to draw and from frame to frame.
    std::map<GLint, std::map<GLint, State::Uniform>> values;
    for (const Call& call : calls_) values[call.state.program] = call.state.uniforms;
    for (const Call& call : calls_) {
        Step step{.call = call};
        const bool draws = call.kind == Call::Kind::elements || call.kind == Call::Kind::arrays;
        if (draws && call.state.program != 0)
            step.location = glGetUniformLocation(static_cast<GLuint>(call.state.program), value.c_str());
        for (const auto& [location, uniform] : call.state.uniforms) {
            State::Uniform& set = values[call.state.program][location];
            if (draws && location != step.location && set != uniform)
                step.uniforms.emplace_back(location, uniform);
            set = uniform;
        }
        const State& before = &call == calls_.data() ? calls_.back().state : (&call - 1)->state;
        step.changes = change(before, call.state);
        steps_.push_back(std::move(step));
    }
    for (const auto& each : change({}, calls_.back().state)) each();
    for (const Call& call : calls_) {
        glUseProgram(static_cast<GLuint>(call.state.program));
        for (const auto& [location, uniform] : call.state.uniforms) put(location, uniform);
    }
    glUseProgram(static_cast<GLuint>(calls_.back().state.program));
    glReadBuffer(GL_COLOR_ATTACHMENT0);
    glBindBuffer(GL_PIXEL_PACK_BUFFER, 0);
}

bool BareFrame::hasValue() const {
    return std::any_of(steps_.begin(), steps_.end(), [](const Step& each) { return each.location >= 0; });
}

void BareFrame::draw(float value, std::span<std::byte> pixels) const {
    for (const Step& step : steps_) {
        const Call& call = step.call;
        for (const auto& each : step.changes) each();
        for (const auto& [location, uniform] : step.uniforms) put(location, uniform);
        if (step.location >= 0) glUniform1f(step.location, value);
        switch (call.kind) {
            case Call::Kind::elements:
                glDrawElements(call.mode, call.count, call.type, call.offset);
                break;
            case Call::Kind::arrays:
                glDrawArrays(call.mode, call.first, call.count);
                break;
            case Call::Kind::clearFloats:
                glClearBufferfv(call.mode, call.first, call.floats.data());
                break;
            case Call::Kind::clearIntegers:
                glClearBufferiv(call.mode, call.first, &call.stencil);
                break;
            case Call::Kind::clearBoth:
                glClearBufferfi(call.mode, call.first, call.floats[0], call.stencil);
                break;
        }
    }
    glReadPixels(0, 0, width_, height_, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
}

}  // namespace bench
