#pragma once
// The interface between the program and its image module: C functions and plain structs; no memory
// changes its owner, and no exception crosses. Pixels are RGBA (reading) or RGB and RGBA (writing), top row
// first, tightly packed.

#include <stddef.h>
#include <stdint.h>

extern "C" {

/// Increased whenever anything below changes. The program rejects a module with another number.
constexpr int kGlibraModuleVersion = 4;

enum { kGlibraU8 = 0, kGlibraU16 = 1, kGlibraF32 = 2 };  // component types
// Results. Unknown: the module was built without a library for the format.
enum { kGlibraDone = 0, kGlibraFailed = 1, kGlibraRefused = 2, kGlibraUnknown = 3 };

/// Returns memory for width x height RGBA pixels of a type, or null to reject the picture. Must not throw.
using GlibraAllocate = void* (*)(void* context, uint64_t width, uint64_t height, int type);

struct GlibraReadRequest {
    const char* format;  ///< OpenImageIO's name of the format, which the caller found by the content
    const char* path;    ///< the file, or null if there are only bytes
    const void* bytes;   ///< its whole content
    size_t size;
    GlibraAllocate allocate;
    void* context;  ///< for `allocate`
    char* message;  ///< receives the reason of a failure, zero-terminated
    size_t messageSize;
};

struct GlibraWriteRequest {
    const char* format;
    const char* path;  ///< an existing file is overwritten
    int width, height;
    int components;  ///< 3 or 4
    int keepsAlpha;  ///< 0: a fourth component is not written
    int type;
    const void* pixels;
    const char* comment;  ///< for formats that can store one; null or empty: none
    char* message;
    size_t messageSize;
};

using GlibraModuleVersion = int (*)();
using GlibraReadPicture = int (*)(const GlibraReadRequest*);
using GlibraWritePicture = int (*)(const GlibraWriteRequest*);

/// The module's functions, by these names.
int glibraModuleVersion();
int glibraReadPicture(const GlibraReadRequest* request);
int glibraWritePicture(const GlibraWriteRequest* request);
}
