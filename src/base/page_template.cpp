#include "base/page_template.h"

#include <algorithm>
#include <cassert>
#include <ranges>

namespace glibra::base {
namespace {

class Filler {
  public:
    Filler(std::string_view page, std::string (*escape)(std::string_view)) : page_(page), escape_(escape) {}

    std::string fill(const Fields& fields) {
        scopes_.push_back({&fields});
        put(0, page_.size());
        return std::move(text_);
    }

  private:
    struct Scope {
        const Fields* fields;
        bool isFirst = true;
    };

    /// The innermost field of the name; null if there is none.
    const Field* find(std::string_view name) const {
        for (const Scope& scope : scopes_ | std::views::reverse) {
            const auto field = std::ranges::find(*scope.fields, name, &Field::name);
            if (field != scope.fields->end()) return &*field;
        }
        return nullptr;
    }

    void put(std::size_t begin, std::size_t end) {
        while (true) {
            const std::size_t open = std::min(page_.find("{{", begin), end);
            text_ += page_.substr(begin, open - begin);
            if (open == end) return;
            begin = putTag(open);
        }
    }

    /// Returns where the template goes on after a tag, which takes the end of its line with it if it is
    /// alone.
    std::size_t after(std::size_t open, std::size_t close) const {
        const bool isAlone = (open == 0 || page_[open - 1] == '\n') && page_.substr(close, 1) == "\n";
        return isAlone ? close + 1 : close;
    }

    /// The text between a tag and the one that closes it, and where the template goes on.
    struct Body {
        std::size_t begin, end, next;
    };
    Body bodyAt(std::size_t begin, std::string_view name, std::string_view mark = {}) const {
        const std::string close = fmt::format("{{{{/{}{}}}}}", mark, name);
        const std::size_t end = page_.find(close, begin);
        assert(end != std::string_view::npos);
        return {begin, end, after(end, end + close.size())};
    }

    std::size_t putTag(std::size_t open) {
        const std::string_view closing = page_.substr(open).starts_with("{{{") ? "}}}" : "}}";
        const std::size_t first = open + closing.size(), last = page_.find(closing, first);
        assert(last != std::string_view::npos && last > first);
        const std::string_view name = page_.substr(first, last - first);
        const std::size_t next = last + closing.size();
        if (std::string_view("#^?=>").find(name.front()) == std::string_view::npos) {
            if (const Field* field = find(name))
                text_ += closing.size() == 3 ? field->text : escape_(field->text);
            return next;
        }
        return putBlock(name.front(), name.substr(1), after(open, next));
    }

    std::size_t putBlock(char kind, std::string_view name, std::size_t begin) {
        if (kind == '>') {
            const std::string definition = fmt::format("{{{{={}}}}}", name);
            const std::size_t open = page_.find(definition);
            assert(open != std::string_view::npos);
            const Body part = bodyAt(after(open, open + definition.size()), name);
            put(part.begin, part.end);
            return begin;
        }
        const Body body = bodyAt(begin, name, kind == '?' ? "?" : "");
        const Field* field = find(name);
        const bool isFirst = name == "first" && scopes_.back().isFirst;
        const bool isGiven = isFirst || (field && !(field->text.empty() && field->rows.empty()));
        if (kind == '=' || isGiven == (kind == '^')) return body.next;
        if (kind == '#' && field && !field->rows.empty())
            putRows(field->rows, body);
        else
            put(body.begin, body.end);
        return body.next;
    }

    void putRows(const std::vector<Fields>& rows, const Body& body) {
        for (const Fields& row : rows) {
            scopes_.push_back({&row, &row == &rows.front()});
            put(body.begin, body.end);
            scopes_.pop_back();
        }
    }

    std::string_view page_;
    std::string (*escape_)(std::string_view);
    std::vector<Scope> scopes_;
    std::string text_;
};

}  // namespace

Field::Field(std::string_view fieldName, std::span<const std::string> value)
    : name(fieldName), rows(rowsOf(value, [](const std::string& each) { return Fields{{".", each}}; })) {}

std::vector<Fields> titledRows(std::initializer_list<std::pair<const char*, std::string>> texts) {
    std::vector<Fields> rows;
    for (const auto& [title, text] : texts)
        if (!text.empty()) rows.push_back({{"title", title}, {"text", text}});
    return rows;
}

std::string filled(std::string_view page, const Fields& fields, std::string (*escape)(std::string_view)) {
    return Filler(page, escape).fill(fields);
}

}  // namespace glibra::base
