#pragma once
// What can be found out about a scene without drawing it. It reads files of strangers, so it runs in worker
// processes.

#include <glibra/render.h>

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "gallery/gallery.h"

namespace glibra::gallery {

struct DescribeTask {
    std::filesystem::path folder;  ///< of the gallery
    std::filesystem::path scene;   ///< with the folder
    RenderOptions options;         ///< `within` is the folder
};

/// Reads no file outside of the folder and the library. A scene with errors has what could be read of it.
Description describe(const DescribeTask& task);

/// A description as text for the pipe of a worker. parseDescription returns nothing for text that is none.
std::string toText(const Description& description);
std::optional<Description> parseDescription(std::string_view text);

}  // namespace glibra::gallery
