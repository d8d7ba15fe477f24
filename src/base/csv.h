#pragma once
// Fields of tables as text.

#include <string>
#include <string_view>

namespace glibra::base {

/// A field of a CSV file (RFC 4180), quoted if it has one of `special`.
inline std::string csvField(std::string_view text, std::string_view special = ",\"\r\n") {
    if (text.find_first_of(special) == std::string_view::npos) return std::string(text);
    std::string field = "\"";
    for (const char each : text) field.append(each == '"' ? 2 : 1, each);
    return field + '"';
}

}  // namespace glibra::base
