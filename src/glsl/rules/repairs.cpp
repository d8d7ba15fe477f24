// Repairs mistakes in declarations that real shaders contain (language, 7.10).

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>
#include <span>

#include "glsl/read/words.h"
#include "glsl/rules/rules.h"
#include "glsl/types/builtins.h"

namespace glibra::glsl {
namespace {

class Repairs {
  public:
    Repairs(Unit& unit, const TokenWalk& walk, const std::string& geometryInput, Report& report)
        : unit_(unit), walk_(walk), primitive_(geometryInput), report_(report) {}

    void run() {
        strays();
        repeatedUniforms();
        falseConstants();
        constructorConstants();
        for (Variable& each : unit_.variables) writtenInput(each);
    }

  private:
    void strays() {
        for (const Declaration& each : unit_.syntax.declarations) {
            if (each.kind != DeclarationKind::stray || !each.qualifiers.tokens.empty()) continue;
            const ViewToken& token = unit_.view[each.tokens.first];
            if (token.text != ";") continue;
            unit_.edits.remove(token.raw);
            report_.report("glsl-W09", "stray ';' removed", unit_.place(each.tokens.first));
        }
    }

    void repeatedUniforms() {
        std::map<std::string, const Variable*> first;
        for (Variable& each : unit_.variables) {
            if (each.storage != Storage::uniform || each.removed) continue;
            const auto [found, isNew] = first.emplace(each.name, &each);
            if (isNew || found->second->type != each.type || found->second->sizes() != each.sizes() ||
                each.type.empty())
                continue;
            each.removed = true;
            const Place place = unit_.place(each.nameToken);
            report_.report("glsl-W21",
                           "uniform '" + each.name + "' declared again on line " +
                               std::to_string(place.line) + ", ignored",
                           place);
        }
    }

    /// The first word of the initialiser that is not a constant, or kNone.
    [[nodiscard]] std::uint32_t variableWord(Range range) {
        for (std::uint32_t i = range.first; i < range.end; ++i) {
            if (unit_.bodies.roles[i] != WordRole::global) continue;
            const std::string_view text = unit_.text(i);
            if (const Variable* variable = unit_.variable(text)) {
                if (variable->storage != Storage::constant) return i;
            } else if (unit_.isDeclared(text)) {
                const std::uint32_t at = unit_.declared.find(text)->second;
                if (unit_.text(at + 1) != "(" && isBlockMember(text)) return i;
            } else if (findBuiltinUniform(text) || findBuiltinInput(text)) {
                return i;
            }
        }
        return kNone;
    }
    [[nodiscard]] bool isBlockMember(std::string_view name) const {
        return unit_.bodies.memberNames.contains(name);
    }

    void falseConstants() {
        for (const Variable& each : unit_.variables) {
            if (each.storage != Storage::constant || each.removed) continue;
            const Range value =
                unit_.syntax.declarations[each.declaration].declarators[each.declarator].initializer;
            if (variableWord(value) == kNone) continue;
            // All variables of one declaration share its qualifiers.
            for (Variable& other : unit_.variables)
                if (other.declaration == each.declaration) {
                    other.storage = Storage::none;
                    other.changed = true;
                }
            report_.report("glsl-W10", "'" + each.name + "' depends on a uniform, 'const' dropped",
                           unit_.place(each.nameToken));
        }
    }

    /// Removes `const` from `const vec3(1.)`, `= const vec3[2](...)` and `= const 1.`
    void constructorConstants() {
        for (std::uint32_t i = 0; i < unit_.tokens.size(); ++i) {
            if (unit_.tokens[i].text != "const") continue;
            std::uint32_t next = walk_.next(i);
            const bool inInitialiser = walk_.text(walk_.previous(i)) == "=";
            if (!inInitialiser) {
                if (next == kNone || unit_.tokens[next].kind != TokenKind::word ||
                    isQualifierWord(walk_.text(next)))
                    continue;
                next = walk_.next(next);
                while (walk_.text(next) == "[" && walk_.match(next) != kNone)
                    next = walk_.next(walk_.match(next));
                if (walk_.text(next) != "(") continue;
            }
            unit_.edits.remove(i);
            report_.report("glsl-W20", "'const' inside an initialiser dropped", unit_.placeOfToken(i));
        }
    }

    void writtenInput(Variable& input) {
        if (input.storage != Storage::input || input.removed || !unit_.isWritten(input.name) ||
            input.type.empty())
            return;
        if (input.name.starts_with("gl_")) return;
        if (unit_.stage == Stage::tessControl || unit_.stage == Stage::tessEvaluation) return;
        const std::string copy = "glibra_" + input.name;
        std::string sizes, value = input.name;
        if (unit_.stage == Stage::geometry) {
            if (input.sizes().size() != 1) return;
            const int count = verticesOfPrimitive(primitive_);
            sizes = "[" + std::to_string(count) + "]";
            value = input.type + sizes + "(";
            for (int i = 0; i < count; ++i)
                value += (i ? ", " : "") + input.name + "[" + std::to_string(i) + "]";
            value += ")";
        } else {
            for (const std::string& each : input.sizes()) sizes += "[" + each + "]";
        }
        input.after += " " + input.type + " " + copy + sizes + " = " + value + ";";
        unit_.renames[input.name] = copy;
        unit_.keptSpelling.insert(unit_.view[input.nameToken].raw);
        report_.report("glsl-W22", "input '" + input.name + "' is written to; a local copy is used",
                       unit_.place(unit_.writes.find(input.name)->second.front()));
    }

    Unit& unit_;
    const TokenWalk& walk_;
    const std::string& primitive_;  ///< the input primitive of a geometry stage
    Report& report_;
};

}  // namespace

void repairDeclarations(Unit& unit, const TokenWalk& walk, const std::string& geometryInput, Report& report) {
    Repairs(unit, walk, geometryInput, report).run();
}

// Writes the conversions of arguments of built-in functions: a scalar that is widened where the function
// wants a vector, glsl-W23 (language, 7.10), and implicit conversions, because drivers disagree about which
// overload fits an int among floats (GLSL 4.50, 4.1.10 and 6.1).

namespace {

/// The arguments that may be scalars while others are vectors, as bits.
struct Function {
    std::string_view name;
    std::size_t arguments;
    unsigned scalars;  ///< the set that is allowed, in addition to the empty one
};
constexpr std::array kFunctions = std::to_array<Function>({
    {"pow", 2, 0},
    {"mod", 2, 2},
    {"min", 2, 2},
    {"max", 2, 2},
    {"step", 2, 1},
    {"smoothstep", 3, 3},
    {"clamp", 3, 6},
    {"mix", 3, 4},
});

/// The vector size to widen to, and the arguments that are scalars, as bits; nothing if the call is correct
/// or not certain.
struct Widening {
    int size = 0;
    unsigned scalars = 0;
};
std::optional<Widening> wideningOf(const Function& function, const Call& call) {
    if (call.types.size() != function.arguments) return std::nullopt;
    Widening result;
    for (std::size_t i = 0; i < call.types.size(); ++i) {
        const Type& type = call.types[i];
        if (type.base != BaseType::floating && !type.integral()) return std::nullopt;
        if (type.scalar()) {
            result.scalars |= 1U << i;
        } else if (!type.vector() || type.base != BaseType::floating ||
                   (result.size && result.size != type.rows)) {
            return std::nullopt;
        } else {
            result.size = type.rows;
        }
    }
    if (result.size == 0 || result.scalars == function.scalars) result.scalars = 0;
    return result;
}

/// Functions that take floating-point numbers only, with the arguments that are converted, as bits; bit i
/// stands for argument i.
constexpr std::string_view kFloatOnly =
    " radians degrees sin cos tan asin acos atan sinh cosh tanh asinh acosh atanh pow exp log exp2 log2 sqrt "
    "inversesqrt floor trunc truncate round roundEven ceil fract mod mix step smoothstep length distance dot "
    "cross normalize faceforward reflect refract dFdx dFdy fwidth dFdxFine dFdyFine fwidthFine dFdxCoarse "
    "dFdyCoarse fwidthCoarse fma isnan isinf ";
/// Functions that exist for floats, ints and unsigned ints; all arguments have one of these types.
constexpr std::string_view kForAll = " min max clamp ";
/// Functions that exist for floats and ints, but not for unsigned ints.
constexpr std::string_view kForSigned = " abs sign ";

/// The type that the integers among the arguments are implicitly converted to; unknown: to none.
BaseType conversionOf(std::string_view function, std::span<const Type> types) {
    bool hasFloat = false, hasDouble = false, hasInt = false, hasUnsigned = false;
    for (const Type& each : types) {
        if (!each.scalar() && !each.vector()) return BaseType::unknown;
        hasFloat = hasFloat || each.base == BaseType::floating;
        hasDouble = hasDouble || each.base == BaseType::doublePrecision;
        hasInt = hasInt || each.base == BaseType::integer;
        hasUnsigned = hasUnsigned || each.base == BaseType::unsignedInteger;
        // mix(a, b, bool) takes all types; a and b get the same one.
        if (each.base == BaseType::boolean && (function != "mix" || &each != &types.back()))
            return BaseType::unknown;
    }
    const bool isSelection = types.back().base == BaseType::boolean;
    const bool isFloatOnly =
        (listed(kFloatOnly, function) && !isSelection) || (listed(kForSigned, function) && hasUnsigned);
    if (!isFloatOnly && !isSelection && !listed(kForAll, function)) return BaseType::unknown;
    if (hasDouble) return BaseType::doublePrecision;
    if (hasFloat || isFloatOnly) return BaseType::floating;
    return hasInt && hasUnsigned ? BaseType::unsignedInteger : BaseType::unknown;
}

class Widener {
  public:
    Widener(Unit& unit, Report& report) : unit_(unit), report_(report) {}

    void run() {
        for (const Call& call : unit_.bodies.calls) {
            const std::string_view name = unit_.text(call.name);
            const auto* const function =
                std::ranges::find_if(kFunctions, [&](const Function& each) { return each.name == name; });
            const bool isWidened = function != kFunctions.end();
            const bool isConverted =
                listed(kFloatOnly, name) || listed(kForAll, name) || listed(kForSigned, name);
            if (unit_.isDeclared(name) || call.types.empty() || !(isWidened || isConverted)) continue;
            const auto widening = isWidened ? wideningOf(*function, call) : std::nullopt;
            change(call, widening.value_or(Widening{}), conversionOf(name, call.types));
        }
    }

  private:
    /// Inner calls are recorded before the calls around them, so brackets nest.
    void change(const Call& call, const Widening& widening, BaseType base) {
        const std::string type = "vec" + std::to_string(widening.size);
        std::string shape;
        for (const Type& each : call.types) shape += (shape.empty() ? "" : ", ") + wordOf(each);
        for (std::size_t i = 0; i < call.arguments.size(); ++i) {
            const Range argument = call.arguments[i];
            if (argument.empty()) continue;
            Type own = call.types[i];
            if ((widening.scalars >> i & 1U) != 0) {
                unit_.convert(argument, type);
                report_.reportOnce(
                    unit_.path + std::to_string(call.name), "glsl-W23",
                    fmt::format("{}({}): the scalar is widened to {}", unit_.text(call.name), shape, type),
                    unit_.place(call.name));
            } else if (base != BaseType::unknown && own.integral() && own.base != base) {
                own.base = base;  // what GLSL does itself
                unit_.convert(argument, wordOf(own));
            }
        }
    }

    Unit& unit_;
    Report& report_;
};

}  // namespace

void widenScalars(Unit& unit, Report& report) {
    Widener(unit, report).run();
}

}  // namespace glibra::glsl
