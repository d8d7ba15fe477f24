#include "glsl/parse/straight_line.h"

namespace glibra::glsl {

std::optional<Range> bodyOfMain(const Unit& unit) {
    const Declaration* main = nullptr;
    for (const Declaration& each : unit.syntax.declarations) {
        if (each.kind != DeclarationKind::function || unit.text(each.name) != "main") continue;
        if (main != nullptr) return std::nullopt;
        main = &each;
    }
    return main != nullptr ? std::optional(main->body) : std::nullopt;
}

bool isAlwaysExecuted(const Unit& unit, Range body, std::uint32_t at) {
    if (!body.contains(at) || at == 0) return false;
    const std::string_view before = unit.text(at - 1);
    if (before != "{" && before != "}" && before != ";") return false;
    int depth = 0;
    for (std::uint32_t i = body.first; i < at; ++i) {
        const std::string_view text = unit.text(i);
        if (text == "return") return false;
        depth += text == "{" ? 1 : text == "}" ? -1 : 0;
    }
    return depth == 1;
}

bool isLiteralOne(std::string_view number) {
    return number == "1" || number == "1." || number == "1.0" || number == "1.f" || number == "1.0f";
}

}  // namespace glibra::glsl
