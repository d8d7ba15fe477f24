#include "classroom/page_parts.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <tuple>
#include <utility>

#include "base/contained.h"
#include "base/files.h"
#include "base/text.h"
#include "base/utf8.h"
#include "classroom/review.h"
#include "suite/report/packed_pixels.h"

namespace glibra::classroom {
namespace {

namespace fs = std::filesystem;
using base::escapeXml;

constexpr std::size_t kMostMessages = 30;  // of a submission
constexpr std::size_t kLongestLine = 400;  // bytes of a source line
constexpr int kContext = 2;                // lines around that of a message
constexpr std::uint64_t kLargestEmbedded = std::uint64_t{64} << 20U;

std::string addressOf(const PictureSource& source, const Picture& picture) {
    if (!source.embeddedFrom) return picture.file;
    if (!picture.small.empty()) return picture.small;
    const auto bytes = base::bytesIn(base::openBeneath(*source.embeddedFrom, picture.file), kLargestEmbedded);
    return bytes ? "data:image/png;base64," + suite::base64(*bytes) : std::string();
}

/// The line that a message names, between its neighbours.
std::string quoteHtml(const Entry& entry, const Place& place, SourceLines& sources) {
    if (place.line < 1 || place.file.empty() || entry.submission.folder.empty()) return {};
    const int from = std::max(1, place.line - kContext);
    const auto lines = sources.lines(entry.submission, place.file, from, place.line + kContext);
    if (!lines || static_cast<int>(lines->size()) <= place.line - from) return {};
    std::string html = "<div class=\"source\"><ol>";
    for (std::size_t i = 0; i < lines->size(); ++i) {
        const int number = from + static_cast<int>(i);
        html += fmt::format("<li data-line=\"{}\"{}>{}</li>", number,
                            number == place.line ? " class=\"named\"" : "", escapeXml((*lines)[i]));
    }
    return html + "</ol></div>";
}

/// The message, with its file relative to the submission.
std::string messageText(const Entry& entry, const Diagnostic& message) {
    Diagnostic shown = message;
    const fs::path inside = fs::path(shown.place.file).lexically_relative(entry.submission.folder);
    if (!inside.empty() && *inside.begin() != "..") shown.place.file = inside.generic_string();
    return escapeXml(toString(shown));
}

}  // namespace

std::string nameHtml(std::string_view name) {
    return "<bdi>" + escapeXml(base::printableText(name)) + "</bdi>";
}

std::string figureText(double value) {
    return fmt::format("{:.3f}", value);
}

std::string percentText(double share) {
    return fmt::format("{:.0f} %", 100 * share);
}

std::string stateHtml(const Entry& entry) {
    const std::string state = stateOf(entry);
    const char* look = state == "drawn"                            ? "passed"
                       : state == "no-scene" || state == "nothing" ? "missing"
                                                                   : state.c_str();
    std::string words = state == "no-scene" ? "no scene" : state == "nothing" ? "draws nothing" : state;
    if (const std::size_t drawn = drawnCount(entry); drawn > 0 && drawn < entry.pictures.size())
        words = fmt::format("{} of {} drawn", drawn, entry.pictures.size());
    return fmt::format("<span class=\"verdict {}\">{}</span>", look, words);
}

std::optional<std::vector<std::string>> SourceLines::lines(const Submission& submission,
                                                           const std::string& path, int from, int to) {
    const auto [known, isNew] = texts_.try_emplace(path);
    if (isNew) {
        base::Roots folder;
        folder.add(submission.folder);
        known->second = base::textIn(folder.open(path), kLargestSource);
    }
    if (!known->second) return std::nullopt;
    std::vector<std::string> found;
    std::string_view rest = *known->second;
    for (int line = 1; line <= to && !rest.empty(); ++line) {
        const std::size_t end = rest.find('\n');
        std::string_view one = rest.substr(0, end);
        if (one.ends_with('\r')) one.remove_suffix(1);
        if (line >= from) found.emplace_back(one.substr(0, kLongestLine));
        if (end == std::string_view::npos) break;
        rest.remove_prefix(end + 1);
    }
    return found;
}

std::string pictureHtml(const PictureSource& source, const Picture& picture, const Picture& shape,
                        const std::string& alternative, const std::string& caption) {
    const std::string address = picture.file.empty() ? std::string() : addressOf(source, picture);
    if (address.empty())
        return fmt::format(
            "<figure><div class=\"none\" style=\"aspect-ratio: {} / {}\">no picture</div>"
            "<figcaption>{}</figcaption></figure>",
            shape.width, shape.height, caption);
    const std::string image = fmt::format(
        "<img src=\"{}\" alt=\"{}\" width=\"{}\" height=\"{}\" loading=\"lazy\" decoding=\"async\">", address,
        alternative, picture.width, picture.height);
    return fmt::format("<figure><div class=\"shown\">{}</div><figcaption>{}</figcaption></figure>",
                       source.embeddedFrom ? image : fmt::format("<a href=\"{}\">{}</a>", address, image),
                       caption);
}

std::string picturesHtml(const PictureSource& source, const Classroom& room, const Entry& entry) {
    std::string html;
    if (std::ranges::all_of(entry.pictures, [](const Picture& each) { return each.file.empty(); }))
        return html;
    const std::string name = escapeXml(base::printableText(entry.submission.name));
    for (std::size_t i = 0; i < std::min(entry.pictures.size(), source.most); ++i) {
        const Picture& picture = entry.pictures[i];
        const std::string label = escapeXml(room.moments[i].label);
        const std::string caption =
            picture.score
                ? fmt::format("likeness {}{}, FLIP {}, structure {}", figureText(picture.score->likeness),
                              picture.score->effect ? ", effect " + figureText(*picture.score->effect) : "",
                              figureText(picture.score->flip), figureText(picture.score->structure))
            : picture.isIncomplete   ? std::string("incomplete: the scene has errors")
            : picture.reason.empty() ? std::string()
                                     : std::string("not drawn");
        // Where there is no picture, there is nothing to compare.
        if (!hasReference(room) || picture.file.empty()) {
            Picture shape = hasReference(room) ? room.reference.pictures[i] : picture;
            if (shape.height == 0) std::tie(shape.width, shape.height) = std::pair(4, 3);
            html += pictureHtml(source, picture, shape, name,
                                label.empty() || caption.empty() ? label + caption : label + ": " + caption);
            continue;
        }
        html += fmt::format("<div class=\"pair compared\">{}{}</div>",
                            pictureHtml(source, room.reference.pictures[i], room.reference.pictures[i],
                                        "the reference", label.empty() ? "reference" : label),
                            pictureHtml(source, picture, room.reference.pictures[i], name, caption));
    }
    if (entry.pictures.size() > source.most)
        html += fmt::format("<p>{} more pictures are not shown.</p>", entry.pictures.size() - source.most);
    return html;
}

std::string messagesHtml(const Entry& entry, SourceLines& sources) {
    std::string errors;
    std::size_t shown = 0, left = 0;
    // In the order of their first occurrence, those of one kind together.
    std::vector<std::pair<std::string, std::vector<const Diagnostic*>>> kinds;
    for (const Diagnostic& each : entry.diagnostics) {
        if (each.severity == Severity::error) {
            if (++shown <= kMostMessages)
                errors += fmt::format("<li class=\"remark error\">{}{}</li>", messageText(entry, each),
                                      shown <= 5 ? quoteHtml(entry, each.place, sources) : "");
            else
                ++left;
            continue;
        }
        const std::string kind = each.id.empty() ? "others" : each.id;
        auto known = std::ranges::find_if(kinds, [&](const auto& one) { return one.first == kind; });
        if (known == kinds.end()) known = kinds.insert(kinds.end(), {kind, {}});
        known->second.push_back(&each);
    }
    std::string items = errors;
    if (left > 0) items += fmt::format("<li>{} more errors</li>", left);
    for (const auto& [kind, all] : kinds) {
        std::string lines;
        for (std::size_t i = 0; i < std::min(all.size(), kMostMessages); ++i)
            lines += fmt::format("<li class=\"remark {}\">{}{}</li>", name(all[i]->severity),
                                 messageText(entry, *all[i]),
                                 i == 0 ? quoteHtml(entry, all[i]->place, sources) : "");
        if (all.size() > kMostMessages)
            lines += fmt::format("<li>{} more of this kind</li>", all.size() - kMostMessages);
        items +=
            all.size() == 1
                ? lines
                : fmt::format(
                      "<li class=\"remark {}\"><details><summary>{} times {}: {}</summary><ul>{}</ul>"
                      "</details></li>",
                      name(all[0]->severity), all.size(), escapeXml(kind), escapeXml(all[0]->text), lines);
    }
    return items.empty() ? items : "<ul class=\"messages\">" + items + "</ul>";
}

std::string marksHtml(const Classroom& room, const Entry& entry, std::string_view picturePrefix) {
    if (entry.marks.empty() && entry.comment.empty()) return {};
    std::string rows;
    for (const Mark& each : entry.marks) {
        std::string reason = escapeXml(each.reason);
        if (each.moment && *each.moment < entry.pictures.size() &&
            !entry.pictures[*each.moment].file.empty() && !picturePrefix.empty())
            reason += fmt::format(" <a href=\"{}\">{}</a>", escapeXml(entry.pictures[*each.moment].file),
                                  room.moments[*each.moment].label.empty()
                                      ? "picture"
                                      : escapeXml(room.moments[*each.moment].label));
        rows += fmt::format(
            "<tr{}><th>{}{}</th><td class=\"points\" data-check=\"{}\" data-most=\"{:g}\">{}</td><td>of "
            "{:g}</td><td>{}</td></tr>",
            each.isOwn                     ? " class=\"own\""
            : each.isOpen && !each.isBonus ? " class=\"open\""
                                           : "",
            escapeXml(each.check), each.isBonus ? " <small>bonus</small>" : "", escapeXml(each.check),
            each.most, each.isOpen ? std::string() : fmt::format("{:g}", each.points), each.most, reason);
    }
    std::string html;
    if (!rows.empty())
        html = fmt::format(
            "<table class=\"marks\"><tbody>{}</tbody><tfoot><tr><th>points</th><td>{:g}</td><td>of "
            "{:g}</td><td>{}</td></tr></tfoot></table>",
            rows, pointsOf(entry).value_or(0), mostPoints(room), escapeXml(entry.lateReason));
    if (!entry.comment.empty()) html += "<p class=\"comment\">" + escapeXml(entry.comment) + "</p>";
    return html;
}

std::string reactionsHtml(const Classroom& room, const Entry& entry) {
    std::string html;
    for (std::size_t i = 0; i < room.sliders.size(); ++i) {
        const Reacts reacts = reactsOf(room, entry, i);
        if (reacts == Reacts::unknown) continue;
        const std::optional<Change> expected =
            i < room.reference.reactions.size() ? room.reference.reactions[i] : std::nullopt;
        html += fmt::format("{}<span title=\"{}{}\">{} {}</span>", html.empty() ? "" : ", ",
                            figureText(entry.reactions[i]->strength),
                            expected ? ", the reference " + figureText(expected->strength) : "",
                            escapeXml(room.sliders[i].name), name(reacts));
    }
    return html;
}

std::string programsHtml(const Entry& entry) {
    std::string rows;
    for (const UsedProgram& each : entry.programs) {
        std::string uniforms;
        for (const DeclaredUniform& one : each.uniforms)
            uniforms += fmt::format("{}<code>{}</code> <small>{}</small>", uniforms.empty() ? "" : ", ",
                                    escapeXml(one.name), escapeXml(one.type));
        rows += fmt::format("<tr><th>{}</th><td>{}</td><td>{}</td></tr>", escapeXml(each.name),
                            escapeXml(fmt::format("{}", fmt::join(each.stages, ", "))),
                            uniforms.empty() ? "no uniforms" : uniforms);
    }
    return rows.empty()
               ? rows
               : "<table class=\"programs\"><thead><tr><th>program</th><th>stages</th><th>uniforms</th></tr>"
                 "</thead>" +
                     rows + "</table>";
}

}  // namespace glibra::classroom
