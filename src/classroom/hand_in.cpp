#include "classroom/hand_in.h"

#include <algorithm>
#include <charconv>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <ctime>
#include <iterator>
#include <set>
#include <system_error>
#include <vector>

#include "base/contained.h"
#include "base/files.h"
#include "base/text.h"
#include "classroom/effect.h"
#include "image/png/png_writer.h"
#include "image/video/video_file.h"
#include "render/file/scene_inputs.h"
#include "suite/golden/hash_list.h"
#include "suite/number_of.h"
#include "suite/report/report_pictures.h"
#include "system/places.h"

namespace glibra::classroom {
namespace {

/// Minutes since 1970, of UTC or of a clock on the wall.
struct ReadTime {
    std::int64_t minutes = 0;
    bool isUtc = false;
};

/// How the names of the twelve months begin in the languages of hand_in.h. "mar" alone would also be a
/// Tuesday.
constexpr std::string_view kMonths[] = {"jan ene gen",
                                        "feb fev f\303\251v",
                                        "march mars marzo maart m\303\244r mar\303\247o",
                                        "apr avr abr",
                                        "may mai mag mei",
                                        "jun juin giu",
                                        "jul juil lug",
                                        "aug ago ao\303\273",
                                        "sep set",
                                        "oct okt ott out",
                                        "nov",
                                        "dec dez dic d\303\251c"};

constexpr std::string_view kLate[] = {"late",    "zu sp\xC3\xA4t", "en retard", "despu\xC3\xA9s",
                                      "ritardo", "te laat",        "atras"};
constexpr std::string_view kExtended[] = {"xten",    "erl\xC3\xA4ngerung", "prolong", "ampliaci",
                                          "proroga", "erlenging",          "prorroga"};
constexpr std::string_view kDays[] = {"day", "tag", "jour", "d\303\255a", "dia", "giorn", "dag"};
constexpr std::string_view kYears[] = {"year", "jahr", "an", "a\303\261o", "jaar"};

/// A letter, or a byte of one beyond ASCII.
bool isLetter(char c) {
    return base::isLetter(c) || static_cast<unsigned char>(c) >= 0x80;
}

/// A run of digits, of letters, or one other character that is no blank.
std::vector<std::string_view> partsOf(std::string_view text) {
    std::vector<std::string_view> parts;
    for (std::size_t i = 0; i < text.size();) {
        std::size_t end = i + 1;
        for (const auto& kind : {base::isDigit, isLetter})
            while (kind(text[i]) && end < text.size() && kind(text[end])) ++end;
        if (text[i] != ' ' && text[i] != '\t') parts.push_back(text.substr(i, end - i));
        i = end;
    }
    return parts;
}

bool contains(std::string_view text, std::span<const std::string_view> words) {
    return std::ranges::any_of(
        words, [&](std::string_view each) { return text.find(each) != std::string_view::npos; });
}

bool begins(std::string_view text, std::span<const std::string_view> words) {
    return std::ranges::any_of(words, [&](std::string_view each) { return text.starts_with(each); });
}

/// A number of at most four digits, or -1.
int numberAt(const std::vector<std::string_view>& parts, std::size_t i) {
    if (i >= parts.size() || !base::isDigit(parts[i][0]) || parts[i].size() > 4) return -1;
    int value = 0;
    std::from_chars(parts[i].data(), parts[i].data() + parts[i].size(), value);
    return value;
}

bool isAt(const std::vector<std::string_view>& parts, std::size_t i, std::string_view text) {
    return i < parts.size() && parts[i] == text;
}

struct Fields {
    int year = -1, month = -1, day = -1, hour = 23, minute = 59;
    std::optional<int> zone;  ///< minutes east of UTC
};

/// Reads "23:59", "23:59:30.25" or "11:45 pm" from `i` on, and moves it after that; false if there is no
/// such.
bool readClock(const std::vector<std::string_view>& parts, std::size_t& i, Fields& to) {
    const int hour = numberAt(parts, i), minute = numberAt(parts, i + 2);
    if (hour < 0 || minute < 0 || !(isAt(parts, i + 1, ":") || isAt(parts, i + 1, "h"))) return false;
    to.hour = hour;
    to.minute = minute;
    i += 3;
    if (isAt(parts, i, ":") && numberAt(parts, i + 1) >= 0) i += 2;
    if (isAt(parts, i, ".") && i + 1 < parts.size() && base::isDigit(parts[i + 1][0])) i += 2;
    const bool isAfternoon = isAt(parts, i, "pm");
    if (isAfternoon || isAt(parts, i, "am")) {
        if (to.hour < 1 || to.hour > 12) return false;
        to.hour = to.hour % 12 + (isAfternoon ? 12 : 0);
        ++i;
    }
    return true;
}

/// Reads "z", "utc", "+01:00" or "-0800"; false if something else is left.
bool readZone(const std::vector<std::string_view>& parts, std::size_t i, Fields& to) {
    if (i == parts.size()) return true;
    if (isAt(parts, i, "z") || isAt(parts, i, "utc") || isAt(parts, i, "gmt")) {
        to.zone = 0;
        return i + 1 == parts.size();
    }
    if (!isAt(parts, i, "+") && !isAt(parts, i, "-")) return false;
    const int sign = parts[i] == "+" ? 1 : -1, first = numberAt(parts, i + 1);
    if (first < 0) return false;
    int minutes = 0;
    if (parts[i + 1].size() == 4) {
        minutes = first / 100 * 60 + first % 100;
        i += 2;
    } else {
        const bool hasMinutes = isAt(parts, i + 2, ":") && numberAt(parts, i + 3) >= 0;
        minutes = first * 60 + (hasMinutes ? numberAt(parts, i + 3) : 0);
        i += hasMinutes ? 4 : 2;
    }
    to.zone = sign * minutes;
    return i == parts.size();
}

/// "2026-11-20 23:59" and "20.11.2026 23:59".
std::optional<Fields> readDigits(const std::vector<std::string_view>& parts) {
    Fields read;
    const int first = numberAt(parts, 0), second = numberAt(parts, 2), third = numberAt(parts, 4);
    if (first < 0 || second < 0 || third < 0) return std::nullopt;
    if (isAt(parts, 1, "-") && isAt(parts, 3, "-") && parts[0].size() == 4)
        read.year = first, read.month = second, read.day = third;
    else if (isAt(parts, 1, ".") && isAt(parts, 3, ".") && parts[4].size() == 4)
        read.day = first, read.month = second, read.year = third;
    else
        return std::nullopt;
    std::size_t i = 5;
    if (isAt(parts, i, "t") || isAt(parts, i, ",")) ++i;
    if (i == parts.size()) return read;
    if (!readClock(parts, i, read) || !readZone(parts, i, read)) return std::nullopt;
    return read;
}

/// "friday, 20 november 2026, 11:45 pm"
std::optional<Fields> readWords(const std::vector<std::string_view>& parts) {
    Fields read;
    for (std::size_t i = 0; i < parts.size(); ++i) {
        const std::string_view part = parts[i];
        if (std::size_t after = i; readClock(parts, after, read)) {
            i = after - 1;
        } else if (base::isDigit(part[0])) {
            int& field = part.size() == 4 ? read.year : read.day;
            if (field >= 0 || part.size() == 3) return std::nullopt;
            field = numberAt(parts, i);
        } else if (isLetter(part[0])) {
            const auto* const names = std::ranges::find_if(
                kMonths, [&](std::string_view each) { return begins(part, partsOf(each)); });
            if (names == std::end(kMonths)) continue;
            const int month = static_cast<int>(names - std::begin(kMonths)) + 1;
            if (read.month > 0 && read.month != month) return std::nullopt;
            read.month = month;
        }
    }
    return read;
}

std::optional<ReadTime> readTime(std::string_view text) {
    constexpr std::size_t kLongest = 100;
    if (text.size() > kLongest) return std::nullopt;
    const std::string lower = base::lower(text);
    const std::vector<std::string_view> parts = partsOf(lower);
    std::optional<Fields> read = readDigits(parts);
    if (!read) read = readWords(parts);
    if (!read || read->year < 0 || read->month < 0 || read->day < 0) return std::nullopt;
    using namespace std::chrono;
    const year_month_day day{year(read->year), month(static_cast<unsigned>(read->month)),
                             std::chrono::day(static_cast<unsigned>(read->day))};
    if (!day.ok() || read->hour > 23 || read->minute > 59) return std::nullopt;
    const std::int64_t minutes =
        std::int64_t{sys_days(day).time_since_epoch().count()} * 24 * 60 + read->hour * 60 + read->minute;
    return ReadTime{minutes - read->zone.value_or(0), read->zone.has_value()};
}

/// What a clock on the wall shows at that time, in the zone of this machine.
std::int64_t onTheWall(const ReadTime& time) {
    if (!time.isUtc) return time.minutes;
    const std::time_t seconds = static_cast<std::time_t>(time.minutes) * 60;
    const std::optional<system::LocalTime> local = system::localTime(seconds);
    return time.minutes + (local ? local->minutesAhead : 0);
}

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

constexpr std::string_view kPng = "data:image/png;base64,", kGif = "data:image/gif;base64,";

}  // namespace

std::optional<double> daysBetween(std::string_view due, std::string_view time) {
    const std::optional<ReadTime> a = readTime(due), b = readTime(time);
    if (!a || !b) return std::nullopt;
    const bool isSame = a->isUtc == b->isUtc;
    const std::int64_t minutes = isSame ? b->minutes - a->minutes : onTheWall(*b) - onTheWall(*a);
    constexpr std::int64_t kDay = std::int64_t{24} * 60;
    return minutes <= 0 ? 0.0 : static_cast<double>((minutes + kDay - 1) / kDay);
}

bool isTime(std::string_view text) {
    return readTime(text).has_value();
}

std::optional<double> latenessOf(std::string_view hours) {
    const std::vector<std::string_view> parts = partsOf(hours);
    if (parts.size() != 5 || parts[1] != ":" || parts[3] != ":") return std::nullopt;
    std::int64_t seconds = 0;
    for (const std::size_t i : {0U, 2U, 4U}) {
        const auto number = suite::numberOf<int>(parts[i]);
        if (!number) return std::nullopt;
        seconds = 60 * seconds + *number;
    }
    constexpr std::int64_t kDay = 24 * 60 * 60;
    return static_cast<double>((seconds + kDay - 1) / kDay);
}

MoodleStatus readMoodleStatus(std::string_view status) {
    MoodleStatus read;
    const std::string lower = base::lower(status);
    read.isExtended = contains(lower, kExtended);
    std::string_view rest = lower;
    while (!rest.empty()) {
        const std::size_t end = std::min(rest.find(" - "), rest.size());
        const std::string_view sentence = rest.substr(0, end);
        rest.remove_prefix(std::min(end + 3, rest.size()));
        if (!contains(sentence, kLate)) continue;
        const std::vector<std::string_view> parts = partsOf(sentence);
        double days = 0;
        bool hasRest = false, hasNumber = false;
        for (std::size_t i = 0; i + 1 < parts.size(); ++i) {
            const int number = numberAt(parts, i);
            if (number < 0) continue;
            hasNumber = true;
            if (begins(parts[i + 1], kDays))
                days += number;
            else if (begins(parts[i + 1], kYears))
                days += 365. * number;
            else
                hasRest = hasRest || number > 0;
        }
        if (hasNumber) read.daysLate = days + (hasRest ? 1 : 0);
    }
    return read;
}

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
