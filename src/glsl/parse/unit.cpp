#include "glsl/parse/unit.h"

#include <algorithm>

namespace glibra::glsl {

bool Unit::isUserName(std::string_view name) const {
    return isDeclared(name) || macros.find(name) != macros.end() ||
           bodies.localNames.find(name) != bodies.localNames.end();
}

void Unit::declare(const std::string& line) {
    if (std::find(prologue.begin(), prologue.end(), line) == prologue.end()) prologue.push_back(line);
}

Variable* Unit::variable(std::string_view name) {
    const auto found = std::find_if(variables.begin(), variables.end(),
                                    [&](const Variable& each) { return each.name == name && !each.removed; });
    return found == variables.end() ? nullptr : &*found;
}

const Declaration* Unit::function(std::string_view name) const {
    const auto found =
        std::find_if(syntax.declarations.begin(), syntax.declarations.end(), [&](const Declaration& each) {
            return each.kind == DeclarationKind::function && text(each.name) == name;
        });
    return found == syntax.declarations.end() ? nullptr : &*found;
}

Unit* ProgramUnits::find(Stage stage) {
    const auto found =
        std::find_if(units.begin(), units.end(), [&](const Unit& each) { return each.stage == stage; });
    return found == units.end() ? nullptr : &*found;
}

Unit* ProgramUnits::before(Stage stage) {
    Unit* last = nullptr;
    for (Unit& each : units)
        if (each.stage < stage) last = &each;
    return last;
}

Unit* ProgramUnits::lastBeforeRaster() {
    return before(Stage::fragment);
}

std::string shortPlace(const Place& place) {
    const std::size_t slash = place.file.find_last_of("/\\");
    return (slash == std::string::npos ? place.file : place.file.substr(slash + 1)) + ":" +
           std::to_string(place.line);
}

std::string textOf(const Unit& unit, Range range) {
    std::string text;
    for (std::uint32_t i = range.first; i < range.end && i < unit.view.size(); ++i) {
        const auto wordLike = [](TokenKind kind) {
            return kind == TokenKind::word || kind == TokenKind::number;
        };
        if (i > range.first && wordLike(unit.view[i].kind) && wordLike(unit.view[i - 1].kind)) text += ' ';
        text += unit.view[i].text;
    }
    return text;
}

}  // namespace glibra::glsl
