#include "variant_maker.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>

namespace glibra::image::testing {
namespace {

using Numbers = std::vector<std::uint32_t>;

constexpr int kWide = 11, kTall = 5;

void putText(Bytes& to, const std::string& text) {
    for (const char each : text) to.push_back(static_cast<std::byte>(each));
}
void putByte(Bytes& to, std::uint32_t value) {
    to.push_back(static_cast<std::byte>(value));
}
void putBytes(Bytes& to, const Bytes& more) {
    to.insert(to.end(), more.begin(), more.end());
}
std::size_t pixelCount() {
    return static_cast<std::size_t>(kWide) * kTall;
}

/// Runs of equal values and single ones, so that run lengths have both.
Numbers runsOfNumbers(std::uint32_t most, std::uint32_t seed) {
    Numbers numbers;
    while (numbers.size() < pixelCount()) {
        const auto at = seed + static_cast<std::uint32_t>(numbers.size());
        const std::uint32_t value = most == 0xffffffffU ? hash(at) : hash(at) % (most + 1);
        const std::size_t length = hash(at + 999) % 3 == 0 ? 1 + hash(at + 7) % 9 : 1;
        for (std::size_t i = 0; i < length && numbers.size() < pixelCount(); ++i) numbers.push_back(value);
    }
    return numbers;
}

double fraction(std::uint32_t pixel, std::uint32_t first, std::uint32_t bits) {
    const std::uint32_t most = bits == 32 ? 0xffffffffU : (1U << bits) - 1;
    return static_cast<double>(pixel >> first & most) / most;
}

std::array<double, 4> targaColor(std::uint32_t pixel, int bits, bool attributes) {
    if (bits <= 16)
        return {fraction(pixel, 10, 5), fraction(pixel, 5, 5), fraction(pixel, 0, 5),
                bits == 16 && attributes ? fraction(pixel, 15, 1) : 1};
    return {fraction(pixel, 16, 8), fraction(pixel, 8, 8), fraction(pixel, 0, 8),
            bits == 32 ? fraction(pixel, 24, 8) : 1};
}

Bytes targaRuns(const Numbers& pixels, int bytes) {
    Bytes to;
    for (std::size_t at = 0; at < pixels.size();) {
        std::size_t run = 1;
        while (at + run < pixels.size() && run < 128 && pixels[at + run] == pixels[at]) ++run;
        if (run > 1) {
            putByte(to, static_cast<std::uint32_t>(0x7f + run));
            putLittle(to, pixels[at], bytes);
            at += run;
            continue;
        }
        std::size_t single = 1;
        while (at + single < pixels.size() && single < 5 &&
               (at + single + 1 == pixels.size() || pixels[at + single] != pixels[at + single + 1]))
            ++single;
        putByte(to, static_cast<std::uint32_t>(single - 1));
        for (std::size_t i = 0; i < single; ++i) putLittle(to, pixels[at + i], bytes);
        at += single;
    }
    return to;
}

struct TargaForm {
    int kind, bits, entryBits;
    int first;
    bool packed, rightToLeft, topDown, attributes;
};

Variant targaVariant(const TargaForm& form) {
    Variant variant;
    variant.width = kWide;
    variant.height = kTall;
    variant.name = "tga-" + std::to_string(form.kind) + "-" + std::to_string(form.bits) + "-" +
                   std::to_string(form.entryBits) + "-" + std::to_string(form.first) +
                   (form.packed ? "p" : "") + (form.rightToLeft ? "r" : "") + (form.topDown ? "t" : "") +
                   (form.attributes ? "a" : "") + ".tga";
    constexpr std::uint32_t kEntries = 13;
    const int entries = form.kind == 1 ? kEntries : 0, bytes = (form.bits + 7) / 8;
    const std::uint32_t most = form.kind == 1    ? kEntries - 1
                               : form.bits == 32 ? 0xffffffffU
                                                 : (1U << form.bits) - 1;
    Numbers numbers = runsOfNumbers(most, static_cast<std::uint32_t>(form.bits));
    Bytes map;
    std::vector<std::array<double, 4>> colors;
    for (std::uint32_t i = 0; i < static_cast<std::uint32_t>(entries); ++i) {
        const std::uint32_t entry = hash(i + 77) & (form.entryBits == 15 ? 0x7fffU : 0xffffffffU);
        putLittle(map, entry, (form.entryBits + 7) / 8);
        colors.push_back(targaColor(entry, form.entryBits, false));
    }
    for (int y = 0; y < kTall; ++y)
        for (int x = 0; x < kWide; ++x) {
            const int column = form.rightToLeft ? kWide - 1 - x : x, row = form.topDown ? y : kTall - 1 - y;
            const std::uint32_t number = numbers[static_cast<std::size_t>(row * kWide + column)];
            if (form.kind == 1) variant.pixels.push_back(colors[number]);
            if (form.kind == 2) variant.pixels.push_back(targaColor(number, form.bits, form.attributes));
            if (form.kind == 3) {
                const double grey = fraction(number, 0, 8);
                variant.pixels.push_back({grey, grey, grey, form.bits == 16 ? fraction(number, 8, 8) : 1});
            }
        }
    if (form.kind == 1)
        for (auto& each : numbers) each += static_cast<std::uint32_t>(form.first);

    Bytes& to = variant.file;
    putByte(to, 3);  // of identification
    putByte(to, form.kind == 1 ? 1 : 0);
    putByte(to, static_cast<std::uint32_t>(form.kind + (form.packed ? 8 : 0)));
    putLittle(to, static_cast<std::uint32_t>(form.kind == 1 ? form.first : 0), 2);
    putLittle(to, static_cast<std::uint32_t>(entries), 2);
    putByte(to, static_cast<std::uint32_t>(form.kind == 1 ? form.entryBits : 0));
    putLittle(to, 0, 4);
    putLittle(to, kWide, 2);
    putLittle(to, kTall, 2);
    putByte(to, static_cast<std::uint32_t>(form.bits));
    putByte(to, (form.rightToLeft ? 0x10U : 0U) | (form.topDown ? 0x20U : 0U) |
                    (form.attributes ? (form.bits == 32 ? 8U : 1U) : 0U));
    putText(to, "id.");
    putBytes(to, map);
    if (form.packed)
        putBytes(to, targaRuns(numbers, bytes));
    else
        for (const auto each : numbers) putLittle(to, each, bytes);
    return variant;
}

struct PnmForm {
    int kind;
    std::uint32_t most;
    std::string between, headerEnd;
};

Variant pnmVariant(const PnmForm& form, int number) {
    Variant variant;
    variant.width = kWide;
    variant.height = kTall;
    variant.name = "pnm-" + std::to_string(form.kind) + "-" + std::to_string(form.most) + "-" +
                   std::to_string(number) + ".pnm";
    const bool isBitmap = form.kind == 1 || form.kind == 4, isPlain = form.kind <= 3;
    const std::size_t channels = form.kind % 3 == 0 ? 3 : 1;
    Bytes& to = variant.file;
    putText(to, "P" + std::to_string(form.kind) + form.between + std::to_string(kWide) + form.between +
                    std::to_string(kTall));
    if (!isBitmap) putText(to, form.between + std::to_string(form.most));
    putText(to, form.headerEnd);
    std::uint32_t seed = form.most, bits = 0;
    for (int y = 0; y < kTall; ++y)
        for (int x = 0; x < kWide; ++x) {
            std::array<double, 4> pixel{0, 0, 0, 1};
            for (std::size_t c = 0; c < channels; ++c) {
                const std::uint32_t value = hash(++seed) % (form.most + 1);
                pixel.at(c) = static_cast<double>(value) / form.most;
                if (form.kind == 1) {
                    putText(to, std::to_string(value) + (x % 4 == 3 ? form.between : ""));
                } else if (form.kind == 4) {
                    bits = bits << 1U | value;
                    if (x % 8 == 7 || x == kWide - 1) {
                        putByte(to, bits << (7 - static_cast<unsigned>(x % 8)) & 255U);
                        bits = 0;
                    }
                } else if (isPlain) {
                    putText(to, std::to_string(value) + form.between);
                } else {
                    if (form.most > 255) putByte(to, value >> 8);
                    putByte(to, value & 255U);
                }
            }
            if (isBitmap) pixel[0] = 1 - pixel[0];
            if (channels == 1) pixel[1] = pixel[2] = pixel[0];
            variant.pixels.push_back(pixel);
        }
    return variant;
}

enum class HdrPacking { none, old, byComponent };

Variant hdrVariant(const std::string& slow, const std::string& fast, HdrPacking packing) {
    Variant variant;
    const bool slowIsX = slow[1] == 'X';
    const std::size_t slowSize = slowIsX ? kWide : kTall, fastSize = slowIsX ? kTall : kWide;
    // Run lengths by component need eight pixels, so the picture is repeated.
    const std::size_t times = packing == HdrPacking::byComponent ? 2 : 1, length = fastSize * times;
    variant.width = static_cast<int>(slowIsX ? slowSize : length);
    variant.height = static_cast<int>(slowIsX ? length : slowSize);
    variant.name = "hdr-" + slow + fast + std::to_string(static_cast<int>(packing)) + ".hdr";
    variant.pixels.resize(slowSize * length);
    Bytes& to = variant.file;
    putText(to, "#?RADIANCE\n# a comment\nEXPOSURE=2.5\nFORMAT=32-bit_rle_rgbe\n\n" + slow + " " +
                    std::to_string(slowSize) + " " + fast + " " + std::to_string(length) + "\n");
    const Numbers numbers = runsOfNumbers(0xffffffffU, 5);
    for (std::size_t i = 0; i < slowSize; ++i) {
        std::vector<std::array<std::uint32_t, 4>> line;
        for (std::size_t j = 0; j < length; ++j) {
            const std::uint32_t number = numbers[i * fastSize + j % fastSize];
            const std::array<std::uint32_t, 4> rgbe{number & 127U, 128 + (number >> 8U & 127U),
                                                    number >> 16U & 255U, 120 + (number >> 24U) % 16};
            line.push_back(rgbe);
            std::size_t x = slowIsX ? i : j, y = slowIsX ? j : i;
            if ((slowIsX ? slow : fast)[0] == '-') x = static_cast<std::size_t>(variant.width) - 1 - x;
            if ((slowIsX ? fast : slow)[0] == '+') y = static_cast<std::size_t>(variant.height) - 1 - y;
            auto& pixel = variant.pixels[y * static_cast<std::size_t>(variant.width) + x];
            for (std::size_t c = 0; c < 3; ++c)
                pixel.at(c) = std::ldexp(rgbe.at(c), static_cast<int>(rgbe[3]) - 136);
            pixel[3] = 1;
        }
        if (packing == HdrPacking::byComponent) {
            for (const std::uint32_t each : {2U, 2U, 0U, static_cast<std::uint32_t>(length)})
                putByte(to, each);
            for (std::size_t c = 0; c < 4; ++c)
                for (std::size_t j = 0; j < length;) {
                    std::size_t run = 1;
                    while (j + run < length && line[j + run].at(c) == line[j].at(c)) ++run;
                    putByte(to, static_cast<std::uint32_t>(run > 1 ? 128 + run : 1));
                    putByte(to, line[j].at(c));
                    j += run;
                }
            continue;
        }
        for (std::size_t j = 0; j < length;) {
            std::size_t run = 1;
            while (packing == HdrPacking::old && j + run < length && line[j + run] == line[j]) ++run;
            for (const std::uint32_t each : line[j]) putByte(to, each);
            if (run > 1)
                for (const std::uint32_t each : {1U, 1U, 1U, static_cast<std::uint32_t>(run - 1)})
                    putByte(to, each);
            j += run;
        }
    }
    return variant;
}

/// The codes of a GIF picture; the table is cleared after `reset` codes, or never.
Bytes gifCodes(const Numbers& indices, unsigned least, std::size_t reset) {
    Bytes packed;
    std::uint32_t held = 0, heldBits = 0, bits = least + 1;
    const auto put = [&](std::uint32_t code) {
        held |= code << heldBits;
        for (heldBits += bits; heldBits >= 8; heldBits -= 8, held >>= 8U) putByte(packed, held & 255U);
    };
    const std::uint32_t clear = 1U << least;
    std::map<Numbers, std::uint32_t> table;
    std::uint32_t next = 0;
    const auto restart = [&] {
        put(clear);
        table.clear();
        for (std::uint32_t i = 0; i < clear; ++i) table[{i}] = i;
        next = clear + 2;
        bits = least + 1;
    };
    restart();
    Numbers text;
    std::size_t sent = 0;
    for (const auto each : indices) {
        Numbers longer = text;
        longer.push_back(each);
        if (table.contains(longer)) {
            text = longer;
            continue;
        }
        put(table.at(text));
        if (next < 4096) {
            table[longer] = next;
            if (next++ == 1U << bits && bits < 12) ++bits;
        }
        text = {each};
        if (reset > 0 && ++sent % reset == 0) restart();
    }
    put(table.at(text));
    put(clear + 1);
    if (heldBits > 0) putByte(packed, held & 255U);
    Bytes blocks;
    putByte(blocks, least);
    for (std::size_t at = 0; at < packed.size(); at += 255) {
        const std::size_t length = std::min<std::size_t>(255, packed.size() - at);
        putByte(blocks, static_cast<std::uint32_t>(length));
        blocks.insert(blocks.end(), packed.begin() + static_cast<std::ptrdiff_t>(at),
                      packed.begin() + static_cast<std::ptrdiff_t>(at + length));
    }
    putByte(blocks, 0);
    return blocks;
}

struct GifForm {
    unsigned bits;
    bool interlaced, local, offset, transparent;
    std::size_t reset;
};

Variant gifVariant(const GifForm& form) {
    constexpr int kWidth = 61, kHeight = 47;  // enough for codes of 12 bits
    Variant variant;
    const int left = form.offset ? 3 : 0, top = form.offset ? 2 : 0;
    variant.width = kWidth + (form.offset ? 5 : 0);
    variant.height = kHeight + (form.offset ? 4 : 0);
    variant.name = "gif-" + std::to_string(form.bits) + (form.interlaced ? "i" : "") +
                   (form.local ? "l" : "") + (form.offset ? "o" : "") + (form.transparent ? "t" : "") +
                   std::to_string(form.reset) + ".gif";
    const std::uint32_t colors = 1U << form.bits, transparent = form.transparent ? 1 : colors;
    Numbers indices;
    for (std::uint32_t i = 0; i < kWidth * kHeight; ++i) indices.push_back(hash(i / (1 + i % 3)) % colors);
    Bytes& to = variant.file;
    putText(to, "GIF89a");
    putLittle(to, static_cast<std::uint32_t>(variant.width), 2);
    putLittle(to, static_cast<std::uint32_t>(variant.height), 2);
    putByte(to, form.local ? 0 : 0x80U | (form.bits - 1));
    putLittle(to, 0, 2);
    const auto putColors = [&] {
        for (std::uint32_t i = 0; i < 3 * colors; ++i) putByte(to, hash(i) & 255U);
    };
    if (!form.local) putColors();
    for (const std::uint32_t each : {0x21U, 0xfeU, 2U, 'h' + 0U, 'i' + 0U, 0U})
        putByte(to, each);  // a comment
    if (form.transparent)
        for (const std::uint32_t each : {0x21U, 0xf9U, 4U, 1U, 0U, 0U, transparent, 0U}) putByte(to, each);
    putByte(to, ',');
    for (const int each : {left, top, kWidth, kHeight}) putLittle(to, static_cast<std::uint32_t>(each), 2);
    putByte(to, (form.local ? 0x80U | (form.bits - 1) : 0U) | (form.interlaced ? 0x40U : 0U));
    if (form.local) putColors();
    Numbers inFile;
    if (form.interlaced) {
        for (const auto& [first, step] : {std::pair{0, 8}, {4, 8}, {2, 4}, {1, 2}})
            for (int y = first; y < kHeight; y += step)
                inFile.insert(inFile.end(), indices.begin() + y * kWidth, indices.begin() + (y + 1) * kWidth);
    } else {
        inFile = indices;
    }
    putBytes(to, gifCodes(inFile, std::max(2U, form.bits), form.reset));
    putByte(to, ';');
    variant.pixels.resize(static_cast<std::size_t>(variant.width) * static_cast<std::size_t>(variant.height));
    for (int y = 0; y < kHeight; ++y)
        for (int x = 0; x < kWidth; ++x) {
            const std::uint32_t index = indices[static_cast<std::size_t>(y * kWidth + x)];
            if (index == transparent) continue;
            auto& pixel = variant.pixels[static_cast<std::size_t>((top + y) * variant.width + left + x)];
            for (std::uint32_t c = 0; c < 3; ++c) pixel.at(c) = (hash(3 * index + c) & 255U) / 255.;
            pixel[3] = 1;
        }
    return variant;
}

struct DdsForm {
    std::string name;
    std::uint32_t flags, bits;
    std::array<std::uint32_t, 4> masks;
    std::uint32_t dxgi = 0;
};

Variant ddsVariant(const DdsForm& form) {
    Variant variant;
    variant.width = kWide;
    variant.height = kTall;
    variant.name = "dds-" + form.name + ".dds";
    Bytes& to = variant.file;
    putText(to, "DDS ");
    for (const std::uint32_t each :
         {124U, 0x1007U, static_cast<std::uint32_t>(kTall), static_cast<std::uint32_t>(kWide), 0U, 0U, 0U})
        putLittle(to, each, 4);
    to.resize(to.size() + 44);
    for (const std::uint32_t each :
         {32U, form.dxgi > 0 ? 4U : form.flags, form.dxgi > 0 ? 0x30315844U : 0U, form.bits})
        putLittle(to, each, 4);
    for (const std::uint32_t each : form.masks) putLittle(to, form.dxgi > 0 ? 0 : each, 4);
    for (const std::uint32_t each : {0x1000U, 0U, 0U, 0U, 0U}) putLittle(to, each, 4);
    if (form.dxgi > 0)
        for (const std::uint32_t each : {form.dxgi, 3U, 0U, 1U, 0U}) putLittle(to, each, 4);
    const bool isGrey = form.masks[1] == 0 && form.masks[2] == 0 && form.masks[0] != 0;
    for (const auto number :
         runsOfNumbers(form.bits == 32 ? 0xffffffffU : (1U << form.bits) - 1, form.bits)) {
        putLittle(to, number, static_cast<int>(form.bits / 8));
        std::array<double, 4> pixel{0, 0, 0, 1};
        for (std::size_t c = 0; c < 4; ++c)
            if (const double mask = form.masks.at(c); mask > 0) {
                const double low = std::exp2(std::log2(form.masks.at(c) & (0U - form.masks.at(c))));
                pixel.at(c) = (number & form.masks.at(c)) / low / (mask / low);
            }
        if (isGrey) pixel[1] = pixel[2] = pixel[0];
        variant.pixels.push_back(pixel);
    }
    return variant;
}

}  // namespace

std::vector<Variant> targaVariants() {
    std::vector<Variant> all;
    for (const auto& [kind, bits] :
         {std::pair{1, 8}, {1, 16}, {2, 15}, {2, 16}, {2, 24}, {2, 32}, {3, 8}, {3, 16}})
        for (const int entryBits : {15, 16, 24, 32})
            for (const int first : {0, 10, 200})
                for (unsigned flags = 0; flags < 16; ++flags) {
                    if (kind != 1 && (entryBits != 24 || first != 0)) continue;
                    if (kind == 1 && flags % 4 != static_cast<unsigned>(first) % 4)
                        continue;  // each orientation with some map
                    all.push_back(targaVariant({kind, bits, entryBits, first, (flags & 8U) != 0,
                                                (flags & 1U) != 0, (flags & 2U) != 0, (flags & 4U) != 0}));
                }
    return all;
}

std::vector<Variant> pnmVariants() {
    std::vector<Variant> all;
    int number = 0;
    for (const int kind : {1, 2, 3, 4, 5, 6})
        for (const std::uint32_t most : {1U, 2U, 100U, 255U, 256U, 1023U, 65535U})
            for (const std::string between : {" ", "\n", "\t \r\n", "\n# a comment 9\n# 8\n", " #7\n"})
                for (const std::string end : {"\n", " ", "#x\n"}) {
                    if (most != 1 && kind % 3 == 1) continue;
                    // Without a blank, the comment would belong to the number before.
                    if (end == "#x\n" && kind <= 3) continue;
                    all.push_back(pnmVariant({kind, most, between, end}, ++number));
                }
    return all;
}

std::vector<Variant> hdrVariants() {
    std::vector<Variant> all;
    for (const std::string y : {"-Y", "+Y"})
        for (const std::string x : {"+X", "-X"})
            for (const HdrPacking packing : {HdrPacking::none, HdrPacking::old, HdrPacking::byComponent}) {
                all.push_back(hdrVariant(y, x, packing));
                all.push_back(hdrVariant(x, y, packing));
            }
    return all;
}

std::vector<Variant> gifVariants() {
    std::vector<Variant> all;
    for (unsigned bits = 1; bits <= 8; ++bits)
        for (unsigned flags = 0; flags < 16; ++flags)
            for (const std::size_t reset : {std::size_t{0}, std::size_t{50}})
                if ((flags + bits) % 3 == 0)
                    all.push_back(gifVariant({bits, (flags & 1U) != 0, (flags & 2U) != 0, (flags & 4U) != 0,
                                              (flags & 8U) != 0, reset}));
    return all;
}

std::vector<Variant> ddsVariants() {
    std::vector<Variant> all;
    for (const DdsForm& each : std::vector<DdsForm>{
             {"rgba8", 0x41, 32, {0xff, 0xff00, 0xff0000, 0xff000000}},
             {"bgra8", 0x41, 32, {0xff0000, 0xff00, 0xff, 0xff000000}},
             {"bgrx8", 0x40, 32, {0xff0000, 0xff00, 0xff, 0}},
             {"bgr8", 0x40, 24, {0xff0000, 0xff00, 0xff, 0}},
             {"rgb8", 0x40, 24, {0xff, 0xff00, 0xff0000, 0}},
             {"565", 0x40, 16, {0xf800, 0x7e0, 0x1f, 0}},
             {"1555", 0x41, 16, {0x7c00, 0x3e0, 0x1f, 0x8000}},
             {"4444", 0x41, 16, {0xf00, 0xf0, 0xf, 0xf000}},
             {"332", 0x40, 8, {0xe0, 0x1c, 3, 0}},
             {"8332", 0x41, 16, {0xe0, 0x1c, 3, 0xff00}},
             {"1010102", 0x41, 32, {0x3ff, 0xffc00, 0x3ff00000, 0xc0000000}},
             {"rg16", 0x40, 32, {0xffff, 0xffff0000, 0, 0}},
             {"rg8", 0x40, 16, {0xff, 0xff00, 0, 0}},
             {"r16", 0x40, 16, {0xffff, 0, 0, 0}},
             {"r32", 0x40, 32, {0xffffffff, 0, 0, 0}},
             {"l8", 0x20000, 8, {0xff, 0, 0, 0}},
             {"l16", 0x20000, 16, {0xffff, 0, 0, 0}},
             {"la8", 0x20001, 16, {0xff, 0, 0, 0xff00}},
             {"la4", 0x20001, 8, {0xf, 0, 0, 0xf0}},
             {"a8", 2, 8, {0, 0, 0, 0xff}},
             {"dx10-rgba8", 0, 32, {0xff, 0xff00, 0xff0000, 0xff000000}, 28},
             {"dx10-bgra8", 0, 32, {0xff0000, 0xff00, 0xff, 0xff000000}, 87},
             {"dx10-rg16", 0, 32, {0xffff, 0xffff0000, 0, 0}, 35},
             {"dx10-r8", 0, 8, {0xff, 0, 0, 0}, 61},
             {"dx10-1010102", 0, 32, {0x3ff, 0xffc00, 0x3ff00000, 0xc0000000}, 24},
             {"dx10-565", 0, 16, {0xf800, 0x7e0, 0x1f, 0}, 85},
         })
        all.push_back(ddsVariant(each));
    return all;
}

}  // namespace glibra::image::testing
