#include <glad/gl.h>

#include "gpu/context/context.h"

namespace glibra::gpu {

bool loadCoreFunctions(Backend& backend) {
    const auto address = [](void* from, const char* function) {
        return reinterpret_cast<GLADapiproc>(static_cast<Backend*>(from)->address(function));
    };
    return gladLoadGLUserPtr(address, &backend) != 0 && GLAD_GL_VERSION_4_1 != 0;
}

}  // namespace glibra::gpu
