#include "glsl/es/borders.h"

#include <array>
#include <string>
#include <string_view>

namespace glibra::glsl {
namespace {

/// Of the texels that are read one is outside.
constexpr const char* kNear =
    "bool glibra_isNear(vec4 border, vec2 size, vec2 at) { "
    "vec2 first = floor(at * size - .5 * border.w), last = first + border.w; "
    "return border.x > 0. && (first.x < 0. || last.x >= size.x) || "
    "border.y > 0. && (first.y < 0. || last.y >= size.y); }";
constexpr const char* kOutside =
    "bool glibra_isOutside(vec4 border, ivec2 size, ivec2 at) { "
    "return border.x > 0. && (at.x < 0 || at.x >= size.x) || border.y > 0. && (at.y < 0 || at.y >= size.y); "
    "}";

constexpr const char* kColor =
    "vec4 glibra_texel(vec4 b[2], sampler2D s, ivec2 at) { ivec2 size = textureSize(s, 0); "
    "return glibra_isOutside(b[0], size, at) ? b[1] : texelFetch(s, clamp(at, ivec2(0), size - 1), 0); }";
constexpr const char* kColorNear =
    "vec4 glibra_near(vec4 b[2], sampler2D s, vec2 p) { "
    "vec2 at = p * vec2(textureSize(s, 0)) - .5 * b[0].w, f = at - floor(at); ivec2 i = ivec2(floor(at)); "
    "if (b[0].w == 0.) return glibra_texel(b, s, i); "
    "return mix(mix(glibra_texel(b, s, i), glibra_texel(b, s, i + ivec2(1, 0)), f.x), "
    "mix(glibra_texel(b, s, i + ivec2(0, 1)), glibra_texel(b, s, i + 1), f.x), f.y); }";
constexpr const char* kDepth =
    "float glibra_texel(vec4 b[2], sampler2DShadow s, ivec2 at, float d) { ivec2 size = textureSize(s, 0); "
    "if (glibra_isOutside(b[0], size, at)) return float(b[0].z > 0. ? d <= b[1].x : d >= b[1].x); "
    "return textureLod(s, vec3((vec2(clamp(at, ivec2(0), size - 1)) + .5) / vec2(size), d), 0.); }";
constexpr const char* kDepthNear =
    "float glibra_near(vec4 b[2], sampler2DShadow s, vec3 p) { "
    "vec2 at = p.xy * vec2(textureSize(s, 0)) - .5 * b[0].w, f = at - floor(at); ivec2 i = ivec2(floor(at)); "
    "if (b[0].w == 0.) return glibra_texel(b, s, i, p.z); "
    "return mix(mix(glibra_texel(b, s, i, p.z), glibra_texel(b, s, i + ivec2(1, 0), p.z), f.x), "
    "mix(glibra_texel(b, s, i + ivec2(0, 1), p.z), glibra_texel(b, s, i + 1, p.z), f.x), f.y); }";

/// A function that reads.
struct Reader {
    std::string_view name, sampler, coordinates;
    std::string_view place;  ///< of the coordinates in the texture, by which glibra_near() is called
    bool takesNumber;        ///< a level or a bias after them
};
constexpr std::array kReaders = std::to_array<Reader>({
    {"texture", "sampler2D", "vec2", "p", false},
    {"texture", "sampler2D", "vec2", "p", true},
    {"textureLod", "sampler2D", "vec2", "p", true},
    {"textureProj", "sampler2D", "vec3", "p.xy / p.z", false},
    {"textureProj", "sampler2D", "vec4", "p.xy / p.w", false},
    {"texture", "sampler2DShadow", "vec3", "p", false},
    {"textureLod", "sampler2DShadow", "vec3", "p", true},
    {"textureProj", "sampler2DShadow", "vec4", "p.xyz / p.w", false},
});

std::string text(const Reader& reader) {
    const std::string value(reader.sampler == "sampler2D" ? "vec4 " : "float ");
    const std::string name(reader.name), place(reader.place);
    return value + "glibra_" + name + "(vec4 b[2], " + std::string(reader.sampler) + " s, " +
           std::string(reader.coordinates) + " p" + (reader.takesNumber ? ", float n" : "") + ") { " + value +
           "v = " + name + "(s, p" + (reader.takesNumber ? ", n" : "") + "); vec2 at = (" + place +
           ").xy; return glibra_isNear(b[0], vec2(textureSize(s, 0)), at) ? glibra_near(b, s, " + place +
           ") : v; }";
}

bool hasBorder(std::string_view type) {
    return type == "sampler2D" || type == "sampler2DShadow";
}

/// Declares what the border of a sampler is if that is a uniform; the border of a parameter is a parameter.
std::string borderOf(Unit& unit, Range argument) {
    constexpr const char* kNone = "vec4[2](vec4(0.), vec4(0.))";
    if (argument.end != argument.first + 1) return kNone;
    const std::string name(unit.text(argument.first));
    const bool isGlobal = unit.bodies.roles[argument.first] == WordRole::global;
    const Variable* const variable = isGlobal ? unit.firstVariable(name) : nullptr;
    if (variable != nullptr) unit.declare("uniform vec4 " + (kBorderOf + name) + "[2];");
    return isGlobal && variable == nullptr ? kNone : kBorderOf + name;
}

/// A call of a function of GLSL.
void readBorder(Unit& unit, const Call& call) {
    if (call.types.empty() || call.arguments.empty()) return;
    const std::string_view sampler = call.types.front().word, name = unit.text(call.name);
    if (!hasBorder(sampler) || (name != "texture" && name != "textureLod" && name != "textureProj")) return;
    const Range first = call.arguments.front();
    unit.declare(kNear);
    unit.declare(kOutside);
    const bool isColor = sampler == "sampler2D";
    unit.declare(isColor ? kColor : kDepth);
    unit.declare(isColor ? kColorNear : kDepthNear);
    for (const Reader& each : kReaders)
        if (each.name == name && each.sampler == sampler &&
            (unit.stage == Stage::fragment || name != "texture" || !each.takesNumber))
            unit.declare(text(each));
    unit.edits.replace(unit.view[call.name].raw, "glibra_" + std::string(name));
    unit.edits.before(unit.view[first.first].raw, borderOf(unit, first) + ", ");
}

}  // namespace

void passBorders(Unit& unit) {
    for (const Declaration& each : unit.syntax.declarations)
        for (const Parameter& parameter : each.parameters)
            if (hasBorder(parameter.type.name))
                unit.edits.before(
                    unit.view[parameter.qualifiers.tokens.empty() ? parameter.type.tokens.first
                                                                  : parameter.qualifiers.tokens.first]
                        .raw,
                    "vec4 " +
                        (parameter.name == kNone ? std::string()
                                                 : kBorderOf + std::string(unit.text(parameter.name))) +
                        "[2], ");
    for (const Call& each : unit.bodies.calls) {
        const std::string_view name = unit.text(each.name);
        if (unit.function(name) == nullptr) {
            readBorder(unit, each);
            continue;
        }
        for (std::size_t i = 0; i < each.arguments.size() && i < each.types.size(); ++i)
            if (hasBorder(each.types[i].word))
                unit.edits.before(unit.view[each.arguments[i].first].raw,
                                  borderOf(unit, each.arguments[i]) + ", ");
    }
}

}  // namespace glibra::glsl
