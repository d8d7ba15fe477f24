// Pictures as the library's headers have them, files of them, and their comparison.

#include <glibra/compare.h>
#include <glibra/render.h>

#include <fmt/format.h>

#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <utility>

#include "base/text.h"
#include "image/compare/judge.h"
#include "image/file.h"
#include "image/format.h"
#include "image/read.h"
#include "image/write.h"
#include "library/renderer_state.h"

namespace glibra {
namespace {

/// The type with the size of the picture's numbers, which are those of that type unless isOfOnes().
image::Component typeOf(const Picture& picture) {
    if (picture.isFloat || picture.bits == 32) return image::Component::f32;
    return picture.bits == 16 ? image::Component::u16 : image::Component::u8;
}

/// True for whole numbers that are no shares of a largest one.
bool isOfOnes(const Picture& picture) {
    return !picture.isFloat && (picture.isSigned || picture.bits == 32);
}

/// Why the picture's bytes cannot be those of its size.
Diagnostics problemsOf(const Picture& picture) {
    const image::Image shape{picture.width, picture.height, picture.components, typeOf(picture), {}};
    const bool isShape = picture.width > 0 && picture.height > 0 && picture.components >= 1 &&
                         picture.components <= 4 &&
                         (picture.isFloat || picture.bits == 8 || picture.bits == 16 || picture.bits == 32);
    if (isShape && picture.data.size() == shape.rowBytes() * static_cast<std::size_t>(picture.height))
        return {};
    return {wrongOption(fmt::format("a picture of {} x {} pixels with {} components does not have {} bytes",
                                    picture.width, picture.height, picture.components, picture.data.size()))};
}

template <class Number>
double numberIn(const Picture& picture, std::size_t index) {
    Number number{};
    std::memcpy(&number, picture.data.data() + index * sizeof number, sizeof number);
    return static_cast<double>(number);
}

/// A component of the picture, counted from the first one of the first pixel.
double numberAt(const Picture& picture, std::size_t index) {
    if (picture.isFloat) return numberIn<float>(picture, index);
    if (picture.bits == 8)
        return picture.isSigned ? numberIn<std::int8_t>(picture, index)
                                : numberIn<std::uint8_t>(picture, index);
    if (picture.bits == 16)
        return picture.isSigned ? numberIn<std::int16_t>(picture, index)
                                : numberIn<std::uint16_t>(picture, index);
    return picture.isSigned ? numberIn<std::int32_t>(picture, index)
                            : numberIn<std::uint32_t>(picture, index);
}

/// The whole numbers as floats; library-E06 if a float is another number.
Result<image::Image> asFloats(const Picture& picture) {
    image::Image to{picture.width, picture.height, picture.components, image::Component::f32, {}};
    to.data.resize(to.rowBytes() * static_cast<std::size_t>(to.height));
    for (std::size_t i = 0; i < to.data.size() / sizeof(float); ++i) {
        const double number = numberAt(picture, i);
        const auto value = static_cast<float>(number);
        if (static_cast<double>(value) != number)
            return diagnose("library-E06",
                            fmt::format("the picture has the number {:.0f}, which no 32-bit float has, "
                                        "so that no file of a picture keeps it",
                                        number));
        std::memcpy(to.data.data() + i * sizeof value, &value, sizeof value);
    }
    return to;
}

/// library-E01 for numbers that no difference can be measured by.
Diagnostics problemsOf(const Tolerance& tolerance) {
    Diagnostics found;
    const auto check = [&](const char* name, double value, double most) {
        if (std::isfinite(value) && value >= 0 && value <= most) return;
        const bool isOpen = most == std::numeric_limits<double>::max();
        found.push_back(wrongOption(isOpen
                                        ? fmt::format("{}: {} is not a finite number from 0 on", name, value)
                                        : fmt::format("{}: {} is not between 0 and {}", name, value, most)));
    };
    constexpr double kAny = std::numeric_limits<double>::max();
    check("largest", tolerance.largest, 255);
    check("fraction", tolerance.fraction, 1);
    check("cluster", tolerance.cluster, kAny);
    check("line", tolerance.line, kAny);
    check("bias", tolerance.bias, 255);
    check("flip", tolerance.flip.value_or(0), 1);
    check("structure", tolerance.structure.value_or(0), 1);
    check("relative", tolerance.relative, kAny);
    check("absolute", tolerance.absolute, kAny);
    return found;
}

image::Tolerance toleranceOf(const Tolerance& from) {
    if (from.exact) return image::exactTolerance();
    image::Tolerance to;
    to.largest = from.largest;
    to.fraction = from.fraction;
    to.cluster = from.cluster;
    to.line = from.line;
    to.bias = from.bias;
    to.flip = from.flip;
    to.structure = from.structure;
    to.relative = from.relative;
    to.absolute = from.absolute;
    return to;
}

Comparison refused(Diagnostics why) {
    Comparison to;
    if (!why.empty()) {
        const Diagnostic& first = why.front();
        to.reason = (first.place.file.empty() ? "" : first.place.file + ": ") + first.text;
    }
    to.diagnostics = std::move(why);
    return to;
}

Comparison compared(const image::Image& got, const image::Image& expected, const Tolerance& tolerance) {
    const image::Judgement judged = image::judge(expected, got, toleranceOf(tolerance));
    const image::Comparison plain = image::compare(expected, got);
    Comparison to;
    to.same = judged.same;
    to.reason = judged.reason;
    to.differingPixels = plain.differingPixels;
    to.largest = plain.largest * 255;
    to.x = plain.x;
    to.y = plain.y;
    to.rootMeanSquare = plain.rootMeanSquare * 255;
    to.flip = judged.flip;
    to.structure = judged.structure;
    return to;
}

/// Whole numbers are compared one by one, since a share of a largest one means nothing for them.
Comparison comparedByNumbers(const Picture& got, const Picture& expected, const Tolerance& tolerance) {
    Comparison to;
    if (got.width != expected.width || got.height != expected.height ||
        got.components != expected.components) {
        to.reason =
            fmt::format("the sizes differ: expected {} x {} with {}, found {} x {} with {}", expected.width,
                        expected.height, base::counted(expected.components, "component"), got.width,
                        got.height, base::counted(got.components, "component"));
        return to;
    }
    const auto components = static_cast<std::size_t>(got.components);
    const std::size_t pixels = static_cast<std::size_t>(got.width) * static_cast<std::size_t>(got.height);
    double squares = 0;
    for (std::size_t pixel = 0; pixel < pixels; ++pixel) {
        double largest = 0;
        for (std::size_t i = pixel * components; i < (pixel + 1) * components; ++i) {
            const double difference = std::abs(numberAt(got, i) - numberAt(expected, i));
            largest = difference <= largest ? largest : difference;  // NaN, too
            squares += difference * difference;
        }
        if (largest == 0) continue;
        ++to.differingPixels;
        if (largest <= to.largest) continue;
        to.largest = largest;
        to.x = static_cast<int>(pixel % static_cast<std::size_t>(got.width));
        to.y = static_cast<int>(pixel / static_cast<std::size_t>(got.width));
    }
    to.rootMeanSquare = std::sqrt(squares / static_cast<double>(pixels * components));
    const double limit = tolerance.exact ? 0 : tolerance.absolute;
    to.same = to.largest <= limit;
    to.reason =
        to.differingPixels == 0
            ? "equal values"
            : fmt::format("whole numbers differ in {}; the largest difference is {:.17g} at {}, {}, {} {:g}",
                          base::counted(to.differingPixels, "pixel"), to.largest, to.x, to.y,
                          to.same ? "within" : "the limit is", limit);
    return to;
}

/// A picture, or the one in a file.
Result<Picture> pictureIn(const Picture& picture) {
    if (Diagnostics problems = problemsOf(picture); !problems.empty()) return problems;
    return picture;
}
Result<Picture> pictureIn(const std::filesystem::path& file) {
    Result<image::Image> read =
        image::readImage(file, {file.generic_string(), 1, 1}, {.limits = image::kDrawnLimits});
    if (!read) return std::move(read.diagnostics);
    return pictureOf(std::move(*read));
}

Diagnostics appearanceOf(const Picture& /*shown*/) {
    return {};
}
Diagnostics appearanceOf(const std::filesystem::path& file) {
    const std::string path = file.generic_string();
    const auto bytes = image::readFile(file, {path, {path, 1, 1}}, image::Limits().fileBytes);
    return bytes ? image::warnIfShownOtherwise(*bytes, path) : Diagnostics();
}

Comparison comparison(const auto& got, const auto& expected, const Tolerance& tolerance) {
    if (Diagnostics problems = problemsOf(tolerance); !problems.empty()) return refused(std::move(problems));
    Result<Picture> one = pictureIn(got);
    if (!one) return refused(one.diagnostics);
    Result<Picture> other = pictureIn(expected);
    if (!other) return refused(other.diagnostics);
    if (isOfOnes(*one) || isOfOnes(*other)) return comparedByNumbers(*one, *other, tolerance);
    Comparison to = compared(imageOf(std::move(*one)), imageOf(std::move(*other)), tolerance);
    append(to.diagnostics, appearanceOf(got));
    append(to.diagnostics, appearanceOf(expected));
    return to;
}

}  // namespace

Picture pictureOf(image::Image image) {
    Picture picture;
    picture.width = image.width;
    picture.height = image.height;
    picture.components = image.components;
    picture.isFloat = image.type == image::Component::f32;
    picture.bits = static_cast<int>(8 * image::bytesOf(image.type));
    picture.data = std::move(image.data);
    return picture;
}

image::Image imageOf(Picture picture) {
    return {picture.width, picture.height, picture.components, typeOf(picture), std::move(picture.data)};
}

Result<void> Picture::save(const std::filesystem::path& file) const {
    if (Diagnostics problems = problemsOf(*this); !problems.empty()) return problems;
    if (!isOfOnes(*this)) return image::writeImage(imageOf(*this), file);
    const image::Format format = image::formatOfSuffix(file);
    if (format != image::Format::openExr && format != image::Format::pfm)
        return diagnose(
            "library-E06",
            fmt::format("whole numbers {} are written by .exr and .pfm, not by {}",
                        isSigned ? "with a sign" : "of 32 bits", file.extension().generic_string()),
            {file.generic_string(), 1, 1});
    Result<image::Image> floats = asFloats(*this);
    if (!floats) return std::move(floats.diagnostics);
    return image::writeImage(*floats, file);
}

Comparison compare(const Picture& got, const Picture& expected, const Tolerance& tolerance) {
    return comparison(got, expected, tolerance);
}
Comparison compare(const std::filesystem::path& got, const std::filesystem::path& expected,
                   const Tolerance& tolerance) {
    return comparison(got, expected, tolerance);
}
Comparison compare(const Picture& got, const std::filesystem::path& expected, const Tolerance& tolerance) {
    return comparison(got, expected, tolerance);
}

}  // namespace glibra
