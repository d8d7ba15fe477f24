#include "render/consequences.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <set>
#include <string>
#include <string_view>
#include <tuple>

namespace glibra::render {
namespace {

// What stands for a class of messages in place of an id.
constexpr std::string_view kError = "any error";
constexpr std::string_view kScriptError = "any error of a statement, an expression or a file";

/// Which of the messages with the second id follow from one with the first.
enum class Link { anywhere, sameSubject, sameLine, ofMisspelling };

struct Consequence {
    std::string_view cause;  ///< an id, kError or kScriptError
    std::string_view id;     ///< what follows from it
    Link link = Link::anywhere;
};

constexpr std::array kConsequences{
    // A sampler that is not set reads unit 0. That this unit is empty too is not a second mistake.
    Consequence{"glib-W37", "draw-W02", Link::sameSubject},
    // A compiler removes what is computed from an input that no stage writes.
    Consequence{"glsl-W11", "glib-W24", Link::ofMisspelling},
    // What nothing writes may be the work of a program that does not compile, or of a dispatch that the
    // driver cannot do.
    Consequence{kError, "draw-W11"},
    Consequence{kError, "draw-W13"},
    Consequence{"memory-E03", "memory-W05"},
    // What the scene lacks is often what a faulty statement would have given.
    Consequence{kScriptError, "glib-W23"},
    Consequence{kScriptError, "glib-W37"},
    Consequence{kScriptError, "glib-W38"},
    Consequence{kScriptError, "glib-W39"},
    Consequence{kScriptError, "draw-N04"},
    Consequence{kScriptError, "draw-W01"},
    Consequence{kScriptError, "draw-W02"},
    Consequence{kScriptError, "draw-W16"},
    Consequence{kScriptError, "memory-E02"},
    // Commas of an expression without parentheses.
    Consequence{kScriptError, "glib-W03", Link::sameLine},
    // A driver without compute shaders is reported where the scene needs one, not for each of its programs.
    Consequence{"memory-E01", "glsl-E12"},
};

bool isOf(const Diagnostic& message, std::string_view cause) {
    if (cause == kError) return message.severity == Severity::error;
    if (cause == kScriptError)
        return message.id.starts_with("glib-E") || message.id.starts_with("expr-E") ||
               message.id.starts_with("file-E");
    return message.id == cause;
}

bool follows(const Diagnostic& message, const Diagnostic& cause, Link link) {
    switch (link) {
        case Link::anywhere:
            break;
        case Link::sameSubject:
            return !cause.subject.empty() && message.subject == cause.subject;
        case Link::sameLine:
            return message.place.file == cause.place.file && message.place.line == cause.place.line;
        case Link::ofMisspelling:
            return !cause.suggestion.empty();
    }
    return true;
}

void removeConsequences(Diagnostics& diagnostics) {
    for (const Consequence& rule : kConsequences) {
        // A warning that is an error by now has been shown.
        const auto isRuled = [&](const Diagnostic& each) {
            return each.id == rule.id && each.severity == severityOf(each.id);
        };
        if (std::ranges::none_of(diagnostics, isRuled)) continue;
        Diagnostics causes;
        std::ranges::copy_if(diagnostics, std::back_inserter(causes),
                             [&](const Diagnostic& each) { return isOf(each, rule.cause); });
        std::erase_if(diagnostics, [&](const Diagnostic& each) {
            return isRuled(each) && std::ranges::any_of(causes, [&](const Diagnostic& cause) {
                       return follows(each, cause, rule.link);
                   });
        });
    }
}

/// The parser and the plan may both report a mistake. The first of equal ids at one place is kept.
void removeRepeats(Diagnostics& diagnostics) {
    std::set<std::tuple<std::string, std::string, int, int, std::string>> seen;
    std::erase_if(diagnostics, [&](const Diagnostic& each) {
        const bool byPlace = each.id == "glib-W15" && !each.place.file.empty();
        return !seen.emplace(each.id, each.place.file, each.place.line, each.place.column,
                             byPlace ? "" : each.text)
                    .second;
    });
}

/// A name without a near one may be left over from another program, which does no harm.
bool isMisspelling(const Diagnostic& each) {
    constexpr std::array<std::string_view, 3> kNames{"glib-W23", "draw-W03", "draw-W15"};
    return each.severity == Severity::warning && std::ranges::find(kNames, each.id) != kNames.end() &&
           !each.suggestion.empty();
}

}  // namespace

void applyStrict(Diagnostics& diagnostics, bool strict) {
    removeRepeats(diagnostics);
    removeConsequences(diagnostics);
    if (!strict) return;
    for (Diagnostic& each : diagnostics)
        if (each.severity == Severity::warning) each.severity = Severity::error;
}

Diagnostics takeMisspellings(Diagnostics& diagnostics) {
    const auto first = std::stable_partition(diagnostics.begin(), diagnostics.end(),
                                             [](const Diagnostic& each) { return !isMisspelling(each); });
    Diagnostics taken(std::make_move_iterator(first), std::make_move_iterator(diagnostics.end()));
    diagnostics.erase(first, diagnostics.end());
    for (Diagnostic& each : taken) each.severity = Severity::error;
    return taken;
}

}  // namespace glibra::render
