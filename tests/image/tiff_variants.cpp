// TIFF files (Adobe, "TIFF Revision 6.0"), byte by byte: what samples mean, their bits and types, how many a
// pixel has, their order in the file, and the order of bytes.

#include <algorithm>
#include <cmath>
#include <cstring>

#include "variant_maker.h"

namespace glibra::image::testing {
namespace {

constexpr std::uint32_t kTiffWide = 7, kTiffTall = 3;

enum Meaning : std::uint32_t { whiteIsZero = 0, blackIsZero = 1, rgb = 2, palette = 3, inks = 5, cieLab = 8 };
enum Type : std::uint32_t { unsignedWhole = 1, signedWhole = 2, floating = 3 };

enum Packing : std::uint32_t { none = 1, lzw = 5, deflate = 8, packBits = 32773 };

struct TiffForm {
    Meaning meaning;
    Type type;
    std::uint32_t bits, samples;
    bool isBig = false, isPlanar = false;
    Packing packing = none;
    bool isPredicted = false;  ///< differences of adjacent samples are stored
};

/// Bits one after the other, the highest of a byte first.
class BitWriter {
  public:
    explicit BitWriter(bool isBig) : isBig_(isBig) {}

    void put(std::uint64_t value, std::uint32_t bits) {
        if (bits % 8 == 0) {
            for (std::uint32_t i = 0; i < bits / 8; ++i)
                bytes.push_back(
                    static_cast<std::byte>(value >> (8 * (isBig_ ? bits / 8 - 1 - i : i)) & 255U));
            return;
        }
        for (std::uint32_t i = bits; i-- > 0;) {
            if (used_ == 0) bytes.push_back({});
            bytes.back() |= static_cast<std::byte>((value >> i & 1U) << (7 - used_));
            used_ = (used_ + 1) % 8;
        }
    }

    Bytes bytes;

  private:
    bool isBig_;
    std::uint32_t used_ = 0;
};

std::uint64_t highest(std::uint32_t bits) {
    return bits == 64 ? ~std::uint64_t{0} : (std::uint64_t{1} << bits) - 1;
}

/// The bits of a floating-point number of 16, 24, 32 or 64 bits that hold `value` exactly.
std::uint64_t floatBits(double value, std::uint32_t bits) {
    if (bits == 64) {
        std::uint64_t raw = 0;
        std::memcpy(&raw, &value, 8);
        return raw;
    }
    if (bits == 32) {
        const auto narrow = static_cast<float>(value);
        std::uint32_t raw = 0;
        std::memcpy(&raw, &narrow, 4);
        return raw;
    }
    const std::uint32_t fraction = bits == 16 ? 10 : 16, bias = bits == 16 ? 15 : 63;
    if (value == 0) return 0;
    int exponent = 0;
    const double mantissa = std::frexp(std::abs(value), &exponent);
    const auto scaled =
        static_cast<std::uint64_t>((2 * mantissa - 1) * std::ldexp(1., static_cast<int>(fraction)));
    return (value < 0 ? std::uint64_t{1} << (bits - 1) : 0) |
           static_cast<std::uint64_t>(exponent - 1 + static_cast<int>(bias)) << fraction | scaled;
}

struct Sample {
    std::uint64_t raw;
    double value;  ///< 0..1, a whole number, or a float
};

Sample sampleOf(const TiffForm& form, std::uint32_t x, std::uint32_t y, std::uint32_t component) {
    const std::uint32_t seed = hash(x + 31 * y + 977 * component);
    const std::uint64_t all = highest(form.bits);
    if (form.type == floating) {
        const double value = static_cast<double>(static_cast<int>(seed % 17) - (component == 3 ? 0 : 4)) / 16;
        return {floatBits(value, form.bits), value};
    }
    const std::uint64_t wide = std::uint64_t{seed} << 32U | hash(seed);
    const std::uint64_t raw = x == 0 && y == 0 ? all : x == 1 && y == 0 ? 0 : wide & all;
    if (form.type == unsignedWhole) return {raw, static_cast<double>(raw) / static_cast<double>(all)};
    const bool isNegative = (raw >> (form.bits - 1) & 1U) != 0;
    return {raw, isNegative ? -static_cast<double>((all - raw) + 1) : static_cast<double>(raw)};
}

std::array<double, 4> pixelOf(const TiffForm& form, const std::array<double, 4>& samples,
                              const std::vector<std::array<double, 4>>& colors, std::uint64_t first) {
    const double grey = form.meaning == whiteIsZero ? 1 - samples[0] : samples[0];
    switch (form.meaning) {
        case whiteIsZero:
        case blackIsZero:
            return {grey, grey, grey, form.samples > 1 ? samples[1] : 1};
        case palette:
            return colors[static_cast<std::size_t>(first)];
        case inks: {
            const double rest = 1 - samples[3];
            return {(1 - samples[0]) * rest, (1 - samples[1]) * rest, (1 - samples[2]) * rest, 1};
        }
        case rgb:
        case cieLab:
            break;
    }
    return {samples[0], samples[1], samples[2], form.samples > 3 ? samples[3] : 1};
}

struct Field {
    std::uint32_t tag, type;
    std::vector<std::uint32_t> values;
};

void putField(BitWriter& to, const Field& field, BitWriter& after, std::uint32_t afterAt) {
    const std::uint32_t bits = field.type == 3 ? 16 : 32;
    to.put(field.tag, 16);
    to.put(field.type, 16);
    to.put(field.values.size(), 32);
    if (field.values.size() * bits <= 32) {
        for (const std::uint32_t each : field.values) to.put(each, bits);
        for (std::size_t used = field.values.size() * bits; used < 32; used += 16) to.put(0, 16);
        return;
    }
    to.put(afterAt + after.bytes.size(), 32);
    for (const std::uint32_t each : field.values) after.put(each, bits);
}

/// The samples of a row as they are stored.
Bytes rowBytes(const TiffForm& form, std::vector<std::uint64_t> raws, std::size_t stride) {
    if (form.isPredicted && form.type != floating)
        for (std::size_t i = raws.size(); i-- > stride;)
            raws[i] = (raws[i] - raws[i - stride]) & highest(form.bits);
    BitWriter writer(form.isBig || (form.isPredicted && form.type == floating));
    for (const std::uint64_t each : raws) writer.put(each, form.bits);
    if (!form.isPredicted || form.type != floating) return writer.bytes;
    // All highest bytes come first, then all next ones, as differences (Adobe Photoshop TIFF Technical Note
    // 3).
    const std::size_t bytes = form.bits / 8;
    Bytes planes(writer.bytes.size());
    for (std::size_t i = 0; i < planes.size(); ++i)
        planes[i % bytes * raws.size() + i / bytes] = writer.bytes[i];
    for (std::size_t i = planes.size(); i-- > stride;)
        planes[i] = static_cast<std::byte>(std::to_integer<int>(planes[i]) -
                                           std::to_integer<int>(planes[i - stride]));
    return planes;
}

/// Every packing has a form in which all bytes stand as they are.
Bytes packed(const Bytes& from, Packing packing) {
    if (packing == none) return from;
    if (packing == lzw) {
        BitWriter codes(true);
        for (std::size_t i = 0; i < from.size(); ++i) {
            if (i % 200 == 0) codes.put(256, 9);  // clears the table, so that codes stay short
            codes.put(std::to_integer<std::uint64_t>(from[i]), 9);
        }
        codes.put(257, 9);
        return codes.bytes;
    }
    Bytes to;
    if (packing == packBits) {
        for (std::size_t i = 0; i < from.size(); ++i) {
            if (i % 100 == 0)
                putLittle(to, static_cast<std::uint32_t>(std::min<std::size_t>(100, from.size() - i) - 1), 1);
            to.push_back(from[i]);
        }
        return to;
    }
    const auto size = static_cast<std::uint32_t>(from.size());
    for (const std::uint32_t each : {0x78U, 0x01U, 0x01U}) putLittle(to, each, 1);
    putLittle(to, size, 2);
    putLittle(to, ~size & 0xffffU, 2);
    to.insert(to.end(), from.begin(), from.end());
    std::uint32_t low = 1, high = 0;
    for (const std::byte each : from) {
        low = (low + std::to_integer<std::uint32_t>(each)) % 65521;
        high = (high + low) % 65521;
    }
    for (const std::uint32_t each : {high, low}) {
        putLittle(to, each >> 8U, 1);
        putLittle(to, each, 1);
    }
    return to;
}

std::string nameOf(const TiffForm& form) {
    const char* const meaning = form.meaning == whiteIsZero   ? "white"
                                : form.meaning == blackIsZero ? "black"
                                : form.meaning == rgb         ? "rgb"
                                : form.meaning == palette     ? "palette"
                                : form.meaning == inks        ? "inks"
                                                              : "lab";
    const char* const type = form.type == unsignedWhole ? "u" : form.type == signedWhole ? "i" : "f";
    return std::string("tiff-") + meaning + "-" + type + std::to_string(form.bits) + "-" +
           std::to_string(form.samples) + (form.isBig ? "b" : "") + (form.isPlanar ? "p" : "") +
           (form.packing == lzw        ? "-lzw"
            : form.packing == deflate  ? "-deflate"
            : form.packing == packBits ? "-bits"
                                       : "") +
           (form.isPredicted ? "-differences" : "") + ".tif";
}

Variant tiffVariant(const TiffForm& form) {
    Variant variant;
    variant.name = nameOf(form);
    variant.width = kTiffWide;
    variant.height = kTiffTall;

    std::vector<std::array<double, 4>> colors;
    Field map{320, 3, {}};
    if (form.meaning == palette) {
        const auto count = static_cast<std::uint32_t>(highest(form.bits) + 1);
        for (std::uint32_t c = 0; c < 3; ++c)
            for (std::uint32_t i = 0; i < count; ++i) map.values.push_back((hash(i + 5000 * c) & 255U) * 257);
        for (std::uint32_t i = 0; i < count; ++i)
            colors.push_back({map.values[i] / 65535., map.values[count + i] / 65535.,
                              map.values[2 * count + i] / 65535., 1});
    }

    std::vector<Bytes> planes(form.isPlanar ? form.samples : 1);
    const auto samplesOf = [&](std::uint32_t x, std::uint32_t y) {
        std::array<Sample, 4> samples{};
        for (std::uint32_t c = 0; c < form.samples; ++c) samples.at(c) = sampleOf(form, x, y, c);
        return samples;
    };
    for (std::uint32_t y = 0; y < kTiffTall; ++y)
        for (std::uint32_t x = 0; x < kTiffWide; ++x) {
            const auto samples = samplesOf(x, y);
            variant.pixels.push_back(
                pixelOf(form, {samples[0].value, samples[1].value, samples[2].value, samples[3].value},
                        colors, samples[0].raw));
        }
    const std::uint32_t stride = form.isPlanar ? 1 : form.samples;
    for (std::uint32_t plane = 0; plane < planes.size(); ++plane) {
        Bytes strip;
        for (std::uint32_t y = 0; y < kTiffTall; ++y) {
            std::vector<std::uint64_t> raws;
            for (std::uint32_t x = 0; x < kTiffWide; ++x)
                for (std::uint32_t c = 0; c < stride; ++c)
                    raws.push_back(samplesOf(x, y).at(form.isPlanar ? plane : c).raw);
            Bytes row = rowBytes(form, raws, stride);
            if (form.packing == packBits) row = packed(row, packBits);  // by rows
            strip.insert(strip.end(), row.begin(), row.end());
        }
        planes[plane] = form.packing == packBits ? strip : packed(strip, form.packing);
    }

    const bool hasAlpha = form.samples == (form.meaning == rgb ? 4U : 2U);
    std::vector<Field> fields{{256, 4, {kTiffWide}},
                              {257, 4, {kTiffTall}},
                              {258, 3, std::vector<std::uint32_t>(form.samples, form.bits)},
                              {259, 3, {form.packing}},
                              {262, 3, {form.meaning}},
                              {273, 4, {}},
                              {277, 3, {form.samples}},
                              {278, 4, {kTiffTall}},
                              {279, 4, {}},
                              {284, 3, {form.isPlanar ? 2U : 1U}}};
    if (form.isPredicted) fields.push_back({317, 3, {form.type == floating ? 3U : 2U}});
    if (form.meaning == palette) fields.push_back(map);
    if (hasAlpha) fields.push_back({338, 3, {2}});
    fields.push_back({339, 3, std::vector<std::uint32_t>(form.samples, form.type)});
    std::uint32_t at = 8;
    for (const Bytes& each : planes) {
        fields[5].values.push_back(at);
        fields[8].values.push_back(static_cast<std::uint32_t>(each.size()));
        at += static_cast<std::uint32_t>(each.size() + each.size() % 2);
    }

    BitWriter file(form.isBig), after(form.isBig);
    for (int i = 0; i < 2; ++i) file.put(form.isBig ? 'M' : 'I', 8);
    file.put(42, 16);
    file.put(at, 32);
    for (const Bytes& each : planes) {
        file.bytes.insert(file.bytes.end(), each.begin(), each.end());
        if (each.size() % 2 != 0) file.put(0, 8);
    }
    file.put(fields.size(), 16);
    const auto afterAt = static_cast<std::uint32_t>(at + 2 + 12 * fields.size() + 4);
    for (const Field& each : fields) putField(file, each, after, afterAt);
    file.put(0, 32);
    file.bytes.insert(file.bytes.end(), after.bytes.begin(), after.bytes.end());
    variant.file = file.bytes;
    return variant;
}

}  // namespace

std::vector<Variant> tiffVariants() {
    std::vector<Variant> variants;
    const auto add = [&](const TiffForm& form) { variants.push_back(tiffVariant(form)); };
    const auto addAll = [&](const TiffForm& form) {
        add(form);
        TiffForm other = form;
        other.isBig = other.isPlanar = true;
        add(other);
        if (form.bits != 1 && form.bits != 4 && form.bits != 12 && form.bits % 8 != 0) return;
        for (const Packing packing : {lzw, deflate, packBits})
            for (const bool isPredicted : {false, true}) {
                const bool isPossible = form.type == floating ? true : form.bits % 8 == 0;
                if (isPredicted && (packing == packBits || !isPossible)) continue;
                other = form;
                other.packing = packing;
                other.isPredicted = isPredicted;
                add(other);
            }
    };
    for (const std::uint32_t bits : {1U, 2U, 3U, 4U, 6U, 7U, 8U, 10U, 12U, 14U, 16U, 24U, 32U, 64U})
        for (const Type type : {unsignedWhole, signedWhole, floating}) {
            if (type == floating && (bits < 16 || bits % 8 != 0)) continue;
            for (const Meaning meaning : {whiteIsZero, blackIsZero})
                for (const std::uint32_t samples : {1U, 2U}) addAll({meaning, type, bits, samples});
            for (const std::uint32_t samples : {3U, 4U}) addAll({rgb, type, bits, samples});
            addAll({inks, type, bits, 4});
            if (bits <= 12) addAll({palette, type, bits, 1});
            if (bits == 8 || bits == 16) addAll({cieLab, type, bits, 3});
        }
    return variants;
}

}  // namespace glibra::image::testing
