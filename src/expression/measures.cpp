#include "expression/measures.h"

#include <fmt/format.h>
#include <algorithm>
#include <utility>

#include "expression/functions.h"
#include "expression/parser.h"

namespace glibra::expression {
namespace {

std::string_view slice(std::string_view text, Range range) {
    return text.substr(range.begin, range.end - range.begin);
}

/// Reads one call, token by token.
class CallReader {
  public:
    CallReader(std::string_view text, const Token& function) : text_(text), lexer_(text) {
        lexer_.goTo(function.range.end);
        call_.function = function.text;
        call_.range = function.range;
        take();
    }

    std::optional<MeasureCall> read() {
        if (!token_.is("(")) return std::nullopt;
        readArguments();
        if (call_.why.empty()) readSeconds();
        call_.path = slice(text_, call_.range);
        if (call_.seconds) call_.path += fmt::format(" at {}", slice(text_, *call_.seconds));
        return std::move(call_);
    }

  private:
    void take() { token_ = lexer_.next(); }

    void refuse() {
        call_.why = fmt::format("{0} needs the name of a texture or buffer: {0}(NAME)", call_.function);
    }

    /// Moves to the end of brackets that are open; false at the end of the text.
    bool skipBrackets() {
        int depth = 0;
        do {
            depth += token_.is("(") || token_.is("[") ? 1 : 0;
            depth -= token_.is(")") || token_.is("]") ? 1 : 0;
            if (token_.kind == TokenKind::end) return false;
            if (depth > 0) take();
        } while (depth > 0);
        return true;
    }

    void readArguments() {
        std::vector<Range> arguments;
        std::uint32_t begin = token_.range.end;
        take();
        while (token_.kind != TokenKind::end && token_.kind != TokenKind::wrong) {
            if (token_.is("(") || token_.is("[")) {
                if (!skipBrackets()) break;
                take();
                continue;
            }
            if (!token_.is(",") && !token_.is(")")) {
                take();
                continue;
            }
            arguments.push_back({begin, token_.range.begin});
            begin = token_.range.end;
            if (token_.is(")")) break;
            take();
        }
        call_.range.end = token_.range.end;
        if (!token_.is(")")) {
            call_.why = fmt::format("{}: a closing parenthesis is missing", call_.function);
            return;
        }
        call_.object = arguments.front();
        call_.numbers.assign(arguments.begin() + 1, arguments.end());
        checkName();
    }

    /// A name has parts, each with a number in parentheses: `sky.face(+x).level(1)`.
    void checkName() {
        Lexer lexer(text_.substr(0, call_.object.end));
        lexer.goTo(call_.object.begin);
        std::swap(lexer, lexer_);
        bool isName = true;
        for (take(); isName && token_.kind != TokenKind::end;) {
            isName = token_.kind == TokenKind::name;
            take();
            while (isName && (token_.is("(") || token_.is("["))) {
                isName = skipBrackets();
                take();
            }
            if (token_.is("."))
                take();
            else
                isName = isName && token_.kind == TokenKind::end;
        }
        if (!isName || slice(text_, call_.object).find_first_not_of(" \t") == std::string_view::npos)
            refuse();
        std::swap(lexer, lexer_);
    }

    void readSeconds() {
        take();
        while (token_.is(".") || token_.is("[")) {  // components
            if (token_.is("[") ? !skipBrackets() : (take(), token_.kind != TokenKind::name)) return;
            take();
        }
        if (token_.kind != TokenKind::name || token_.text != "at") return;
        Range seconds{token_.range.end, token_.range.end};
        const std::uint32_t at = token_.range.end;
        take();
        if (token_.is("-") || token_.is("+")) {
            seconds.end = token_.range.end;
            take();
        }
        const bool isNumber = token_.kind == TokenKind::number;
        bool isOpen = token_.is("(") || token_.kind == TokenKind::name;
        while (isNumber || isOpen) {
            if (token_.is("(") || token_.is("[")) {
                if (!skipBrackets()) break;
            }
            seconds.end = token_.range.end;
            const bool wasPoint = token_.is(".");
            take();
            if (isNumber) break;
            isOpen = token_.is("(") || token_.is("[") || token_.is(".") ||
                     (wasPoint && token_.kind == TokenKind::name);
        }
        if (seconds.end == at)
            call_.why = fmt::format("{}: a time in seconds follows 'at'", call_.function);
        else
            call_.seconds = seconds;
    }

    std::string_view text_;
    Lexer lexer_;
    Token token_;
    MeasureCall call_;
};

}  // namespace

bool isMeasure(std::string_view function) {
    const auto rows = functionsNamed(function);
    return !rows.empty() && rows.front().group == FunctionGroup::data;
}

std::optional<MeasureCall> measureAt(std::string_view text, std::uint32_t begin) {
    Lexer lexer(text);
    lexer.goTo(begin);
    const Token name = lexer.next();
    if (name.kind != TokenKind::name || !isMeasure(name.text)) return std::nullopt;
    return CallReader(text, name).read();
}

std::vector<MeasureCall> measuresIn(std::string_view text) {
    std::vector<MeasureCall> calls;
    Lexer lexer(text);
    bool isField = false;
    for (Token token = lexer.next(); token.kind != TokenKind::end && token.kind != TokenKind::wrong;
         token = lexer.next()) {
        const bool isName = token.kind == TokenKind::name && !isField;
        isField = token.is(".");
        if (!isName || !isMeasure(token.text)) continue;
        auto call = CallReader(text, token).read();
        if (!call) continue;
        lexer.goTo(call->range.end);
        calls.push_back(std::move(*call));
    }
    return calls;
}

std::vector<std::string> pathsIn(std::string_view text) {
    std::vector<std::string> paths;
    std::vector<std::string> open;  // the paths before the subscripts that are open: `slice[k].view`
    Lexer lexer(text);
    std::string path;
    bool isField = false;
    for (Token token = lexer.next(); token.kind != TokenKind::end && token.kind != TokenKind::wrong;
         token = lexer.next()) {
        if (token.is("[")) open.push_back(path);
        if (token.is("]") && !open.empty()) {
            path = std::move(open.back());
            open.pop_back();
        }
        if (token.kind == TokenKind::name && !isField && isMeasure(token.text))
            if (const auto call = CallReader(text, token).read()) {
                lexer.goTo(call->range.end);
                continue;
            }
        if (token.kind == TokenKind::name) {
            path = isField ? path + "." + std::string(token.text) : std::string(token.text);
            if (std::ranges::find(paths, path) == paths.end()) paths.push_back(path);
        }
        isField = token.is(".");
    }
    return paths;
}

}  // namespace glibra::expression
