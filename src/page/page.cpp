#include "page/page.h"

#include <fmt/format.h>
#include <libdeflate.h>

#include <algorithm>
#include <memory>
#include <nlohmann/json.hpp>
#include <system_error>
#include <utility>

#include "base/page_template.h"
#include "base/sha256.h"
#include "base/text.h"
#include "base/utf8.h"
#include "embedded/live_page.h"
#include "glib/text.h"
#include "image/file.h"
#include "plan/overrides.h"
#include "source/code_html.h"
#include "suite/report/packed_pixels.h"
#include "system/places.h"

namespace glibra::page {
namespace {

namespace fs = std::filesystem;
using base::escapeXml;
using base::printableText;
using Json = nlohmann::json;

struct FreeCompressor {
    void operator()(libdeflate_compressor* each) const { libdeflate_free_compressor(each); }
};

std::span<const std::byte> bytesOf(std::string_view text) {
    return std::as_bytes(std::span(text));
}

/// 'sha256-...', as a Content-Security-Policy names a text of the page.
std::string hashOf(std::string_view text) {
    return fmt::format("'sha256-{}'", suite::base64(base::sha256(bytesOf(text))));
}

/// JSON in ASCII without what ends or begins an element of HTML.
std::string scriptText(const Json& json) {
    std::string text;
    for (const char each : json.dump(-1, ' ', true, Json::error_handler_t::replace))
        if (each == '<' || each == '>' || each == '&')
            text += fmt::format("\\u{:04x}", static_cast<unsigned>(each));
        else
            text += each;
    return text;
}

/// A film as the page plays it, with the texts that it names in colours: [] of what is no film, which may
/// come from a worker that a scene has taken over.
Json filmJson(const PageScene& scene) {
    constexpr int kDeepest = 8;
    Json film = Json::parse(
        scene.film.state, [](int depth, Json::parse_event_t, Json&) { return depth < kDeepest; }, false);
    Json sources = Json::object();
    if (!film.is_object() || !film.contains("files") || !film["files"].is_array()) return Json::array();
    for (const Json& each : film["files"]) {
        const auto file = std::ranges::find_if(scene.files, [&](const PageFile& one) {
            return each.is_object() && each.contains("name") && each["name"] == one.name;
        });
        if (file == scene.files.end()) continue;
        const bool isGlib = each.value("language", Json()) == "glib";
        sources[file->name] =
            source::codeHtml(file->content, isGlib ? source::CodeLanguage::glib : source::CodeLanguage::glsl);
    }
    film["sources"] = packed(bytesOf(sources.dump(-1, ' ', true, Json::error_handler_t::replace)));
    film["pictures"] = Json::array();
    for (const std::string& each : scene.film.pictures)
        film["pictures"].push_back(suite::base64(bytesOf(each)));
    return film;
}

std::string dataOf(const PageScene& scene, const PageOptions& options) {
    Json files = Json::array(), set = Json::array();
    std::string content;
    for (const PageFile& each : scene.files) {
        files.push_back(
            {{"name", each.name}, {"bytes", each.content.size()}, {"converted", each.isConverted}});
        content += each.content;
    }
    for (const std::string& each : options.set)
        if (const Result<plan::Override> value = plan::parseOverride(each))
            set.push_back({{"program", value->program},
                           {"name", value->name},
                           {"values", value->values},
                           {"word", value->word}});
    Json data = {
        {"scene", scene.name},        {"files", std::move(files)},  {"content", packed(bytesOf(content))},
        {"set", std::move(set)},      {"time", options.time},       {"width", options.width},
        {"height", options.height},   {"samples", options.samples}, {"embed", options.isEmbedded},
        {"poster", options.hasPoster}};
    if (isFilm(scene)) data["film"] = filmJson(scene);
    return scriptText(data);
}

std::string posterHtml(std::string_view source, int width, int height) {
    return fmt::format("<img class=\"poster\" src=\"{}\" width=\"{}\" height=\"{}\" alt=\"the picture\">",
                       escapeXml(source), width, height);
}

constexpr const char* kPlainPolicy =
    "default-src 'none'; img-src data:; style-src {}; base-uri 'none'; form-action 'none'";
constexpr const char* kLivePolicy =
    "default-src 'none'; img-src data: blob:; style-src {}; script-src {} 'wasm-unsafe-eval'; base-uri "
    "'none'; "
    "form-action 'none'";
constexpr const char* kFilmPolicy =
    "default-src 'none'; img-src data: blob:; style-src {}; script-src {}; base-uri 'none'; form-action "
    "'none'";

}  // namespace

std::string whyNotLive(const PageScene& scene) {
    const auto found = std::ranges::find_if(scene.diagnostics, [](const Diagnostic& each) {
        return each.severity == Severity::error || each.id.starts_with("web-");
    });
    std::string why = "it cannot be drawn";
    if (found != scene.diagnostics.end()) {
        Diagnostic first = *found;
        first.severity = Severity::error;
        nameAsOnPage(first.place, scene.files);
        why = toString(first);
    }
    if (scene.film.pictures.size() < 2)
        return "This is a picture, because browsers cannot draw the scene: " + why;
    return "This is a film, because browsers cannot draw the scene: " + why +
           ". It shows one change at a time: of the time, or of one value while all others are as at the "
           "beginning; and the mouse does not turn it.";
}

std::string packed(std::span<const std::byte> bytes) {
    constexpr int kSmallest = 12;
    const std::unique_ptr<libdeflate_compressor, FreeCompressor> compressor(
        libdeflate_alloc_compressor(kSmallest));
    std::vector<std::byte> file(libdeflate_gzip_compress_bound(compressor.get(), bytes.size()));
    file.resize(
        libdeflate_gzip_compress(compressor.get(), bytes.data(), bytes.size(), file.data(), file.size()));
    return suite::base64(file);
}

Result<std::string> packedRuntime(const std::vector<fs::path>& folders) {
    std::vector<fs::path> places = folders;
    const fs::path program = system::programFile().parent_path();
    std::error_code failure;
    if (fs::exists(program / "CMakeCache.txt", failure)) places.push_back(program.parent_path() / "web");
    for (const fs::path& each : places) {
        const fs::path file = each / "glibra.wasm";
        if (!fs::is_regular_file(file, failure)) continue;
        Result<std::vector<std::byte>> bytes = image::readFile(file, {file.generic_string(), {}});
        if (!bytes) return std::move(bytes.diagnostics);
        return packed(*bytes);
    }
    return diagnose("page-E01",
                    "the runtime of live pages, glibra.wasm, is not there; in a checkout of glibra, "
                    "tools/glibra publish builds it");
}

std::string wholePage(const PageScene& scene, const PageOptions& options, const std::string& title,
                      std::string_view runtime) {
    const std::string_view style = live_page::live_css(), script = live_page::live_js();
    const std::string picture =
        scene.picture.empty() ? std::string()
                              : posterHtml("data:image/png;base64," + suite::base64(bytesOf(scene.picture)),
                                           scene.width, scene.height);
    std::string content = fmt::format("<div class=\"live\">{}</div>", picture), scripts;
    const bool hasScript = scene.isLive || isFilm(scene);
    if (!scene.isLive)
        content.insert(options.isEmbedded ? content.size() : 0,
                       "<p class=\"remark\">" + escapeXml(printableText(whyNotLive(scene))) + "</p>\n");
    if (hasScript) {
        content += fmt::format("<noscript><p class=\"remark\">With JavaScript the {} moves.</p></noscript>",
                               scene.isLive ? "scene" : "film");
        scripts = fmt::format("<script type=\"application/json\" id=\"glibra-scene\">{}</script>\n",
                              dataOf(scene, options));
        if (scene.isLive)
            scripts +=
                fmt::format("<script type=\"text/plain\" id=\"glibra-runtime\">{}</script>\n", runtime);
        scripts += fmt::format("<script>{}</script>", script);
    }
    std::string facts;
    for (const std::string& each : scene.head.rows) facts += (facts.empty() ? "" : " ") + each;
    const base::Fields fields = {
        {"policy", scene.isLive ? fmt::format(kLivePolicy, hashOf(style), hashOf(script))
                   : hasScript  ? fmt::format(kFilmPolicy, hashOf(style), hashOf(script))
                                : fmt::format(kPlainPolicy, hashOf(style))},
        {"title", printableText(title)},
        {"style", style},
        {"kind", options.isEmbedded ? "page embedded" : "page"},
        {"content", std::move(content)},
        {"text", options.isEmbedded ? std::string() : textHtml(scene.head, facts)},
        {"scripts", std::move(scripts)},
    };
    return base::filled(live_page::page_html(), fields);
}

std::vector<SiteFile> runtimeFiles(std::string_view runtime) {
    std::vector<SiteFile> files{{"live.css", std::string(live_page::live_css())},
                                {"live.js", std::string(live_page::live_js())}};
    if (!runtime.empty())
        files.push_back({"runtime.js", fmt::format("globalThis.glibraRuntime = \"{}\";\n", runtime)});
    return files;
}

std::string sceneScript(const PageScene& scene, const PageOptions& options) {
    return fmt::format("globalThis.glibraScene = {};\n", dataOf(scene, options));
}

std::string liveHtml(std::string_view folder, std::string_view script, std::string_view picture, int width,
                     int height, const std::string& whyFilm) {
    std::string html;
    if (!whyFilm.empty()) html = "<p class=\"remark\">" + escapeXml(printableText(whyFilm)) + "</p>\n";
    html += fmt::format("<link rel=\"stylesheet\" href=\"{0}/live.css\"><div class=\"live\">{1}</div>\n",
                        folder, posterHtml(picture, width, height));
    std::vector<std::string> scripts{std::string(script), fmt::format("{}/live.js", folder)};
    if (whyFilm.empty()) scripts.insert(scripts.begin() + 1, fmt::format("{}/runtime.js", folder));
    for (const std::string& each : scripts)
        html += fmt::format("<script src=\"{}\" defer></script>\n", escapeXml(each));
    return html;
}

std::string textHtml(const source::SceneHead& head, std::string_view facts) {
    std::string html, paragraph;
    const auto end = [&] {
        if (!paragraph.empty()) html += "<p>" + paragraph + "</p>\n";
        paragraph.clear();
    };
    for (const std::string& each : head.text) {
        // The items of a task have a line of their own.
        const bool isItem = each.size() > 1 && glib::isDigit(each[0]) && each[1] == '.';
        if (each.empty() || isItem) end();
        if (!each.empty()) paragraph += (paragraph.empty() ? "" : " ") + escapeXml(printableText(each));
    }
    end();
    if (!facts.empty()) html += "<p><small>" + escapeXml(printableText(facts)) + "</small></p>\n";
    return html.empty() ? html : "<div class=\"text\">" + html + "</div>";
}

}  // namespace glibra::page
