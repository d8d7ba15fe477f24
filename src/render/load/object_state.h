#pragma once
// What has happened to a texture or buffer since it was made as the scene declares it.

namespace glibra::render {

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
