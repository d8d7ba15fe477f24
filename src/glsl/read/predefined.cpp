#include "glsl/read/predefined.h"

#include "glsl/read/extensions.h"

namespace glibra::glsl {
namespace {

constexpr int kFirstWithProfiles = 150;
constexpr int kFirstWithPrecision = 130;

bool isDefined(std::string_view name, const Dialect& dialect, const Target& target) {
    if (name == "GL_ES") return dialect.es;
    if (name == "GL_FRAGMENT_PRECISION_HIGH") return dialect.es || dialect.version >= kFirstWithPrecision;
    const bool hasProfiles = !dialect.es && dialect.version >= kFirstWithProfiles;
    if (name == "GL_core_profile") return hasProfiles;
    if (name == "GL_compatibility_profile") return hasProfiles && !dialect.core;
    return isInCore(name, target.version) || (target.hasExtension && target.hasExtension(name));
}

}  // namespace

std::optional<std::string> predefinedMacro(std::string_view name, const Dialect& dialect,
                                           const Target& target) {
    if (name == "__VERSION__") return std::to_string(dialect.written);
    if (name.starts_with("GL_") && isDefined(name, dialect, target)) return "1";
    return std::nullopt;
}

bool isPlaceMacro(std::string_view name) {
    return name == "__LINE__" || name == "__FILE__";
}

bool isReservedMacro(std::string_view name) {
    return isPlaceMacro(name) || name == "__VERSION__" || name.starts_with("GL_");
}

}  // namespace glibra::glsl
