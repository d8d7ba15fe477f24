// Any bytes as a picture of any format. The formats besides PNG and BMP are read by OpenImageIO, which is not
// ours and not instrumented: what ends inside it is counted apart (tools/fuzz).

#include <span>

#include "check.h"
#include "image/format.h"
#include "image/read.h"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace glibra;
    using fuzz::check;
    image::ReadOptions options;
    options.limits = {.fileBytes = 1U << 20, .texelBytes = 1U << 24, .side = 4096, .side3D = 128};
    const Result<image::Image> picture =
        image::decodeImage(std::as_bytes(std::span(data, size)), "nowhere/a.tif", {}, options);
    fuzz::checkMessages(picture.diagnostics);
    check(picture.value.has_value() != hasError(picture.diagnostics), "a picture or an error");
    for (const Diagnostic& each : picture.diagnostics) {
        const bool isMissing = each.text.find("the image module that reads it") != std::string::npos;
        check(!isMissing, "the image module is installed");
    }
    if (picture) {
        check(picture->width >= 1 && picture->height >= 1 && picture->components == 4,
              "a picture has pixels");
        check(picture->data.size() == picture->rowBytes() * static_cast<std::size_t>(picture->height),
              "a picture has all its pixels");
        check(picture->data.size() <= options.limits.texelBytes, "a picture keeps to the limits");
    }
    return 0;
}
