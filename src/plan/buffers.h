#pragma once
// Finds how the content of the buffers of a scene lies in memory (language, 12).

#include <glibra/diagnostic.h>

#include <cstdint>
#include <map>
#include <string>

#include "plan/frame_plan.h"
#include "plan/memory_pattern.h"
#include "scene/scene.h"

namespace glibra::plan {

/// Every buffer gets at least these bytes on the device: GL has none without bytes, and drivers round the
/// size of a block up to a multiple of them.
inline constexpr std::uint64_t kLeastBufferBytes = 16;

/// How a buffer lies in memory.
struct BufferLayout {
    MemoryPattern pattern;
    std::uint64_t elements = 0;  ///< of the pattern's array
    std::uint64_t bytes = 0;
    std::string from;  ///< what decides it, for messages: "storage block 'Particles'", "type vec4"
    Place place;       ///< of that
};

/// The layouts of all buffers of a scene. They are the same for all plans of the scene: the first block that
/// uses a buffer decides. Blocks of later plans may only add padding at its end.
class BufferLayouts {
  public:
    /// Adds the buffers that the plan uses. Errors: memory-E03 for blocks that lay out one buffer
    /// differently, memory-E04 for a buffer that is too small for its block, memory-E17 for one larger than
    /// `mostBytes`, and memory-E05 for a buffer whose type is not known. `fileBytes` returns the size of a
    /// file.
    Diagnostics add(const scene::Scene& scene, const FramePlan& plan, std::uint64_t mostBytes,
                    std::uint64_t (*fileBytes)(const scene::FileReference& file));
    /// Null if no plan uses the buffer, or with an error.
    [[nodiscard]] const BufferLayout* find(scene::BufferIndex buffer) const;

  private:
    std::map<scene::BufferIndex, BufferLayout> layouts_;
};

}  // namespace glibra::plan
