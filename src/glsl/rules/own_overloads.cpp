// GLSL ES 1.00 lets a shader overload the built-in functions (chapter 8), and GLSL hides them all behind the
// first function of their name. The shader's own overloads therefore get a name of their own.

#include <algorithm>
#include <map>
#include <vector>

#include "glsl/read/words.h"
#include "glsl/rules/rules.h"

namespace glibra::glsl {
namespace {

constexpr std::string_view kBuiltins =
    " radians degrees sin cos tan asin acos atan pow exp log exp2 log2 sqrt inversesqrt abs sign floor ceil "
    "fract "
    "mod min max clamp mix step smoothstep length distance dot cross normalize faceforward reflect refract "
    "matrixCompMult lessThan lessThanEqual greaterThan greaterThanEqual equal notEqual any all not dFdx dFdy "
    "fwidth texture2D texture2DProj texture2DLod texture2DProjLod textureCube textureCubeLod ";

using Signature = std::vector<Type>;

Signature signatureOf(const Declaration& function) {
    Signature types;
    for (const Parameter& each : function.parameters)
        types.push_back(
            arrayOf(typeOfWord(each.type.name), each.type.dimensions.size() + each.dimensions.size()));
    return types;
}

/// True if no argument is known to be of another type. There are no conversions in GLSL ES 1.00.
bool takes(const Signature& signature, const std::vector<Type>& arguments) {
    return std::ranges::equal(signature, arguments, [](const Type& wanted, const Type& given) {
        return !wanted.known() || !given.known() || wanted == given;
    });
}

void rename(Unit& unit, std::uint32_t at) {
    Token& token = unit.tokens[unit.view[at].raw];
    token.text = unit.storage.emplace_back(std::string(kOwnOverload) + std::string(token.text));
    unit.view[at].text = token.text;
}

}  // namespace

bool renameOwnOverloads(Unit& unit) {
    if (!unit.dialect.es || unit.dialect.written != 100) return false;
    std::map<std::string_view, std::vector<Signature>> own;
    std::vector<std::uint32_t> names;
    for (const Declaration& each : unit.syntax.declarations) {
        if (each.kind != DeclarationKind::function && each.kind != DeclarationKind::prototype) continue;
        if (!listed(kBuiltins, unit.text(each.name))) continue;
        own[unit.text(each.name)].push_back(signatureOf(each));
        names.push_back(each.name);
    }
    if (own.empty()) return false;
    for (const Call& each : unit.bodies.calls) {
        const auto known = own.find(unit.text(each.name));
        if (known != own.end() && unit.bodies.roles[each.name] == WordRole::global &&
            std::ranges::any_of(known->second, [&](const auto& one) { return takes(one, each.types); }))
            names.push_back(each.name);
    }
    for (const std::uint32_t each : names) rename(unit, each);
    return true;
}

}  // namespace glibra::glsl
