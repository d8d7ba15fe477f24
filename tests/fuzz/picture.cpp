// Any bytes as a picture of a format that is read here, or as a raw texture. What is accepted gives the same
// pixels after it is written as PNG, unless they are floats. The targets "header" and "module" have the other
// formats.

#include <array>
#include <span>

#include "check.h"
#include "image/png/png_reader.h"
#include "image/png/png_writer.h"
#include "image/read.h"
#include "image/texture_file.h"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace glibra;
    using fuzz::check;
    const auto file = std::as_bytes(std::span(data, size));
    image::ReadOptions options;
    options.limits = {.fileBytes = 1U << 20, .texelBytes = 1U << 22, .side = 2048, .side3D = 128};
    options.moduleFolders.clear();
    const Result<image::Image> picture = image::decodeImage(file, "nowhere/a.png", {}, options);
    fuzz::checkMessages(picture.diagnostics);
    check(picture.value.has_value() != hasError(picture.diagnostics), "a picture or an error");
    if (picture) {
        check(picture->width >= 1 && picture->height >= 1, "a picture has pixels");
        check(picture->data.size() == picture->rowBytes() * static_cast<std::size_t>(picture->height),
              "a picture has all its pixels");
        check(picture->data.size() <= options.limits.texelBytes, "a picture keeps to the limits");
        if (picture->type != image::Component::f32) {  // PNG has no floats
            const auto written =
                image::encodePng(*picture, {.level = static_cast<int>(size % 5), .text = {}, .threads = 1});
            const Result<image::Image> again = image::decodePng(written, {"again.png", {}}, options.limits);
            check(again && again->width == picture->width && again->height == picture->height &&
                      again->type == picture->type && again->data == picture->data,
                  "a picture that is written as PNG keeps its pixels");
        }
    }
    for (const int dimensions : std::array{0, 1, 2, 3}) {
        const Result<image::TexelBlock> texels =
            image::decodeRawTexture(file, dimensions, {"a.tex", {}}, options.limits);
        fuzz::checkMessages(texels.diagnostics);
        if (texels)
            check(texels->data.size() ==
                      static_cast<std::size_t>(texels->width) * static_cast<std::size_t>(texels->height) *
                          static_cast<std::size_t>(texels->depth) * 4 * image::bytesOf(texels->type),
                  "a texture has all its texels");
    }
    return 0;
}
