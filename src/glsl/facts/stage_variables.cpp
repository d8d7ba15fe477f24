#include "glsl/facts/stage_variables.h"

#include <charconv>
#include <optional>
#include <string_view>
#include <utility>

#include "glsl/parse/syntax.h"
#include "glsl/parse/types.h"
#include "glsl/read/source.h"

namespace glibra::glsl {
namespace {

constexpr int kMostElements = 1 << 16;
/// With it begin the names that the translator gives to what the user calls gl_...
constexpr std::string_view kOwnPrefix = "glibra_";

class Collector {
  public:
    Collector(const StageText& text, const std::map<std::string, std::string>& userNames)
        : text_(text), userNames_(userNames) {}

    std::vector<StageVariable> collect() {
        for (const Declaration& each : parseSyntax(text_.view).declarations) {
            const Storage storage = each.qualifiers.storage;
            if (storage != Storage::input && storage != Storage::output) continue;
            isOutput_ = storage == Storage::output;
            if (each.kind == DeclarationKind::variable) addAll(each, "", "");
            if (each.kind == DeclarationKind::block) addBlock(each);
        }
        return std::move(found_);
    }

  private:
    [[nodiscard]] std::string userName(std::string_view emitted) const {
        const auto renamed = userNames_.find(std::string(emitted));
        if (renamed != userNames_.end()) return renamed->second;
        if (emitted.starts_with(kOwnPrefix)) return "gl_" + std::string(emitted.substr(kOwnPrefix.size()));
        return std::string(emitted);
    }

    /// The number of elements that the brackets state: 0 without brackets, nothing if it is not known.
    [[nodiscard]] std::optional<int> elementsOf(const TypeUse& type, const Declarator& declarator) const {
        if (type.dimensions.size() + declarator.dimensions.size() > 1) return std::nullopt;
        if (type.dimensions.empty() && declarator.dimensions.empty()) return 0;
        const Range range = type.dimensions.empty() ? declarator.dimensions[0] : type.dimensions[0];
        const std::string_view digits = text_.text(range.first);
        int count = 0;
        const auto [end, failure] = std::from_chars(digits.data(), digits.data() + digits.size(), count);
        const bool isNumber = failure == std::errc() && end == digits.data() + digits.size();
        if (range.end != range.first + 1 || !isNumber || count < 1 || count > kMostElements)
            return std::nullopt;
        return count;
    }

    /// `shown` is before the names as the user sees them, `prefix` before those in the source.
    void addAll(const Declaration& declaration, const std::string& shown, const std::string& prefix) {
        if (declaration.type.isStruct || !typeOfWord(declaration.type.name).numeric()) return;
        for (const Declarator& each : declaration.declarators) {
            const std::string_view name = text_.text(each.name);
            const std::optional<int> elements = elementsOf(declaration.type, each);
            if (!elements || name.starts_with("gl_")) continue;
            found_.push_back({shown + userName(name), prefix + std::string(name),
                              std::string(declaration.type.name), *elements, isOutput_});
        }
    }

    void addBlock(const Declaration& block) {
        std::string prefix;
        if (!block.declarators.empty()) {
            const Declarator& instance = block.declarators.front();
            if (!instance.dimensions.empty()) return;
            prefix = std::string(text_.text(instance.name)) + ".";
        }
        if (prefix.starts_with("gl_")) return;
        // The translator's own block has the members FrontColor, TexCoord and so on.
        const std::string shown = prefix.starts_with(kOwnPrefix) ? "gl_" : prefix;
        for (const Declaration& each : block.members) addAll(each, shown, prefix);
    }

    const StageText& text_;
    const std::map<std::string, std::string>& userNames_;
    bool isOutput_ = false;
    std::vector<StageVariable> found_;
};

}  // namespace

int StageVariable::components() const {
    return typeOfWord(type).components();
}

std::string StageVariable::number(int element, int component) const {
    const Type shape = typeOfWord(type);
    std::string text = expression;
    if (elements > 0) text += "[" + std::to_string(element) + "]";
    if (shape.matrix())
        text += "[" + std::to_string(component / shape.rows) + "][" + std::to_string(component % shape.rows) +
                "]";
    else if (shape.vector())
        text += "[" + std::to_string(component) + "]";
    return "float(" + text + ")";
}

std::vector<StageVariable> stageVariables(const TranslatedStage& stage,
                                          const std::map<std::string, std::string>& userNames) {
    const ProgramRequest request;
    StageText text;
    text.request = &request;
    Report ignored;  // the source has been translated already
    readSource({stage.stage, stage.path, stage.source}, text, ignored);
    return Collector(text, userNames).collect();
}

}  // namespace glibra::glsl
