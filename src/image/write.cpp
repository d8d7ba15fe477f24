#include "image/write.h"

#include <fmt/format.h>

#include <new>
#include <system_error>

#include "image/convert.h"
#include "image/file.h"
#include "image/format.h"

namespace glibra::image {
namespace {

namespace fs = std::filesystem;

Diagnostics writePng(const Image& image, const fs::path& path, const PngOptions& options) {
    const bool floats = image.type == Component::f32;
    const auto png = floats ? encodePng(withType(image, Component::u16), options) : encodePng(image, options);
    if (png.empty()) return {cannotWrite(path, "there is not enough memory")};
    return writeFileAtomically(path, png);
}

Diagnostics writeOther(const Image& image, Format format, const fs::path& path, const WriteOptions& options) {
    std::error_code failed;
    if (fs::is_directory(path, failed)) return {cannotWrite(path, "it is a folder")};
    TemporaryFile temporary(path);
    if (temporary.path().empty()) return {temporary.failure()};
    Diagnostics problems = writeByModule(image, format, temporary.path(), {path.string(), {}},
                                         options.comment, options.moduleFolders);
    if (hasError(problems)) return problems;
    return temporary.commit();
}

}  // namespace

Diagnostics writeImage(const Image& image, const fs::path& path, const WriteOptions& options) {
    if (!isConsistent(image)) return {cannotWrite(path, "the picture has no pixels")};
    const Format format = formatOfSuffix(path);
    try {
        if (format == Format::png) return writePng(image, path, options.png);
        if (format == Format::unknown || format == Format::rawTexture)
            return {
                cannotWrite(path, fmt::format("the suffix '{}' is not that of a picture format; .png is one",
                                              path.extension().string()))};
        return writeOther(image, format, path, options);
    } catch (const std::bad_alloc&) {
        return {cannotWrite(path, "there is not enough memory")};
    }
}

}  // namespace glibra::image
