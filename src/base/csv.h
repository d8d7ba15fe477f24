#pragma once
// Fields of tables as text.

#include <string>
#include <string_view>

namespace glibra::base {

/// A field of a CSV file (RFC 4180), quoted where it must be.
inline std::string csvField(std::string_view text) {
    if (text.find_first_of(",\"\r\n") == std::string_view::npos) return std::string(text);
    std::string field = "\"";
    for (const char each : text) field.append(each == '"' ? 2 : 1, each);
    return field + '"';
}

}  // namespace glibra::base
