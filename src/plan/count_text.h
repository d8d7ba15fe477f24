#pragma once
// Private to this room: counts in messages about buffers, with commas between thousands.

#include <fmt/format.h>

#include <cstdint>
#include <string>
#include <string_view>

#include "glib/number.h"

namespace glibra::plan {

inline std::string grouped(std::uint64_t count) {
    return glib::groupedText(static_cast<long long>(count));
}

/// "1 byte", "4,096 bytes".
inline std::string countedText(std::uint64_t count, std::string_view one) {
    return fmt::format("{} {}{}", grouped(count), one, count == 1 ? "" : "s");
}

}  // namespace glibra::plan
