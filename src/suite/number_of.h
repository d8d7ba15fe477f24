#pragma once

#include <charconv>
#include <optional>
#include <string_view>
#include <system_error>

namespace glibra::suite {

/// The number that is the whole text, as std::from_chars reads it; nothing if the text is anything else.
template <class T>
std::optional<T> numberOf(std::string_view text) {
    T value{};
    const auto [end, failure] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (failure != std::errc() || end != text.data() + text.size()) return std::nullopt;
    return value;
}

}  // namespace glibra::suite
