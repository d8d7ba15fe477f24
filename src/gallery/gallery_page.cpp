#include "gallery/gallery_page.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <span>
#include <string_view>
#include <utility>

#include "base/page_template.h"
#include "base/text.h"
#include "base/utf8.h"
#include "classroom/page_parts.h"
#include "embedded/gallery_page.h"
#include "embedded/report_page.h"
#include "glib/number.h"
#include "glib/text.h"
#include "page/page.h"
#include "source/code_html.h"
#include "suite/report/html_report.h"
#include "suite/write_below.h"

namespace glibra::gallery {
namespace {

namespace fs = std::filesystem;
using base::escapeXml;
using base::printableText;
using classroom::nameHtml;

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

std::string tileHtml(const GalleryScene& scene) {
    const std::string film = scene.film.empty() ? "" : fmt::format(" data-film=\"{}\"", scene.film);
    const std::string frame =
        scene.picture.empty()
            ? fmt::format("<span class=\"none\">{}</span>", escapeXml(printableText(shownReason(scene))))
            : fmt::format("<img src=\"{}\"{} alt=\"\" loading=\"lazy\">", scene.picture, film);
    return fmt::format(
        "<a class=\"tile\" href=\"{}\" data-text=\"{}\"><span class=\"frame{}\">{}</span><b>{}</b>"
        "<small>{}</small></a>\n",
        pageOf(scene), escapeXml(searchText(scene)), scene.film.empty() ? "" : " moves", frame,
        nameHtml(fs::path(scene.path).stem().generic_string()), nameHtml(scene.description.head.summary));
}

using Sections = std::vector<std::pair<std::string, std::vector<const GalleryScene*>>>;

std::string listPage(const Gallery& gallery, const Sections& sections, bool hasChapters, bool isChapters) {
    std::string content, parts;
    for (std::size_t i = 0; i < sections.size(); ++i) {
        const auto& [title, scenes] = sections[i];
        const std::string heading = title == "." ? "Scenes" : title;
        content +=
            fmt::format("<section id=\"p{}\"><h2>{}</h2><div class=\"grid\">\n", i + 1, nameHtml(heading));
        for (const GalleryScene* each : scenes) content += tileHtml(*each);
        content += "</div></section>\n";
        parts += fmt::format("<a href=\"#p{}\">{}</a> ", i + 1, nameHtml(heading));
    }
    const std::string pages = !hasChapters ? ""
                              : isChapters ? "<a href=\"index.html\">By topic</a> <b>By chapter</b>"
                                           : "<b>By topic</b> <a href=\"chapters.html\">By chapter</a>";
    const base::Slot slots[] = {
        {"title", escapeXml(printableText(gallery.title))},
        {"headline", nameHtml(gallery.title)},
        {"pages", pages},
        {"count", base::counted(gallery.scenes.size(), "scene")},
        {"partsTitle", isChapters ? "Chapters" : "Topics"},
        {"parts", parts},
        {"content", content},
    };
    return suite::loadingFirstScreen(base::filled(gallery_page::index_html(), slots));
}

Sections chaptersOf(const Gallery& gallery) {
    const auto order = [](const std::string& a, const std::string& b) { return source::isBefore(a, b); };
    std::map<std::string, std::vector<const GalleryScene*>, decltype(order)> chapters(order);
    for (const GalleryScene& scene : gallery.scenes)
        for (const std::string& each : scene.chapters) chapters[each].push_back(&scene);
    return {chapters.begin(), chapters.end()};
}

std::string numbersText(const std::vector<double>& numbers) {
    std::string text;
    for (const double each : numbers) text += (text.empty() ? "" : " ") + glib::numberText(each);
    return text;
}

std::string controlRow(const Control& control) {
    std::string cells;
    switch (control.kind) {
        case Control::Kind::range:
            for (const std::size_t i : {0U, 2U, 1U})
                cells += "<td>" + glib::numberText(control.numbers[i]) + "</td>";
            break;
        case Control::Kind::choice: {
            std::string words;
            for (const std::string& each : control.words) words += (words.empty() ? "" : ", ") + each;
            const double number = control.numbers.front();
            const bool isIn = number >= 0 && number < static_cast<double>(control.words.size());
            cells = fmt::format("<td colspan=\"2\">one of {}</td><td>{}</td>", escapeXml(words),
                                escapeXml(isIn ? control.words[static_cast<std::size_t>(number)] : ""));
            break;
        }
        case Control::Kind::truth:
            cells = fmt::format("<td colspan=\"2\">true or false</td><td>{}</td>",
                                control.numbers.front() != 0 ? "true" : "false");
            break;
        case Control::Kind::color:
            cells = fmt::format("<td colspan=\"2\">a colour</td><td>{}</td>", numbersText(control.numbers));
            break;
    }
    return fmt::format("<tr><th><code>{}</code></th>{}<td>{}</td></tr>\n", escapeXml(control.name), cells,
                       nameHtml(control.owner.empty() ? "scene" : control.owner));
}

std::string controlsHtml(const Description& about) {
    std::string html;
    if (!about.controls.empty()) {
        html =
            "<h2>Values to change</h2><table "
            "class=\"controls\"><thead><tr><th>name</th><th>from</th><th>to</th>"
            "<th>at first</th><th>of</th></tr></thead><tbody>\n";
        for (const Control& each : about.controls) html += controlRow(each);
        html += "</tbody></table>\n";
    }
    if (!about.keys.empty()) {
        html += "<p>Keys:";
        for (const std::string& each : about.keys) html += " <kbd>" + escapeXml(each) + "</kbd>";
        html += "</p>\n";
    }
    return html;
}

std::string textHtml(const GalleryScene& scene) {
    std::string facts;
    for (const std::string& each : scene.description.head.rows) facts += (facts.empty() ? "" : " ") + each;
    for (const std::string& each : scene.chapters) facts += (facts.empty() ? "" : "; ") + each;
    return page::textHtml(scene.description.head, facts);
}

std::string picturesHtml(const GalleryScene& scene) {
    if (scene.picture.empty()) return {};
    if (scene.isLive)
        return page::liveHtml("../live", scene.name + ".js", "../" + scene.picture, scene.width, scene.height,
                              scene.whyFilm);
    std::string html = fmt::format(
        "<div class=\"shown\"><figure><img src=\"../{}\" width=\"{}\" height=\"{}\" alt=\"the "
        "picture\"></figure>",
        scene.picture, scene.width, scene.height);
    if (!scene.film.empty())
        html += fmt::format(
            "<figure><picture><source media=\"(prefers-reduced-motion: reduce)\" srcset=\"../{}\">"
            "<img src=\"../{}\" width=\"{}\" height=\"{}\" alt=\"a film of it\"></picture></figure>",
            scene.picture, scene.film, scene.width / 2, scene.height / 2);
    return html + "</div>";
}

std::string messagesHtml(const GalleryScene& scene) {
    std::string items;
    if (scene.diagnostics.empty() && !scene.reason.empty())
        items = "<li class=\"remark error\">" + escapeXml(printableText(shownReason(scene))) + "</li>";
    for (std::size_t i = 0; i < std::min(scene.diagnostics.size(), kMostMessages); ++i) {
        const Diagnostic& each = scene.diagnostics[i];
        items += fmt::format("<li class=\"remark {}\">{}</li>\n", name(each.severity),
                             escapeXml(printableText(toString(asShown(scene, each)), true)));
    }
    if (scene.diagnostics.size() > kMostMessages)
        items += fmt::format("<li>{} more</li>", scene.diagnostics.size() - kMostMessages);
    return items.empty() ? items : "<h2>Messages</h2><ul class=\"messages\">" + items + "</ul>";
}

std::string sourcesHtml(const Description& about) {
    std::string html;
    for (const SourceText& each : about.sources) {
        const bool isScene = each.role == "scene";
        html += fmt::format(
            "<details{}><summary><strong>{}</strong> <small>{}</small></summary><div class=\"source\">{}"
            "</div></details>\n",
            each.role == "included" ? "" : " open", nameHtml(each.name), escapeXml(each.role),
            source::codeHtml(each.text, isScene ? source::CodeLanguage::glib : source::CodeLanguage::glsl));
    }
    return html.empty() ? html : "<h2>Sources</h2>" + html;
}

std::string sceneLink(const GalleryScene& scene) {
    return fmt::format("<a href=\"{}.html\">{}</a>", scene.name,
                       nameHtml(fs::path(scene.path).replace_extension().generic_string()));
}

std::string linksHtml(const Gallery& gallery, std::size_t index) {
    const GalleryScene& scene = gallery.scenes[index];
    std::string html;
    if (scene.solution)
        html +=
            "<span class=\"solution\">Solution: " + sceneLink(gallery.scenes[*scene.solution]) + "</span> ";
    for (const std::size_t each : scene.tasks)
        html += "<span class=\"task\">Exercise: " + sceneLink(gallery.scenes[each]) + "</span> ";
    if (index > 0)
        html += fmt::format("<a rel=\"prev\" href=\"{}.html\">Previous</a> ", gallery.scenes[index - 1].name);
    if (index + 1 < gallery.scenes.size())
        html += fmt::format("<a rel=\"next\" href=\"{}.html\">Next</a>", gallery.scenes[index + 1].name);
    return html;
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
    const std::string path = fs::path(scene.path).replace_extension().generic_string();
    const bool isEmbedded = gallery.isEmbedded && scene.isLive;
    const std::string header =
        fmt::format("<header>\n<h1>{}</h1>\n<nav><a href=\"../index.html\">{}</a> {}</nav>\n</header>",
                    nameHtml(path), nameHtml(gallery.title), linksHtml(gallery, index));
    const base::Slot slots[] = {
        {"title", escapeXml(printableText(path + " - " + gallery.title))},
        {"kind", isEmbedded ? "page embedded" : "gallery scene"},
        {"header", isEmbedded ? std::string() : header},
        {"policy", std::string(scene.isLive ? page::kSitePolicy : kPlainPolicy)},
        {"pictures", picturesHtml(scene)},
        {"text", isEmbedded ? std::string() : textHtml(scene)},
        {"messages", messagesHtml(scene)},
        // A live scene has its own.
        {"controls", scene.isLive ? std::string() : controlsHtml(scene.description)},
        {"sources", scene.isLive ? std::string() : sourcesHtml(scene.description)},
    };
    return base::filled(gallery_page::scene_html(), slots);
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
