#pragma once
// One stage, from the text of the core profile to that of GLSL ES 3.00.

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "glsl/es/parts.h"
#include "glsl/parse/unit.h"
#include "glsl/types/request.h"

namespace glibra::glsl {

/// Reads the translated unit of a stage and edits it until it is GLSL ES: adapt() once, then take().
class EsStage {
  public:
    /// `core`: the text that `unit` was read from; its map leads to the user's lines. `report` gets what GLSL
    /// ES lacks (web-E01 to web-E05). All of them outlive the stage.
    EsStage(const TranslatedStage& core, Unit& unit, Report& report, const EsOptions& options);

    /// It becomes a part of the vertex stage, and so do the stages with which it shares variables.
    struct Part {
        std::optional<BlockPlace> input{};
        std::function<BlockPlace(bool isOfPatch)> output{};
        /// Gets the variables in place of the members of blocks that the fragment stage reads.
        std::function<void(std::string type, std::string name)> keep{};
    };
    void becomePart(Part part);
    /// Edits the unit. The initialisers of uniforms go to `initialValues`.
    void adapt(std::vector<InitialValue>& initialValues);
    /// The text, with a map that leads to the user's lines.
    [[nodiscard]] TranslatedStage take();
    /// Guards the loops (additions.h), which `sites` gets. False: there are none.
    bool guardLoops(std::vector<Place>& sites);
    /// Of the vertex stage, if loops of it or of the stages that become parts of it are guarded.
    void beginUncut();
    /// Makes a fragment stage show the loop that was ended first (kShowsCut), or that of the stages before it
    /// if `hasVertexLoops`, unless it has no colour that could.
    void showCutLoop(bool hasVertexLoops);
    /// Statements that main does first.
    void beginWith(std::string statements) { beginnings_.push_back(std::move(statements)); }

    /// Reports what GLSL ES lacks: of the stage as a whole, or at a word of it.
    void lacks(const char* id, const std::string& text) const;
    void lacks(const char* id, const std::string& text, std::uint32_t at);

    /// The place of the user's text that the core text has there; the file's first line for what the
    /// translation added.
    [[nodiscard]] Place userPlaceOf(std::uint32_t at) const;

  private:
    void declaration(const Declaration& each);
    /// Blocks between stages become variables, one for each member.
    void block(const Declaration& each);
    /// The qualifiers of a variable in place of a member of a block.
    void declareMember(const Declaration& block, const Declaration& member, bool isVarying,
                       const std::string& word);
    void noPerspective(std::uint32_t at);
    void variable(Variable& each, std::vector<InitialValue>& initialValues);
    void uniformValue(Variable& each, const Declarator& declarator, std::vector<InitialValue>& initialValues);
    [[nodiscard]] bool isConstant(Range range) const;
    void word(std::uint32_t at);
    void type(std::uint32_t at, std::string_view text);
    /// instance.member of a block between stages
    void member(std::uint32_t at, std::string_view instance);
    /// Textures of one dimension are those of two with one row.
    void call(const Call& each);
    void missing(std::string_view name, std::uint32_t at);
    /// What main does first.
    void begin();

    const TranslatedStage& core_;
    Unit& unit_;
    Report& report_;
    const EsOptions& options_;
    Part part_;
    bool isPart_ = false;
    std::vector<std::string> beginnings_;  ///< statements that give variables their first values
    /// The variables in place of the members of blocks, by instance and member.
    std::map<std::pair<std::string, std::string>, std::string> members_;
};

}  // namespace glibra::glsl
