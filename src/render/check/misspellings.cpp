#include "render/check/misspellings.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <string_view>

namespace glibra::render {
namespace {

/// A name without a near one may be left over from another program, which does no harm.
bool isMisspelling(const Diagnostic& each) {
    constexpr std::array<std::string_view, 3> kNames{"glib-W23", "draw-W03", "draw-W15"};
    return each.severity == Severity::warning &&
           std::find(kNames.begin(), kNames.end(), each.id) != kNames.end() && !each.suggestion.empty();
}

}  // namespace

Diagnostics takeMisspellings(Diagnostics& diagnostics) {
    const auto first = std::stable_partition(diagnostics.begin(), diagnostics.end(),
                                             [](const Diagnostic& each) { return !isMisspelling(each); });
    Diagnostics taken(std::make_move_iterator(first), std::make_move_iterator(diagnostics.end()));
    diagnostics.erase(first, diagnostics.end());
    for (Diagnostic& each : taken) each.severity = Severity::error;
    return taken;
}

}  // namespace glibra::render
