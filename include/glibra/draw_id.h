#pragma once

#include <compare>

namespace glibra {

/// Which draw of a scene: the same from frame to frame and from one reading of an unchanged text to the next.
struct DrawId {
    int line = 0;     ///< of the statement, counted from 1; 0: none
    int file = 0;     ///< 0: the scene's own file; files that it includes are counted from 1
    int counter = 0;  ///< draws that this line has made before
    friend auto operator<=>(const DrawId&, const DrawId&) = default;
};

}  // namespace glibra
