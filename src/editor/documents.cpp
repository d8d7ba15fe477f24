#include "editor/language_server.h"

#include <fmt/format.h>

#include <algorithm>
#include <system_error>

#include "base/files.h"
#include "base/percent.h"
#include "base/utf8.h"
#include "glib/limits.h"
#include "glib/text.h"
#include "image/file.h"

namespace glibra::editor {
namespace {

using nlohmann::json;

constexpr std::string_view kFileScheme = "file://";

CodeLanguage languageOf(const std::filesystem::path& file, const std::string& id) {
    if (id == "glib") return CodeLanguage::glib;
    if (id == "glsl") return CodeLanguage::glsl;
    return glib::sameWord(file.extension().generic_string(), ".glib") ? CodeLanguage::glib
                                                                      : CodeLanguage::glsl;
}

}  // namespace

std::filesystem::path fileOf(std::string_view uri) {
    namespace fs = std::filesystem;
    const bool isFile = uri.starts_with(kFileScheme);
    std::string path;
    if (isFile) {
        const std::size_t scheme = kFileScheme.size(), end = std::min(uri.find('/', scheme), uri.size());
        const std::string_view host = uri.substr(scheme, end - scheme);
        const bool isShare = !host.empty() && host != "localhost" && fs::path("//server").has_root_name();
        uri.remove_prefix(isShare ? scheme - 2 : end);  // "//server/share/a.glib"
    }
    path = base::percentDecoded(uri);
    std::erase(path, '\0');
    if (isFile && path.starts_with('/') && fs::path(path.substr(1)).has_root_name()) path.erase(0, 1);  // C:
    if (isFile) return fs::path(path).lexically_normal();
    std::ranges::replace(path, '/', '_');
    std::error_code failure;
    return fs::current_path(failure) / path;
}

std::string uriOf(const std::filesystem::path& file) {
    constexpr std::string_view kPlain = "/-._~!$&'()*+,;=@";
    std::string uri(kFileScheme);
    std::error_code failure;
    const std::filesystem::path whole = std::filesystem::absolute(file, failure);
    const std::string path = whole.lexically_normal().generic_string();
    const bool hasDrive = !path.starts_with('/');
    if (hasDrive) uri += '/';
    const bool hasHost = path.starts_with("//");  // a share of Windows
    for (const char& c : std::string_view(path).substr(hasHost ? 2 : 0)) {
        if ((hasDrive && &c == &path[1]) || glib::isLetter(c) || glib::isDigit(c) ||
            kPlain.find(c) != std::string_view::npos)
            uri += c;
        else
            uri += fmt::format("%{:02X}", static_cast<unsigned char>(c));
    }
    return uri;
}

const Document& Documents::open(const json& parameters) {
    const json& item = parameters.at("textDocument");
    Document document{
        .uri = item.at("uri").get<std::string>(), .file = {}, .text = item.at("text").get<std::string>()};
    document.file = fileOf(document.uri);
    document.version = item.value("version", 0LL);
    document.language = languageOf(document.file, item.value("languageId", std::string()));
    Document& kept = documents_[document.uri];
    kept = std::move(document);
    return kept;
}

const Document* Documents::change(const json& parameters) {
    const json& item = parameters.at("textDocument");
    const auto found = documents_.find(item.at("uri").get<std::string>());
    if (found == documents_.end()) return nullptr;
    Document& document = found->second;
    for (const json& each : parameters.at("contentChanges")) {
        const auto& text = each.at("text").get_ref<const std::string&>();
        if (!each.contains("range")) {
            document.text = text;
            continue;
        }
        const TextLines lines(document.text);
        const std::size_t begin = lines.byte(positionIn(each.at("range").at("start")));
        const std::size_t end = std::max(begin, lines.byte(positionIn(each.at("range").at("end"))));
        document.text.replace(begin, end - begin, text);
    }
    if (item.contains("version") && item.at("version").is_number_integer())
        document.version = item.at("version").get<long long>();
    return &document;
}

void Documents::close(const std::string& uri) {
    documents_.erase(uri);
}

const Document* Documents::find(const std::string& uri) const {
    const auto found = documents_.find(uri);
    return found == documents_.end() ? nullptr : &found->second;
}

const Document* Documents::findFile(const std::filesystem::path& file) const {
    for (const auto& [uri, each] : documents_)
        if (each.file == file) return &each;
    return nullptr;
}

std::string Documents::textOf(const std::filesystem::path& file) const {
    if (const Document* open = findFile(file)) return open->text;
    const auto bytes = image::readFile(file, {file.generic_string(), {}}, glib::kLargestFile);
    return bytes ? std::string(base::asText(*bytes)) : std::string();
}

std::string Documents::uriOf(const std::filesystem::path& file) const {
    const Document* open = findFile(file);
    return open ? open->uri : editor::uriOf(file);
}

TextPosition positionIn(const json& position) {
    const auto number = [&](const char* name) {
        return static_cast<std::size_t>(std::clamp(position.at(name).get<long long>(), 0LL, 1LL << 31U));
    };
    return {number("line"), number("character")};
}

json toJson(const TextPosition& position) {
    return {{"line", position.line}, {"character", position.unit}};
}

json toJson(const TextLines& lines, const TextRange& range) {
    return {{"start", toJson(lines.position(range.begin))}, {"end", toJson(lines.position(range.end))}};
}

// ---- Lines.

namespace {

std::size_t unitsOf(const base::Character& character) {
    constexpr std::uint32_t kFirstPair = 0x10000;
    return character.code >= kFirstPair ? 2 : 1;
}

}  // namespace

TextLines::TextLines(std::string_view text) : text_(text), begins_{0}, isPlain_{true} {
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (static_cast<unsigned char>(text[i]) >= 0x80) isPlain_.back() = false;
        if (text[i] != '\n' && (text[i] != '\r' || text.substr(i + 1, 1) == "\n")) continue;
        begins_.push_back(i + 1);
        isPlain_.push_back(true);
    }
}

TextRange TextLines::line(std::size_t index) const {
    if (index >= begins_.size()) return {text_.size(), text_.size()};
    const std::size_t begin = begins_[index];
    return {begin, std::min(text_.find_first_of("\r\n", begin), text_.size())};
}

TextPosition TextLines::position(std::size_t byte) const {
    byte = std::min(byte, text_.size());
    const auto after = std::ranges::upper_bound(begins_, byte);
    TextPosition found{static_cast<std::size_t>(after - begins_.begin()) - 1, 0};
    if (isPlain_[found.line]) return {found.line, byte - *(after - 1)};
    for (std::size_t at = *(after - 1); at < byte;) {
        const base::Character character = base::firstCharacter(text_.substr(at));
        at += character.bytes;
        found.unit += unitsOf(character);
    }
    return found;
}

std::size_t TextLines::byte(TextPosition position) const {
    const TextRange range = line(position.line);
    if (position.line < begins_.size() && isPlain_[position.line])
        return range.begin + std::min(position.unit, range.end - range.begin);
    std::size_t at = range.begin;
    for (std::size_t unit = 0; at < range.end && unit < position.unit;) {
        const base::Character character = base::firstCharacter(text_.substr(at));
        unit += unitsOf(character);
        if (unit > position.unit) break;  // inside of a character
        at += character.bytes;
    }
    return at;
}

}  // namespace glibra::editor
