#include "view/edit/recovery.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <ctime>
#include <nlohmann/json.hpp>
#include <span>
#include <system_error>

#include "base/files.h"
#include "image/file.h"
#include "suite/golden/hash_list.h"
#include "system/folder.h"
#include "system/places.h"
#include "system/process.h"

namespace glibra::view {
namespace {

namespace fs = std::filesystem;
constexpr std::uint64_t kLargestKept = 8ULL << 20;

/// Names the copies of a file, after its absolute path without links.
std::string nameOf(const fs::path& file) {
    std::error_code failure;
    const fs::path whole = system::wholePath(file), real = fs::weakly_canonical(whole, failure);
    const std::string path = (failure ? whole : real).generic_string();
    return suite::toText(suite::hashOf(std::as_bytes(std::span(path))));
}

std::string asDate(std::chrono::system_clock::time_point time) {
    const std::time_t seconds = std::chrono::system_clock::to_time_t(time);
    const std::tm local = system::localTime(seconds).value_or(system::LocalTime()).time;
    std::array<char, 32> text{};
    return {text.data(), std::strftime(text.data(), text.size(), "%Y-%m-%d %H:%M", &local)};
}

fs::path lockOf(const fs::path& folder, const std::string& owner) {
    return folder / "windows" / (owner + ".lock");
}

std::optional<RecoveredText> readCopy(const fs::path& copy) {
    const auto bytes = image::readFile(copy, {copy.generic_string(), {}}, kLargestKept);
    if (!bytes) return std::nullopt;
    const nlohmann::json json = nlohmann::json::parse(base::asText(*bytes), nullptr, false);
    const auto word = [&](const char* key) {
        return json.is_object() && json.contains(key) && json[key].is_string() ? json[key].get<std::string>()
                                                                               : std::string();
    };
    if (!json.is_object() || !json.contains("text")) return std::nullopt;
    const auto written = json.find("written");
    const bool isKnown = written != json.end() && written->is_number_integer();
    return RecoveredText{word("text"), word("when"), copy, isKnown ? written->get<std::int64_t>() : 0};
}

}  // namespace

fs::path stateFolder() {
    return system::userFolder(system::UserFolder::state);
}

SafetyCopies::~SafetyCopies() {
    std::error_code failure;
    if (lock_.isTaken()) fs::remove(lockOf(folder_, owner_), failure);
}

/// Gets a lock of a new name, which the system gives back when the process ends, however it does.
bool SafetyCopies::own() {
    if (lock_.isTaken()) return true;
    if (folder_.empty()) return false;
    std::error_code failure;
    fs::create_directories(folder_ / "windows", failure);
    constexpr int kTries = 10;
    for (int i = 0; i < kTries; ++i) {
        const auto now = std::chrono::system_clock::now().time_since_epoch().count();
        const std::string owner = fmt::format("{}-{:x}", system::ownNumber(), now);
        const system::Lock::Try result = lock_.takeNewFile(lockOf(folder_, owner));
        if (result == system::Lock::Try::missing) return false;
        if (result != system::Lock::Try::taken) continue;
        owner_ = owner;
        return true;
    }
    return false;
}

bool SafetyCopies::isAlive(const std::string& owner) const {
    // Owners of earlier versions had no locks.
    return !owner.empty() && system::removeUnlessLocked(lockOf(folder_, owner));
}

fs::path SafetyCopies::copyOf(const fs::path& file) const {
    return folder_ / "unsaved" / (nameOf(file) + "." + owner_ + ".json");
}

void SafetyCopies::keep(const fs::path& file, const std::string& text) {
    if (!own()) return;
    std::error_code failure;
    fs::create_directories(folder_ / "unsaved", failure);
    const auto now = std::chrono::system_clock::now();
    const nlohmann::ordered_json json{{"file", fs::absolute(file, failure).generic_string()},
                                      {"when", asDate(now)},
                                      {"written", now.time_since_epoch().count()},
                                      {"text", text}};
    const std::string bytes = json.dump(1, ' ', false, nlohmann::json::error_handler_t::replace);
    const fs::path copy = copyOf(file);
    image::writeFileAtomically(copy, std::as_bytes(std::span(bytes)));
    if (std::ranges::find(copies_, copy) != copies_.end()) return;
    copies_.push_back(copy);
    ++timesChanged_;
}

void SafetyCopies::forget(const fs::path& file) {
    if (owner_.empty()) return;
    const fs::path copy = copyOf(file);
    std::error_code failure;
    fs::remove(copy, failure);
    timesChanged_ += std::erase(copies_, copy);
}

void SafetyCopies::forgetAll() {
    std::error_code failure;
    for (const fs::path& each : std::exchange(copies_, {})) fs::remove(each, failure);
}

bool SafetyCopies::isKept(const fs::path& file) const {
    std::error_code failure;
    return !owner_.empty() && fs::exists(copyOf(file), failure);
}

SafetyCopies::Others SafetyCopies::othersOf(const fs::path& file) const {
    Others others;
    if (folder_.empty()) return others;
    const std::string name = nameOf(file);
    std::error_code failure;
    for (fs::directory_iterator each(folder_ / "unsaved", failure), end; !failure && each != end;
         each.increment(failure)) {
        // NAME.OWNER.json, or NAME.json of earlier versions
        const fs::path path = each->path();
        if (path.extension() != ".json" || !path.filename().generic_string().starts_with(name)) continue;
        const std::string rest = path.stem().generic_string().substr(name.size());
        if (!rest.empty() && rest.front() != '.') continue;
        const std::string owner = rest.empty() ? rest : rest.substr(1);
        if (!owner_.empty() && owner == owner_) continue;
        if (isAlive(owner)) {
            others.isOpen = true;
            continue;
        }
        std::optional<RecoveredText> text = readCopy(path);
        if (text && (!others.left || text->written > others.left->written)) others.left = std::move(text);
    }
    return others;
}

void SafetyCopies::remove(const RecoveredText& text) {
    std::error_code failure;
    fs::remove(text.copy, failure);
}

}  // namespace glibra::view
