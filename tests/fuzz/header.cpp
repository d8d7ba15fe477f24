// Any bytes as the header of a picture that a library decodes: what is judged before the library sees the
// file.

#include <span>

#include "check.h"
#include "image/foreign_headers.h"
#include "image/formats/readers.h"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace glibra;
    using fuzz::check;
    const auto file = std::as_bytes(std::span(data, size));
    const image::FileLabel label{"a", {}};
    const image::Limits limits{.fileBytes = 1U << 20, .texelBytes = 1U << 22, .side = 2048, .side3D = 128};
    const auto judge = [](const auto& read) {
        fuzz::checkMessages(read.diagnostics);
        check(read.value.has_value() != hasError(read.diagnostics), "a header or an error");
        return read.value.has_value();
    };
    const auto exr = image::readExrHeader(file, label, limits);
    if (judge(exr)) {
        check(exr->display.width() <= 2048 && exr->display.height() <= 2048,
              "a display window keeps to the limits");
        check(exr->data.width() <= 2048 && exr->data.height() <= 2048, "a data window keeps to the limits");
        check(!exr->channels.empty() && !image::describeExr(*exr).empty(), "a part has channels");
    }
    const auto tiff = image::readTiffHeader(file, label, limits);
    if (judge(tiff)) {
        check(tiff->width <= 2048 && tiff->height <= 2048, "a TIFF keeps to the limits");
        check(tiff->orientation >= 1 && tiff->orientation <= 8, "an orientation is one of eight");
        const auto changed = image::withBitsPerSample(file);
        check(changed.size() <= 2 * size + 64, "a directory grows by one entry");
        if (!tiff->hasBits && !changed.empty()) {
            const auto again = image::readTiffHeader(changed, label, limits);
            // What lay beyond the end of the file may lie in the added field.
            check(!again || (again->hasBits && again->bits == 1 && again->width == tiff->width),
                  "the added field is found, and nothing else changes");
        }
    }
    judge(image::decodeBmp(file, label, limits));
    const auto dds = image::decodeDds(file, label, limits);
    if (judge(dds)) check(dds->blocks.size() <= size, "blocks are a part of the file");
    const image::JpegFacts jpeg = image::jpegFacts(file);
    check(jpeg.orientation >= 1 && jpeg.orientation <= 8, "an orientation is one of eight");
    check(image::withoutMetadata(file).size() <= size, "metadata are removed, not added");
    return 0;
}
