#include "gpu/object/compute.h"

#include <algorithm>

namespace glibra::gpu {

std::array<std::uint64_t, 3> groupsOver(const std::array<std::uint64_t, 3>& invocations,
                                        const std::array<int, 3>& localSize) {
    std::array<std::uint64_t, 3> groups{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto size = static_cast<std::uint64_t>(std::max(1, localSize[axis]));
        groups[axis] = invocations[axis] / size + (invocations[axis] % size != 0 ? 1 : 0);
    }
    return groups;
}

void dispatch(const std::array<GLuint, 3>& groups) {
    glDispatchCompute(groups[0], groups[1], groups[2]);
}

void dispatchFrom(const Buffer& groups, std::size_t offset) {
    groups.bind(GL_DISPATCH_INDIRECT_BUFFER);
    glDispatchComputeIndirect(static_cast<GLintptr>(offset));
}

}  // namespace glibra::gpu
