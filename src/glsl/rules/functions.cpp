// Replaces functions of older versions (language, 7.5).

#include <fmt/format.h>

#include <array>

#include "glsl/read/words.h"
#include "glsl/rules/rules.h"

namespace glibra::glsl {
namespace {

constexpr std::array<std::string_view, 9> kDimensions = {
    "2DRect", "1DArray", "2DArray", "CubeArray", "Buffer", "Cube", "1D", "2D", "3D"};

bool take(std::string_view& text, std::string_view part) {
    if (!text.starts_with(part)) return false;
    text.remove_prefix(part.size());
    return true;
}

std::string_view takeDimension(std::string_view& text) {
    for (const std::string_view each : kDimensions)
        if (take(text, each)) return each;
    return {};
}

/// The suffixes that may follow the dimension in names of texture and shadow functions.
bool takeVariant(std::string_view& text, std::string& core) {
    for (const std::string_view part : {"Proj", "Lod", "Grad", "Offset"}) {
        if (part == "Lod" || part == "Grad") {
            if (core.ends_with("Lod")) continue;
        }
        if (take(text, part)) core += part;
    }
    return take(text, "ARB") || take(text, "EXT") || take(text, "NV");
}

class FunctionRule {
  public:
    FunctionRule(Unit& unit, const TokenWalk& walk) : unit_(unit), walk_(walk) {}

    void run() {
        for (std::uint32_t i = 0; i < unit_.tokens.size(); ++i)
            if (unit_.tokens[i].kind == TokenKind::word && !unit_.tokens[i].synthetic) word(i);
        if (noise_ != 0)
            for (std::string& line : noiseFunctions(noise_)) unit_.prologue.push_back(std::move(line));
    }

  private:
    void word(std::uint32_t at) {
        const std::string_view text = unit_.tokens[at].text;
        const char first = text.front();
        if (first != 't' && first != 's' && first != 'f' && first != 'n') return;
        if (walk_.text(walk_.previous(at)) == "." || unit_.isUserName(text)) return;
        const std::uint32_t open = walk_.next(at);
        const bool called = walk_.text(open) == "(";
        if (first == 't' || first == 's') texture(at, text, called ? open : kNone);
        if (!called) return;
        if (text == "truncate") unit_.edits.replace(at, "trunc");
        if (text == "texelSize") unit_.edits.replace(at, "textureSize");
        if (text == "ftransform") ftransform(at, open);
        if (text.size() == 6 && text.starts_with("noise") && text[5] >= '1' && text[5] <= '4') {
            if (unit_.isUsed(text)) noise_ |= 1U << (text[5] - '1');
            unit_.edits.replace(at, "glibra_" + std::string(text));
        }
    }

    void texture(std::uint32_t at, std::string_view text, std::uint32_t open) {
        const TextureFunction function = textureFunction(text);
        if (function.core.empty()) return;
        const std::uint32_t close = open == kNone ? kNone : walk_.match(open);
        if (!function.shadow) {
            unit_.edits.replace(at, function.core);
        } else if (close != kNone) {
            unit_.edits.replace(at, "vec4(" + function.core);
            unit_.edits.after(close, ")");
        }
        if (function.dropsLod && close != kNone) dropSecondArgument(open, close);
    }

    void dropSecondArgument(std::uint32_t open, std::uint32_t close) {
        std::uint32_t comma = kNone;
        for (std::uint32_t i = walk_.next(open); i != kNone && i != close; i = walk_.next(i)) {
            const std::string_view text = walk_.text(i);
            if (comma == kNone && (text == "(" || text == "[") && walk_.match(i) != kNone)
                i = walk_.match(i);
            else if (comma == kNone && text == ",")
                comma = i;
            if (comma != kNone) unit_.edits.remove(i);
        }
    }

    void ftransform(std::uint32_t at, std::uint32_t open) {
        const std::uint32_t close = walk_.match(open);
        if (close == kNone || walk_.next(open) != close) return;
        unit_.edits.replace(at, "(glibra_ModelViewProjectionMatrix * glibra_Vertex)");
        unit_.edits.remove(open);
        unit_.edits.remove(close);
        if (!unit_.isUsed("ftransform") || unit_.stage != Stage::vertex) return;
        // Its two names are supplied as if the user had written them here.
        const std::uint32_t use = unit_.uses["ftransform"].front();
        unit_.uses["gl_ModelViewProjectionMatrix"].push_back(use);
        unit_.uses["gl_Vertex"].push_back(use);
        unit_.declare("invariant gl_Position;");
    }

    Unit& unit_;
    const TokenWalk& walk_;
    unsigned noise_ = 0;
};

}  // namespace

TextureFunction textureFunction(std::string_view name) {
    TextureFunction result;
    std::string_view rest = name;
    if (name == "textureQueryLOD") {
        result.core = "textureQueryLod";
        return result;
    }
    if (take(rest, "texelFetch")) {
        const std::string_view dimension = takeDimension(rest);
        std::string core = "texelFetch";
        if (take(rest, "Offset")) core += "Offset";
        if (dimension.empty() || !(rest.empty() || rest == "ARB" || rest == "EXT")) return {};
        return {core, "sampler" + std::string(dimension), false, false};
    }
    if (take(rest, "textureSize")) {
        const std::string_view dimension = takeDimension(rest);
        if (dimension.empty() || !rest.empty()) return {};
        const bool noLod = dimension == "2DRect" || dimension == "Buffer";
        return {"textureSize", "sampler" + std::string(dimension), false, noLod};
    }
    result.shadow = rest.starts_with("shadow");
    if (!take(rest, "texture") && !take(rest, "shadow")) return {};
    const std::string_view dimension = takeDimension(rest);
    result.core = "texture";
    const bool isScalar = name.ends_with("EXT") || name.ends_with("NV");  // EXT_shadow_samplers
    const bool vendor = takeVariant(rest, result.core);
    if (!rest.empty() || (dimension.empty() && (!vendor || result.shadow))) return {};
    const bool isShadow = result.shadow;
    if (isScalar) result.shadow = false;
    if (!dimension.empty()) result.sampler = "sampler" + std::string(dimension) + (isShadow ? "Shadow" : "");
    return result;
}

bool isTextureFunction(std::string_view name) {
    if (!textureFunction(name).core.empty()) return true;
    constexpr std::string_view kCore =
        " texture textureProj textureLod textureProjLod textureGrad textureProjGrad textureOffset "
        "textureProjOffset textureLodOffset textureProjLodOffset textureGradOffset textureProjGradOffset "
        "texelFetch texelFetchOffset textureSize textureGather textureGatherOffset textureGatherOffsets "
        "textureQueryLod textureQueryLevels textureSamples texelSize ";
    return listed(kCore, name);
}

void modernizeFunctions(Unit& unit, const TokenWalk& walk) {
    FunctionRule(unit, walk).run();
}

// noise1 ... noise4 as GLSL (language, 7.5): gradient noise after Perlin (2002) with integer hashes, so that
// every driver gives the same values.

std::vector<std::string> noiseFunctions(unsigned wanted) {
    std::vector<std::string> lines = {
        "uint glibra_mix(uint x) {",
        "    x ^= x >> 16; x *= 0x7feb352du; x ^= x >> 15; x *= 0x846ca68bu; x ^= x >> 16;",
        "    return x;",
        "}",
        "float glibra_cornerNoise(uint h, vec4 offset, int dimension) {",
        "    vec4 g = vec4(0.);",
        "    for (int j = 0; j < dimension; ++j)",
        "        g[j] = float(glibra_mix(h + 0x9e3779b9u * uint(j)) >> 8) / 8388608. - 1.;",
        "    float size = length(g);",
        "    return dot(size < .001 ? vec4(1., 0., 0., 0.) : g / size, offset);",
        "}",
        "float glibra_latticeNoise(vec4 p, int dimension, uint component) {",
        "    vec4 cell = floor(p);",
        "    vec4 t = p - cell;",
        "    vec4 w = t * t * t * (10. + t * (6. * t - 15.));",
        "    float sum = 0.;",
        "    for (int i = 0; i < 1 << dimension; ++i) {",
        "        ivec4 corner = ivec4(i, i >> 1, i >> 2, i >> 3) & 1;",
        "        uvec4 c = uvec4(ivec4(cell) + corner);",
        "        c *= uvec4(0x8da6b343u, 0xd8163841u, 0xcb1ab31fu, 0x165667b1u);",
        "        uint h = glibra_mix(c.x ^ c.y ^ c.z ^ c.w ^ component * 0x85ebca6bu);",
        "        vec4 s = mix(1. - w, w, vec4(corner));",
        "        sum += s.x * s.y * s.z * s.w * glibra_cornerNoise(h, t - vec4(corner), dimension);",
        "    }",
        "    return 2. / sqrt(float(dimension)) * sum;",
        "}",
    };
    static constexpr const char* kParameters[] = {"float p", "vec2 p", "vec3 p", "vec4 p"};
    static constexpr const char* kPoints[] = {"vec4(p, 0., 0., 0.)", "vec4(p, 0., 0.)", "vec4(p, 0.)", "p"};
    for (int components = 1; components <= 4; ++components) {
        if ((wanted >> (components - 1) & 1U) == 0) continue;
        const std::string type = components == 1 ? "float" : "vec" + std::to_string(components);
        for (int dimension = 1; dimension <= 4; ++dimension) {
            std::string values;
            for (int k = 0; k < components; ++k)
                values += fmt::format("{}glibra_latticeNoise({}, {}, {}u)", k == 0 ? "" : ", ",
                                      kPoints[dimension - 1], dimension, k);
            lines.push_back(fmt::format("{0} glibra_noise{1}({2}) {{ return {0}({3}); }}", type, components,
                                        kParameters[dimension - 1], values));
        }
    }
    return lines;
}

}  // namespace glibra::glsl
