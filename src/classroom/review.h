#pragma once
// What can be found out about a submission without drawing it: its programs, its shader sources as tokens,
// and how its pictures differ from the reference's. It reads files of strangers, so it runs in worker
// processes.

#include <glibra/render.h>

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "classroom/classroom.h"
#include "glib/limits.h"

namespace glibra::classroom {

struct ReviewTask {
    std::filesystem::path scene;  ///< empty: only `sources`
    RenderOptions options;        ///< `within` is the submission's own folder; empty for the reference
    std::vector<RenderOptions> others{};                        ///< of the other pictures
    std::filesystem::path site;                                 ///< that the pictures are relative to
    std::vector<std::pair<std::string, std::string>> pictures;  ///< of the reference and of the submission
    std::optional<suite::ColorShare> has{};                     ///< what pictures of an exercise have
    std::vector<Slider> sliders;                                ///< whose pairs are indices of `pictures`
    std::vector<std::filesystem::path> sources;                 ///< files and folders of given code
    std::filesystem::path handedIn{};                           ///< the folder or file of the submission
    std::set<std::uint64_t> givenFunctions{};                   ///< ReachedCode::functions of given code
    std::vector<std::string> shown{};                           ///< pictures that a page to be sent shows
};

struct Review : Findings {
    std::vector<std::uint64_t> functions{};    ///< ReachedCode::functions of the reference or of given code
    std::vector<std::optional<Score>> scores;  ///< one per pair of pictures; nothing if one cannot be read
    std::vector<bool> showNothing{};           ///< one per picture of the submission
    std::vector<std::string> small{};  ///< smallPicture() of those that are shown; empty if it cannot be read
};

/// A shader source of more than this many bytes is not compared. No scene can use one.
inline constexpr std::uint64_t kLargestSource = glib::kLargestFile;

/// Reads no file outside of `options.within` and the library. `scored` is called after each pair of pictures.
Review review(const ReviewTask& task, const std::function<void()>& scored = {});

/// A review as text for the pipe of a worker. parseReview returns nothing for text that is none.
std::string toText(const Review& review);
std::optional<Review> parseReview(std::string_view text);

}  // namespace glibra::classroom
