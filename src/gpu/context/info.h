#pragma once
// Everything about the driver that `glibra info` prints.

#include <cstdint>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "gpu/context/context.h"

namespace glibra::gpu {

struct InfoEntry {
    std::string key;    ///< for JSON: camelCase, never changes meaning
    std::string label;  ///< for people: "largest 2D texture"
    std::variant<std::string, std::int64_t, double, bool> value;
};

/// Entries in the order of display: how the context was opened, driver, versions, limits, number of
/// extensions.
std::vector<InfoEntry> describe(const Context& context);

/// One "label: value" line per entry, with the values aligned.
std::string toText(const std::vector<InfoEntry>& entries);

}  // namespace glibra::gpu
