#include "view/debug_view/display_expression.h"

#include <fmt/format.h>
#include <glad/gl.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <initializer_list>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "base/text.h"
#include "gpu/object/framebuffer.h"
#include "gpu/object/program.h"
#include "gpu/object/texture.h"
#include "view/debug_view/bound_target.h"
#include "view/debug_view/debug_program.h"

namespace glibra::view {
namespace {

constexpr std::string_view kWhole =
    "#version 410 core\n"
    "void main() { gl_Position = vec4(gl_VertexID == 1 ? 3. : -1., gl_VertexID == 2 ? 3. : -1., 0., 1.); }\n";

constexpr std::string_view kBegin =
    "#version 410 core\n"
    "uniform sampler2D glibra_texels;\n"
    "out vec4 glibra_shown;\n"
    "uniform float glibra_zero;\n"
    "vec4 near(int glibra_x, int glibra_y) {\n"
    "    ivec2 glibra_most = textureSize(glibra_texels, 0) - 1;\n"
    "    return texelFetch(glibra_texels,\n"
    "                      clamp(ivec2(gl_FragCoord.xy) + ivec2(glibra_x, glibra_y), ivec2(0), glibra_most), "
    "0);\n"
    "}\n"
    "vec4 glibra_asColor(float value) { return vec4(vec3(value), 1.); }\n"
    "vec4 glibra_asColor(int value) { return vec4(vec3(float(value)), 1.); }\n"
    "vec4 glibra_asColor(uint value) { return vec4(vec3(float(value)), 1.); }\n"
    "vec4 glibra_asColor(bool value) { return vec4(vec3(value ? 1. : 0.), 1.); }\n"
    "vec4 glibra_asColor(vec2 value) { return vec4(value, 0., 1.); }\n"
    "vec4 glibra_asColor(vec3 value) { return vec4(value, 1.); }\n"
    "vec4 glibra_asColor(vec4 value) { return value; }\n"
    "void main() {\n"
    "    ivec2 texel = ivec2(gl_FragCoord.xy);\n"
    "    ivec2 size = textureSize(glibra_texels, 0);\n"
    "    vec2 st = gl_FragCoord.xy / vec2(size);\n"
    "    vec4 color = near(0, 0);\n"
    "    glibra_shown = glibra_asColor(\n"
    "#line 1\n";

/// Red, green, blue and alpha as a sampler gives them: what the texture does not have is 0, alpha 1.
std::vector<float> asSampled(const render::Content& content) {
    const std::size_t count =
        static_cast<std::size_t>(content.width) * static_cast<std::size_t>(content.height);
    std::vector<float> texels;
    texels.reserve(4 * count);
    for (std::size_t i = 0; i < count; ++i) {
        std::array<float, 4> texel{0, 0, 0, 1};
        const std::span<const double> values = content.at(i);
        for (std::size_t k = 0; k < std::min(values.size(), texel.size()); ++k)
            texel.at(k) = static_cast<float>(values[k]);
        texels.insert(texels.end(), texel.begin(), texel.end());
    }
    return texels;
}

/// The expression with a uniform that is 0 added to each number with a point. Drivers compute with constants
/// as they compile, and make anything of a division by a constant 0.
std::string withoutConstants(std::string_view expression) {
    std::string text;
    const auto isDigit = [&](std::size_t at) {
        return at < expression.size() && std::isdigit(static_cast<unsigned char>(expression[at])) != 0;
    };
    for (std::size_t at = 0; at < expression.size();) {
        const std::size_t begin = at;
        if (base::isOfName(expression[at]) && !isDigit(at)) {
            while (at < expression.size() && base::isOfName(expression[at])) ++at;
            text += expression.substr(begin, at - begin);
            continue;
        }
        if (!isDigit(at) && !(expression[at] == '.' && isDigit(at + 1))) {
            text += expression[at++];
            continue;
        }
        bool isReal = false;
        for (; at < expression.size() && (base::isOfName(expression[at]) || expression[at] == '.'); ++at) {
            const bool isExponent = (expression[at] == 'e' || expression[at] == 'E') && !isReal;
            isReal = isReal || expression[at] == '.' || isExponent;
            const bool isSigned = (expression[at] == 'e' || expression[at] == 'E') &&
                                  at + 2 < expression.size() &&
                                  (expression[at + 1] == '-' || expression[at + 1] == '+') && isDigit(at + 2);
            if (isSigned) ++at;
        }
        const std::string_view number = expression.substr(begin, at - begin);
        const bool isHexadecimal = number.starts_with("0x") || number.starts_with("0X");
        text += isReal && !isHexadecimal ? fmt::format("({} + glibra_zero)", number) : std::string(number);
    }
    return text;
}

/// "0:1(9): error: `colour' undeclared" without the place.
std::string firstMessage(const gpu::BuildOutcome& built) {
    std::string log = built.linkLog;
    for (const gpu::StageLog& each : built.stages)
        if (!each.compiled) log = each.log;
    log = log.substr(0, log.find('\n'));
    if (const std::size_t at = log.find("error: "); at != std::string::npos) log = log.substr(at + 7);
    return log.empty() ? "the driver does not compile this expression" : log;
}

}  // namespace

Displayed displayedBy(gpu::Context& context, const render::Content& content, const std::string& expression) {
    // One expression cannot loop: it always ends.
    if (expression.find_first_of(";{}#\n\\") != std::string::npos)
        return {std::nullopt, "one expression, such as color.rgb * 10"};
    const gpu::Capabilities& capabilities = context.capabilities();
    const std::string text = std::string(kBegin) + withoutConstants(expression) + "\n    );\n}\n";
    const std::array<gpu::StageSource, 2> stages{{{GL_VERTEX_SHADER, kWhole}, {GL_FRAGMENT_SHADER, text}}};
    const gpu::BuildOutcome built = gpu::buildProgram(capabilities, {.stages = stages});
    // Its messages are about that text.
    [[maybe_unused]] const Diagnostics known = context.debugLog().takeDiagnostics();
    if (!built.program) return {std::nullopt, firstMessage(built)};
    const KeptState kept;
    const std::vector<float> texels = asSampled(content);
    const Result<gpu::Texture> source = gpu::Texture::create(
        capabilities, gpu::TextureShape::texture2D, gpu::TexelFormat::rgba32f,
        {content.width, content.height, 1}, {std::as_bytes(std::span(texels)), 4, gpu::TexelType::f32});
    const Result<gpu::Renderbuffer> made =
        gpu::Renderbuffer::create(capabilities, content.width, content.height, gpu::TexelFormat::rgba32f);
    if (!source || !made) return {std::nullopt, "there is no memory for another picture"};
    const std::array<gpu::Attachment, 1> colors{&*made};
    const Result<gpu::Framebuffer> target = gpu::Framebuffer::create(colors);
    if (!target) return {std::nullopt, "there is no memory for another picture"};
    std::array<GLint, 4> viewport{};
    glGetIntegerv(GL_VIEWPORT, viewport.data());
    std::array<GLint, 2> polygons{GL_FILL, GL_FILL};
    glGetIntegerv(GL_POLYGON_MODE, polygons.data());
    const bool discards = glIsEnabled(GL_RASTERIZER_DISCARD) != GL_FALSE;
    GLint bound = 0, active = GL_TEXTURE0;
    glGetIntegerv(GL_ACTIVE_TEXTURE, &active);
    glActiveTexture(GL_TEXTURE0);
    glGetIntegerv(GL_TEXTURE_BINDING_2D, &bound);
    GLuint vertices = 0;
    glGenVertexArrays(1, &vertices);
    target->bindForDrawing();
    writeOnly(0);
    for (const GLenum each : std::initializer_list<GLenum>{GL_DEPTH_TEST, GL_STENCIL_TEST, GL_SCISSOR_TEST,
                                                           GL_CULL_FACE, GL_FRAMEBUFFER_SRGB})
        glDisable(each);
    glDisable(GL_RASTERIZER_DISCARD);
    glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);
    glDisablei(GL_BLEND, 0);
    glColorMaski(0, GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    glViewport(0, 0, content.width, content.height);
    glBindTexture(GL_TEXTURE_2D, source->id());
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glBindVertexArray(vertices);
    built.program->use();
    glDrawArrays(GL_TRIANGLES, 0, 3);
    Displayed shown{
        readBound(capabilities,
                  {FrameTarget::Kind::color, 0, base::TexelFormat::rgba32f, content.width, content.height},
                  0),
        {}};
    glDeleteVertexArrays(1, &vertices);
    glPolygonMode(GL_FRONT_AND_BACK, static_cast<GLenum>(polygons[0]));
    if (discards) glEnable(GL_RASTERIZER_DISCARD);
    glBindTexture(GL_TEXTURE_2D, static_cast<GLuint>(bound));
    glActiveTexture(static_cast<GLenum>(active));
    glViewport(viewport[0], viewport[1], viewport[2], viewport[3]);
    if (shown.content) shown.content->name = content.name;
    return shown;
}

}  // namespace glibra::view
