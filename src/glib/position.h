#pragma once

namespace glibra::glib {

/// A place inside the scene's own file.
struct Position {
    int line = 1;
    int column = 1;

    friend bool operator==(const Position&, const Position&) = default;
};

}  // namespace glibra::glib
