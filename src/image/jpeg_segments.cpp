#include "image/jpeg_segments.h"

#include <algorithm>
#include <string_view>

#include "image/bytes.h"
#include "image/tiff/tiff_header.h"

namespace glibra::image {
namespace {

constexpr unsigned kRestart0 = 0xd0, kRestart7 = 0xd7, kEndOfImage = 0xd9, kStartOfScan = 0xda, kApp0 = 0xe0,
                   kApp14 = 0xee, kApp15 = 0xef, kComment = 0xfe;

bool isMetadata(unsigned marker) {
    return marker == kComment || (marker > kApp0 && marker <= kApp15 && marker != kApp14);
}

}  // namespace

JpegFacts jpegFacts(ByteSpan jpeg) {
    constexpr std::size_t kLeastFrame = 8;  // after the length: precision, height, width, components
    constexpr std::string_view kExif("Exif\0\0", 6);
    JpegFacts facts;
    bool hasExif = false;  // of several, the first one counts
    for (std::size_t at = 2; at + 4 <= jpeg.size() && octetAt(jpeg, at) == 0xff;) {
        const unsigned marker = octetAt(jpeg, at + 1);
        if (marker == 0xff) {  // a fill byte
            ++at;
            continue;
        }
        const std::size_t length = big16(jpeg, at + 2);
        if (marker == kStartOfScan || marker < 0xc0 || length < 2 || at + 2 + length > jpeg.size()) break;
        const ByteSpan content = jpeg.subspan(at + 4, length - 2);
        const bool isFrame = marker <= 0xcf && marker != 0xc4 && marker != 0xc8 && marker != 0xcc;
        if (isFrame && length >= kLeastFrame) {
            facts.frame = marker;
            facts.bits = octetAt(content, 0);
            facts.height = big16(content, 1);
            facts.width = big16(content, 3);
            facts.components = octetAt(content, 5);
        }
        if (!hasExif && marker == kApp0 + 1 && content.size() > kExif.size() &&
            std::equal(kExif.begin(), kExif.end(), reinterpret_cast<const char*>(content.data()))) {
            facts.orientation = tiffOrientation(content.subspan(kExif.size()));
            hasExif = true;
        }
        at += 2 + length;
    }
    return facts;
}

std::vector<std::byte> withoutMetadata(std::span<const std::byte> jpeg) {
    std::vector<std::byte> kept;
    kept.reserve(jpeg.size());
    std::size_t at = 2;  // after the start-of-image marker
    std::size_t copied = 0;
    const auto copyUntil = [&](std::size_t end) {
        kept.insert(kept.end(), jpeg.begin() + static_cast<std::ptrdiff_t>(copied),
                    jpeg.begin() + static_cast<std::ptrdiff_t>(end));
    };
    while (at + 4 <= jpeg.size() && octetAt(jpeg, at) == 0xff) {
        const unsigned marker = octetAt(jpeg, at + 1);
        if (marker == 0xff) {  // a fill byte
            ++at;
            continue;
        }
        const std::size_t end = at + 2 + big16(jpeg, at + 2);
        if (marker == kStartOfScan || marker < 0xc0 || end < at + 4 || end > jpeg.size()) break;
        if (isMetadata(marker)) {
            copyUntil(at);
            copied = end;
        }
        at = end;
    }
    copyUntil(jpeg.size());
    return kept;
}

bool hasEndOfImage(std::span<const std::byte> jpeg) {
    std::size_t at = 2;
    while (at + 2 <= jpeg.size()) {
        // Both between segments and within a scan, anything that is not a marker is pixel data or fill.
        const unsigned marker = octetAt(jpeg, at + 1);
        const bool data = octetAt(jpeg, at) != 0xff || marker == 0 || marker == 0xff ||
                          (marker >= kRestart0 && marker <= kRestart7);
        if (data) {
            ++at;
        } else if (marker == kEndOfImage) {
            return true;
        } else {
            if (at + 4 > jpeg.size()) return false;
            at += 2 + big16(jpeg, at + 2);
        }
    }
    return false;
}

}  // namespace glibra::image
