#pragma once
// Finds how the content of the buffers of a scene lies in memory (language, 12).

#include <glibra/diagnostic.h>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "base/program_resources.h"
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
    std::optional<base::StorageBlock> block{};  ///< that names the members, as a storage block; nothing: none
};

/// The layouts of all buffers of a scene. They are the same for all plans of the scene: the first block that
/// uses a buffer and is an array of the declared type decides, otherwise the first that uses it.
/// Blocks of later plans may only add padding at its end.
class BufferLayouts {
  public:
    /// Adds the buffers that the plan uses. Errors: memory-E03 for blocks that lay out one buffer
    /// differently, memory-E04 for a buffer that is too small for its block, memory-E17 for one larger than
    /// `mostBytes`, and memory-E05 for a buffer whose type is not known, unless it is one that no node of a
    /// Once or Step uses. `fileBytes` returns the size of a file. Blocks of `others` decide about buffers
    /// that they have as declared, and about those without a basic type that no block of `plan` uses; their
    /// structures count too.
    Diagnostics add(const scene::Scene& scene, const FramePlan& plan, std::uint64_t mostBytes,
                    std::uint64_t (*fileBytes)(const scene::FileReference& file),
                    std::span<const FramePlan* const> others = {});
    /// Null if no plan uses the buffer, or with an error.
    [[nodiscard]] const BufferLayout* find(scene::BufferIndex buffer) const;
    /// The next plan that uses the buffer decides anew.
    void forget(scene::BufferIndex buffer) { layouts_.erase(buffer); }

  private:
    std::map<scene::BufferIndex, BufferLayout> layouts_;
};

// The content of a buffer as a table: a column for each member that its block declares, a row for each
// element.

/// A member: a scalar, vector or matrix.
struct BufferColumn {
    std::string name;
    std::size_t first = 0, count = 1;  ///< numbers, counted from the first one of the element or the head
    int matrixColumns = 1;             ///< of a matrix, whose numbers come column by column; else 1
};

struct BufferTable {
    std::vector<BufferColumn> head;     ///< members before the array
    std::vector<BufferColumn> columns;  ///< of an element of the array; empty: there is no array
    std::uint64_t elements = 0;
};

/// A member, or those of its numbers that are of one kind.
struct BufferField {
    std::string name;                   ///< another one for each field
    std::vector<MemoryNumber> numbers;  ///< with offsets from the element, or from the begin of the buffer
    bool isOfElement = false;
};

/// The fields of the head, then those of an element: what files and programs read of a buffer.
std::vector<BufferField> fieldsOf(const BufferTable& table, const MemoryPattern& pattern);

/// Without a block the columns have no names of members. An element has at most `most` columns; the last one
/// takes what is left.
BufferTable tableOf(const BufferLayout& layout, std::size_t most = std::numeric_limits<std::size_t>::max());

/// The numbers of a member as text: "0.5 -1 2". `kinds` and `values` begin at the member.
std::string cellText(std::span<const MemoryNumber> kinds, std::span<const double> values);

// What dispatches and draws need of buffers and do not find, or do not reach (language, 12.7).

/// memory-E12 for draws and dispatches whose counts their buffers do not hold, then memory-W05 for
/// invocations, vertices and instances that use elements which their buffer does not have, and memory-W06 for
/// dispatches with a single group along an axis along which a written image goes on.
Diagnostics reachProblems(const scene::Scene& scene, const FramePlan& plan, const BufferLayouts& layouts);

}  // namespace glibra::plan
