#pragma once
// What a shot leaves out of its comparisons (`ignore` and `mask` of suites), and when two drawings of it
// agree.

#include <glibra/diagnostic.h>
#include <glibra/result.h>

#include <cstddef>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "image/image.h"
#include "suite/suite.h"

namespace glibra::suite {

// Pictures of a suite that somebody accepts by looking at them: goldens and masks.

/// suite-E32 if a browser may show another picture of the file than the one that is decoded: of a PNG file
/// for the reasons of image::shownOtherwise(), and of a file whose content is of another format than its name
/// says. `what` is "golden" or "mask".
std::optional<Diagnostic> shownOtherwise(std::string_view what, const std::filesystem::path& file,
                                         std::span<const std::byte> bytes, const Place& place);

/// True if some part is left out today.
bool ignoresSomething(const Shot& shot);
/// What is left out today, with the content of the mask, as a text that changes with it; empty if nothing is.
std::string ignoredText(const Shot& shot);
/// True for two drawings of a shot that are equal where it looks, or within a tolerance that the suite states
/// for it.
bool drawingsAgree(const Shot& shot, const image::Image& first, const image::Image& second);
/// How a verdict on the shot is found beside its tolerance, as a text that changes with it: what is ignored,
/// retries, whether it is in quarantine today. Empty for a shot that states nothing of this.
std::string judgedBy(const Shot& shot);
/// What is wrong with the shot's `ignore` and `mask` for a picture of this size, each at its place in the
/// suite: suite-E29 a rectangle outside of the picture, or a mask of another size; suite-E21 they leave
/// nothing that is compared; suite-E32 a mask that other programs may show otherwise; those of
/// image::readImage for the mask.
Diagnostics wrongIgnored(const Shot& shot, int width, int height);
/// The part of a picture of this size that is compared, 0 to 1; 0 if wrongIgnored() has an error.
double comparedPart(const Shot& shot, int width, int height);
/// `got` with the pixels of `expected` where the shot does not look, so that a comparison of the two sees no
/// difference there. Of pictures with different sizes or types `got` is returned: they differ anyway. Errors:
/// those of wrongIgnored().
Result<image::Image> withoutIgnored(const Shot& shot, const image::Image& expected, const image::Image& got);

}  // namespace glibra::suite
