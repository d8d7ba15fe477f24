#pragma once
// Addresses in which "%20" stands for a blank (RFC 3986, 2.1).

#include <charconv>
#include <cstddef>
#include <string>
#include <string_view>

namespace glibra::base {

/// The text with the bytes that are written so. What is no such writing stays.
inline std::string percentDecoded(std::string_view address) {
    std::string text;
    for (std::size_t i = 0; i < address.size(); ++i) {
        const std::string_view digits = address[i] == '%' ? address.substr(i + 1, 2) : std::string_view{};
        unsigned char byte = 0;
        const char* const end = digits.data() + digits.size();
        const bool isByte = digits.size() == 2 && std::from_chars(digits.data(), end, byte, 16).ptr == end;
        text += isByte ? static_cast<char>(byte) : address[i];
        if (isByte) i += 2;
    }
    return text;
}

}  // namespace glibra::base
