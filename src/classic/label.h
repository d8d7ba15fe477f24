#pragma once

#include <string>
#include <string_view>

namespace glibra::classic {

/// How a line of Print() begins: "cube:", and "I =" for the book's label "I = ".
inline std::string labelled(std::string_view label) {
    const std::size_t end = label.find_last_not_of(' ') + 1;
    const bool isClosed = end > 0 && (label[end - 1] == '=' || label[end - 1] == ':');
    return std::string(label.substr(0, end)) + (isClosed ? "" : ":");
}

}  // namespace glibra::classic
