#pragma once
// What a scene asks the user when it is loaded: messages, and files that it does not name.

#include <cstdint>
#include <string>
#include <vector>

namespace glibra::view {

struct MessageBox {
    std::uint64_t loaded = 0;  ///< Session::timesLoaded() of the texts
    std::vector<std::string> texts;
    bool isShown = false;
    std::uint64_t asked = 0;  ///< Session::timesLoaded() when the user was asked for a file last
};

}  // namespace glibra::view
