#pragma once
// Any picture file as pixels. The content decides what it is, never the suffix (language reference, 8.1).

#include <glibra/result.h>

#include <filesystem>
#include <span>
#include <vector>

#include "image/image.h"
#include "image/limits.h"
#include "image/module_loader.h"

namespace glibra::image {

struct ReadOptions {
    Limits limits;
    std::vector<std::filesystem::path> moduleFolders = defaultModuleFolders();
};

/// The picture as RGBA, top row first: u8, u16 (16-bit PNG and the like) or f32 (EXR, HDR and the like). BMP
/// and PNG are read here, everything else by the OpenImageIO module. `place` is where the scene names the
/// file. file-W03 if the suffix promises another format. Errors: file-E01, E02 no such file or unreadable,
/// file-E03 no picture, or one that needs the module, which is not there; file-E04 damaged or short; file-E09
/// beyond the limits.
Result<Image> readImage(const std::filesystem::path& path, const Place& place = {},
                        const ReadOptions& options = {});

/// The same for a file that is in memory already. `path` gives the name for messages and the promised suffix.
Result<Image> decodeImage(std::span<const std::byte> file, const std::filesystem::path& path,
                          const Place& place = {}, const ReadOptions& options = {});

}  // namespace glibra::image
