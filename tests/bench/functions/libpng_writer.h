#pragma once
// Writes a PNG file with libpng's defaults: adaptive filters, zlib level 6.

#include <png.h>

#include <cstdint>
#include <vector>

#include "image/image.h"

namespace glibra::bench {

/// The picture has three bytes per pixel.
inline std::vector<std::uint8_t> writeByLibpng(const image::Image& picture) {
    std::vector<std::uint8_t> file;
    png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
    png_infop info = png_create_info_struct(png);
    const auto append = [](png_structp writer, png_bytep data, std::size_t size) {
        auto* to = static_cast<std::vector<std::uint8_t>*>(png_get_io_ptr(writer));
        to->insert(to->end(), data, data + size);
    };
    png_set_write_fn(png, &file, append, nullptr);
    png_set_IHDR(png, info, static_cast<png_uint_32>(picture.width), static_cast<png_uint_32>(picture.height),
                 8, PNG_COLOR_TYPE_RGB, PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT,
                 PNG_FILTER_TYPE_DEFAULT);
    png_write_info(png, info);
    for (int y = 0; y < picture.height; ++y)
        png_write_row(png, reinterpret_cast<png_const_bytep>(picture.row(y).data()));
    png_write_end(png, info);
    png_destroy_write_struct(&png, &info);
    return file;
}

}  // namespace glibra::bench
