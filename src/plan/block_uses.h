#pragma once
// Finds the buffer that each block of a program uses (language, 12).

#include <glibra/result.h>

#include <cstddef>
#include <string>
#include <vector>

#include "plan/program_interface.h"
#include "scene/scene.h"

namespace glibra::plan {

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

}  // namespace glibra::plan
