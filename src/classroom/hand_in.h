#pragma once
// What is known about a hand-in besides its content: when it came, and whether it is still the same.

#include <glibra/render.h>

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "image/image.h"

namespace glibra::classroom {

// When something was handed in, and how late that is, in the forms that learning platforms write.

/// The begun days from one time to another; 0 if the second is not later; nothing if one cannot be read.
/// Seconds do not count, and a day without a time of day ends with it. Read are
/// - "2026-11-20 23:59", also with a T between, seconds, fractions, and Z, UTC, +01:00 or -0800 after it;
/// - "20.11.2026 23:59";
/// - "Friday, 20 November 2026, 11:45 PM", as Moodle writes it in English, German, French, Spanish, Italian,
///   Dutch and Portuguese, and "November 20, 2026", as in the USA.
/// If only one of the two has a time zone, the other is a time of this machine's zone.
std::optional<double> daysBetween(std::string_view due, std::string_view time);

/// True for a text that daysBetween reads.
bool isTime(std::string_view text);

/// The begun days of a lateness in hours, minutes and seconds, as Gradescope has it: "27:13:05" is 2.
std::optional<double> latenessOf(std::string_view hours);

/// What the column "Status" of Moodle's grading worksheet says: "Submitted for grading - 1 day 3 hours late",
/// in the same languages. Moodle counts from the student's own due date, and leaves out what is less than its
/// two largest units.
struct MoodleStatus {
    std::optional<double> daysLate;  ///< begun days; nothing if it does not say that it is late
    bool isExtended = false;         ///< the student was granted more time
};
MoodleStatus readMoodleStatus(std::string_view status);

// Whether a student has handed in something else since points were typed.

/// A digest of what was handed in, by names and contents; of files beyond a limit by their sizes alone. Of a
/// folder these are all its files; of a scene that lies alone among the submissions it is the scene and all
/// that the pictures read of that folder, but not what was given to all (`shaders` and `textures`).
std::string digestOfHandIn(const std::filesystem::path& handedIn, std::span<const RenderOptions> pictures);

// Pictures for pages that are sent: small ones.

/// A picture as the address of an <img>, which has its content: with at most 256 pixels on the longer side,
/// and 256 colours if it would be more than 24 KiB otherwise.
std::string smallPicture(const image::Image& picture);

/// True for what smallPicture() returns: nothing but a picture, whoever sent it.
bool isSmallPicture(std::string_view address);

}  // namespace glibra::classroom
