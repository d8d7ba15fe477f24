#include "classroom/grades.h"

#include <fmt/format.h>
#include <algorithm>
#include <cstdint>
#include <iterator>

#include "base/text.h"
#include "base/utf8.h"

namespace glibra::classroom {
namespace {

/// Also the wide forms, which spreadsheets for East Asian languages accept.
bool beginsFormula(std::uint32_t code) {
    constexpr std::uint32_t kSigns[] = {'=', '+', '-', '@', 0xFF1D, 0xFF0B, 0xFF0D, 0xFF20, 0x2212};
    return std::ranges::find(kSigns, code) != std::end(kSigns);
}

constexpr bool isBlank(std::uint32_t code) {
    return code <= ' ' || (code >= 0x7F && code <= 0xA0) || code == 0x2028 || code == 0x2029 ||
           code == 0xFEFF;
}

}  // namespace

std::string csvField(std::string_view text) {
    std::string clean;
    bool begun = false, isFormula = false;
    while (!text.empty()) {
        const base::Character next = base::firstCharacter(text);
        text.remove_prefix(next.bytes);
        if (isBlank(next.code)) {
            clean += ' ';
            continue;
        }
        if (!begun) isFormula = beginsFormula(next.code);
        begun = true;
        base::appendUtf8(clean, next.code);
    }
    if (isFormula) clean.insert(0, "'");
    return base::csvField(clean, ",;\"");
}

std::string gradesCsv(const Classroom& classroom) {
    const bool several = classroom.moments.size() > 1;
    const bool numbered = std::ranges::any_of(classroom.entries, [](const Entry& each) {
        return !each.submission.number.empty() || !each.submission.email.empty();
    });
    const bool pointed = mostPoints(classroom) > 0;
    CsvRecord head;
    for (const char* each : {"submission", "state", "reason", "scene", "pictures", "drawn", "flip",
                             "worst flip", "structure", "worst structure", "likeness", "errors", "warnings",
                             "stages", "uniforms", "most similar", "similarity", "not compared"})
        head.text(each);
    for (const Slider& each : classroom.sliders) head.text("reacts " + each.name);
    if (numbered)
        for (const char* each : {"number", "email"}) head.text(each);
    if (pointed) {
        for (const char* each : {"points", "most points"}) head.text(each);
        for (const Mark& each : classroom.entries.front().marks) head.text("points " + each.check);
        for (const char* each : {"not marked", "late", "comment"}) head.text(each);
    }
    if (several)
        for (const Moment& each : classroom.moments) {
            head.text("flip " + each.label);
            head.text("structure " + each.label);
            head.text("likeness " + each.label);
        }
    // Excel takes a table without this mark for one in the machine's own code page.
    const bool isAscii = std::ranges::all_of(classroom.entries, [](const Entry& each) {
        const std::string texts = each.submission.name + each.comment;
        return std::ranges::all_of(texts, [](char one) { return static_cast<unsigned char>(one) < 0x80; });
    });
    std::string table = (isAscii ? "" : "\xEF\xBB\xBF") + head.end();
    for (std::size_t i = 0; i < classroom.entries.size(); ++i) {
        const Entry& entry = classroom.entries[i];
        const std::optional<Scores> scores = scoresOf(entry);
        const auto part = [&](double Scores::* member) {
            return scores ? std::optional<double>((*scores).*member) : std::nullopt;
        };
        std::vector<std::string> stages, uniforms;
        const auto addNew = [](std::vector<std::string>& to, const std::string& word) {
            if (std::ranges::find(to, word) == to.end()) to.push_back(word);
        };
        for (const UsedProgram& program : entry.programs) {
            for (std::string stage : program.stages) {
                std::ranges::replace(stage, ' ', '-');
                addNew(stages, stage);
            }
            for (const DeclaredUniform& uniform : program.uniforms) addNew(uniforms, uniform.name);
        }
        CsvRecord line;
        line.text(entry.submission.name);
        line.text(stateOf(entry));
        line.text(reasonOf(entry));
        line.text(entry.submission.scene.empty()
                      ? std::string()
                      : entry.submission.scene.lexically_relative(entry.submission.folder).generic_string());
        line.count(classroom.moments.size());
        line.count(drawnCount(entry));
        line.score(part(&Scores::flip));
        line.score(part(&Scores::worstFlip));
        line.score(part(&Scores::structure));
        line.score(part(&Scores::worstStructure));
        line.score(part(&Scores::likeness));
        line.count(countOf(entry, Severity::error));
        line.count(countOf(entry, Severity::warning));
        line.text(fmt::format("{}", fmt::join(stages, " ")));
        line.text(fmt::format("{}", fmt::join(uniforms, " ")));
        const std::optional<Nearest> nearest = nearestOf(classroom, i);
        line.text(nearest ? comparedEntry(classroom, nearest->entry).submission.name : "");
        line.score(nearest ? std::optional(nearest->share) : std::nullopt);
        line.text(fmt::format("{}", fmt::join(entry.notCompared, "; ")));
        for (std::size_t slider = 0; slider < classroom.sliders.size(); ++slider)
            line.text(name(reactsOf(classroom, entry, slider)));
        if (numbered) {
            const std::vector<Member> members = membersOf(entry.submission);
            line.text(joined(members, &Member::number));
            line.text(joined(members, &Member::email));
        }
        if (pointed) {
            line.score(pointsOf(entry));
            line.score(mostPoints(classroom));
            for (const Mark& each : entry.marks)
                line.score(each.isOpen ? std::nullopt : std::optional(each.points));
            line.count(openCount(entry));
            line.text(entry.lateReason);
            line.text(entry.comment);
        }
        if (several)
            for (std::size_t moment = 0; moment < classroom.moments.size(); ++moment) {
                const std::optional<Score> score =
                    moment < entry.pictures.size() ? entry.pictures[moment].score : std::nullopt;
                line.score(score ? std::optional(score->flip) : std::nullopt);
                line.score(score ? std::optional(score->structure) : std::nullopt);
                line.score(score ? std::optional(score->likeness) : std::nullopt);
            }
        table += line.end();
    }
    return table;
}

}  // namespace glibra::classroom
