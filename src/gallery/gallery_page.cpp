#include "gallery/gallery_page.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <ranges>
#include <span>
#include <string_view>
#include <utility>

#include "base/page_template.h"
#include "base/text.h"
#include "base/utf8.h"
#include "embedded/gallery_page.h"
#include "embedded/report_page.h"
#include "glib/number.h"
#include "glib/text.h"
#include "page/page.h"
#include "source/code_html.h"
#include "suite/report/report_files.h"
#include "suite/write_below.h"

namespace glibra::gallery {
namespace {

namespace fs = std::filesystem;
using base::printableText;

constexpr std::size_t kMostMessages = 50;  // of a scene
constexpr std::size_t kLongestSearch = 4'000;
constexpr std::string_view kPlainPolicy =
    "default-src 'none'; img-src 'self' file: data:; style-src 'self' file:";

std::string pageOf(const GalleryScene& scene) {
    return "scenes/" + scene.name + ".html";
}

/// The text that the search looks at, in small letters.
std::string searchText(const GalleryScene& scene) {
    const Description& about = scene.description;
    std::string text = scene.path;
    const auto add = [&](std::string_view more) { text.append(" ").append(more); };
    for (const std::string& each : about.head.rows) add(each);
    for (const std::string& each : about.head.text) add(each);
    for (const std::string& each : scene.chapters) add(each);
    for (const Control& each : about.controls) add(each.name);
    for (const SourceText& each : about.sources) add(each.name);
    add(scene.film.empty() ? "" : "film");
    return glib::lower(text.substr(0, kLongestSearch));
}

Diagnostic asShown(const GalleryScene& scene, Diagnostic of) {
    if (of.place.file.ends_with("/" + scene.path)) of.place.file = scene.path;
    page::nameAsOnPage(of.place, scene.description.sources);
    return of;
}

std::string shownReason(const GalleryScene& scene) {
    const std::size_t at = scene.reason.find("/" + scene.path + ":");
    return at == std::string::npos ? scene.reason : scene.reason.substr(at + 1);
}

base::Fields tileFields(const GalleryScene& scene) {
    return {{"page", pageOf(scene)},
            {"words", searchText(scene)},
            {"picture", scene.picture},
            {"film", scene.film},
            {"reason", printableText(shownReason(scene))},
            {"name", printableText(fs::path(scene.path).stem().generic_string())},
            {"summary", printableText(scene.description.head.summary)}};
}

using Sections = std::vector<std::pair<std::string, std::vector<const GalleryScene*>>>;

std::string listPage(const Gallery& gallery, const Sections& sections, bool hasChapters, bool isByChapter) {
    std::vector<base::Fields> rows;
    for (const auto& [title, scenes] : sections)
        rows.push_back(
            {{"id", fmt::format("p{}", rows.size() + 1)},
             {"heading", printableText(title == "." ? "Scenes" : title)},
             {"scenes", base::rowsOf(scenes, [](const auto* each) { return tileFields(*each); })}});
    return suite::loadingFirstScreen(
        base::filled(gallery_page::index_html(), {{"title", printableText(gallery.title)},
                                                  {"count", base::counted(gallery.scenes.size(), "scene")},
                                                  {"hasChapters", hasChapters},
                                                  {"isByChapter", isByChapter},
                                                  {"sections", std::move(rows)}}));
}

Sections chaptersOf(const Gallery& gallery) {
    const auto order = [](const std::string& a, const std::string& b) { return source::isBefore(a, b); };
    std::map<std::string, std::vector<const GalleryScene*>, decltype(order)> chapters(order);
    for (const GalleryScene& scene : gallery.scenes)
        for (const std::string& each : scene.chapters) chapters[each].push_back(&scene);
    return {chapters.begin(), chapters.end()};
}

/// Of a range its ends; of others which values there are.
base::Fields controlFields(const Control& control) {
    std::string values, value;
    switch (control.kind) {
        case Control::Kind::range:
            value = glib::numberText(control.numbers[1]);
            break;
        case Control::Kind::choice: {
            values = fmt::format("one of {}", fmt::join(control.words, ", "));
            const double number = control.numbers.front();
            if (number >= 0 && number < static_cast<double>(control.words.size()))
                value = control.words[static_cast<std::size_t>(number)];
            break;
        }
        case Control::Kind::truth:
            values = "true or false";
            value = control.numbers.front() != 0 ? "true" : "false";
            break;
        case Control::Kind::color:
            values = "a colour";
            for (const double each : control.numbers)
                value += (value.empty() ? "" : " ") + glib::numberText(each);
            break;
    }
    const bool isRange = control.kind == Control::Kind::range;
    return {{"name", control.name},
            {"range", isRange},
            {"least", isRange ? glib::numberText(control.numbers[0]) : ""},
            {"most", isRange ? glib::numberText(control.numbers[2]) : ""},
            {"values", values},
            {"value", value},
            {"owner", printableText(control.owner.empty() ? "scene" : control.owner)}};
}

std::string textHtml(const GalleryScene& scene) {
    std::string facts;
    for (const std::string& each : scene.description.head.rows) facts += (facts.empty() ? "" : " ") + each;
    for (const std::string& each : scene.chapters) facts += (facts.empty() ? "" : "; ") + each;
    return page::textHtml(scene.description.head, facts);
}

std::vector<base::Fields> messageRows(const GalleryScene& scene) {
    if (scene.diagnostics.empty() && !scene.reason.empty())
        return {{{"severity", "error"}, {"text", printableText(shownReason(scene))}}};
    return base::rowsOf(scene.diagnostics | std::views::take(kMostMessages), [&](const Diagnostic& each) {
        return base::Fields{{"severity", name(each.severity)},
                            {"text", printableText(toString(asShown(scene, each)), true)}};
    });
}

base::Fields sourceFields(const SourceText& source) {
    const bool isScene = source.role == "scene";
    return {{"name", printableText(source.name)},
            {"role", source.role},
            {"isIncluded", source.role == "included"},
            {"code", source::codeHtml(source.text,
                                      isScene ? source::CodeLanguage::glib : source::CodeLanguage::glsl)}};
}

std::string nameOf(const GalleryScene& scene) {
    return printableText(fs::path(scene.path).replace_extension().generic_string());
}

}  // namespace

std::string indexPage(const Gallery& gallery) {
    Sections folders;
    for (const GalleryScene& each : gallery.scenes) {
        const std::string folder = folderOf(each);
        const auto known =
            std::ranges::find_if(folders, [&](const auto& one) { return one.first == folder; });
        if (known != folders.end())
            known->second.push_back(&each);
        else
            folders.push_back({folder, {&each}});
    }
    return listPage(gallery, folders, !chaptersOf(gallery).empty(), false);
}

std::string chaptersPage(const Gallery& gallery) {
    const Sections chapters = chaptersOf(gallery);
    return chapters.empty() ? std::string() : listPage(gallery, chapters, true, true);
}

std::string scenePage(const Gallery& gallery, std::size_t index) {
    const GalleryScene& scene = gallery.scenes[index];
    const Description& about = scene.description;
    const auto link = [&](std::size_t other) {
        return base::Fields{{"page", gallery.scenes[other].name + ".html"},
                            {"name", nameOf(gallery.scenes[other])}};
    };
    const auto pageAt = [&](std::size_t other) {
        return other < gallery.scenes.size() ? gallery.scenes[other].name + ".html" : std::string();
    };
    const std::string title =
        fs::path(scene.path).replace_extension().generic_string() + " - " + gallery.title;
    const base::Fields fields = {
        {"title", printableText(title)},
        {"name", nameOf(scene)},
        {"gallery", printableText(gallery.title)},
        {"isEmbedded", gallery.isEmbedded && scene.isLive},
        {"solution", base::rowsOf(scene.solution, link)},
        {"tasks", base::rowsOf(scene.tasks, link)},
        {"previous", pageAt(index - 1)},
        {"next", pageAt(index + 1)},
        {"policy", scene.isLive ? page::kSitePolicy : kPlainPolicy},
        {"isLive", scene.isLive},  // then the page has controls and sources of its own
        {"live", !scene.isLive || scene.picture.empty()
                     ? std::string()
                     : page::liveHtml("../live", scene.name + ".js", "../" + scene.picture, scene.width,
                                      scene.height, scene.whyFilm)},
        {"picture", scene.picture},
        {"film", scene.film},
        {"width", scene.width},
        {"height", scene.height},
        {"filmWidth", scene.width / 2},
        {"filmHeight", scene.height / 2},
        {"text", textHtml(scene)},
        {"messages", messageRows(scene)},
        {"more", base::leftOut(scene.diagnostics.size(), kMostMessages)},
        {"controls", base::rowsOf(about.controls, controlFields)},
        {"keys", about.keys},
        {"sources", base::rowsOf(about.sources, sourceFields)},
    };
    return base::filled(gallery_page::scene_html(), fields);
}

Diagnostics writePages(const Gallery& gallery, const fs::path& site) {
    const auto write = [&](const std::string& name, std::string_view text) -> Diagnostics {
        return suite::writeBelow(site, name, std::as_bytes(std::span(text)));
    };
    Diagnostics problems = write(
        "gallery.css", std::string(report_page::report_css()) + std::string(gallery_page::gallery_css()));
    if (problems.empty()) problems = write("gallery.js", gallery_page::gallery_js());
    for (std::size_t i = 0; i < gallery.scenes.size() && problems.empty(); ++i)
        problems = write(pageOf(gallery.scenes[i]), scenePage(gallery, i));
    if (const std::string chapters = chaptersPage(gallery); !chapters.empty() && problems.empty())
        problems = write("chapters.html", chapters);
    if (problems.empty()) problems = write("index.html", indexPage(gallery));
    return problems;
}

}  // namespace glibra::gallery
