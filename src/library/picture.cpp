// Pictures as the library's headers have them, files of them, and their comparison.

#include <glibra/compare.h>
#include <glibra/render.h>

#include <fmt/format.h>

#include <utility>

#include "image/compare/judge.h"
#include "image/read.h"
#include "image/write.h"
#include "library/renderer_state.h"

namespace glibra {
namespace {

image::Component typeOf(const Picture& picture) {
    if (picture.isFloat) return image::Component::f32;
    return picture.bits == 16 ? image::Component::u16 : image::Component::u8;
}

/// Why the picture's bytes cannot be those of its size.
Diagnostics problemsOf(const Picture& picture) {
    const image::Image shape{picture.width, picture.height, picture.components, typeOf(picture), {}};
    const bool isShape =
        picture.width > 0 && picture.height > 0 && picture.components >= 1 && picture.components <= 4;
    if (isShape && picture.data.size() == shape.rowBytes() * static_cast<std::size_t>(picture.height))
        return {};
    return {diagnose("library-E01",
                     fmt::format("a picture of {} x {} pixels with {} components does not have {} bytes",
                                 picture.width, picture.height, picture.components, picture.data.size()))};
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
    to.reason = why.empty() ? std::string() : why.front().text;
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

/// The image of a picture, or in a file.
Result<image::Image> imageIn(const Picture& picture) {
    if (Diagnostics problems = problemsOf(picture); !problems.empty()) return problems;
    return imageOf(picture);
}
Result<image::Image> imageIn(const std::filesystem::path& file) {
    return image::readImage(file, {file.string(), 1, 1});
}

Comparison comparison(const auto& got, const auto& expected, const Tolerance& tolerance) {
    const Result<image::Image> one = imageIn(got);
    if (!one) return refused(one.diagnostics);
    const Result<image::Image> other = imageIn(expected);
    if (!other) return refused(other.diagnostics);
    return compared(*one, *other, tolerance);
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

image::Image imageOf(const Picture& picture) {
    return {picture.width, picture.height, picture.components, typeOf(picture), picture.data};
}

Result<void> Picture::save(const std::filesystem::path& file) const {
    if (Diagnostics problems = problemsOf(*this); !problems.empty()) return problems;
    return image::writeImage(imageOf(*this), file);
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
