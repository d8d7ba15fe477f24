#pragma once
// The content of a buffer as a table: a column for each member that its block declares, a row for each
// element.

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "base/program_resources.h"
#include "plan/buffers.h"

namespace glibra::view {

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

/// `block`: the storage block through which a program uses the buffer; without one (null) the columns have no
/// names of members. At most 60 columns; the last one takes what is left.
BufferTable tableOf(const plan::BufferLayout& layout, const base::StorageBlock* block);

/// The numbers of a member as text: "0.5 -1 2". `kinds` and `values` begin at the member.
std::string cellText(std::span<const plan::MemoryNumber> kinds, std::span<const double> values);

}  // namespace glibra::view
