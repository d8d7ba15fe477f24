// Writes the conversions of arguments of built-in functions: a scalar that is widened where the function
// wants a vector, glsl-W23 (language, 7.10), and implicit conversions, because drivers disagree about which
// overload fits an int among floats (GLSL 4.50, 4.1.10 and 6.1).

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <span>

#include "glsl/read/words.h"
#include "glsl/rules/rules.h"

namespace glibra::glsl {
namespace {

/// The arguments that may be scalars while others are vectors, as bits, for each overload of a function.
struct Function {
    std::string_view name;
    std::size_t arguments;
    std::array<unsigned, 2> scalars;  ///< the allowed sets, in addition to the empty set
};
constexpr std::array kFunctions = std::to_array<Function>({
    {"pow", 2, {0, 0}},
    {"mod", 2, {2, 2}},
    {"min", 2, {2, 2}},
    {"max", 2, {2, 2}},
    {"step", 2, {1, 1}},
    {"smoothstep", 3, {3, 3}},
    {"clamp", 3, {6, 6}},
    {"mix", 3, {4, 4}},
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
    const bool inOrder = result.size == 0 || result.scalars == 0 || result.scalars == function.scalars[0] ||
                         result.scalars == function.scalars[1];
    if (inOrder) result.scalars = 0;
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
                std::find_if(kFunctions.begin(), kFunctions.end(),
                             [&](const Function& each) { return each.name == name; });
            const bool isWidened = function != kFunctions.end();
            const bool isConverted =
                listed(kFloatOnly, name) || listed(kForAll, name) || listed(kForSigned, name);
            if (unit_.isDeclared(name) || call.types.empty() || !(isWidened || isConverted)) continue;
            const auto widening = isWidened ? wideningOf(*function, call) : std::optional(Widening{});
            if (widening)
                decide(call, *widening, conversionOf(name, call.types));
            else if (const BaseType base = conversionOf(name, call.types); base != BaseType::unknown)
                decide(call, Widening{}, base);
            else
                cannotTell(call);
        }
        apply();
    }

  private:
    using Span = std::pair<std::uint32_t, std::uint32_t>;
    struct Wish {
        std::string type;  ///< empty: no change
        bool conflicting = false;
        std::string text;
        std::uint32_t place = 0;
        std::size_t order = 0;
    };

    /// The first and the last token of an argument, if the argument can be put in brackets.
    [[nodiscard]] std::optional<Span> spanOf(Range range) const {
        if (range.empty()) return std::nullopt;
        const ViewToken& first = unit_.view[range.first];
        const ViewToken& last = unit_.view[range.end - 1];
        if (first.body != last.body) return std::nullopt;
        if (!first.body) return Span{first.raw, last.raw};
        if (first.objectSite && first.site == last.site && wholeMacro(range))
            return Span{first.site, first.site};
        // If both are in the body of the same macro, all uses of it have to agree.
        for (std::uint32_t i = first.raw; i <= last.raw && i < unit_.tokens.size(); ++i)
            if (unit_.tokens[i].kind == TokenKind::newline) return std::nullopt;
        return first.raw <= last.raw ? std::optional(Span{first.raw, last.raw}) : std::nullopt;
    }
    [[nodiscard]] bool wholeMacro(Range range) const {
        const std::uint32_t site = unit_.view[range.first].site;
        const auto outside = [&](std::uint32_t at) {
            return at >= unit_.view.size() || unit_.view[at].site != site;
        };
        return outside(range.first - 1) && outside(range.end);
    }

    void cannotTell(const Call& call) {
        for (const Range& each : call.arguments)
            if (const auto span = spanOf(each); span && unit_.view[each.first].body)
                wishes_[*span].conflicting = true;
    }

    void decide(const Call& call, const Widening& widening, BaseType base) {
        const std::string type = "vec" + std::to_string(widening.size);
        std::string shape;
        for (const Type& each : call.types) shape += (shape.empty() ? "" : ", ") + wordOf(each);
        for (std::size_t i = 0; i < call.arguments.size(); ++i) {
            const auto span = spanOf(call.arguments[i]);
            if (!span) continue;
            const bool isWidened = (widening.scalars >> i & 1U) != 0;
            std::string wanted = isWidened ? type : std::string{};
            const Type& own = call.types[i];
            if (!isWidened && base != BaseType::unknown && own.integral() && own.base != base) {
                Type converted = own;
                converted.base = base;
                wanted = wordOf(converted);
            }
            const auto [found, isNew] =
                wishes_.emplace(*span, Wish{wanted, false, {}, call.name, wishes_.size()});
            if (!isNew && found->second.type != wanted) found->second.conflicting = true;
            if (isNew && isWidened)
                found->second.text =
                    fmt::format("{}({}): the scalar is widened to {}", unit_.text(call.name), shape, type);
        }
    }

    void apply() {
        // Inner calls are recorded before the calls around them, so brackets nest in this order.
        std::vector<std::pair<Span, const Wish*>> ordered;
        for (const auto& [span, wish] : wishes_)
            if (!wish.type.empty() && !wish.conflicting) ordered.emplace_back(span, &wish);
        std::sort(ordered.begin(), ordered.end(),
                  [](const auto& a, const auto& b) { return a.second->order < b.second->order; });
        for (const auto& [span, wish] : ordered) {
            unit_.edits.before(span.first, wish->type + "(");
            unit_.edits.after(span.second, ")");
            if (wish->text.empty()) continue;  // what GLSL does itself
            const Place place = unit_.place(wish->place);
            report_.reportOnce(unit_.path + std::to_string(wish->place), "glsl-W23", wish->text, place);
        }
    }

    Unit& unit_;
    Report& report_;
    std::map<Span, Wish> wishes_;
};

}  // namespace

void widenScalars(Unit& unit, Report& report) {
    Widener(unit, report).run();
}

}  // namespace glibra::glsl
