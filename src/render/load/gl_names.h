#pragma once
// GL's names for stages and topologies.

#include <glad/gl.h>

#include "glsl/types/stage.h"
#include "plan/frame_plan.h"

namespace glibra::render {

/// GL_VERTEX_SHADER and so on.
GLenum glStage(glsl::Stage stage);

/// GL_POINTS, GL_TRIANGLE_STRIP and so on: the mode of a draw call.
GLenum glMode(const plan::Submission& submission);

// What has happened when the scene declares objects in other sizes.

struct Resized {
    bool isAny = false;    ///< an object has been forgotten, because the scene declares another size
    bool hasLost = false;  ///< blocks of Once and Step have to begin anew
};

// What has happened to a texture or buffer since it was made as the scene declares it.

struct ObjectState {
    bool lasts = false;      ///< Once or Step writes it, so frames do not reset it
    bool isChanged = false;  ///< a frame has written it: not as declared
    bool isWritten = false;  ///< any node has; false: as it was made, or as a reset has made it

    void setLasting() {
        lasts = true;
        isChanged = false;
    }
    void noteWritten() {
        isChanged = isChanged || !lasts;
        isWritten = true;
    }
    void noteReset() { isChanged = isWritten = false; }
};

}  // namespace glibra::render
