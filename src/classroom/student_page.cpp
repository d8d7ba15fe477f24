#include "classroom/student_page.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <utility>

#include "base/page_template.h"
#include "base/text.h"
#include "base/utf8.h"
#include "classroom/file_names.h"
#include "classroom/page_parts.h"
#include "embedded/class_page.h"
#include "embedded/report_page.h"

namespace glibra::classroom {
namespace {

std::uint64_t shuffled(std::string_view text) {
    std::uint64_t hash = 14695981039346656037ULL;  // FNV-1a
    for (const char each : text) hash = (hash ^ static_cast<unsigned char>(each)) * 1099511628211ULL;
    hash = (hash ^ (hash >> 33U)) * 0xff51afd7ed558ccdULL;
    return hash ^ (hash >> 33U);
}

void replaceAll(std::string& text, const std::string& from, const std::string& to) {
    if (from.size() < 2) return;
    for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size()))
        text.replace(at, from.size(), to);
}

}  // namespace

std::vector<std::string> studentFiles(const Classroom& room) {
    std::vector<std::string> files;
    for (const Entry& each : room.entries) files.push_back(each.submission.name);
    files = fileNames(std::move(files));
    for (std::string& each : files) each += ".html";
    return files;
}

std::string studentPage(const Classroom& room, std::size_t index, const std::filesystem::path& site) {
    const Entry& entry = room.entries[index];
    const PictureSource source{site, kMostStudentPictures};
    SourceLines sources;
    std::string body = "<p>" + stateHtml(entry) + "</p>" + marksHtml(room, entry, "");
    const std::string reason = reasonOf(entry);
    if (!reason.empty() && (entry.diagnostics.empty() || entry.drawsNothing))
        body += "<p class=\"reason\">" + base::escapeXml(base::printableText(reason)) + "</p>";
    body += messagesHtml(entry, sources) + picturesHtml(source, room, entry) + programsHtml(entry);
    const base::Slot slots[] = {
        {"title", base::escapeXml(base::printableText(entry.submission.name))},
        {"headline", nameHtml(entry.submission.name)},
        {"style", std::string(report_page::report_css()) + std::string(class_page::class_css())},
        {"body", body},
    };
    return base::filled(class_page::student_html(), slots);
}

Classroom anonymous(const Classroom& room, std::vector<std::string>& keys) {
    std::vector<std::size_t> order(room.entries.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::sort(order, [&](std::size_t a, std::size_t b) {
        const auto key = [&](std::size_t i) {
            const std::string& name = room.entries[i].submission.name;
            return std::pair(shuffled(name), name);
        };
        return key(a) < key(b);
    });
    std::vector<std::size_t> numberOf(order.size());
    for (std::size_t i = 0; i < order.size(); ++i) numberOf[order[i]] = i;
    const auto nameOf = [](std::size_t number) { return fmt::format("Submission {:02}", number + 1); };
    Classroom made = room;
    made.command.clear();
    made.leftOut.clear();
    made.absent.clear();
    made.unplaced.clear();
    keys.clear();
    for (std::size_t i = 0; i < order.size(); ++i) {
        const Entry& from = room.entries[order[i]];
        Entry& to = made.entries[i];
        to = from;
        keys.push_back(from.submission.name);
        if (order[i] < room.fingerprints.size()) made.fingerprints[i] = room.fingerprints[order[i]];
        to.submission.name = nameOf(i);
        to.submission.number.clear();
        to.submission.email.clear();
        to.submission.members.clear();
        to.submission.key.clear();
        to.reproduce.clear();
        // Messages name the folder, and whoever made it put a name there.
        const auto clean = [&](std::string& text) {
            replaceAll(text, from.submission.folder.string() + "/", "");
            for (std::size_t other = 0; other < order.size(); ++other) {
                const Submission& one = room.entries[other].submission;
                replaceAll(text, one.name, nameOf(numberOf[other]));
                for (const Member& each : one.members) replaceAll(text, each.name, nameOf(numberOf[other]));
                replaceAll(text, one.key, nameOf(numberOf[other]));
            }
        };
        clean(to.submission.problem);
        for (std::string& each : to.notCompared) clean(each);
        for (Picture& each : to.pictures) clean(each.reason);
        for (Mark& each : to.marks) clean(each.reason);
        for (Diagnostic& each : to.diagnostics) clean(each.text);
    }
    for (SimilarPair& each : made.pairs) {
        each.a = numberOf[each.a];
        each.b = numberOf[each.b];
        if (each.a > each.b) {
            std::swap(each.a, each.b);
            std::swap(each.ofA, each.ofB);
        }
    }
    made.isAnonymous = true;
    return made;
}

}  // namespace glibra::classroom
