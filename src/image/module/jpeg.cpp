// JPEG with libjpeg, for a module without OpenImageIO.

#include <array>
#include <cstdio>  // jpeglib.h needs it

#include <jpeglib.h>

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <string>
#include <vector>

#include "image/module/codec.h"

namespace glibra::module {
namespace {

/// Errors end the work, and so do warnings, which are about damaged pixels. The exception passes through the
/// library, which is compiled for that.
[[noreturn]] void fail(j_common_ptr info) {
    std::array<char, JMSG_LENGTH_MAX> text{};
    info->err->format_message(info, text.data());
    throw Failure{std::string("JPEG error: ") + text.data() + " (\"picture.jpeg\")"};
}

/// A jpeg_decompress_struct or jpeg_compress_struct, and what it needs.
template <class Info, void (*destroy)(Info*)>
struct Jpeg {
    Jpeg() {
        info.err = jpeg_std_error(&errors);
        errors.error_exit = errors.output_message = fail;
    }
    Jpeg(const Jpeg&) = delete;
    Jpeg& operator=(const Jpeg&) = delete;
    ~Jpeg() { destroy(&info); }

    Info info{};
    jpeg_error_mgr errors{};
};

/// Inks as a JPEG file holds them, where 0 is all of an ink, become colours.
void colorsOfInks(JSAMPLE* pixel, size_t count) {
    constexpr float kStep = 1.F / 255;
    for (; count > 0; --count, pixel += 4) {
        const float black = static_cast<float>(pixel[3]) * kStep;
        for (int c = 0; c < 3; ++c)
            pixel[c] = static_cast<JSAMPLE>(static_cast<float>(pixel[c]) * kStep * black * 255.F + .5F);
        pixel[3] = 255;
    }
}

JSAMPLE jpegByteAt(const GlibraWriteRequest& request, size_t index) {
    if (request.type == kGlibraU8) return static_cast<const uint8_t*>(request.pixels)[index];
    const float value =
        request.type == kGlibraU16
            ? static_cast<float>(static_cast<const uint16_t*>(request.pixels)[index]) * (1.F / 65535)
            : static_cast<const float*>(request.pixels)[index];
    return static_cast<JSAMPLE>(std::clamp(value * 255.F + .5F, 0.F, 255.F));
}

}  // namespace

void readJpeg(const GlibraReadRequest& request) {
    Jpeg<jpeg_decompress_struct, jpeg_destroy_decompress> codec;
    auto& info = codec.info;
    jpeg_create_decompress(&info);
    jpeg_mem_src(&info, static_cast<const unsigned char*>(request.bytes),
                 static_cast<unsigned long>(request.size));
    if (jpeg_read_header(&info, FALSE) != JPEG_HEADER_OK) throw Failure{"Bad JPEG header"};
    const bool isInks = info.jpeg_color_space == JCS_CMYK || info.jpeg_color_space == JCS_YCCK;
    info.out_color_space = isInks ? JCS_CMYK : JCS_EXT_RGBA;
    jpeg_start_decompress(&info);
    auto* const pixels =
        static_cast<JSAMPLE*>(allocate(request, info.output_width, info.output_height, kGlibraU8));
    while (info.output_scanline < info.output_height) {
        JSAMPROW row = pixels + size_t{4} * info.output_width * info.output_scanline;
        jpeg_read_scanlines(&info, &row, 1);
        if (isInks) colorsOfInks(row, info.output_width);
    }
}

void writeJpeg(const GlibraWriteRequest& request) {
    // EXIF data with nothing but the date 1970:01:01 00:00:00, as OpenImageIO writes them.
    static constexpr char kExif[] =
        "Exif\0\0II*\0\x1c\0\0\0"
        "1970:01:01 00:00:00\0\1\0\x32\1\2\0\x14\0\0\0\x8\0\0\0\0\0\0";
    struct Memory {
        ~Memory() { std::free(bytes); }  // NOLINT: the library's own
        unsigned char* bytes = nullptr;
        unsigned long size = 0;
    } memory;
    Jpeg<jpeg_compress_struct, jpeg_destroy_compress> codec;
    auto& info = codec.info;
    jpeg_create_compress(&info);
    jpeg_mem_dest(&info, &memory.bytes, &memory.size);
    info.image_width = static_cast<JDIMENSION>(request.width);
    info.image_height = static_cast<JDIMENSION>(request.height);
    info.input_components = 3;
    info.in_color_space = JCS_RGB;
    jpeg_set_defaults(&info);
    constexpr int kQuality = 95;
    jpeg_set_quality(&info, kQuality, TRUE);
    for (int c = 0; c < 3; ++c) info.comp_info[c].h_samp_factor = info.comp_info[c].v_samp_factor = 1;
    jpeg_start_compress(&info, TRUE);
    if (request.comment != nullptr && *request.comment != 0)
        jpeg_write_marker(&info, JPEG_COM, reinterpret_cast<const JOCTET*>(request.comment),
                          static_cast<unsigned>(std::strlen(request.comment)) + 1);
    jpeg_write_marker(&info, JPEG_APP0 + 1, reinterpret_cast<const JOCTET*>(kExif), sizeof kExif);
    const auto width = static_cast<size_t>(request.width),
               components = static_cast<size_t>(request.components);
    std::vector<JSAMPLE> row(3 * width);
    for (size_t y = 0; y < static_cast<size_t>(request.height); ++y) {
        for (size_t i = 0; i < row.size(); ++i)
            row[i] = jpegByteAt(request, (y * width + i / 3) * components + i % 3);
        JSAMPROW at = row.data();
        jpeg_write_scanlines(&info, &at, 1);
    }
    jpeg_finish_compress(&info);
    writeFile(request.path, {memory.bytes, memory.bytes + memory.size});
}

}  // namespace glibra::module
