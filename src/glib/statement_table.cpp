#include "glib/statement_table.h"

#include <algorithm>
#include <cassert>
#include <utility>

#include "base/suggest.h"
#include "geometry/shapes/primitive.h"
#include "glib/text.h"

namespace glibra::glib {
namespace {

/// Rows by the first letters of their words, for a quick answer to words that are none.
class Index {
  public:
    explicit Index(std::span<const StatementRow> rows) {
        for (const StatementRow& row : rows)
            for (const std::string_view name : row.names())
                if (!name.empty()) lists_.at(letterOf(name)).push_back({name, &row});
    }
    /// The row of the word, in any case; null if there is none.
    [[nodiscard]] const StatementRow* find(std::string_view word) const {
        if (word.empty() || !isLetter(word[0])) return nullptr;
        for (const auto& [name, row] : lists_.at(letterOf(word)))
            if (sameWord(name, word)) return row;
        return nullptr;
    }

  private:
    static std::size_t letterOf(std::string_view word) {
        return static_cast<std::size_t>(lower(word[0]) - 'a');
    }
    std::array<std::vector<std::pair<std::string_view, const StatementRow*>>, 26> lists_;
};

const StatementRow* modernRowOf(std::string_view word) {
    static const Index kIndex(statementTable());
    return kIndex.find(word);
}

const StatementRow* rowOfId(CommandId id) {
    const auto classic = std::ranges::find(commandTable(), id, &StatementRow::id);
    return classic != commandTable().end() ? &*classic : statementOf(id);
}

}  // namespace

bool StatementRow::sharesWord() const {
    return findCommand(name) != nullptr && modernRowOf(name) != nullptr;
}

const StatementRow* findCommand(std::string_view word) {
    static const Index kIndex(commandTable());
    return kIndex.find(word);
}

CommandId commandOf(std::string_view word) {
    const StatementRow* row = findCommand(word);
    assert(row != nullptr);
    return row->id;
}

const StatementRow* findStatement(std::string_view word) {
    const StatementRow* row = modernRowOf(word);
    return row != nullptr && findCommand(row->name) == nullptr ? row : nullptr;
}

const StatementRow* modernFormOf(std::string_view word) {
    const StatementRow* row = modernRowOf(word);
    return row != nullptr && findCommand(row->name) != nullptr ? row : nullptr;
}

const StatementRow* statementOf(CommandId id) {
    static const auto kById = [] {
        std::array<const StatementRow*, static_cast<std::size_t>(CommandId::firstPrimitive)> rows{};
        for (const StatementRow& row : statementTable()) rows.at(static_cast<std::size_t>(row.id)) = &row;
        return rows;
    }();
    return id < CommandId::firstPrimitive ? kById[static_cast<std::size_t>(id)] : nullptr;
}

bool restartsSimulation(CommandId id) {
    const StatementRow* row = rowOfId(id);
    return row == nullptr || row->restartsSimulation;
}

std::string_view nameOf(CommandId id) {
    const StatementRow* row = rowOfId(id);
    return row != nullptr ? row->name : std::string_view();
}

std::string_view nearestCommand(std::string_view word) {
    std::vector<std::string_view> names;
    for (const StatementRow& row : commandTable())
        for (const std::string_view name : row.names())
            if (!name.empty()) names.push_back(name);
    for (const StatementRow& row : statementTable())
        if (!row.sharesWord()) names.push_back(row.name);
    const auto nearest = std::ranges::find(names, base::nearestName(word, names));
    return nearest != names.end() ? *nearest : std::string_view();
}

const geometry::PrimitiveSpec* primitiveOf(CommandId id) {
    if (id < CommandId::firstPrimitive) return nullptr;
    const std::span<const geometry::PrimitiveSpec* const> all = geometry::primitives();
    const std::size_t index =
        static_cast<std::size_t>(id) - static_cast<std::size_t>(CommandId::firstPrimitive);
    return index < all.size() ? all[index] : nullptr;
}

std::vector<std::string_view> wordsOfFragment(std::string_view name) {
    std::vector<std::string_view> words;
    std::string_view text = syntaxFragment(name);
    while (!text.empty()) {
        const std::size_t comma = std::min(text.find(','), text.size());
        words.push_back(text.substr(0, comma));
        text.remove_prefix(std::min(comma + 1, text.size()));
    }
    return words;
}

}  // namespace glibra::glib
