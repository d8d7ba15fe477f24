#include "suite/golden/ignored.h"

#include <fmt/format.h>
#include <algorithm>
#include <cstring>

#include "image/file.h"
#include "image/format.h"
#include "image/png/png_reader.h"
#include "image/read.h"
#include "suite/golden/hash_list.h"

namespace glibra::suite {

std::optional<Diagnostic> shownOtherwise(std::string_view what, const std::filesystem::path& file,
                                         std::span<const std::byte> bytes, const Place& place) {
    const image::Format format = image::formatOf(bytes);
    std::string why;
    if (format != image::formatOfSuffix(file))
        why = fmt::format("by its content it is {}", image::describe(format));
    else if (format == image::Format::png)
        why = image::shownOtherwise(bytes);
    if (why.empty()) return std::nullopt;
    return diagnose(
        "suite-E32",
        fmt::format("the {} '{}' may be shown as another picture than the one that is compared: {}", what,
                    file.filename().generic_string(), why),
        place);
}

namespace {

/// The rectangles that are left out today.
std::vector<IgnoredRegion> activeRegions(const Shot& shot) {
    if (shot.ignored.empty()) return {};
    std::vector<IgnoredRegion> active = shot.ignored;
    std::erase_if(active, [day = today()](const IgnoredRegion& each) {
        return !each.until.empty() && day > each.until;
    });
    return active;
}

bool samePixels(const image::Image& a, const image::Image& b) {
    return a.width == b.width && a.height == b.height && a.components == b.components && a.type == b.type &&
           a.data == b.data;
}

std::optional<Diagnostic> reachesOut(const IgnoredRegion& region, int width, int height) {
    if (region.width <= width - region.x && region.height <= height - region.y) return std::nullopt;
    return diagnose("suite-E29",
                    fmt::format("ignore: [{}, {}, {}, {}] is not inside of the picture of {} x {} pixels",
                                region.x, region.y, region.width, region.height, width, height),
                    region.place);
}

Result<image::Image> readMask(const Shot& shot, int width, int height) {
    const auto bytes = image::readFile(shot.mask, {shot.mask.generic_string(), shot.maskPlace});
    if (!bytes) return bytes.diagnostics;
    Result<image::Image> mask =
        image::decodeImage(*bytes, shot.mask, shot.maskPlace, {.limits = image::kDrawnLimits});
    if (mask)
        if (std::optional<Diagnostic> why = shownOtherwise("mask", shot.mask, *bytes, shot.maskPlace))
            return *std::move(why);
    if (mask && (mask->width != width || mask->height != height))
        return diagnose("suite-E29",
                        fmt::format("mask: '{}' has {} x {} pixels, the picture {} x {}",
                                    shot.mask.generic_string(), mask->width, mask->height, width, height),
                        shot.maskPlace);
    return mask;
}

}  // namespace

Diagnostics wrongIgnored(const Shot& shot, int width, int height) {
    Diagnostics problems;
    for (const IgnoredRegion& each : activeRegions(shot))
        if (const auto problem = reachesOut(each, width, height)) problems.push_back(*problem);
    if (!shot.mask.empty()) append(problems, readMask(shot, width, height).diagnostics);
    if (!hasError(problems) && ignoresSomething(shot) && comparedPart(shot, width, height) == 0)
        problems.push_back(diagnose(
            "suite-E21",
            fmt::format("nothing of the picture of '{}' is compared: {} all of its {} x {} pixels", shot.name,
                        shot.mask.empty()      ? "`ignore` covers"
                        : shot.ignored.empty() ? "the white of `mask` covers"
                                               : "`ignore` and the white of `mask` cover",
                        width, height),
            shot.ignored.empty() ? shot.maskPlace : shot.ignored.front().place));
    return problems;
}

double comparedPart(const Shot& shot, int width, int height) {
    const image::Image zeros{
        width, height, 1, image::Component::u8,
        std::vector<std::byte>(static_cast<std::size_t>(width) * static_cast<std::size_t>(height))};
    image::Image ones = zeros;
    std::ranges::fill(ones.data, std::byte{1});
    const Result<image::Image> seen = withoutIgnored(shot, zeros, ones);
    if (!seen || seen->data.empty()) return 0;
    return static_cast<double>(std::ranges::count(seen->data, std::byte{1})) /
           static_cast<double>(seen->data.size());
}

bool ignoresSomething(const Shot& shot) {
    return !shot.mask.empty() || !activeRegions(shot).empty();
}

std::string ignoredText(const Shot& shot) {
    if (!ignoresSomething(shot)) return {};
    std::string text;
    for (const IgnoredRegion& each : activeRegions(shot))
        text += fmt::format(" {},{},{},{}", each.x, each.y, each.width, each.height);
    if (shot.mask.empty()) return text;
    const Result<image::Image> mask = image::readImage(shot.mask, {}, {.limits = image::kDrawnLimits});
    return text + " mask " + (mask ? toText(hashOf(*mask)) : "unreadable");
}

bool drawingsAgree(const Shot& shot, const image::Image& first, const image::Image& second) {
    if (samePixels(first, second)) return true;
    if (!shot.statesTolerance && !ignoresSomething(shot)) return false;
    const Result<image::Image> seen = withoutIgnored(shot, first, second);
    if (!seen) return false;
    return shot.statesTolerance ? image::judge(first, *seen, shot.tolerance, false).same
                                : samePixels(first, *seen);
}

std::string judgedBy(const Shot& shot) {
    std::string text = ignoredText(shot);
    if (shot.statesTolerance) text += " stated";
    if (shot.retries > 0) text += fmt::format(" {} retries", shot.retries);
    if (!shot.quarantine.empty())
        text += fmt::format(" quarantine {} {}", shot.quarantine, today() <= shot.quarantine);
    return text.empty() ? text : "\n" + text;
}

Result<image::Image> withoutIgnored(const Shot& shot, const image::Image& golden, const image::Image& got) {
    if (golden.width != got.width || golden.height != got.height) return got;
    // Either may have an alpha or a finer type, which the other has not.
    const auto common = [&](const image::Image& picture) {
        return image::withType(image::withComponents(picture, std::max(golden.components, got.components)),
                               std::max(golden.type, got.type));
    };
    const image::Image expected = common(golden);
    image::Image seen = common(got);
    const std::size_t pixel = seen.rowBytes() / static_cast<std::size_t>(std::max(1, got.width));
    const auto hide = [&](int x, int y, int count) {
        const std::size_t at =
            static_cast<std::size_t>(y) * seen.rowBytes() + static_cast<std::size_t>(x) * pixel;
        std::memcpy(seen.data.data() + at, expected.data.data() + at,
                    static_cast<std::size_t>(count) * pixel);
    };
    for (const IgnoredRegion& each : activeRegions(shot)) {
        if (const auto problem = reachesOut(each, got.width, got.height)) return *problem;
        for (int y = each.y; y < each.y + each.height; ++y) hide(each.x, y, each.width);
    }
    if (shot.mask.empty()) return seen;
    const Result<image::Image> mask = readMask(shot, got.width, got.height);
    if (!mask) return mask.diagnostics;
    const image::Image bytes = image::withComponents(image::withType(*mask, image::Component::u8), 4);
    const auto isWhite = [](std::byte value) { return value >= std::byte{128}; };
    for (int y = 0; y < got.height; ++y)
        for (int x = 0; x < got.width; ++x)
            if (std::ranges::all_of(bytes.row(y).subspan(4 * static_cast<std::size_t>(x), 4), isWhite))
                hide(x, y, 1);
    return seen;
}

}  // namespace glibra::suite
