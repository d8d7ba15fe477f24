#pragma once
// Strict readers of the tables that grade books import.

#include <map>
#include <stdexcept>
#include <string>
#include <vector>

namespace glibra::classroom {

/// RFC 4180 and nothing else: every record has as many fields as the first, lines end with CR LF, a quote
/// stands only around a field or doubled in one.
inline std::vector<std::map<std::string, std::string>> strictly(const std::string& text) {
    std::vector<std::vector<std::string>> records(1);
    std::size_t at = 0;
    while (at < text.size()) {
        std::string field;
        if (text[at] == '"') {
            for (++at;; ++at) {
                if (at >= text.size()) throw std::runtime_error("a quote is not closed");
                if (text[at] != '"')
                    field += text[at];
                else if (text.compare(at, 2, "\"\"") == 0)
                    field += text[at++];
                else
                    break;
            }
            ++at;
        } else {
            const std::size_t end = text.find_first_of(",\r\n\"", at);
            field = text.substr(at, end - at);
            at = end;
        }
        records.back().push_back(field);
        if (text.compare(at, 1, ",") == 0) {
            ++at;
        } else if (text.compare(at, 2, "\r\n") == 0) {
            at += 2;
            records.emplace_back();
        } else {
            throw std::runtime_error("neither a comma nor a line end at " + std::to_string(at));
        }
    }
    records.pop_back();
    std::vector<std::map<std::string, std::string>> rows;
    for (std::size_t i = 1; i < records.size(); ++i) {
        if (records[i].size() != records[0].size()) throw std::runtime_error("a record of another length");
        std::map<std::string, std::string>& row = rows.emplace_back();
        for (std::size_t k = 0; k < records[0].size(); ++k)
            if (!row.emplace(records[0][k], records[i][k]).second) throw std::runtime_error("two columns");
    }
    return rows;
}

/// As importgradeslib.php of Moodle's assignfeedback_offline reads it: a table without one of three columns,
/// which are compared letter by letter, is refused, lines without a known identifier are skipped, an empty
/// grade changes nothing.
inline std::map<std::string, double> moodleGrades(const std::string& table) {
    std::map<std::string, double> grades;
    for (const auto& row : strictly(table)) {
        for (const char* each : {"Identifier", "Grade", "Last modified (grade)"})
            if (!row.contains(each)) throw std::runtime_error(std::string("there is no column ") + each);
        const std::string id = row.at("Identifier");
        if (!id.starts_with("Participant ")) continue;
        (void)row.at("Feedback comments");
        if (!row.at("Grade").empty()) grades[id.substr(12)] = std::stod(row.at("Grade"));
    }
    return grades;
}

/// As Canvas reads it: five columns with their names in this order, then assignments; lines without an id, as
/// that of the points possible, are no students.
inline std::map<std::string, double> canvasGrades(const std::string& table, const std::string& assignment) {
    const std::string head = table.substr(0, table.find('\n'));
    if (!head.starts_with("Student,ID,SIS User ID,SIS Login ID,Section,"))
        throw std::runtime_error("the columns of Canvas are missing");
    std::map<std::string, double> grades;
    for (const auto& row : strictly(table))
        if (!row.at("ID").empty() && !row.at(assignment).empty())
            grades[row.at("ID")] = std::stod(row.at(assignment));
    return grades;
}

/// The columns of Gradescope's own export of scores.
inline std::map<std::string, double> gradescopeGrades(const std::string& table) {
    std::map<std::string, double> grades;
    for (const auto& row : strictly(table)) {
        for (const char* each : {"First Name", "Last Name", "Email", "Max Points"}) (void)row.at(each);
        if (!row.at("Total Score").empty()) grades[row.at("SID")] = std::stod(row.at("Total Score"));
    }
    return grades;
}

}  // namespace glibra::classroom
