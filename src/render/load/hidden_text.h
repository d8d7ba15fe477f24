#pragma once
// Messages about shaders that include files which a scene must not show: files outside of its folder and the
// library.

#include <set>
#include <string>
#include <string_view>

namespace glibra::render {

/// How a message about a place in such a file begins. The line that it names must not be quoted either.
inline constexpr std::string_view kHiddenText = "the text of this message is not shown";

/// Which words of a compiler's message may come from the files that are not shown. The compiler quotes words
/// of the source, and words that the preprocessor has joined; it never quotes comments.
class HiddenWords {
  public:
    /// A source that may be shown, and one that may not.
    void addShown(std::string_view source);
    void addHidden(std::string_view source);
    /// The message with "..." in place of each word that is, or contains, a word of a hidden source, unless
    /// it stands in a shown source or is a keyword of GLSL.
    [[nodiscard]] std::string removedFrom(std::string_view message) const;

  private:
    [[nodiscard]] bool mayBeHidden(std::string_view word) const;

    std::set<std::string, std::less<>> shown_, hidden_;
};

}  // namespace glibra::render
