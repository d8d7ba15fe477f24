#pragma once
// Private to this room: what statements that do not run in this frame may write in another one.

#include <cstddef>
#include <set>

#include "glib/script.h"
#include "scene/index.h"
#include "scene/objects.h"

namespace glibra::scene {

struct Interpreter;

/// Statements that did not run, although other values of variables or another time would run them.
struct UntakenRange {
    const glib::Script* script = nullptr;
    std::size_t first = 0, last = 0;  ///< commands [first, last)
};

/// The textures that statements of in.modern.untaken may write, also through the groups that they draw, and
/// those that the other words of a choice would make the target of a statement. Uniforms of dispatches count
/// as images.
std::set<TextureIndex> undecidedWrites(const Interpreter&);

}  // namespace glibra::scene
