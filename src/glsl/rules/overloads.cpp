// Calls of the user's own functions that fit several overloads, or fit one by a conversion. Drivers choose
// differently, so the choice is made here by the rules of GLSL 4.60, 6.1.1, and written into the call.

#include <algorithm>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "glsl/parse/types.h"
#include "glsl/read/words.h"
#include "glsl/rules/rules.h"

namespace glibra::glsl {
namespace {

/// How well an argument fits a parameter. Only some conversions are better than others.
enum class Fit { none, exact, floatToDouble, integerToFloat, integerToDouble, integerToUnsigned };

Fit fitOf(const Type& from, const Type& to) {
    if (from == to) return Fit::exact;
    if (from.columns != to.columns || from.rows != to.rows || from.arrayDepth != to.arrayDepth)
        return Fit::none;
    if (from.base == BaseType::floating && to.base == BaseType::doublePrecision) return Fit::floatToDouble;
    if (!from.integral()) return Fit::none;
    if (to.base == BaseType::floating) return Fit::integerToFloat;
    if (to.base == BaseType::doublePrecision) return Fit::integerToDouble;
    const bool isToUnsigned = from.base == BaseType::integer && to.base == BaseType::unsignedInteger;
    return isToUnsigned ? Fit::integerToUnsigned : Fit::none;
}

bool isBetter(Fit a, Fit b) {
    if (a == b) return false;
    if (a == Fit::exact) return true;
    if (b == Fit::exact) return false;
    return a == Fit::floatToDouble || (a == Fit::integerToFloat && b == Fit::integerToDouble);
}

struct Overload {
    const Declaration* declaration = nullptr;
    std::vector<Type> types;
    std::vector<Fit> fits{};

    [[nodiscard]] bool operator==(const Overload& other) const { return types == other.types; }
};

/// True if one argument fits better and none worse.
bool isBetter(const Overload& a, const Overload& b) {
    bool anyBetter = false;
    for (std::size_t i = 0; i < a.fits.size(); ++i) {
        if (isBetter(b.fits[i], a.fits[i])) return false;
        anyBetter = anyBetter || isBetter(a.fits[i], b.fits[i]);
    }
    return anyBetter;
}

class OverloadChoice {
  public:
    OverloadChoice(Unit& unit, Report& report) : unit_(unit), report_(report) {
        for (const Declaration& each : unit.syntax.declarations)
            if (each.kind == DeclarationKind::function || each.kind == DeclarationKind::prototype) add(each);
    }

    void run() {
        for (const Call& each : unit_.bodies.calls)
            if (unit_.bodies.roles[each.name] == WordRole::global) choose(each);
    }

  private:
    void add(const Declaration& declaration) {
        Overload overload{&declaration, {}};
        for (const Parameter& each : declaration.parameters)
            overload.types.push_back(
                arrayOf(typeOfWord(each.type.name), each.type.dimensions.size() + each.dimensions.size()));
        std::vector<Overload>& known = functions_[unit_.text(declaration.name)];
        if (std::ranges::find(known, overload) == known.end()) known.push_back(std::move(overload));
    }

    static Storage storageOf(const Overload& overload, std::size_t argument) {
        return overload.declaration->parameters[argument].qualifiers.storage;
    }

    /// How the arguments fit; false if one does not.
    static bool fit(Overload& overload, const std::vector<Type>& types) {
        for (std::size_t i = 0; i < types.size(); ++i) {
            const Storage storage = storageOf(overload, i);
            Fit found = Fit::none;
            if (storage == Storage::output)
                found = fitOf(overload.types[i], types[i]);
            else if (storage != Storage::inputOutput || overload.types[i] == types[i])
                found = fitOf(types[i], overload.types[i]);
            if (found == Fit::none) return false;
            overload.fits.push_back(found);
        }
        return true;
    }

    void choose(const Call& call) {
        const auto known = functions_.find(unit_.text(call.name));
        if (known == functions_.end()) return;
        const auto isNumeric = [](const Type& each) { return each.numeric(); };
        if (!std::ranges::all_of(call.types, isNumeric)) return;
        std::vector<Overload> all, fitting;
        for (const Overload& each : known->second)
            if (each.types.size() == call.types.size()) all.push_back(each);
        if (all.size() < 2) return;
        for (Overload& each : all) {
            // A structure, or a type that is not known here, does not fit a number.
            const bool isKnown =
                std::ranges::all_of(each.types, [](const Type& type) { return type.known(); });
            if (isKnown && fit(each, call.types)) fitting.push_back(each);
        }
        if (fitting.empty()) return;
        const auto best = std::ranges::find_if(fitting, [&](const Overload& each) {
            return std::ranges::all_of(
                fitting, [&](const Overload& other) { return &other == &each || isBetter(each, other); });
        });
        if (best == fitting.end()) return ambiguous(call, fitting);
        for (std::size_t i = 0; i < call.arguments.size(); ++i) {
            if (best->fits[i] == Fit::exact || storageOf(*best, i) == Storage::output) continue;
            unit_.convert(call.arguments[i], wordOf(best->types[i]));
        }
    }

    static std::string listOf(std::string_view name, const std::vector<Type>& types) {
        std::string text(name);
        text += "(";
        for (std::size_t i = 0; i < types.size(); ++i) text += (i ? ", " : "") + wordOf(types[i]);
        return text + ")";
    }

    void ambiguous(const Call& call, const std::vector<Overload>& fitting) {
        const std::string_view name = unit_.text(call.name);
        // The first two of which neither is better
        for (std::size_t i = 0; i < fitting.size(); ++i)
            for (std::size_t k = i + 1; k < fitting.size(); ++k) {
                if (isBetter(fitting[i], fitting[k]) || isBetter(fitting[k], fitting[i])) continue;
                report_.report("glsl-E17",
                               "the call " + listOf(name, call.types) + " is ambiguous: '" +
                                   listOf(name, fitting[i].types) + "' and '" +
                                   listOf(name, fitting[k].types) + "' fit; convert an argument",
                               unit_.place(call.name));
                return;
            }
    }

    Unit& unit_;
    Report& report_;
    std::map<std::string_view, std::vector<Overload>> functions_;
};

}  // namespace

void chooseOverloads(Unit& unit, Report& report) {
    OverloadChoice(unit, report).run();
}

// GLSL ES 1.00 lets a shader overload the built-in functions (chapter 8), and GLSL hides them all behind the
// first function of their name. The shader's own overloads therefore get a name of their own.

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
