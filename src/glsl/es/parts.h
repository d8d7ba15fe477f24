#pragma once
// Stages that WebGL 2 does not have become parts of the vertex stage. This is what all of them need: a stage
// whose work is done once for each corner of what the next one reads, and the variables between the two.

#include <functional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "glsl/parse/unit.h"
#include "glsl/types/translated_program.h"

namespace glibra::glsl {

/// How an input of the vertex stage is named for a corner; ExpandedGeometry says how they are placed.
inline constexpr const char* kCornerInput = "glibra_Corner";

/// "[3]" for each size.
std::string bracketed(const std::vector<std::string>& sizes);
/// How the emitted text spells a name of the stage.
std::string emittedName(const Unit& unit, const std::string& name);
/// It is a variable of the stage from now on.
void makePlain(Variable& variable);
/// The same, as an array.
void makeArray(Variable& variable, int size);
/// The output of `from` that an input of the next stage reads: at the same location or of the same name. Null
/// if there is none.
Variable* outputFor(Unit& from, const Variable& input);
/// Removes the uniforms, blocks and structures that an earlier stage declares, too.
void removeTwins(Unit& unit, const Unit& earlier);
/// Gives all names of the file but those of uniforms a prefix, and an underscore.
void prefixNames(Unit& unit, std::string_view prefix);
/// Replaces .gl_Position and .gl_PointSize by the members of glibra_Corner.
void renameCornerMembers(Unit& unit);

/// Where the members of a block between two stages stand once both are parts of the vertex stage.
struct BlockPlace {
    std::string prefix;      ///< before "BLOCK_MEMBER"
    std::string sizes{};     ///< "[3]": an array in place of an array of blocks
    bool isDeclared = true;  ///< by this stage; false: by the one before it
    std::function<void(const std::string& member)> note{};  ///< gets "BLOCK_MEMBER"
};

/// A stage that runs for each corner of a patch or of a primitive.
class CornerStage {
  public:
    /// `prefix`: of the stage's names. `array`: of the corners, which the next stage reads as gl_in.
    CornerStage(Unit& unit, std::string prefix, std::string array, int corners)
        : unit_(&unit), prefix_(std::move(prefix)), array_(std::move(array)), corners_(corners) {}

    /// Renames what the stage declares. `instance`: what gl_InstanceID is written as.
    void prepare(std::string_view instance);
    /// The inputs of a vertex stage become one input for each corner, or are fetched from a texture.
    void spreadInputs();
    /// The inputs of `next` become arrays of what this stage delivers. False if it has some that this stage
    /// does not deliver.
    bool deliverTo(Unit& next);
    /// For the members of blocks that `next` reads and this stage delivers.
    void pass(const std::string& from, const std::string& to) { passed_.push_back({from, to}); }
    [[nodiscard]] BlockPlace output() const { return {prefix_ + "_"}; }
    [[nodiscard]] BlockPlace inputOfNext(const std::string& prefix);

    /// Statements that run the stage for a corner. `before`: what it needs.
    [[nodiscard]] std::string run(int corner, const std::string& before) const;
    [[nodiscard]] bool hasInputs() const { return !attributes_.empty(); }
    /// Those that do not fit into attributes.
    [[nodiscard]] const std::vector<ExpandedGeometry::Fetched>& fetched() const { return fetched_; }

  private:
    Unit* unit_;
    std::string prefix_, array_;
    int corners_;
    std::vector<std::string> attributes_;
    std::vector<ExpandedGeometry::Fetched> fetched_;
    std::vector<std::pair<std::string, std::string>>
        passed_;  ///< a variable here, an array of the next stage
};

}  // namespace glibra::glsl
