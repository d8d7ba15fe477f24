#pragma once

#include <cstddef>
#include <vector>

#include "plan/buffer_table.h"
#include "plan/buffers.h"

namespace glibra::render {

/// A buffer as the last picture left it.
struct BufferContent {
    plan::BufferLayout layout;
    plan::BufferTable table;
    std::vector<std::byte> bytes;
};

}  // namespace glibra::render
