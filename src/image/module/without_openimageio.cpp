// JPEG with libjpeg, for a module without OpenImageIO.

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfOutputFile.h>
#include <ImfStringAttribute.h>
#include <ImfThreading.h>
#include <half.h>
#include <jpeglib.h>
#include <tiffio.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdarg>
#include <cstdio>  // jpeglib.h needs it
#include <cstdlib>
#include <cstring>
#include <memory>
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

// TIFF with libtiff, for a module without OpenImageIO: the kinds of samples that image/foreign_headers.cpp
// lets through.

/// A file in memory, and the first thing that is wrong with it.
struct Memory {
    const unsigned char* bytes = nullptr;  ///< that are read
    uint64_t size = 0, at = 0;
    std::vector<unsigned char> written;
    std::string problem;
};

Memory& memoryOf(thandle_t handle) {
    return *static_cast<Memory*>(handle);
}

tmsize_t readBytes(thandle_t handle, void* to, tmsize_t count) {
    Memory& memory = memoryOf(handle);
    const uint64_t left = memory.at < memory.size ? memory.size - memory.at : 0;
    const uint64_t taken = std::min(static_cast<uint64_t>(count), left);
    if (taken > 0) std::memcpy(to, memory.bytes + memory.at, taken);
    memory.at += taken;
    return static_cast<tmsize_t>(taken);
}

tmsize_t writeBytes(thandle_t handle, void* from, tmsize_t count) {
    Memory& memory = memoryOf(handle);
    const auto* const bytes = static_cast<const unsigned char*>(from);
    const auto length = static_cast<size_t>(count);
    try {
        memory.written.resize(std::max(memory.written.size(), memory.at + length));
    } catch (const std::exception&) {
        return 0;
    }
    std::copy_n(bytes, length, memory.written.begin() + static_cast<ptrdiff_t>(memory.at));
    memory.at += length;
    memory.size = memory.written.size();
    return count;
}

toff_t seekTo(thandle_t handle, toff_t offset, int from) {
    Memory& memory = memoryOf(handle);
    memory.at = offset + (from == SEEK_CUR ? memory.at : from == SEEK_END ? memory.size : 0);
    return memory.at;
}

int onError(TIFF* /*file*/, void* memory, const char* /*place*/, const char* format, va_list values) {
    std::array<char, 500> text{};
    if (std::vsnprintf(text.data(), text.size(), format, values) > 0 && memoryOf(memory).problem.empty())
        memoryOf(memory).problem = text.data();
    return 1;
}

struct CloseTiff {
    void operator()(TIFF* file) const { TIFFClose(file); }
};
using Tiff = std::unique_ptr<TIFF, CloseTiff>;

[[noreturn]] void fail(const Memory& memory) {
    throw Failure{memory.problem.empty() ? "damaged" : memory.problem};
}

Tiff open(Memory& memory, const char* mode) {
    const std::unique_ptr<TIFFOpenOptions, void (*)(TIFFOpenOptions*)> options(TIFFOpenOptionsAlloc(),
                                                                               TIFFOpenOptionsFree);
    TIFFOpenOptionsSetErrorHandlerExtR(options.get(), onError, &memory);
    TIFFOpenOptionsSetWarningHandlerExtR(
        options.get(), [](TIFF*, void*, const char*, const char*, va_list) { return 1; }, nullptr);
    Tiff file(TIFFClientOpenExt(
        "picture.tiff", mode, &memory, readBytes, writeBytes, seekTo, [](thandle_t) { return 0; },
        [](thandle_t handle) { return memoryOf(handle).size; }, [](thandle_t, void**, toff_t*) { return 0; },
        [](thandle_t, void*, toff_t) {}, options.get()));
    if (!file) fail(memory);
    memory.problem.clear();  // of fields that can be left out
    return file;
}

/// What the fields of a file say.
struct Layout {
    uint32_t width = 0, height = 0, depth = 1;
    uint16_t bits = 1, samples = 1, meaning = PHOTOMETRIC_MINISBLACK, planes = PLANARCONFIG_CONTIG,
             compression = COMPRESSION_NONE, format = SAMPLEFORMAT_UINT;
    int alpha = -1;  ///< the sample that is alpha; -1: none

    explicit Layout(TIFF* file) {
        TIFFGetField(file, TIFFTAG_IMAGEWIDTH, &width);
        TIFFGetField(file, TIFFTAG_IMAGELENGTH, &height);
        TIFFGetFieldDefaulted(file, TIFFTAG_IMAGEDEPTH, &depth);
        TIFFGetFieldDefaulted(file, TIFFTAG_BITSPERSAMPLE, &bits);
        TIFFGetFieldDefaulted(file, TIFFTAG_SAMPLESPERPIXEL, &samples);
        TIFFGetFieldDefaulted(file, TIFFTAG_PLANARCONFIG, &planes);
        TIFFGetFieldDefaulted(file, TIFFTAG_COMPRESSION, &compression);
        TIFFGetFieldDefaulted(file, TIFFTAG_SAMPLEFORMAT, &format);
        meaning = samples == 1 ? PHOTOMETRIC_MINISBLACK : PHOTOMETRIC_RGB;
        TIFFGetField(file, TIFFTAG_PHOTOMETRIC, &meaning);
        if (depth > 1) throw Failure{"it is a volume"};
        if (width == 0 || height == 0) throw Failure{"it holds no pixels"};
        findAlpha(file);
    }

    [[nodiscard]] bool isGrey() const {
        return meaning == PHOTOMETRIC_MINISBLACK || meaning == PHOTOMETRIC_MINISWHITE;
    }
    [[nodiscard]] int colors() const { return isGrey() ? 1 : 3; }
    /// What the library turns into bytes by itself: what is not RGB.
    [[nodiscard]] bool isConverted() const {
        return meaning == PHOTOMETRIC_YCBCR ||
               (compression == COMPRESSION_JPEG && samples != 3 && meaning != PHOTOMETRIC_PALETTE);
    }
    /// The component type that holds the samples without loss.
    [[nodiscard]] int type() const {
        if (isConverted() || meaning == PHOTOMETRIC_PALETTE) return kGlibraU8;
        if (format == SAMPLEFORMAT_INT || format == SAMPLEFORMAT_IEEEFP || bits > 16) return kGlibraF32;
        return bits <= 8 ? kGlibraU8 : kGlibraU16;
    }

  private:
    void findAlpha(TIFF* file) {
        if (meaning == PHOTOMETRIC_SEPARATED || meaning == PHOTOMETRIC_PALETTE) return;
        if (samples == 2 || samples == 4) alpha = samples - 1;
        uint16_t count = 0;
        const uint16_t* kinds = nullptr;
        TIFFGetField(file, TIFFTAG_EXTRASAMPLES, &count, &kinds);
        for (int i = 0; i < count && colors() + i < samples; ++i) {
            if (kinds[i] != EXTRASAMPLE_UNSPECIFIED)
                alpha = colors() + i;
            else if (alpha == colors() + i)
                alpha = -1;
        }
    }
};

/// Samples one after the other, as they are stored: numbers of 8, 16 and 32 bits as this processor has them,
/// others as bits, the highest first.
uint32_t sampleAt(const unsigned char* from, uint32_t bits, size_t index) {
    if (bits == 32) {
        uint32_t value = 0;
        std::memcpy(&value, from + 4 * index, sizeof value);
        return value;
    }
    if (bits == 16) {
        uint16_t value = 0;
        std::memcpy(&value, from + 2 * index, sizeof value);
        return value;
    }
    uint32_t value = 0;
    for (size_t bit = index * bits; bit < (index + 1) * bits; ++bit)
        value = value << 1U | (static_cast<uint32_t>(from[bit / 8]) >> (7 - bit % 8) & 1U);
    return value;
}

/// A sample as a number. Whole numbers with a sign keep their value; those without one are fractions of their
/// range.
float numberOf(const Layout& layout, uint32_t raw) {
    if (layout.format == SAMPLEFORMAT_IEEEFP) {
        if (layout.bits == 16) return imath_half_to_float(static_cast<imath_half_bits_t>(raw));
        float value = 0;
        std::memcpy(&value, &raw, sizeof value);
        return value;
    }
    if (layout.format != SAMPLEFORMAT_INT) return static_cast<float>(raw) * (1.F / 4294967295.F);
    const auto value = static_cast<float>(layout.bits == 8    ? static_cast<int8_t>(raw)
                                          : layout.bits == 16 ? static_cast<int16_t>(raw)
                                                              : static_cast<int32_t>(raw));
    const float largest = std::ldexp(1.F, layout.bits - 1) - (layout.bits < 24 ? 1.F : 0.F);
    return value * (1.F / largest) * largest;  // the rounding of OpenImageIO
}

/// Puts a sample into a component of the pixels.
void put(const Layout& layout, void* pixels, size_t component, uint32_t raw) {
    const uint64_t highest = (uint64_t{1} << layout.bits) - 1;
    switch (layout.type()) {
        case kGlibraU8:
            static_cast<uint8_t*>(pixels)[component] = static_cast<uint8_t>(raw * uint64_t{255} / highest);
            break;
        case kGlibraU16:
            static_cast<uint16_t*>(pixels)[component] =
                static_cast<uint16_t>(raw * uint64_t{65535} / highest);
            break;
        default:
            static_cast<float*>(pixels)[component] = numberOf(layout, raw);
    }
}

/// Calls take(x, y, plane, count, samples) for all rows, or the rows of all tiles.
template <class Take>
void forEachRow(TIFF* file, const Layout& layout, const Memory& memory, Take take) {
    const auto planes =
        static_cast<uint16_t>(layout.planes == PLANARCONFIG_SEPARATE ? layout.samples : uint16_t{1});
    const bool isTiled = TIFFIsTiled(file) != 0;
    std::vector<unsigned char> buffer(isTiled ? TIFFTileSize64(file) : TIFFScanlineSize64(file));
    if (buffer.empty()) fail(memory);
    uint32_t wide = layout.width, tall = 1;
    TIFFGetField(file, TIFFTAG_TILEWIDTH, &wide);
    TIFFGetField(file, TIFFTAG_TILELENGTH, &tall);
    if (!isTiled) {
        wide = layout.width;
        tall = 1;
    }
    const size_t rowBytes = isTiled ? TIFFTileRowSize64(file) : buffer.size();
    for (uint16_t plane = 0; plane < planes; ++plane)
        for (uint32_t top = 0; top < layout.height; top += tall)
            for (uint32_t left = 0; left < layout.width; left += wide) {
                if (isTiled ? TIFFReadTile(file, buffer.data(), left, top, 0, plane) < 0
                            : TIFFReadScanline(file, buffer.data(), top, plane) < 0)
                    fail(memory);
                for (uint32_t row = 0; row < tall && top + row < layout.height; ++row)
                    take(left, top + row, plane, std::min(wide, layout.width - left),
                         buffer.data() + row * rowBytes);
            }
}

/// Every sample in its component; what has a component of its own besides. Inks are in the four components.
void readSamples(TIFF* file, const Layout& layout, const Memory& memory, void* pixels) {
    std::array<const uint16_t*, 3> map{};
    if (layout.meaning == PHOTOMETRIC_PALETTE &&
        TIFFGetField(file, TIFFTAG_COLORMAP, &map[0], &map[1], &map[2]) == 0)
        throw Failure{"it has no palette"};
    const bool isInks = layout.meaning == PHOTOMETRIC_SEPARATED;
    forEachRow(file, layout, memory,
               [&](uint32_t left, uint32_t y, uint16_t plane, uint32_t count, const unsigned char* row) {
                   const bool isSeparate = layout.planes == PLANARCONFIG_SEPARATE;
                   const size_t each = isSeparate ? 1 : layout.samples;
                   for (size_t i = 0; i < count * each; ++i) {
                       const size_t sample = isSeparate ? plane : i % each;
                       const size_t at = 4 * (size_t{y} * layout.width + left + i / each);
                       const uint32_t raw = sampleAt(row, layout.bits, i);
                       if (map[0] != nullptr) {
                           for (size_t c = 0; c < 3; ++c)
                               static_cast<uint8_t*>(pixels)[at + c] =
                                   static_cast<uint8_t>(map.at(c)[raw] / 257);
                       } else if (isInks || static_cast<int>(sample) < layout.colors()) {
                           put(layout, pixels, at + sample, raw);
                       } else if (static_cast<int>(sample) == layout.alpha) {
                           put(layout, pixels, at + 3, raw);
                       }
                   }
               });
}

/// Grey in three components, colours of inks, and alpha where there is none.
template <class Value>
void complete(const Layout& layout, Value* pixel, size_t count, Value one) {
    for (; count > 0; --count, pixel += 4) {
        if (layout.isGrey()) pixel[1] = pixel[2] = pixel[0];
        if (layout.meaning == PHOTOMETRIC_SEPARATED) {
            const auto largest = static_cast<float>(one);
            const auto fraction = [&](int c) { return static_cast<float>(pixel[c]) * (1.F / largest); };
            const float rest = 1.F - fraction(3);
            for (int c = 0; c < 3; ++c)
                pixel[c] = static_cast<Value>((1.F - fraction(c)) * rest * largest + .5F);
        }
        if (layout.alpha < 0) pixel[3] = one;
    }
}

/// A field with a value, which the library takes as the type that the field has.
template <class... Values>
void set(TIFF* file, uint32_t field, Values... values) {
    TIFFSetField(file, field, values...);
}

void readTiff(const GlibraReadRequest& request) {
    Memory memory{static_cast<const unsigned char*>(request.bytes), request.size, 0, {}, {}};
    const Tiff file = open(memory, "r");
    const Layout layout(file.get());
    const int type = layout.type();
    void* const pixels = allocate(request, layout.width, layout.height, type);
    const size_t count = size_t{layout.width} * layout.height;
    if (layout.isConverted()) {
        auto* const packed = static_cast<uint32_t*>(pixels);
        if (TIFFReadRGBAImageOriented(file.get(), layout.width, layout.height, packed, ORIENTATION_TOPLEFT,
                                      0) == 0)
            fail(memory);
        for (size_t i = 0; i < count; ++i) static_cast<uint8_t*>(pixels)[4 * i + 3] = 255;
    } else {
        readSamples(file.get(), layout, memory, pixels);
        if (type == kGlibraU8) complete<uint8_t>(layout, static_cast<uint8_t*>(pixels), count, 255);
        if (type == kGlibraU16) complete<uint16_t>(layout, static_cast<uint16_t*>(pixels), count, 65535);
        if (type == kGlibraF32) complete<float>(layout, static_cast<float*>(pixels), count, 1.F);
    }
    // The library returns the readable part of some short files.
    if (!memory.problem.empty()) fail(memory);
}

void writeTiff(const GlibraWriteRequest& request) {
    const auto from = static_cast<size_t>(request.components),
               components = request.keepsAlpha != 0 ? from : 3;
    const size_t bytes = request.type == kGlibraU8 ? 1 : request.type == kGlibraU16 ? 2 : 4;
    const auto width = static_cast<size_t>(request.width), height = static_cast<size_t>(request.height);
    constexpr size_t kLargest = size_t{4000} << 20;  // beyond it the places of strips need 64 bits
    constexpr int kRowsPerStrip = 32, kEffort = 6;
    const bool isFloating = request.type == kGlibraF32;
    Memory memory;
    Tiff file = open(memory, width * height * components * bytes > kLargest ? "w8" : "w");
    TIFF* const to = file.get();
    set(to, TIFFTAG_IMAGEWIDTH, request.width);
    set(to, TIFFTAG_IMAGELENGTH, request.height);
    set(to, TIFFTAG_ROWSPERSTRIP, kRowsPerStrip);
    set(to, TIFFTAG_SAMPLESPERPIXEL, static_cast<int>(components));
    set(to, TIFFTAG_ORIENTATION, ORIENTATION_TOPLEFT);
    set(to, TIFFTAG_BITSPERSAMPLE, static_cast<int>(8 * bytes));
    set(to, TIFFTAG_SAMPLEFORMAT, isFloating ? SAMPLEFORMAT_IEEEFP : SAMPLEFORMAT_UINT);
    set(to, TIFFTAG_PHOTOMETRIC, PHOTOMETRIC_RGB);
    set(to, TIFFTAG_COMPRESSION, COMPRESSION_ADOBE_DEFLATE);
    set(to, TIFFTAG_PREDICTOR, isFloating ? PREDICTOR_FLOATINGPOINT : PREDICTOR_HORIZONTAL);
    set(to, TIFFTAG_ZIPQUALITY, kEffort);
    set(to, TIFFTAG_PLANARCONFIG, PLANARCONFIG_CONTIG);
    const uint16_t alpha = EXTRASAMPLE_UNASSALPHA;
    if (components == 4) set(to, TIFFTAG_EXTRASAMPLES, 1, &alpha);
    set(to, TIFFTAG_DATETIME, "1970:01:01 00:00:00");
    if (request.comment != nullptr && *request.comment != 0)
        set(to, TIFFTAG_IMAGEDESCRIPTION, request.comment);
    TIFFCheckpointDirectory(to);  // the directory stands before the pixels
    std::vector<unsigned char> row(width * components * bytes);
    for (size_t y = 0; y < height; ++y) {
        const auto* at = static_cast<const unsigned char*>(request.pixels) + y * width * from * bytes;
        for (size_t x = 0; x < width; ++x, at += from * bytes)
            std::memcpy(row.data() + x * components * bytes, at, components * bytes);
        if (TIFFWriteScanline(to, row.data(), static_cast<uint32_t>(y), 0) < 0) fail(memory);
    }
    if (TIFFWriteDirectory(to) == 0) fail(memory);  // in the same place
    file.reset();
    if (!memory.problem.empty()) fail(memory);
    writeFile(request.path, memory.written);
}

// What the module has where OpenImageIO is not: JPEG, TIFF, WebP and EXR with their own libraries, with the
// pixels that OpenImageIO reads and the files that it writes.

class ExrFile : public Imf::OStream {
  public:
    ExrFile() : OStream("picture.exr") {}

    void write(const char from[], int count) override {
        bytes.resize(std::max(bytes.size(), at_ + static_cast<size_t>(count)));
        std::copy_n(from, count, bytes.begin() + static_cast<ptrdiff_t>(at_));
        at_ += static_cast<size_t>(count);
    }
    uint64_t tellp() override { return at_; }
    void seekp(uint64_t at) override { at_ = at; }

    std::vector<unsigned char> bytes;

  private:
    uint64_t at_ = 0;
};

float numberAt(const GlibraWriteRequest& request, size_t index) {
    if (request.type == kGlibraU8)
        return static_cast<float>(static_cast<const uint8_t*>(request.pixels)[index]) * (1.F / 255);
    if (request.type == kGlibraU16)
        return static_cast<float>(static_cast<const uint16_t*>(request.pixels)[index]) * (1.F / 65535);
    return static_cast<const float*>(request.pixels)[index];
}

/// Floats, ZIP compression.
void writeExr(const GlibraWriteRequest& request) {
    Imf::setGlobalThreadCount(0);
    const auto from = static_cast<size_t>(request.components),
               components = request.keepsAlpha != 0 ? from : 3;
    const auto width = static_cast<size_t>(request.width), height = static_cast<size_t>(request.height);
    std::vector<float> pixels(width * height * components);
    for (size_t i = 0; i < pixels.size(); ++i)
        pixels[i] = numberAt(request, i / components * from + i % components);

    Imf::Header header(request.width, request.height);
    header.compression() = Imf::ZIP_COMPRESSION;
    header.insert("capDate", Imf::StringAttribute("1970:01:01 00:00:00"));
    if (request.comment != nullptr && *request.comment != 0)
        header.insert("comments", Imf::StringAttribute(request.comment));
    Imf::FrameBuffer buffer;
    constexpr std::array<const char*, 4> kNames{"R", "G", "B", "A"};
    for (size_t c = 0; c < components; ++c) {
        header.channels().insert(kNames.at(c), Imf::Channel(Imf::FLOAT));
        buffer.insert(kNames.at(c),
                      Imf::Slice(Imf::FLOAT, reinterpret_cast<char*>(pixels.data() + c),
                                 components * sizeof(float), components * width * sizeof(float)));
    }
    ExrFile stream;
    {
        Imf::OutputFile file(stream, header);
        file.setFrameBuffer(buffer);
        file.writePixels(request.height);
    }
    writeFile(request.path, stream.bytes);
}

constexpr std::array kCodecs{
    Codec{"jpeg", readJpeg, writeJpeg},
    Codec{"tiff", readTiff, writeTiff},
    Codec{"webp", readWebp, writeWebp},
    Codec{"openexr", readExr, writeExr},
};

constexpr Codec kNone{"", [](const GlibraReadRequest&) { throw Unknown{}; },
                      [](const GlibraWriteRequest&) { throw Unknown{}; }};

}  // namespace

const Codec& codecFor(std::string_view format) {
    const auto* const found = std::find_if(kCodecs.begin(), kCodecs.end(),
                                           [&](const Codec& each) { return each.format == format; });
    return found == kCodecs.end() ? kNone : *found;
}

}  // namespace glibra::module
