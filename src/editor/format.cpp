#include "editor/format.h"

#include <algorithm>
#include <optional>
#include <vector>

#include "glib/limits.h"
#include "glib/parse/statement.h"
#include "glib/script.h"
#include "glib/statement_table.h"
#include "glib/text.h"

namespace glibra::editor {
namespace {

constexpr std::size_t kIndent = 4;
constexpr std::size_t kTab = 4;  // columns
constexpr std::size_t kNone = static_cast<std::size_t>(-1);

bool isSpaceOrTab(char c) {
    return c == ' ' || c == '\t' || c == '\v' || c == '\f';
}

/// A line of the text and what it gets.
struct FormattedLine {
    std::size_t begin = 0, end = 0, next = 0;  ///< `end` is before its line end, `next` after it
    bool isKept = false;                       ///< it stays as it is
    bool keepsStart = false;                   ///< it begins inside of a token
    std::size_t indent = kNone;                ///< blanks before it; kNone: those that it has
    std::string code{};                        ///< without the blanks at its beginning
    std::size_t backslash = kNone;             ///< where in `code` the backslash is that continues it
    std::size_t comment = kNone;               ///< where in `code` its comment begins
};

/// The column of the first byte that is no blank.
std::size_t columnOf(std::string_view line) {
    std::size_t column = 0;
    for (const char c : line) {
        if (!isSpaceOrTab(c)) break;
        column = c == '\t' ? (column / kTab + 1) * kTab : column + 1;
    }
    return column;
}

/// What a statement does to the indentation of those after it.
enum class Nesting { none, opens, divides, closes };
struct Block {
    Nesting nesting = Nesting::none;
    glib::CommandId kind{};  ///< of the block: the statement that opens it
};

Block blockOf(const glib::Statement& statement) {
    using glib::CommandId;
    if (const glib::StatementRow* row = statement.modern) {
        switch (row->role) {
            case glib::BlockRole::opens:
                return {Nesting::opens, row->id};
            case glib::BlockRole::divides:
                return {Nesting::divides, row->opener};
            case glib::BlockRole::closes:
                return {Nesting::closes, row->opener};
            case glib::BlockRole::none:
                return {};
        }
    }
    if (!statement.row) return {};
    switch (statement.row->id) {
        case CommandId::glBegin:
        case CommandId::pushMatrix:
            return {Nesting::opens, statement.row->id};
        case CommandId::glEnd:
            return {Nesting::closes, CommandId::glBegin};
        case CommandId::popMatrix:
            return {Nesting::closes, CommandId::pushMatrix};
        default:
            return {};
    }
}

/// The blocks around each statement. A block that nothing closes, and an end of no block, have no effect.
std::vector<std::size_t> depthsOf(const std::vector<glib::Statement>& statements) {
    std::vector<Block> blocks;
    for (const glib::Statement& each : statements) blocks.push_back(blockOf(each));
    std::vector<bool> counts(blocks.size(), false);
    std::vector<std::size_t> open;
    for (std::size_t i = 0; i < blocks.size(); ++i) {
        if (blocks[i].nesting == Nesting::opens) open.push_back(i);
        if (blocks[i].nesting != Nesting::closes && blocks[i].nesting != Nesting::divides) continue;
        const auto opener = std::find_if(open.rbegin(), open.rend(),
                                         [&](std::size_t at) { return blocks[at].kind == blocks[i].kind; });
        if (opener == open.rend()) continue;
        counts[i] = true;
        if (blocks[i].nesting == Nesting::divides) continue;
        counts[*opener] = true;
        open.erase(opener.base() - 1, open.end());
    }
    std::vector<std::size_t> depths;
    std::size_t depth = 0;
    for (std::size_t i = 0; i < blocks.size(); ++i) {
        const Nesting nesting = counts[i] ? blocks[i].nesting : Nesting::none;
        if (nesting == Nesting::closes && depth > 0) --depth;
        depths.push_back(nesting == Nesting::divides && depth > 0 ? depth - 1 : depth);
        if (nesting == Nesting::opens) ++depth;
    }
    return depths;
}

/// The statement's word as the reference spells it; nothing if it is no word of the language.
std::optional<std::string_view> spelling(const glib::Statement& statement) {
    if (statement.modern) return statement.modern->name;
    if (!statement.row) return std::nullopt;
    for (const std::string_view each : statement.row->names())
        if (glib::sameWord(each, statement.word.text)) return each;
    return std::nullopt;
}

/// True if the text is blanks with a tab among them.
bool isGapWithTab(std::string_view gap) {
    return gap.find_first_of("\t\v\f") != std::string_view::npos && std::ranges::all_of(gap, isSpaceOrTab);
}

class Formatter {
  public:
    explicit Formatter(std::string_view text) : text_(text), statements_(glib::statementsOf(text)) {
        glib::LineSplitter splitter(text);
        while (const std::optional<glib::LineRange> each = splitter.next()) {
            if (!lines_.empty()) lines_.back().next = each->begin;
            lines_.push_back({.begin = each->begin, .end = each->end, .next = text.size()});
        }
    }

    std::string format() {
        const std::vector<std::size_t> depths = depthsOf(statements_);
        std::size_t line = 0;
        std::size_t depth = 0;
        bool isSkipped = false;  // what follows may be a shader that is not closed
        for (std::size_t i = 0; i < statements_.size(); ++i) {
            const glib::Statement& statement = statements_[i];
            // Comments before an end belong to what stands before them.
            for (; line < lines_.size() && lines_[line].next <= statement.word.begin; ++line)
                betweenStatements(line, std::max(depth, depths[i]), isSkipped);
            std::size_t last = line;
            while (last < lines_.size() && lines_[last].next < statement.end) ++last;
            const bool opens = i + 1 < depths.size() && depths[i + 1] > depths[i];
            depth = opens ? depths[i] + 1 : depths[i];
            isSkipped = statement.faulty || statement.refused || (!statement.row && !statement.modern);
            if (isSkipped)
                for (; line <= last && line < lines_.size(); ++line) lines_[line].isKept = true;
            else
                formatStatement(statement, line, last, depths[i] * kIndent);
            line = last + 1;
        }
        for (; line < lines_.size(); ++line) betweenStatements(line, depth, isSkipped);
        return joined();
    }

  private:
    [[nodiscard]] std::string_view whole(const FormattedLine& line) const {
        return text_.substr(line.begin, line.end - line.begin);
    }

    /// A line with a comment, or an empty one.
    void betweenStatements(std::size_t index, std::size_t depth, bool isSkipped) {
        FormattedLine& line = lines_[index];
        const std::string_view text = whole(line);
        const std::size_t first = text.find_first_not_of(" \t\v\f");
        if (first == std::string_view::npos) {
            line.indent = 0;
            return;
        }
        if (isSkipped || (text[first] != '#' && text[first] != '/')) {
            line.isKept = true;
            return;
        }
        line.code = text.substr(first);
        line.comment = 0;
        line.indent = depth * kIndent;
        // It may go on with the comment after the code of the line before.
        if (index == 0) return;
        const FormattedLine& before = lines_[index - 1];
        if (before.isKept || before.keepsStart || before.comment == kNone || before.code.empty() ||
            (before.comment == 0 && !continuesComment_))
            continuesComment_ = false;
        else
            continuesComment_ = columnOf(text) == commentColumn_ && commentColumn_ > 0;
        if (continuesComment_) line.indent = before.indent + before.comment;
    }

    void formatStatement(const glib::Statement& statement, std::size_t first, std::size_t last,
                         std::size_t indent) {
        continuesComment_ = false;
        std::vector<const glib::Token*> tokens{&statement.word};
        for (const glib::Token& each : statement.arguments) tokens.push_back(&each);
        const std::size_t bodyBegin =
            statement.body.data() ? static_cast<std::size_t>(statement.body.data() - text_.data()) : kNone;
        const std::size_t bodyEnd = bodyBegin == kNone ? kNone : bodyBegin + statement.body.size();
        const std::size_t from = columnOf(whole(lines_[first]));
        std::size_t token = 0;
        std::size_t lastCode = first;
        for (std::size_t i = first; i <= last && i < lines_.size(); ++i) {
            FormattedLine& line = lines_[i];
            if (bodyBegin != kNone && line.begin >= bodyBegin) {
                line.isKept = line.begin < bodyEnd;
                if (line.isKept) continue;
                const std::string_view end = whole(line);
                line.code = end.substr(std::min(end.find_first_not_of(" \t\v\f"), end.size()));
                line.code.erase(line.code.find_last_not_of(" \t\v\f") + 1);
                const std::string word = "End" + std::string(statement.modern->name);
                if (glib::sameWord(line.code, word)) line.code = word;
                line.indent = indent;
                continue;
            }
            lastCode = i;
            while (token < tokens.size() && tokens[token]->end <= line.begin) ++token;
            formatLine(statement, line, tokens, token);
            if (line.keepsStart) continue;
            const std::size_t column = columnOf(whole(line));
            line.indent =
                i == first ? indent
                           : std::max(column + indent > from ? column + indent - from : 0, indent + kIndent);
        }
        commentColumn_ = columnOf(whole(lines_[lastCode]));
        if (lines_[lastCode].comment != kNone) {
            const std::string_view text = whole(lines_[lastCode]);
            commentColumn_ += text.size() - std::min(text.find_first_not_of(" \t\v\f"), text.size());
            commentColumn_ -= commentLength_;
        }
        alignBackslashes(first, lastCode);
    }

    /// Copies the code of a line; `token` is the first one that does not end before it.
    void formatLine(const glib::Statement& statement, FormattedLine& line,
                    const std::vector<const glib::Token*>& tokens, std::size_t token) {
        std::size_t at = line.begin;
        line.keepsStart = token < tokens.size() && tokens[token]->begin < line.begin;
        if (!line.keepsStart)
            while (at < line.end && isSpaceOrTab(text_[at])) ++at;
        const std::size_t codeBegin = at;
        bool endsInside = false;
        for (; token < tokens.size() && tokens[token]->begin < line.end; ++token) {
            const glib::Token& each = *tokens[token];
            if (each.begin > at) {
                const std::string_view gap = text_.substr(at, each.begin - at);
                line.code += isGapWithTab(gap) && at > codeBegin ? std::string_view(" ") : gap;
            }
            const std::size_t begin = std::max(each.begin, line.begin), end = std::min(each.end, line.end);
            const bool isWord = &each == &statement.word;
            const std::optional<std::string_view> spelt = isWord ? spelling(statement) : std::nullopt;
            line.code += spelt ? *spelt : text_.substr(begin, end - begin);
            endsInside = each.end > line.end;
            at = end;
        }
        const std::string_view rest = text_.substr(at, line.end - at);
        if (endsInside) {
            line.code += rest;
            return;
        }
        const std::size_t comment = rest.find_first_of("#/");
        if (comment != std::string_view::npos && !isMessage(statement)) {
            line.comment = line.code.size() + comment;
            commentLength_ = rest.size() - comment;
            line.code += rest;
            return;
        }
        line.code += rest.substr(0, rest.find_last_not_of(" \t\v\f") + 1);
        if (line.code.ends_with('\\') && line.code.size() > 1) line.backslash = line.code.size() - 1;
    }

    static bool isMessage(const glib::Statement& statement) {
        return statement.row && statement.row->id == glib::CommandId::messageBox;
    }

    /// The backslashes that continue the statement stand in one column, a blank after its longest line.
    void alignBackslashes(std::size_t first, std::size_t last) {
        std::size_t column = 0;
        for (std::size_t i = first; i < last; ++i) {
            const FormattedLine& line = lines_[i];
            if (line.backslash == kNone || line.keepsStart) continue;
            const std::string_view code(line.code.data(), line.backslash);
            column = std::max(column, line.indent + code.find_last_not_of(' ') + 2);
        }
        for (std::size_t i = first; i < last; ++i) {
            FormattedLine& line = lines_[i];
            if (line.backslash == kNone || line.keepsStart) continue;
            line.code.resize(line.code.find_last_not_of(' ', line.backslash - 1) + 1);
            line.code.append(column - line.indent - line.code.size(), ' ');
            line.code += '\\';
        }
    }

    [[nodiscard]] std::string joined() const {
        std::size_t count = lines_.size();
        while (count > 0 && !lines_[count - 1].isKept && lines_[count - 1].code.empty()) --count;
        std::string to(text_.substr(0, lines_.empty() ? 0 : lines_.front().begin));
        for (std::size_t i = 0; i < count; ++i) {
            const FormattedLine& line = lines_[i];
            if (line.isKept)
                to += whole(line);
            else if (!line.code.empty())
                to.append(line.keepsStart ? 0 : line.indent, ' ') += line.code;
            const std::string_view end = text_.substr(line.end, line.next - line.end);
            to += !end.empty() ? end : usualEnd();
        }
        return to;
    }

    [[nodiscard]] std::string_view usualEnd() const {
        if (lines_.size() < 2) return "\n";
        return text_.substr(lines_.front().end, lines_.front().next - lines_.front().end);
    }

    std::string_view text_;
    std::vector<glib::Statement> statements_;
    std::vector<FormattedLine> lines_;
    std::size_t commentColumn_ = 0;  ///< of the last comment after code, in the unformatted text
    std::size_t commentLength_ = 0;
    bool continuesComment_ = false;
};

std::string formattedOnce(std::string_view text) {
    return Formatter(text).format();
}

}  // namespace

bool meanTheSame(std::string_view a, std::string_view b) {
    return glib::meanTheSame(glib::parse(a, {}), glib::parse(b, {}));
}

std::string formatted(std::string_view text) {
    if (text.size() > glib::kLargestFile) return std::string(text);
    std::string once = formattedOnce(text);
    // A guard for texts that are hardly scenes.
    if (!meanTheSame(text, once) || formattedOnce(once) != once) return std::string(text);
    return once;
}

}  // namespace glibra::editor
