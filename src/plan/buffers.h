#pragma once
// Finds the buffer that each block of a program uses, and how the content of a buffer lies in memory
// (language, 12).

#include <glibra/result.h>

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "plan/memory_pattern.h"
#include "plan/program_interface.h"
#include "scene/scene.h"

namespace glibra::plan {

struct FramePlan;

/// A block of a program with the buffer that it uses.
struct BlockUse {
    enum class Kind { uniform, storage, counters };
    Kind kind = Kind::storage;
    /// Index into the interface's list of that kind. Blocks are bound to binding points of the same number;
    /// counters have their own.
    std::size_t index = 0;
    scene::BufferView buffer;
    Place place;  ///< of the block's declaration, or of the program
};

/// The buffers of a program's blocks: those that the draw's or dispatch's set binds by a tag with the block's
/// name or its instance's, otherwise those declared with that name. A uniform block without a buffer has
/// values of its own and no entry. Error memory-E02 for a storage block or atomic counter without a buffer,
/// memory-E14 for counters of one binding with several.
Result<std::vector<BlockUse>> blockUses(const scene::Scene& scene, const scene::Program& program,
                                        scene::UniformSetIndex set, const ProgramInterface& interface);

/// The declared name of a block in messages: "storage block 'Particles'".
std::string describe(const BlockUse& use, const ProgramInterface& interface);

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
    /// differently, memory-E04 for a buffer that is too small for its block or larger than `mostBytes`, and
    /// memory-E05 for a buffer whose type is not known, and memory-E12 for one that does not begin with the
    /// counts that a draw or dispatch takes from it. `fileBytes` returns the size of a file.
    Diagnostics add(const scene::Scene& scene, const FramePlan& plan, std::uint64_t mostBytes,
                    std::uint64_t (*fileBytes)(const scene::FileReference& file));
    /// Null if no plan uses the buffer, or with an error.
    [[nodiscard]] const BufferLayout* find(scene::BufferIndex buffer) const;

  private:
    std::map<scene::BufferIndex, BufferLayout> layouts_;
};

}  // namespace glibra::plan
