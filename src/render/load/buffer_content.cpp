#include "render/load/buffer_content.h"

#include <limits>

namespace glibra::render {

BufferContent contentOf(const plan::BufferLayout& layout, const base::StorageBlock* block,
                        const gpu::Buffer& buffer) {
    BufferContent content{layout, plan::tableOf(layout, block, std::numeric_limits<std::size_t>::max()),
                          std::vector<std::byte>(buffer.size())};
    buffer.read(0, content.bytes);
    return content;
}

}  // namespace glibra::render
