#pragma once
// The codecs of the module, one for each library. They report problems by throwing Failure; `module.cpp`
// turns it into the message of the request.

#include <string>
#include <string_view>
#include <vector>

#include "image/module/abi.h"

namespace glibra::module {

struct Failure {
    std::string text;
};

/// Thrown when `allocate` of a request has returned null.
struct Refused {};

/// Thrown for a format that the module is built without.
struct Unknown {};

/// Memory for the RGBA pixels of a request.
inline void* allocate(const GlibraReadRequest& request, uint64_t width, uint64_t height, int type) {
    void* const pixels = request.allocate(request.context, width, height, type);
    if (pixels == nullptr) throw Refused{};
    return pixels;
}

/// Writes a whole file.
void writeFile(const char* path, const std::vector<unsigned char>& bytes);

struct Codec {
    std::string_view format;
    void (*read)(const GlibraReadRequest&);
    void (*write)(const GlibraWriteRequest&);
};

/// What reads and writes a format. Colours are as in the file, whether or not they were multiplied by alpha.
/// The build chooses one of two sources: openimageio.cpp or without_openimageio.cpp.
const Codec& codecFor(std::string_view format);

/// WebP with libwebp: RGBA, u8. OpenImageIO before 3.0 multiplies the colours by alpha, in both directions.
/// Of an animation the first picture is read. Written without loss.
void readWebp(const GlibraReadRequest& request);
void writeWebp(const GlibraWriteRequest& request);

/// OpenEXR with its own library: RGBA, f32, of the size of the display window; black, and transparent if the
/// file has alpha, where the data window does not reach. Whole numbers keep their value. OpenImageIO gives
/// the data window alone, and divides whole numbers by 2^32.
void readExr(const GlibraReadRequest& request);

}  // namespace glibra::module
