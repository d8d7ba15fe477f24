#include "classroom/grades.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <iterator>

#include "base/utf8.h"

namespace glibra::classroom {
namespace {

std::string number(double value) {
    return fmt::format("{:.5f}", value);
}

class Line {
  public:
    void text(std::string_view value) { add(csvField(value)); }
    void count(std::size_t value) { add(fmt::format("{}", value)); }
    void score(const std::optional<double>& value) { add(value ? number(*value) : std::string()); }
    std::string end() { return line_ + "\r\n"; }

  private:
    void add(const std::string& field) {
        line_ += first_ ? field : "," + field;
        first_ = false;
    }
    std::string line_;
    bool first_ = true;
};

/// Also the wide forms, which spreadsheets for East Asian languages accept.
bool beginsFormula(std::uint32_t code) {
    constexpr std::uint32_t kSigns[] = {'=', '+', '-', '@', 0xFF1D, 0xFF0B, 0xFF0D, 0xFF20, 0x2212};
    return std::find(std::begin(kSigns), std::end(kSigns), code) != std::end(kSigns);
}

constexpr bool isBlank(std::uint32_t code) {
    return code <= ' ' || (code >= 0x7F && code <= 0xA0) || code == 0x2028 || code == 0x2029 ||
           code == 0xFEFF;
}

std::string joined(const std::vector<std::string>& words) {
    return fmt::format("{}", fmt::join(words, " "));
}

}  // namespace

std::string csvField(std::string_view text) {
    std::string clean;
    bool begun = false, isFormula = false, isQuoted = false;
    while (!text.empty()) {
        const base::Character next = base::firstCharacter(text);
        text.remove_prefix(next.bytes);
        if (isBlank(next.code)) {
            clean += ' ';
            continue;
        }
        if (!begun) isFormula = beginsFormula(next.code);
        begun = true;
        if (next.code == '"' || next.code == ',' || next.code == ';') isQuoted = true;
        if (next.code == '"') clean += '"';
        base::appendUtf8(clean, next.code);
    }
    if (isFormula) clean.insert(0, "'");
    return isQuoted ? "\"" + clean + "\"" : clean;
}

std::string gradesCsv(const Classroom& classroom) {
    const bool several = classroom.moments.size() > 1;
    Line head;
    for (const char* each : {"submission", "state", "reason", "scene", "pictures", "drawn", "flip",
                             "worst flip", "structure", "worst structure", "errors", "warnings", "stages",
                             "uniforms", "most similar", "similarity", "not compared"})
        head.text(each);
    if (several)
        for (const Moment& each : classroom.moments) {
            head.text("flip " + each.label);
            head.text("structure " + each.label);
        }
    std::string table = head.end();
    for (std::size_t i = 0; i < classroom.entries.size(); ++i) {
        const Entry& entry = classroom.entries[i];
        const std::optional<Scores> scores = scoresOf(entry);
        const auto part = [&](double Scores::* member) {
            return scores ? std::optional<double>((*scores).*member) : std::nullopt;
        };
        std::vector<std::string> stages, uniforms;
        const auto addNew = [](std::vector<std::string>& to, const std::string& word) {
            if (std::find(to.begin(), to.end(), word) == to.end()) to.push_back(word);
        };
        for (const UsedProgram& program : entry.programs) {
            for (std::string stage : program.stages) {
                std::replace(stage.begin(), stage.end(), ' ', '-');
                addNew(stages, stage);
            }
            for (const DeclaredUniform& uniform : program.uniforms) addNew(uniforms, uniform.name);
        }
        Line line;
        line.text(entry.submission.name);
        line.text(stateOf(entry));
        line.text(reasonOf(entry));
        line.text(entry.submission.scene.empty()
                      ? std::string()
                      : entry.submission.scene.lexically_relative(entry.submission.folder).string());
        line.count(classroom.moments.size());
        line.count(drawnCount(entry));
        line.score(part(&Scores::flip));
        line.score(part(&Scores::worstFlip));
        line.score(part(&Scores::structure));
        line.score(part(&Scores::worstStructure));
        line.count(countOf(entry, Severity::error));
        line.count(countOf(entry, Severity::warning));
        line.text(joined(stages));
        line.text(joined(uniforms));
        const std::optional<Nearest> nearest = nearestOf(classroom, i);
        line.text(nearest ? classroom.entries[nearest->entry].submission.name : "");
        line.score(nearest ? std::optional(nearest->share) : std::nullopt);
        line.text(fmt::format("{}", fmt::join(entry.notCompared, "; ")));
        if (several)
            for (std::size_t moment = 0; moment < classroom.moments.size(); ++moment) {
                const std::optional<Score> score =
                    moment < entry.pictures.size() ? entry.pictures[moment].score : std::nullopt;
                line.score(score ? std::optional(score->flip) : std::nullopt);
                line.score(score ? std::optional(score->structure) : std::nullopt);
            }
        table += line.end();
    }
    return table;
}

}  // namespace glibra::classroom
