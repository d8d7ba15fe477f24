#include "view/edit/recovery.h"

#include <array>
#include <cstdint>
#include <cstdlib>
#include <ctime>
#include <nlohmann/json.hpp>
#include <span>
#include <system_error>

#include "base/whole_file.h"
#include "image/file.h"
#include "suite/golden/hash.h"

namespace glibra::view {
namespace {

namespace fs = std::filesystem;
constexpr std::uint64_t kLargestKept = 8ULL << 20;

/// The file for a text, named after the absolute path of its own file.
fs::path keptFile(const fs::path& folder, const fs::path& file) {
    std::error_code failure;
    const std::string path = fs::absolute(file, failure).lexically_normal().string();
    return folder / (suite::toText(suite::hashOf(std::as_bytes(std::span(path)))) + ".json");
}

std::string timeNow() {
    const std::time_t time = std::time(nullptr);
    std::tm local{};
    ::localtime_r(&time, &local);
    std::array<char, 32> text{};
    return {text.data(), std::strftime(text.data(), text.size(), "%Y-%m-%d %H:%M", &local)};
}

}  // namespace

fs::path recoveryFolder() {
    if (const char* folder = std::getenv("XDG_STATE_HOME"); folder && *folder)
        return fs::path(folder) / "glibra" / "unsaved";
    if (const char* home = std::getenv("HOME"); home && *home)
        return fs::path(home) / ".local" / "state" / "glibra" / "unsaved";
    return {};
}

void keepText(const fs::path& folder, const fs::path& file, const std::string& text) {
    if (folder.empty()) return;
    std::error_code failure;
    fs::create_directories(folder, failure);
    const nlohmann::ordered_json json{
        {"file", fs::absolute(file, failure).string()}, {"when", timeNow()}, {"text", text}};
    const std::string bytes = json.dump(1, ' ', false, nlohmann::json::error_handler_t::replace);
    image::writeFileAtomically(keptFile(folder, file), std::as_bytes(std::span(bytes)));
}

void forgetText(const fs::path& folder, const fs::path& file) {
    if (folder.empty()) return;
    std::error_code failure;
    fs::remove(keptFile(folder, file), failure);
}

std::optional<RecoveredText> keptText(const fs::path& folder, const fs::path& file) {
    if (folder.empty()) return std::nullopt;
    const fs::path kept = keptFile(folder, file);
    std::error_code failure;
    if (!fs::exists(kept, failure)) return std::nullopt;
    const auto bytes = image::readFile(kept, {kept.string(), {}}, kLargestKept);
    if (!bytes) return std::nullopt;
    const nlohmann::json json = nlohmann::json::parse(base::asText(*bytes), nullptr, false);
    if (!json.is_object() || !json.contains("text") || !json["text"].is_string()) return std::nullopt;
    return RecoveredText{json["text"].get<std::string>(), json.contains("when") && json["when"].is_string()
                                                              ? json["when"].get<std::string>()
                                                              : ""};
}

}  // namespace glibra::view
