#include "glsl/emit/log_phrases.h"

#include <algorithm>
#include <array>
#include <span>

#include "base/text.h"
#include "glsl/read/token.h"

namespace glibra::glsl {
namespace {

/// The text around an undeclared name. The name ends where its letters and digits end.
struct NamePhrase {
    std::string_view before;  ///< up to the name
    std::string_view after;   ///< right after it
};
constexpr std::array kUndeclaredPhrases = std::to_array<NamePhrase>({
    {"`", "' undeclared"},                         // Mesa
    {"no function with name '", "'"},              // Mesa
    {"undefined variable \"", "\""},               // NVIDIA
    {"'", "' : undeclared identifier"},            // glslang, Intel, AMD, Apple, ANGLE
    {"'", "' : no matching overloaded function"},  // the same, also for functions that nobody declares
    {"undeclared identifier '", "'"},              // Apple
    {"Undeclared identifier: ", ""},               // AMD (fglrx)
    {"Undeclared identifier '", "'"},              // Intel
    {"'", "' is not declared"},                    // Qualcomm
    {"No matching function for call to '", "'"},   // Apple, of names that are no function either
});

constexpr std::array kTypePhrases = std::to_array<std::string_view>({
    "mismatch",                      // Mesa: "type mismatch", "parameter type mismatch"
    "could not implicitly convert",  // Mesa
    "must have the same type",       // Mesa
    "cannot be assigned to",         // Mesa: "initializer of type vec3 cannot be assigned to ..."
    "incompatible types",            // NVIDIA: C1060, C1035
    "invalid operands to",           // NVIDIA: C1020
    "implicit cast from",            // NVIDIA: C7011
    "wrong operand",                 // glslang, Intel, AMD, Apple
    "no operation",                  // the same
    "cannot convert",                // the same
});

constexpr std::array kConsequencePhrases = std::to_array<std::string_view>({
    "from a non-numeric data type",                      // Mesa
    "operands to arithmetic operators must be numeric",  // Mesa
    "used uninitialized",                                // Mesa
    "(error,", "(error)", ", error,", ", error)",        // Mesa: candidates of a call with such an argument
    "compilation terminated",                            // glslang
});

constexpr std::array kSyntaxPhrases = std::to_array<std::string_view>({
    "syntax error",      // Mesa, NVIDIA, glslang, AMD, Intel
    "Syntax error",      // ANGLE, Apple
    "unexpected token",  // Apple
});

bool containsAny(std::string_view text, std::span<const std::string_view> phrases) {
    return std::ranges::any_of(
        phrases, [&](std::string_view each) { return text.find(each) != std::string_view::npos; });
}

std::string_view nameIn(std::string_view message, const NamePhrase& phrase) {
    for (std::size_t at = message.find(phrase.before); at != std::string_view::npos;
         at = message.find(phrase.before, at + 1)) {
        const std::size_t first = at + phrase.before.size();
        std::size_t end = first;
        while (end < message.size() && base::isOfName(message[end])) ++end;
        if (end > first && message.substr(end).starts_with(phrase.after))
            return message.substr(first, end - first);
    }
    return {};
}

}  // namespace

std::string_view undeclaredName(std::string_view message) {
    for (const NamePhrase& each : kUndeclaredPhrases)
        if (const std::string_view name = nameIn(message, each); !name.empty()) return name;
    return {};
}

bool isAboutTypes(std::string_view message) {
    return containsAny(message, kTypePhrases);
}

bool isConsequence(std::string_view message) {
    return containsAny(message, kConsequencePhrases);
}

bool isSyntaxError(std::string_view message) {
    return containsAny(message, kSyntaxPhrases);
}

}  // namespace glibra::glsl
