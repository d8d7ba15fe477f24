#pragma once
// The content of a buffer as a table: a column for each member that its block declares, a row for each
// element.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "base/program_resources.h"
#include "plan/buffers.h"
#include "plan/frame_plan.h"

namespace glibra::plan {

/// The members through which a program sees a buffer: of the storage block, the uniform block, or the atomic
/// counters that use it.
base::StorageBlock blockOf(const BlockUse& use, const ProgramInterface& interface);
/// The first of the plan's programs that uses the buffer decides; nothing if none does.
std::optional<base::StorageBlock> blockOf(const FramePlan& plan, scene::BufferIndex buffer);

/// A member: a scalar, vector or matrix.
struct BufferColumn {
    std::string name;
    std::size_t first = 0, count = 1;  ///< numbers, counted from the first one of the element or the head
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

/// `block`: the members through which a program sees the buffer; without them (null) the columns have no
/// names of members. An element has at most `most` columns; the last one takes what is left.
BufferTable tableOf(const BufferLayout& layout, const base::StorageBlock* block, std::size_t most);

/// The numbers of a member as text: "0.5 -1 2". `kinds` and `values` begin at the member.
std::string cellText(std::span<const MemoryNumber> kinds, std::span<const double> values);

}  // namespace glibra::plan
