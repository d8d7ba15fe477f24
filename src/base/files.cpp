#include "base/files.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdio>

#include "base/text.h"

namespace glibra::base {
namespace {

using namespace std::string_view_literals;

struct Beginning {
    std::string_view bytes, kind;
};

/// Longer ones before those that they begin with.
constexpr Beginning kBeginnings[] = {
    {"\x89PNG"sv, "a PNG picture"},
    {"\xff\xd8\xff"sv, "a JPEG picture"},
    {"GIF8"sv, "a GIF picture"},
    {"II*\0"sv, "a TIFF picture"},
    {"MM\0*"sv, "a TIFF picture"},
    {"\x76\x2f\x31\x01"sv, "an EXR picture"},
    {"#?RADIANCE"sv, "an HDR picture"},
    {"#?RGBE"sv, "an HDR picture"},
    {"DDS "sv, "a DDS picture"},
    {"8BPS"sv, "a PSD picture"},
    {"RIFF"sv, "a RIFF file (WebP, sound or video)"},
    {"%PDF"sv, "a PDF document"},
    {"PK\x03\x04"sv, "a ZIP archive"},
    {"\x1f\x8b"sv, "a compressed file"},
    {"\x7f"
     "ELF"sv,
     "a program"},
    {"glTF"sv, "a glTF model"},
    {"ply\n"sv, "a PLY model"},
    {"ply\r"sv, "a PLY model"},
    {"solid "sv, "an STL model"},
    {"Kaydara FBX"sv, "an FBX model"},
    {"; FBX"sv, "an FBX model"},
    {"BLENDER"sv, "a Blender file"},
    {"OFF\n"sv, "an OFF model"},
    {"\x03\x02\x23\x07"sv, "SPIR-V, a compiled shader"},
};

/// First words of a text, that is no comment of its language, and what they show.
struct FirstWords {
    std::string_view words, kind;
};
constexpr FirstWords kFirstWords[] = {
    {" #version #extension #pragma #define #include #if #ifdef #ifndef precision uniform varying attribute "
     "layout void in out const float int bool vec2 vec3 vec4 mat3 mat4 struct ",
     "a GLSL shader"},
    {" mtllib v vn vt o ", "an OBJ model"},
    {" newmtl ", "an MTL file of materials"},
};

/// The rest of a text after blanks and comments of GLSL, or of OBJ and others, which begin with `#`.
std::string_view afterComments(std::string_view text, bool isHashComment) {
    for (;;) {
        text.remove_prefix(std::min(text.find_first_not_of(" \t\r\n"), text.size()));
        const bool isLine = text.starts_with("//") || (isHashComment && text.starts_with('#'));
        if (!isLine && !text.starts_with("/*")) return text;
        const std::size_t end = text.find(isLine ? "\n"sv : "*/"sv);
        if (end == std::string_view::npos) return {};
        text.remove_prefix(end + (isLine ? 1 : 2));
    }
}

std::string_view kindByFirstWord(std::string_view text) {
    const std::string word = " " + std::string(text.substr(0, text.find_first_of(" \t\r\n("))) + " ";
    for (const FirstWords& each : kFirstWords)
        if (each.words.find(word) != std::string_view::npos) return each.kind;
    return {};
}

}  // namespace

std::string_view foreignEncoding(std::string_view content) {
    constexpr std::size_t kLooked = 512;
    constexpr std::string_view kUtf16 = "UTF-16 text", kUtf32 = "UTF-32 text";
    if (content.starts_with("\xff\xfe\0\0"sv) || content.starts_with("\0\0\xfe\xff"sv)) return kUtf32;
    if (content.starts_with("\xff\xfe"sv) || content.starts_with("\xfe\xff"sv)) return kUtf16;
    // Without a mark at the beginning, every second byte of a text in Latin letters is 0, or three of four
    // are.
    const std::string_view start = content.substr(0, kLooked & ~std::size_t{3});
    std::array<std::size_t, 4> zeros{};
    for (std::size_t i = 0; i < start.size(); ++i) zeros.at(i % 4) += start[i] == '\0' ? 1 : 0;
    const std::size_t quarter = start.size() / 4;
    const auto isFull = [&](std::size_t at) { return quarter > 1 && zeros.at(at) * 10 >= quarter * 9; };
    const auto isFree = [&](std::size_t at) { return zeros.at(at) == 0; };
    if ((isFull(1) && isFull(2) && isFull(3) && isFree(0)) ||
        (isFull(0) && isFull(1) && isFull(2) && isFree(3)))
        return kUtf32;
    if ((isFull(1) && isFull(3) && isFree(0) && isFree(2)) ||
        (isFull(0) && isFull(2) && isFree(1) && isFree(3)))
        return kUtf16;
    return {};
}

std::string_view fileKind(std::string_view content) {
    if (const std::string_view encoding = foreignEncoding(content); !encoding.empty()) return encoding;
    for (const Beginning& each : kBeginnings)
        if (content.starts_with(each.bytes)) return each.kind;
    const std::string_view start = content.substr(0, 4096);
    const bool isBinary = start.find('\0') != std::string_view::npos;
    if (isBinary && content.starts_with("BM")) return "a BMP picture";
    if (isBinary && content.starts_with("MM")) return "a 3DS model";
    if (content.size() > 2 && content[0] == 'P' && content[1] >= '1' && content[1] <= '7' &&
        (content[2] == '\n' || content[2] == ' ' || content[2] == '\r'))
        return "a PNM picture";
    if (isBinary) return {};
    const std::string_view text = afterComments(content, false);
    if (text.starts_with('{'))
        return start.find("\"asset\"") != std::string_view::npos ? "a glTF model" : "a JSON file";
    if (text.starts_with('<') && text.size() > 1 && (isLetter(text[1]) || text[1] == '?' || text[1] == '!')) {
        if (start.find("<COLLADA") != std::string_view::npos) return "a COLLADA model";
        return sameWord(text.substr(0, 5), "<html") || sameWord(text.substr(0, 9), "<!doctype")
                   ? "a web page"
                   : "an XML file";
    }
    if (const std::string_view kind = kindByFirstWord(text); !kind.empty()) return kind;
    return kindByFirstWord(afterComments(content, true));
}

std::string notThe(std::string_view wanted, std::string_view content) {
    if (const std::string_view encoding = foreignEncoding(content); !encoding.empty())
        return "is " + std::string(encoding) + "; save it as UTF-8";
    std::string_view kind = fileKind(content);
    if (kind.empty() && isNoText(content)) kind = "a binary file";
    return kind.empty() || kind == wanted ? std::string()
                                          : "is " + std::string(kind) + ", not " + std::string(wanted);
}

bool isNoText(std::string_view content) {
    return !foreignEncoding(content).empty() || content.substr(0, 4096).find('\0') != std::string_view::npos;
}

std::string endStandardOutput() {
    errno = 0;
    if (std::fflush(stdout) != 0)
        return errno == 0 ? "it cannot be written" : std::generic_category().message(errno);
    return std::ferror(stdout) != 0 ? "a part of it could not be written" : "";
}

namespace fs = std::filesystem;

std::vector<fs::directory_entry> entriesOf(const fs::path& folder, std::error_code& failure) {
    std::vector<fs::directory_entry> entries;
    fs::directory_iterator each(folder, failure);
    for (; !failure && each != fs::directory_iterator(); each.increment(failure)) entries.push_back(*each);
    return entries;
}

std::vector<fs::directory_entry> entriesOf(const fs::path& folder) {
    std::error_code ignored;
    return entriesOf(folder, ignored);
}

std::optional<std::vector<std::byte>> bytesIn(const system::File& file, std::uint64_t largest) {
    std::vector<std::byte> bytes;
    if (!file || readAll(file, largest, bytes) != 0) return std::nullopt;
    return bytes;
}

std::optional<std::string> textIn(const system::File& file, std::uint64_t largest) {
    const auto bytes = bytesIn(file, largest);
    return bytes ? std::optional<std::string>(asText(*bytes)) : std::nullopt;
}

}  // namespace glibra::base
