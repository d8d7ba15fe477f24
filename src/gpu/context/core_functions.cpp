#include <glad/gl.h>

#include "gpu/context/context.h"

namespace glibra::gpu {

bool loadCoreFunctions(Backend& backend) {
    const auto address = [](void* from, const char* function) {
        return reinterpret_cast<GLADapiproc>(static_cast<Backend*>(from)->address(function));
    };
    if (gladLoadGLUserPtr(address, &backend) == 0 || GLAD_GL_VERSION_4_1 == 0) return false;
    // Of ARB_clip_control, too, under the same name; Capabilities::clipControl says whether it is there.
    glad_glClipControl = reinterpret_cast<PFNGLCLIPCONTROLPROC>(backend.address("glClipControl"));
    return true;
}

}  // namespace glibra::gpu
