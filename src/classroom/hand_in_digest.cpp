#include "classroom/hand_in_digest.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <set>
#include <string_view>
#include <system_error>
#include <vector>

#include "base/contained.h"
#include "base/files.h"
#include "classroom/effect.h"
#include "image/png/png_writer.h"
#include "image/video/video_file.h"
#include "render/file/scene_inputs.h"
#include "suite/golden/hash_list.h"
#include "suite/report/report_pictures.h"

namespace glibra::classroom {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostHandedIn = 20'000;  // files of a submission
constexpr std::uint64_t kMostDigested = std::uint64_t{128} << 20U;

/// All files of a folder, relative to it.
std::set<fs::path> filesIn(const fs::path& folder) {
    std::set<fs::path> files;
    std::error_code failure;
    fs::recursive_directory_iterator each(folder, fs::directory_options::skip_permission_denied, failure);
    for (; !failure && each != fs::recursive_directory_iterator() && files.size() < kMostHandedIn;
         each.increment(failure))
        if (each->symlink_status(failure).type() == fs::file_type::regular)
            files.insert(each->path().lexically_relative(folder));
    return files;
}

/// A scene that lies alone among the submissions, and what its pictures read of that folder; not what was
/// given to all.
std::set<fs::path> filesReadBy(const fs::path& scene, const fs::path& folder,
                               std::span<const RenderOptions> pictures) {
    std::set<fs::path> files{scene.filename()};
    for (const RenderOptions& each : pictures)
        for (const fs::path& read : render::filesReadBy(scene, each).files) {
            const fs::path inside =
                fs::absolute(read).lexically_normal().lexically_relative(fs::absolute(folder));
            const std::string first = inside.empty() ? ".." : inside.begin()->generic_string();
            if (first != ".." && first != "shaders" && first != "textures") files.insert(inside);
        }
    return files;
}

}  // namespace

std::string digestOfHandIn(const std::filesystem::path& handedIn, std::span<const RenderOptions> pictures) {
    std::error_code failure;
    const bool isFolder = fs::is_directory(handedIn, failure);
    fs::path folder = isFolder ? handedIn : handedIn.parent_path();
    if (folder.empty()) folder = ".";
    folder = folder.lexically_normal();
    std::string whole;
    std::uint64_t left = kMostDigested;
    for (const fs::path& each : isFolder ? filesIn(folder) : filesReadBy(handedIn, folder, pictures)) {
        const auto bytes = base::bytesIn(base::openBeneath(folder, each), left);
        if (bytes) left -= bytes->size();
        whole += each.generic_string() + '\0' +
                 (bytes ? suite::toText(suite::hashOf(*bytes))
                        : std::to_string(fs::file_size(folder / each, failure))) +
                 '\n';
    }
    return suite::toText(suite::hashOf(std::as_bytes(std::span(whole))));
}

namespace {

constexpr std::string_view kPng = "data:image/png;base64,", kGif = "data:image/gif;base64,";

}  // namespace

std::string smallPicture(const image::Image& picture) {
    constexpr int kLongest = 256;  // pixels
    constexpr int kSmallest = 12;  // of libdeflate's levels
    constexpr std::size_t kLarge = 24U << 10U;
    const Colors colors = reduced(picture, kLongest);
    image::Image small{colors.width, colors.height, 3, image::Component::u8, {}};
    for (const Color& each : colors.at)
        for (const float one : each) small.data.push_back(static_cast<std::byte>(std::lround(255 * one)));
    const std::vector<std::byte> png =
        image::encodePng(small, {.level = kSmallest, .text = {}, .threads = 1});
    if (png.size() <= kLarge) return std::string(kPng) + suite::base64(png);
    const std::vector<std::byte> gif = image::encodeGif(small);
    return gif.size() < png.size() ? std::string(kGif) + suite::base64(gif)
                                   : std::string(kPng) + suite::base64(png);
}

bool isSmallPicture(std::string_view address) {
    const auto isDigit = [](char each) {
        return (each >= 'a' && each <= 'z') || (each >= 'A' && each <= 'Z') || (each >= '0' && each <= '9') ||
               each == '+' || each == '/' || each == '=';
    };
    return (address.starts_with(kPng) || address.starts_with(kGif)) &&
           std::ranges::all_of(address.substr(kPng.size()), isDigit);
}

}  // namespace glibra::classroom
