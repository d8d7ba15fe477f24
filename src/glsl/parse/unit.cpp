#include "glsl/parse/unit.h"

#include <algorithm>

namespace glibra::glsl {

bool Unit::isUserName(std::string_view name) const {
    return isDeclared(name) || macros.contains(name) || bodies.localNames.contains(name);
}

void Unit::declare(const std::string& line) {
    if (std::ranges::find(prologue, line) == prologue.end()) prologue.push_back(line);
}

void Unit::remove(Range range) {
    for (std::uint32_t i = range.first; i < range.end; ++i) edits.remove(view[i].raw);
}

void Unit::convert(Range range, const std::string& type) {
    edits.before(view[range.first].raw, type + "(");
    edits.after(view[range.end - 1].raw, ")");
}

bool Unit::hasAny(Range range, std::initializer_list<std::string_view> words) const {
    for (std::uint32_t i = range.first; i < range.end; ++i)
        if (std::ranges::find(words, text(i)) != words.end()) return true;
    return false;
}

Variable* Unit::variable(std::string_view name) {
    const auto found = std::ranges::find_if(
        variables, [&](const Variable& each) { return each.name == name && !each.removed; });
    return found == variables.end() ? nullptr : &*found;
}

const Variable* Unit::firstVariable(std::string_view name) const {
    const auto found = std::ranges::find(variables, name, &Variable::name);
    return found == variables.end() ? nullptr : &*found;
}

const Declaration* Unit::function(std::string_view name) const {
    const auto found = std::ranges::find_if(syntax.declarations, [&](const Declaration& each) {
        return each.kind == DeclarationKind::function && text(each.name) == name;
    });
    return found == syntax.declarations.end() ? nullptr : &*found;
}

const LocalVariable* Unit::onlyLocal(std::string_view name) const {
    const LocalVariable* found = nullptr;
    for (const LocalVariable& each : bodies.locals) {
        if (text(each.name) != name) continue;
        if (found != nullptr) return nullptr;
        found = &each;
    }
    return found;
}

Unit* ProgramUnits::find(Stage stage) {
    const auto found = std::ranges::find(units, stage, &Unit::stage);
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
    return fileName(place.file) + ":" + std::to_string(place.line);
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
