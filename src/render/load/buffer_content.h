#pragma once

#include <cstddef>
#include <vector>

#include "gpu/object/buffer.h"
#include "plan/buffer_table.h"
#include "plan/buffers.h"

namespace glibra::render {

/// A buffer as the last picture left it.
struct BufferContent {
    plan::BufferLayout layout;
    plan::BufferTable table;
    std::vector<std::byte> bytes;
};

/// Reads it from the device, and waits for that. `block`: as of plan::tableOf.
BufferContent contentOf(const plan::BufferLayout& layout, const base::StorageBlock* block,
                        const gpu::Buffer& buffer);

}  // namespace glibra::render
