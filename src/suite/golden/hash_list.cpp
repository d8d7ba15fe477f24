#include "suite/golden/hash_list.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdint>
#include <cstdlib>
#include <functional>
#include <sstream>
#include <system_error>
#include <tuple>

#include "base/contained.h"
#include "base/files.h"
#include "base/text.h"
#include "image/file.h"
#include "suite/file/shot_name.h"
#include "suite/write_below.h"
#include "system/file.h"
#include "system/places.h"

namespace glibra::suite {

Hash hashOf(const image::Image& picture) {
    const std::array<std::int32_t, 4> shape{picture.width, picture.height, picture.components,
                                            static_cast<std::int32_t>(picture.type)};
    return base::hashOf({std::as_bytes(std::span(shape)), picture.data});
}

Hash hashOf(std::span<const std::byte> bytes) {
    return base::hashOf({bytes});
}

std::string toText(const Hash& hash) {
    return fmt::format("{:016x}{:016x}", hash.high, hash.low);
}

std::optional<Hash> parseHash(std::string_view text) {
    constexpr std::size_t kDigits = 16;
    if (text.size() != 2 * kDigits) return std::nullopt;
    Hash hash;
    const auto half = [&](std::size_t at, std::uint64_t& value) {
        const char* begin = text.data() + at;
        const auto [end, failed] = std::from_chars(begin, begin + kDigits, value, 16);
        return failed == std::errc{} && end == begin + kDigits;
    };
    if (!half(0, hash.high) || !half(kDigits, hash.low)) return std::nullopt;
    return hash;
}

namespace {

/// Processor features that change how floating point is computed, as /proc/cpuinfo names them.
constexpr std::array<std::string_view, 12> kFeatures{"sse4_1", "avx",     "avx2",     "fma",
                                                     "f16c",   "avx512f", "avx512dq", "avx512bw",
                                                     "asimd",  "asimdhp", "sve",      "vsx"};
/// Environment variables that change the code that Mesa generates.
constexpr std::array<const char*, 4> kSwitches{"GALLIUM_OVERRIDE_CPU_CAPS", "LP_NATIVE_VECTOR_WIDTH",
                                               "GALLIVM_PERF", "LP_PERF"};

std::string processor() {
    constexpr std::string_view kMakers[] = {"vendor_id", "CPU implementer"}, kLists[] = {"flags", "Features"};
    std::string words = system::processorFact(kMakers);
    std::istringstream flags(system::processorFact(kLists));
    for (std::string flag; flags >> flag;)
        if (std::ranges::find(kFeatures, flag) != kFeatures.end()) words += " " + flag;
    return words;
}

}  // namespace

std::string driverKey(const gpu::Capabilities& driver) {
    std::string key = driver.renderer + "; " + driver.version;
    if (driver.isSoftware) {
        key += "; " + processor();
        for (const char* each : kSwitches)
            if (const char* value = std::getenv(each)) key += fmt::format("; {}={}", each, value);
    }
    std::ranges::replace_if(key, [](unsigned char c) { return c < ' '; }, ' ');  // it is one line
    return key;
}

std::vector<std::string> variantsFor(std::string_view family) {
    std::vector<std::string> words{std::string(family)};
    constexpr std::string_view kOsmesa = "osmesa-";
    if (family.starts_with(kOsmesa)) words.emplace_back(family.substr(kOsmesa.size()));
    return words;
}

std::string describeMachine() {
    const std::string model = system::processorModel();
    return model + (model.empty() ? "" : ", ") + system::systemName();
}

namespace {

namespace fs = std::filesystem;

constexpr std::string_view kHeading =
    "# Pixels that were accepted: shot, golden variant, hash of the golden file, hash of the pixels, "
    "driver.\n"
    "# Written by glibra test --update. Lines may be deleted at any time.\n";
constexpr std::uint64_t kLargestHashList = 256ULL << 20;

/// Reads the list, changes it and writes it, if that makes a difference.
Diagnostics changeList(const fs::path& file, const std::function<void(HashList&)>& change) {
    // The folder itself is locked for this process, if the file system has locks, so that no lock file is
    // left among the goldens.
    const fs::path folder = file.has_parent_path() ? file.parent_path() : ".";
    system::Lock lock;
    lock.takeFolder(folder, system::Lock::Wait::yes);
    Result<HashList> list = HashList::read(file);
    const std::string before = list->toText();
    change(*list);
    const std::string after = list->toText();
    std::error_code failure;
    if (after == before && fs::exists(file, failure)) return {};
    if (fs::is_symlink(file, failure))
        return {image::cannotWrite(
            file, "it is a symbolic link, and its target would be overwritten; remove the link")};
    const int problem =
        base::writeBeneath(file.parent_path(), file.filename(), std::as_bytes(std::span(after)));
    return problem == 0 ? Diagnostics{} : Diagnostics{cannotWrite(file, problem)};
}

}  // namespace

bool isVariant(std::string_view word) {
    return word.empty() || shotOfVariant(fmt::format("a.{}", word)) == "a";
}

bool isKey(std::string_view text) {
    constexpr std::size_t kLongest = 1000;
    return !text.empty() && text.size() <= kLongest &&
           std::ranges::none_of(text, [](unsigned char each) { return each < ' '; });
}

std::string toLine(const AcceptedHash& accepted) {
    return fmt::format("{} {} {} {} {}", accepted.shot, accepted.variant.empty() ? "-" : accepted.variant,
                       toText(accepted.golden), toText(accepted.pixels), accepted.key);
}

Result<AcceptedHash> parseLine(std::string_view line, const Place& place) {
    std::array<std::string_view, 4> words;
    std::string_view rest = line;
    for (std::string_view& word : words) {
        const std::size_t blank = std::min(rest.find(' '), rest.size());
        word = rest.substr(0, blank);
        rest.remove_prefix(std::min(blank + 1, rest.size()));
    }
    const std::optional<Hash> golden = parseHash(words[2]);
    const std::optional<Hash> pixels = parseHash(words[3]);
    const std::string_view variant = words[1] == "-" ? std::string_view() : words[1];
    if (!golden || !pixels || rest.empty() || !isVariant(variant))
        return diagnose("suite-W01", "this is not a line of accepted pixels; it is ignored", place);
    return AcceptedHash{std::string(words[0]), std::string(variant), *golden, *pixels, std::string(rest)};
}

Result<HashList> HashList::read(const fs::path& file) {
    Result<HashList> list{HashList()};
    std::error_code failure;
    const fs::file_type type = fs::status(file, failure).type();
    // All lines may have been deleted.
    if (type == fs::file_type::not_found || (type == fs::file_type::regular && fs::is_empty(file, failure)))
        return list;
    const Place place{file.generic_string(), 1, 1};
    const auto bytes = image::readFile(file, {file.generic_string(), place}, kLargestHashList);
    if (!bytes) {
        for (Diagnostic each : bytes.diagnostics) {
            each.severity = Severity::warning;
            list.diagnostics.push_back(std::move(each));
        }
        list->isUnknown_ = true;
        return list;
    }
    std::string_view rest = base::asText(*bytes);
    for (int number = 1; !rest.empty(); ++number) {
        const std::string_view line = base::nextLine(rest);
        if (line.empty() || line.front() == '#') continue;
        Result<AcceptedHash> parsed = parseLine(line, {file.generic_string(), number, 1});
        append(list.diagnostics, std::move(parsed.diagnostics));
        if (parsed) list->ofShot_[parsed->shot].push_back(std::move(*parsed));
    }
    return list;
}

const Hash* HashList::find(const std::string& shot, const std::string& variant, const Hash& golden,
                           const std::string& key) const {
    const auto found = ofShot_.find(shot);
    if (found == ofShot_.end()) return nullptr;
    for (const AcceptedHash& each : found->second)
        if (each.variant == variant && each.golden == golden && each.key == key) return &each.pixels;
    return nullptr;
}

std::set<std::string> HashList::shots() const {
    std::set<std::string> names;
    for (const auto& [shot, lines] : ofShot_) names.insert(shot);
    return names;
}

std::vector<AcceptedHash> HashList::linesOf(const std::string& shot) const {
    const auto found = ofShot_.find(shot);
    if (found == ofShot_.end()) return {};
    std::vector<AcceptedHash> lines = found->second;
    std::ranges::sort(lines, [](const AcceptedHash& a, const AcceptedHash& b) {
        return std::tie(a.variant, a.key) < std::tie(b.variant, b.key);
    });
    return lines;
}

void HashList::accept(std::span<const AcceptedHash> accepted) {
    for (const AcceptedHash& each : accepted) {
        std::vector<AcceptedHash>& lines = ofShot_[each.shot];
        std::erase_if(lines, [&](const AcceptedHash& line) {
            return line.variant == each.variant && (line.key == each.key || line.golden != each.golden);
        });
        lines.push_back(each);
    }
}

void HashList::restore(const std::string& shot, const std::string& variant,
                       std::span<const AcceptedHash> lines) {
    std::vector<AcceptedHash>& all = ofShot_[shot];
    std::erase_if(all, [&](const AcceptedHash& line) { return line.variant == variant; });
    all.insert(all.end(), lines.begin(), lines.end());
    if (all.empty()) ofShot_.erase(shot);
}

void HashList::rename(const std::string& shot, const std::string& to) {
    std::vector<AcceptedHash> lines = linesOf(shot);
    ofShot_.erase(shot);
    for (AcceptedHash& each : lines) each.shot = to;
    accept(lines);
}

std::string HashList::toText() const {
    std::string text(kHeading);
    for (const auto& [shot, lines] : ofShot_)
        for (const AcceptedHash& each : linesOf(shot)) text += toLine(each) + "\n";
    return text;
}

Diagnostics acceptHashes(const fs::path& file, std::span<const AcceptedHash> accepted) {
    if (accepted.empty()) return {};
    return changeList(file, [&](HashList& list) { list.accept(accepted); });
}

Diagnostics restoreHashes(const fs::path& file, const std::string& shot, const std::string& variant,
                          std::span<const AcceptedHash> lines) {
    return changeList(file, [&](HashList& list) { list.restore(shot, variant, lines); });
}

Diagnostics renameHashes(const fs::path& file, const std::string& shot, const std::string& to) {
    return changeList(file, [&](HashList& list) { list.rename(shot, to); });
}

}  // namespace glibra::suite
