// Photoshop and ICO files, byte by byte: modes and depths.

#include <cstring>
#include <string_view>

#include "variant_maker.h"

namespace glibra::image::testing {
namespace {

enum Mode : std::uint32_t {
    inBitmap = 0,
    inGrey = 1,
    inIndexed = 2,
    inRgb = 3,
    inInks = 4,
    inChannels = 7,
    inDuotone = 8,
    inLab = 9
};

struct PhotoshopForm {
    Mode mode;
    std::uint32_t bits, channels;
    bool isPacked;
};

constexpr std::uint32_t kForeignWide = 8, kForeignTall = 3;

double photoshopValue(std::uint32_t raw, std::uint32_t bits) {
    return bits == 32 ? raw / 256. : bits == 1 ? 1 - raw : static_cast<double>(raw) / ((1U << bits) - 1);
}

std::uint32_t photoshopRaw(const PhotoshopForm& form, std::uint32_t at, std::uint32_t channel) {
    const std::uint32_t seed = hash(at + 100 * channel);
    return form.bits == 32   ? seed % 300
           : form.bits == 16 ? seed & 0xffffU
           : form.bits == 1  ? seed & 1U
                             : seed & 0xffU;
}

/// Adobe, "Photoshop File Formats Specification".
Variant photoshopVariant(const PhotoshopForm& form) {
    Variant variant;
    variant.name = "psd-" + std::to_string(form.mode) + "-" + std::to_string(form.bits) + "-" +
                   std::to_string(form.channels) + (form.isPacked ? "p" : "") + ".psd";
    variant.width = kForeignWide;
    variant.height = kForeignTall;
    Bytes& to = variant.file;
    for (const char each : {'8', 'B', 'P', 'S'}) to.push_back(static_cast<std::byte>(each));
    putBig(to, 1, 2);
    to.insert(to.end(), 6, std::byte{0});
    putBig(to, form.channels, 2);
    putBig(to, kForeignTall, 4);
    putBig(to, kForeignWide, 4);
    putBig(to, form.bits, 2);
    putBig(to, form.mode, 2);
    const std::uint32_t map = form.mode == inIndexed ? 768 : form.mode == inDuotone ? 100 : 0;
    putBig(to, map, 4);
    for (std::uint32_t i = 0; i < map; ++i) to.push_back(static_cast<std::byte>(hash(i + 9000)));
    const std::size_t mapAt = to.size() - map;
    putBig(to, 0, 4);  // resources
    putBig(to, 0, 4);  // layers
    putBig(to, form.isPacked ? 1 : 0, 2);

    const std::uint32_t rowBytes = (kForeignWide * form.bits + 7) / 8;
    if (form.isPacked)
        for (std::uint32_t i = 0; i < form.channels * kForeignTall; ++i) putBig(to, rowBytes + 1, 2);
    for (std::uint32_t channel = 0; channel < form.channels; ++channel)
        for (std::uint32_t y = 0; y < kForeignTall; ++y) {
            if (form.isPacked) putBig(to, rowBytes - 1, 1);
            std::uint32_t bits = 0;
            for (std::uint32_t x = 0; x < kForeignWide; ++x) {
                const std::uint32_t raw = photoshopRaw(form, x + kForeignWide * y, channel);
                if (form.bits == 1) {
                    bits = bits << 1U | raw;
                } else if (form.bits == 32) {
                    const auto value = static_cast<float>(photoshopValue(raw, 32));
                    std::uint32_t stored = 0;
                    std::memcpy(&stored, &value, 4);
                    putBig(to, stored, 4);
                } else {
                    putBig(to, raw, static_cast<int>(form.bits / 8));
                }
            }
            if (form.bits == 1) putBig(to, bits, 1);
        }

    for (std::uint32_t at = 0; at < kForeignWide * kForeignTall; ++at) {
        std::array<double, 5> values{1, 1, 1, 1, 1};
        for (std::uint32_t c = 0; c < form.channels && c < 5; ++c)
            values.at(c) = photoshopValue(photoshopRaw(form, at, c), form.bits);
        std::array<double, 4> pixel{values[0], values[1], values[2], form.channels > 3 ? values[3] : 1};
        if (form.mode == inInks)  // full ink is 0
            pixel = {values[0] * values[3], values[1] * values[3], values[2] * values[3],
                     form.channels > 4 ? values[4] : 1};
        if (form.mode == inGrey || form.mode == inBitmap || form.mode == inDuotone)
            pixel = {values[0], values[0], values[0], form.channels > 1 ? values[1] : 1};
        if (form.mode == inIndexed) {
            const std::uint32_t entry = photoshopRaw(form, at, 0);
            for (std::size_t c = 0; c < 3; ++c)
                pixel.at(c) = std::to_integer<int>(to[mapAt + 256 * c + entry]) / 255.;
            pixel[3] = 1;
        }
        variant.pixels.push_back(pixel);
    }
    return variant;
}

/// A picture of an icon: a DIB of twice its height whose second half is a mask.
Variant iconVariant(std::uint32_t bits, bool hasMask) {
    constexpr std::uint32_t kSide = 16, kHeader = 40;
    Variant variant;
    variant.name = "ico-" + std::to_string(bits) + (hasMask ? "m" : "") + ".ico";
    variant.width = kSide;
    variant.height = kSide;
    const std::uint32_t colors = bits <= 8 ? 1U << bits : 0, rowBytes = (kSide * bits + 31) / 32 * 4,
                        maskRow = 4;
    Bytes& to = variant.file;
    const std::uint32_t size = kHeader + 4 * colors + kSide * (rowBytes + maskRow);
    for (const std::uint32_t each : {0U, 1U, 1U}) putLittle(to, each, 2);
    putLittle(to, kSide | kSide << 8U, 4);
    putLittle(to, 1, 2);
    putLittle(to, bits, 2);
    putLittle(to, size, 4);
    putLittle(to, 22, 4);
    putLittle(to, kHeader, 4);
    putLittle(to, kSide, 4);
    putLittle(to, 2 * kSide, 4);
    putLittle(to, 1, 2);
    putLittle(to, bits, 2);
    for (int i = 0; i < 6; ++i) putLittle(to, i == 4 ? colors : 0, 4);
    std::vector<std::array<double, 4>> map;
    for (std::uint32_t i = 0; i < colors; ++i) {
        const std::uint32_t entry = hash(i + 5) & 0xffffffU;
        putLittle(to, entry, 4);
        map.push_back({(entry >> 16U) / 255., (entry >> 8U & 255U) / 255., (entry & 255U) / 255., 1});
    }
    variant.pixels.resize(std::size_t{kSide} * kSide);
    for (std::uint32_t y = kSide; y-- > 0;) {  // from below
        std::uint32_t packed = 0;
        for (std::uint32_t x = 0; x < kSide; ++x) {
            const std::uint32_t raw = bits >= 24 ? hash(x + 64 * y) & (bits == 24 ? 0xffffffU : 0xffffffffU)
                                                 : hash(x + 64 * y) & ((1U << bits) - 1);
            std::array<double, 4> pixel{(raw >> 16U & 255U) / 255., (raw >> 8U & 255U) / 255.,
                                        (raw & 255U) / 255., bits == 32 ? (raw >> 24U) / 255. : 1};
            if (bits <= 8) pixel = map[raw];
            if (hasMask && (x + y) % 3 == 0 && bits < 32) pixel[3] = 0;
            variant.pixels[std::size_t{y} * kSide + x] = pixel;
            if (bits >= 24) {
                putLittle(to, raw, static_cast<int>(bits / 8));
            } else {
                packed = packed << bits | raw;
                if ((x + 1) * bits % 8 == 0) {
                    putLittle(to, packed & 255U, 1);
                    packed = 0;
                }
            }
        }
        to.resize(to.size() + rowBytes - (kSide * bits + 7) / 8);
    }
    for (std::uint32_t y = kSide; y-- > 0;) {
        std::uint32_t row = 0;
        for (std::uint32_t x = 0; x < kSide; ++x) row = row << 1U | (hasMask && (x + y) % 3 == 0 ? 1U : 0U);
        putLittle(to, row >> 8U | (row & 255U) << 8U, 4);
    }
    return variant;
}

}  // namespace

std::vector<Variant> photoshopVariants() {
    std::vector<Variant> variants;
    for (const bool isPacked : {false, true}) {
        variants.push_back(photoshopVariant({inBitmap, 1, 1, isPacked}));
        for (const std::uint32_t bits : {8U, 16U, 32U}) {
            for (const std::uint32_t count : {1U, 2U})
                variants.push_back(photoshopVariant({inGrey, bits, count, isPacked}));
            for (const std::uint32_t count : {3U, 4U, 5U})
                variants.push_back(photoshopVariant({inRgb, bits, count, isPacked}));
            for (const std::uint32_t count : {4U, 5U})
                variants.push_back(photoshopVariant({inInks, bits, count, isPacked}));
            for (const Mode mode : {inChannels, inLab})
                variants.push_back(photoshopVariant({mode, bits, 3, isPacked}));
            variants.push_back(photoshopVariant({inDuotone, bits, 1, isPacked}));
        }
        variants.push_back(photoshopVariant({inIndexed, 8, 1, isPacked}));
    }
    return variants;
}

std::vector<Variant> iconVariants() {
    std::vector<Variant> variants;
    for (const std::uint32_t bits : {1U, 4U, 8U, 16U, 24U, 32U})
        for (const bool hasMask : {false, true}) variants.push_back(iconVariant(bits, hasMask));
    return variants;
}

std::vector<std::pair<std::string, Bytes>> blockFiles() {
    std::vector<std::pair<std::string, Bytes>> files;
    const auto add = [&](const std::string& name, std::string_view code, std::uint32_t dxgi,
                         std::uint32_t bytes) {
        constexpr std::uint32_t kWideBlocks = 6, kTallBlocks = 5;
        Bytes to;
        for (const char each : std::string_view("DDS ")) to.push_back(static_cast<std::byte>(each));
        for (const std::uint32_t each :
             {124U, 0x81007U, 4 * kTallBlocks, 4 * kWideBlocks, kWideBlocks * kTallBlocks * bytes})
            putLittle(to, each, 4);
        to.resize(76);
        putLittle(to, 32, 4);
        putLittle(to, 4, 4);
        for (const char each : code) to.push_back(static_cast<std::byte>(each));
        to.resize(108);
        putLittle(to, 0x1000, 4);
        to.resize(128);
        if (dxgi != 0)
            for (const std::uint32_t each : {dxgi, 3U, 0U, 1U, 0U}) putLittle(to, each, 4);
        for (std::uint32_t i = 0; i < kWideBlocks * kTallBlocks * bytes; ++i)
            to.push_back(static_cast<std::byte>(hash(i + 17 * dxgi)));
        files.emplace_back("blocks-" + name + ".dds", to);
    };
    for (const char* const name : {"DXT1", "DXT3", "DXT5", "BC4U", "ATI1", "BC5U", "ATI2", "BC5S"})
        add(name, name, 0,
            name == std::string_view("DXT1") || name == std::string_view("BC4U") ||
                    name == std::string_view("ATI1")
                ? 8
                : 16);
    for (std::uint32_t dxgi = 70; dxgi <= 99; ++dxgi)
        if (dxgi <= 84 || dxgi >= 94)
            add(std::to_string(dxgi), "DX10", dxgi, dxgi <= 72 || (dxgi >= 79 && dxgi <= 81) ? 8 : 16);
    return files;
}

bool isSignedBlocks(const std::string& name) {
    return name == "blocks-81.dds" || name == "blocks-84.dds" || name == "blocks-BC5S.dds";
}

}  // namespace glibra::image::testing
