#include "suite/golden/picture_store.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <cstring>
#include <list>
#include <set>
#include <system_error>
#include <utility>

#include "base/contained.h"
#include "base/files.h"
#include "base/hash.h"
#include "base/text.h"
#include "base/utf8.h"
#include "image/file.h"
#include "image/png/png_writer.h"
#include "suite/file/shot_name.h"
#include "suite/write_below.h"
#include "system/places.h"
#include "system/process.h"

namespace glibra::suite {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kVersion = "version https://git-lfs.github.com/spec/v1";
constexpr std::string_view kOid = "oid sha256:", kSize = "size ";
constexpr std::size_t kLongestPointer = 1024;
constexpr std::size_t kHashLength = 64;
constexpr std::uint64_t kLargestPicture = std::uint64_t{256} << 20U;
/// A golden is written once and kept for years, so it may take longer to write and should be small.
constexpr int kCompression = 9;

bool isSha256(std::string_view text) {
    return text.size() == kHashLength &&
           std::ranges::all_of(text, [](char c) { return base::isDigit(c) || (c >= 'a' && c <= 'f'); });
}

/// The bytes of a file if they are those of the pointer.
std::optional<std::vector<std::byte>> rightBytes(const fs::path& file, const Pointer& pointer) {
    if (pointer.size > kLargestPicture) return std::nullopt;
    auto bytes = image::readFile(file, {file.generic_string(), {}}, pointer.size);
    if (!bytes || pointerTo(*bytes) != pointer) return std::nullopt;
    return std::move(*bytes);
}

}  // namespace

std::optional<Pointer> parsePointer(std::span<const std::byte> file) {
    if (file.size() > kLongestPointer) return std::nullopt;
    std::string_view rest = base::asText(file);
    if (!rest.starts_with(kVersion)) return std::nullopt;
    Pointer pointer;
    bool hasSize = false;
    while (!rest.empty()) {
        std::string_view line = base::nextLine(rest);
        if (line.starts_with(kOid)) pointer.sha256 = line.substr(kOid.size());
        if (!line.starts_with(kSize)) continue;
        line.remove_prefix(kSize.size());
        const auto [end, error] = std::from_chars(line.data(), line.data() + line.size(), pointer.size);
        hasSize = error == std::errc() && end == line.data() + line.size() && pointer.size > 0;
    }
    if (!isSha256(pointer.sha256) || !hasSize) return std::nullopt;
    return pointer;
}

Pointer pointerTo(std::span<const std::byte> picture) {
    return {base::sha256Text(picture), picture.size()};
}

std::string toText(const Pointer& pointer) {
    return fmt::format("{}\n{}{}\n{}{}\n", kVersion, kOid, pointer.sha256, kSize, pointer.size);
}

std::vector<std::byte> goldenBytes(const image::Image& picture) {
    image::PngOptions options;
    options.level = kCompression;
    return image::encodePng(
        picture.type == image::Component::f32 ? image::withType(picture, image::Component::u16) : picture,
        options);
}

bool PictureStore::isRemote() const {
    return isAddress(store_);
}

std::string PictureStore::placeOf(const Pointer& pointer, const std::string& ending) const {
    if (!isRemote()) return (fs::path(store_) / (pointer.sha256 + ending)).generic_string();
    std::string address = store_;
    return address.replace(address.find(kHashSlot), kHashSlot.size(), pointer.sha256);
}

/// The folder of the downloads, in the user's cache; any of its files may be removed. Empty if there is none.
static fs::path downloadFolder() {
    const fs::path cache = system::userFolder(system::UserFolder::cache);
    return cache.empty() ? cache : cache / "goldens";
}

std::optional<std::vector<std::byte>> PictureStore::find(const Pointer& pointer,
                                                         const std::string& ending) const {
    if (isNamed() && !isRemote())
        if (auto bytes = rightBytes(placeOf(pointer, ending), pointer)) return bytes;
    const fs::path folder = downloadFolder();
    if (folder.empty()) return std::nullopt;
    return rightBytes(folder / pointer.sha256, pointer);
}

Diagnostics PictureStore::keep(std::span<const std::byte> picture, const std::string& ending) const {
    const Pointer pointer = pointerTo(picture);
    const fs::path place = placeOf(pointer, ending);
    if (!isRemote())
        return rightBytes(place, pointer) ? Diagnostics() : writeBelow(store_, place.filename(), picture);
    // Without a cache the next run downloads what was uploaded.
    if (const fs::path folder = downloadFolder(); !folder.empty())
        static_cast<void>(base::writeBeneath(folder, pointer.sha256, picture));
    std::string name = place.filename().generic_string();
    for (char& each : name)  // a registry's "sha256:HASH" is no file's name on Windows
        if (std::string_view("<>:\"|?*\\").find(each) != std::string_view::npos) each = '_';
    return writeBelow(uploads_.parent_path(), uploads_.filename() / name, picture);
}

namespace {

constexpr std::uint64_t kLargestErrorPage = std::uint64_t{1} << 20U;  ///< that curl reads past, to its status
constexpr std::size_t kAtOnce = 8;  ///< downloads, and failures after which no more are tried

/// A download that runs.
class Running {
  public:
    Running(Download& wanted, const fs::path& folder, std::size_t number)
        : wanted_(&wanted),
          folder_(folder),
          file_(folder / fmt::format(".glibra-{}-{}", system::ownNumber(), number)),
          words_(file_.generic_string() + ".err") {
        const bool isSecure = wanted.address.starts_with("https:");
        process_ = system::startProgram(
            {"curl",
             "--disable",
             "--globoff",
             "--silent",
             "--show-error",
             "--fail",
             "--location",
             "--max-redirs",
             "5",
             "--proto",
             isSecure ? "=https" : "=https,http",
             "--proto-redir",
             isSecure ? "=https" : "=https,http",
             "--netrc-optional",
             "--connect-timeout",
             "10",
             "--max-time",
             "120",
             "--speed-limit",
             "1000",
             "--speed-time",
             "20",
             "--max-filesize",
             std::to_string(std::max(wanted.pointer.size, kLargestErrorPage)),
             "--stderr",
             words_.generic_string(),
             "--output",
             file_.generic_string(),
             "--url",
             wanted.address},
            {system::Stream::To::nothing, system::Stream::To::nothing, system::Stream::To::nothing});
        if (!process_) {
            wanted.whyNot = "the program 'curl' cannot be started; install it";
            isOver_ = true;
        }
    }
    Running(const Running&) = delete;
    Running& operator=(const Running&) = delete;
    ~Running() {
        if (process_) {
            system::kill(process_);
            system::waitFor(process_);
        }
        std::error_code ignored;
        fs::remove(file_, ignored);
        fs::remove(words_, ignored);
    }

    /// Waits for a moment. True once it is over.
    bool isOver(bool isStopped) {
        constexpr double kMoment = .02;  // seconds
        if (isOver_) return true;
        if (isStopped) {
            wanted_->whyNot = "the run was stopped";
            return true;
        }
        const std::optional<system::End> ended = system::waitFor(process_, kMoment);
        std::error_code ignored;
        const std::uintmax_t size = fs::exists(file_, ignored) ? fs::file_size(file_, ignored) : 0;
        // curl looks at the length that the server states, which need not be true.
        if (size > wanted_->pointer.size) {
            wanted_->whyNot =
                fmt::format("it is larger than the {} bytes of its pointer", wanted_->pointer.size);
            return true;
        }
        if (!ended) return false;
        isOver_ = true;
        wanted_->whyNot = ended->isGood() ? take() : reason(*ended);
        return true;
    }
    [[nodiscard]] bool isGood() const { return wanted_->whyNot.empty(); }

  private:
    /// Puts what has come among the downloads. Returns why not, or nothing.
    [[nodiscard]] std::string take() const {
        const auto bytes = rightBytes(file_, wanted_->pointer);
        if (!bytes) return "what the server gives is not the picture: its SHA-256 is another one";
        const Diagnostics problems = writeBelow(folder_, wanted_->pointer.sha256, *bytes);
        return hasError(problems) ? problems.front().text : std::string();
    }
    /// "curl: (22) The requested URL returned error: 404".
    [[nodiscard]] std::string reason(const system::End& ended) const {
        constexpr std::uint64_t kLongest = 4096;
        const auto bytes = image::readFile(words_, {words_.generic_string(), {}}, kLongest);
        std::string text(bytes ? base::asText(*bytes) : "");
        text = base::printableText(text.substr(0, text.find('\n')));
        return text.empty() ? fmt::format("curl ended with status {}", ended.status) : text;
    }

    Download* wanted_;
    fs::path folder_, file_, words_;
    system::Process process_;
    bool isOver_ = false;
};

}  // namespace

void download(std::span<Download> wanted, const std::function<bool()>& stop) {
    const fs::path folder = downloadFolder();
    std::error_code failure;
    if (!folder.empty()) fs::create_directories(folder, failure);
    std::list<Running> running;
    std::size_t next = 0, failed = 0, good = 0;
    std::string first;  // reason of a failure
    while (next < wanted.size() || !running.empty()) {
        while (next < wanted.size() && running.size() < kAtOnce) {
            Download& each = wanted[next++];
            if (folder.empty() || failure)
                each.whyNot =
                    "there is no folder for downloads; set HOME or XDG_CACHE_HOME (Windows: LOCALAPPDATA)";
            else if (each.pointer.size > kLargestPicture)
                each.whyNot = "it is larger than 256 MiB";
            else if (stop())
                each.whyNot = "the run was stopped";
            else if (failed >= kAtOnce && good == 0)
                each.whyNot = fmt::format("not tried after {} failures: {}", failed, first);
            else if (!rightBytes(folder / each.pointer.sha256, each.pointer))
                running.emplace_back(each, folder, next);
        }
        for (auto each = running.begin(); each != running.end();) {
            if (!each->isOver(stop())) {
                ++each;
                continue;
            }
            ++(each->isGood() ? good : failed);
            each = running.erase(each);
        }
        if (first.empty())
            for (const Download& each : wanted.first(next))
                if (first.empty()) first = each.whyNot;
    }
}

std::string pullCommand(std::span<const fs::path> goldens) {
    constexpr std::size_t kMostNames = 50;
    std::error_code failure;
    std::set<std::string> names;
    for (const fs::path& each : goldens) {
        // Patterns begin at the root of the working tree.
        const fs::path whole = fs::absolute(each, failure).lexically_normal();
        fs::path root = whole.parent_path();
        while (root.has_relative_path() && !fs::exists(root / ".git", failure)) root = root.parent_path();
        const fs::path named = goldens.size() > kMostNames ? whole.parent_path() : whole;
        std::string name =
            (fs::exists(root / ".git", failure) ? named.lexically_relative(root) : named).generic_string();
        // A comma ends a pattern, and the others have a meaning in one.
        std::ranges::replace_if(
            name, [](char c) { return std::strchr(",*[]\\", c) != nullptr && c != '\0'; }, '?');
        names.insert(std::move(name));
    }
    return "git lfs pull --include " + base::shellWord(fmt::format("{}", fmt::join(names, ",")));
}

}  // namespace glibra::suite
