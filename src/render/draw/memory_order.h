#pragma once
// The barriers between nodes whose shaders store to memory: before a node, for what it does with objects that
// nodes before it have used.

#include <glad/gl.h>

#include <cstddef>
#include <vector>

#include "plan/accesses.h"
#include "plan/frame_plan.h"

namespace glibra::render {

/// What a node of a plan does with memory.
struct NodeMemory {
    GLbitfield ways = 0;                ///< how it uses objects, as bits of glMemoryBarrier
    std::vector<plan::Object> touched;  ///< all objects that it uses
    std::vector<plan::Object> stored;   ///< those that its shaders may store to
};
/// Without the copies that NodeAccess::exchanges asks for, which use objects in `kWaysOfCopies`.
NodeMemory memoryOf(const plan::FramePlan& plan, std::size_t node);
inline constexpr GLbitfield kWaysOfCopies = GL_TEXTURE_UPDATE_BARRIER_BIT | GL_FRAMEBUFFER_BARRIER_BIT |
                                            GL_BUFFER_UPDATE_BARRIER_BIT | GL_SHADER_IMAGE_ACCESS_BARRIER_BIT;

/// Knows which uses of objects have no barrier after them yet.
class MemoryOrder {
  public:
    /// Makes the barrier that a node needs, if it needs one.
    void before(const NodeMemory& node);
    /// `isOrdered`: a barrier for everything follows the stores of the node.
    void after(const NodeMemory& node, bool isOrdered);
    /// Makes the barrier for whatever comes next.
    void finish();

  private:
    struct Used {
        plan::Object object;
        GLbitfield since = 0;   ///< the ways that no barrier has ordered since a node used it
        GLbitfield stored = 0;  ///< likewise since a shader may have stored to it
    };
    Used* find(const plan::Object& object);
    std::vector<Used> used_;  ///< few, so that a search is fast
};

}  // namespace glibra::render
