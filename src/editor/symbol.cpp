#include "editor/symbol.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <utility>

#include "editor/declared_names.h"
#include "editor/scene_places.h"

namespace glibra::editor {
namespace {

/// A shader: a file, or a part of a scene.
struct Part {
    std::size_t source = 0;  ///< the index of its text
    std::size_t begin = 0;
    std::string_view text;
    ShaderNames names;

    [[nodiscard]] std::string_view textOf(const TextRange& place) const {
        return text.substr(place.begin, place.end - place.begin);
    }
    /// The declaration of a global name, or null.
    [[nodiscard]] const DeclaredName* global(std::string_view name) const {
        const auto found = std::ranges::find_if(
            names.names, [&](const DeclaredName& each) { return each.name == name && each.isGlobal(); });
        return found == names.names.end() ? nullptr : &*found;
    }
};

class Search {
  public:
    explicit Search(std::span<const SourceText> texts) : texts_(texts) {}

    Symbol at(std::size_t byte) {
        const SourceText& own = texts_.front();
        const LanguageAt at = languageAt(own.text, byte, {own.language, std::nullopt, {}});
        symbol_.language = at.language;
        if (at.language == CodeLanguage::glib) {
            for (const SceneWord& each : namesIn(own.text))
                if (each.place.begin <= byte && byte <= each.place.end) {
                    symbol_.name = each.name;
                    symbol_.place = each.place;
                    if (each.isTag) symbol_.tagOf = each.program;
                    if (!each.function) symbol_.link = each.owner.empty() ? each.name : each.owner;
                    readParts();
                    if (!each.owner.empty())
                        findMember(typeOf(each.owner));
                    else if (each.isTag || (!each.function && interface() != nullptr))
                        findUniform();
                    else
                        findSceneName(each.function);
                }
            return std::move(symbol_);
        }
        const Part part = partOf(0, at.part);
        const NameUse* use = part.names.useAt(byte - std::min(byte, part.begin));
        if (use == nullptr) return {};
        symbol_.name = part.textOf(use->place);
        symbol_.place = {use->place.begin + part.begin, use->place.end + part.begin};
        const DeclaredName* declared = use->name == kNoName ? nullptr : &part.names.names[use->name];
        if (declared != nullptr && !declared->owner.empty()) {
            symbol_.link = declared->owner;
            readParts();
            findMember(declared->owner);
            return std::move(symbol_);
        }
        if (use->isMember || (declared != nullptr && !declared->isGlobal())) {
            for (const NameUse& each : part.names.uses)
                if (use->name != kNoName && each.name == use->name) add(part, each);
            if (use->target != kNoName) declare(part, part.names.names[use->target]);
            return std::move(symbol_);
        }
        if (use->target != kNoName) declare(part, part.names.names[use->target]);
        symbol_.link = symbol_.name;
        readParts();
        findGlobal(declared != nullptr && declared->isInterface, declared != nullptr);
        return std::move(symbol_);
    }

  private:
    [[nodiscard]] Part partOf(std::size_t source, const TextRange& range) const {
        const std::string_view text =
            std::string_view(texts_[source].text).substr(range.begin, range.end - range.begin);
        // What does not have the name at all need not be read.
        const bool isRead = symbol_.name.empty() || text.find(symbol_.name) != text.npos ||
                            text.find(symbol_.link) != text.npos;
        return {source, range.begin, text, isRead ? namesOfShader(text) : ShaderNames{}};
    }
    void readParts() {
        for (std::size_t i = 0; i < texts_.size(); ++i)
            if (texts_[i].language == CodeLanguage::glsl)
                parts_.push_back(partOf(i, {0, texts_[i].text.size()}));
            else
                for (const LanguageAt& each : shadersIn(texts_[i].text))
                    parts_.push_back(partOf(i, each.part));
    }

    void add(const Part& part, const NameUse& use) {
        const auto declared = std::ranges::lower_bound(
            part.names.names, use.place.begin, {}, [](const DeclaredName& each) { return each.place.begin; });
        const bool isDeclaration = declared != part.names.names.end() && declared->place == use.place;
        symbol_.all.push_back({texts_[part.source].file,
                               {use.place.begin + part.begin, use.place.end + part.begin},
                               isDeclaration});
    }
    void declare(const Part& part, const DeclaredName& name) {
        symbol_.declaration = {
            texts_[part.source].file, {name.place.begin + part.begin, name.place.end + part.begin}, true};
    }
    /// The uses of the global name in all shaders of the set.
    void addGlobals(const std::set<std::size_t>& sources) {
        for (const Part& part : parts_) {
            if (!sources.contains(part.source)) continue;
            const DeclaredName* declared = part.global(symbol_.name);
            if (declared != nullptr && !symbol_.declaration) declare(part, *declared);
            for (const NameUse& use : part.names.uses) {
                if (use.isMember || part.textOf(use.place) != symbol_.name) continue;
                if (use.name == kNoName || part.names.names[use.name].isGlobal()) add(part, use);
            }
        }
    }

    /// The texts that the files of the set include, or that include them, and so on.
    [[nodiscard]] std::set<std::size_t> along(std::set<std::size_t> sources, bool upward) const {
        for (std::size_t before = 0; before != sources.size();) {
            before = sources.size();
            for (std::size_t i = 0; i < texts_.size(); ++i)
                for (const std::filesystem::path& each : texts_[i].includes)
                    for (std::size_t k = 0; k < texts_.size(); ++k) {
                        if (texts_[k].file != each) continue;
                        if (upward && sources.contains(k)) sources.insert(i);
                        if (!upward && sources.contains(i)) sources.insert(k);
                    }
        }
        return sources;
    }
    [[nodiscard]] std::set<std::size_t> declaring(const std::set<std::size_t>& sources) const {
        std::set<std::size_t> found;
        for (const Part& each : parts_)
            if (sources.contains(each.source) && each.global(symbol_.name) != nullptr)
                found.insert(each.source);
        return found;
    }

    /// A declaration of the name as a uniform, input or output, or null.
    [[nodiscard]] const DeclaredName* interface() const {
        for (const Part& each : parts_)
            if (const DeclaredName* name = each.global(symbol_.name); name != nullptr && name->isInterface)
                return name;
        return nullptr;
    }
    /// The structure or block that a uniform or member has as its type; the name itself if it is a block.
    [[nodiscard]] std::string typeOf(const std::string& name) const {
        for (const Part& part : parts_)
            for (const DeclaredName& each : part.names.names)
                if (each.name == name && each.type != "block" && (each.isInterface || each.isMember))
                    return each.type.substr(0, each.type.find('['));
        return name;
    }
    /// The tags that have the name in programs that are meant; with `owner`, as a member of that type.
    void addTags(const std::string& owner) {
        for (const SourceText& text : texts_)
            if (text.language == CodeLanguage::glib && !text.programs.empty())
                for (const SceneWord& each : namesIn(text.text))
                    if (each.isTag && each.name == symbol_.name &&
                        (each.program.empty() || text.programs.contains(each.program)) &&
                        (each.owner.empty() ? owner.empty() : typeOf(each.owner) == owner))
                        symbol_.all.push_back({text.file, each.place, false});
    }

    void findGlobal(bool isInterface, bool isDeclared) {
        addTags({});  // a constant that a program sets is none of the file alone
        const bool isSet = !std::exchange(symbol_.all, {}).empty() && interface() == nullptr;
        if (isInterface || isSet || (!isDeclared && interface() != nullptr)) return findUniform();
        std::set<std::size_t> declares{0};
        if (!isDeclared) declares = declaring(along({0}, false));
        if (declares.empty()) declares = declaring(along({0}, true));
        if (declares.empty()) return;
        std::set<std::size_t> all = along(declares, true);
        for (const std::size_t each : along(declares, false))
            if (declaring({each}).empty()) all.insert(each);
        addGlobals(all);
        // The words of scenes may choose a subroutine.
        const bool isChosen = std::ranges::any_of(
            texts_, [](const SourceText& each) { return each.text.find("subroutine") != each.text.npos; });
        for (const SourceText& text : texts_)
            for (const SceneWord& each :
                 isChosen && !text.programs.empty() ? namesIn(text.text) : std::vector<SceneWord>())
                if (!each.isTag && each.name == symbol_.name)
                    symbol_.all.push_back({text.file, each.place, false});
    }

    /// A uniform, input or output, or else a constant that programs set, in all shaders and scenes; with the
    /// variable or object that it reads by its name.
    void findUniform() {
        const DeclaredName* declared = interface();
        if (declared != nullptr && !declared->owner.empty()) return findMember(declared->owner);
        std::set<std::size_t> sources;
        for (const Part& each : parts_) {
            const DeclaredName* name = each.global(symbol_.name);
            if (name == nullptr || (declared != nullptr ? name->isInterface : !name->isFunction))
                sources.insert(each.source);
        }
        const bool isVariable = symbol_.language == CodeLanguage::glib && !symbol_.tagOf;
        if (isVariable) findSceneName(std::nullopt);  // its declaration is that of the symbol
        addGlobals(sources);
        addTags({});
        if (declared != nullptr && !isVariable) findSceneName(std::nullopt);
    }

    /// A member of the structures or blocks of that name, in all shaders and on tags.
    void findMember(const std::string& owner) {
        symbol_.link = owner;
        std::set<std::size_t> declares, unknown;
        bool isOfBlock = false;
        for (const Part& part : parts_) {
            const DeclaredName* type = part.global(owner);
            isOfBlock |= type != nullptr && type->type == "block";
            for (const NameUse& use : part.names.uses) {
                if (part.textOf(use.place) != symbol_.name) continue;
                const DeclaredName* name = use.name == kNoName ? nullptr : &part.names.names[use.name];
                if (name != nullptr ? name->owner == owner : !use.isMember && interface() != nullptr)
                    add(part, use);
                else if (name == nullptr && use.isMember)
                    unknown.insert(part.source);
                if (name == nullptr || name->owner != owner) continue;
                declares.insert(part.source);
                if (!symbol_.declaration) declare(part, *name);
            }
        }
        addTags(owner);
        if (isOfBlock) addTags({});
        for (const std::size_t each : along(declares, true))
            if (unknown.contains(each) && !declares.contains(each))
                symbol_.obstacle =
                    fmt::format("'.{}' in {} may be this member of '{}' or another one", symbol_.name,
                                texts_[each].file.filename().generic_string(), owner);
    }

    /// `function`: of a parameter, SceneWord::function.
    void findSceneName(const std::optional<std::size_t>& function) {
        for (const SourceText& text : texts_)
            if (text.hasNames && (!function || &text == &texts_.front()))
                for (const SceneWord& each : namesIn(text.text)) {
                    if (each.isTag || each.name != symbol_.name || each.function != function) continue;
                    symbol_.all.push_back({text.file, each.place, each.isDeclaration});
                    if (each.isDeclaration && !symbol_.declaration) symbol_.declaration = symbol_.all.back();
                }
    }

    std::span<const SourceText> texts_;
    std::vector<Part> parts_;
    Symbol symbol_;
};

}  // namespace

Symbol symbolAt(std::span<const SourceText> texts, std::size_t byte) {
    return Search(texts).at(byte);
}

}  // namespace glibra::editor
