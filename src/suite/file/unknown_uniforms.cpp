#include "suite/file/unknown_uniforms.h"

#include <algorithm>
#include <string_view>

namespace glibra::suite {
namespace {

/// "uKd" of "Dots:uKd".
std::string_view withoutProgram(std::string_view name) {
    const std::size_t colon = name.rfind(':');
    return colon == std::string_view::npos ? name : name.substr(colon + 1);
}

}  // namespace

void reportUnknownUniforms(const Shot& shot, Diagnostics& diagnostics) {
    for (Diagnostic& each : diagnostics) {
        // A pair in the scene has its own place there.
        if (each.id != "glib-W23" || !each.place.file.empty()) continue;
        const auto isAbout = [&](const PlacedUniform& uniform) {
            return each.subject == withoutProgram(uniform.name);
        };
        const auto found = std::ranges::find_if(shot.ownUniforms, isAbout);
        if (found != shot.ownUniforms.end()) each = diagnose("suite-E19", each.text, found->place);
    }
}

}  // namespace glibra::suite
