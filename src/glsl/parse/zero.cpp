#include "glsl/parse/zero.h"

#include <cstdlib>

#include "glsl/parse/types.h"
#include "glsl/parse/usage.h"
#include "glsl/parse/variables.h"

namespace glibra::glsl {
namespace {

class Zero {
  public:
    Zero(const Unit& unit, int mostElements) : unit_(unit), mostElements_(mostElements) {}

    [[nodiscard]] std::optional<std::string> of(const std::string& type, std::span<const std::string> sizes,
                                                int depth = 0) const {
        if (depth > 6 || type.empty()) return std::nullopt;
        if (sizes.empty()) return scalar(type, depth);
        const auto element = of(type, sizes.subspan(1), depth + 1);
        const int count = std::atoi(sizes.front().c_str());
        if (!element || count < 1 || count > mostElements_) return std::nullopt;
        std::string text = spelled(unit_, type);
        for (const std::string& each : sizes) text += "[" + each + "]";
        text += "(";
        for (int i = 0; i < count && text.size() < kLongest; ++i) text += (i ? ", " : "") + *element;
        if (text.size() >= kLongest) return std::nullopt;
        return text + ")";
    }

  private:
    static constexpr std::size_t kLongest = 1U << 16;

    [[nodiscard]] std::optional<std::string> scalar(const std::string& type, int depth) const {
        for (const Declaration& each : unit_.syntax.declarations) {
            if (!each.type.isStruct || each.type.name != type) continue;
            std::string text = spelled(unit_, type) + "(";
            for (const Declaration& member : each.members)
                for (const Declarator& name : member.declarators) {
                    const auto value =
                        of(std::string(member.type.name),
                           sizeTexts(unit_, name.dimensions, member.type.dimensions), depth + 1);
                    if (!value) return std::nullopt;
                    text += (text.back() == '(' ? "" : ", ") + *value;
                }
            return text + ")";
        }
        std::string zero = zeroOf(type);
        return zero.empty() ? std::nullopt : std::optional(std::move(zero));
    }

    const Unit& unit_;
    int mostElements_;
};

}  // namespace

std::optional<std::string> zeroValue(const Unit& unit, const std::string& type,
                                     std::span<const std::string> sizes, int mostElements) {
    return Zero(unit, mostElements).of(type, sizes);
}

std::vector<std::string> sizeTexts(const Unit& unit, const std::vector<Range>& ofName,
                                   const std::vector<Range>& ofType) {
    std::vector<std::string> sizes;
    for (const auto* ranges : {&ofName, &ofType})
        for (const Range& each : *ranges) sizes.push_back(sizeText(unit, each));
    return sizes;
}

}  // namespace glibra::glsl
