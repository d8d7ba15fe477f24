#pragma once
// What a driver's message leaves out: where the semicolon is missing, which GLSL name a word of another
// language or a misspelt one stands for, and both types of a mismatch.

#include <glibra/diagnostic.h>

#include <memory>

#include "glsl/emit/log_line.h"
#include "glsl/types/translated_program.h"

namespace glibra::glsl {

/// Advice on the messages of one compile log. The program and the stage must outlive it.
class LogAdvice {
  public:
    LogAdvice(const TranslatedProgram& program, const TranslatedStage& stage);
    LogAdvice(const LogAdvice&) = delete;
    LogAdvice& operator=(const LogAdvice&) = delete;
    ~LogAdvice();

    /// Improves `message`, which was made from `line` of the log and names `message.place.file`. Where a
    /// semicolon is missing, the place becomes the end of what is before it. A message that it does not
    /// understand stays as it is, and so do all after the first 32, because the search takes time.
    void addTo(const LogLine& line, Diagnostic& message);

  private:
    class Source;
    const Source& source();
    void explainSyntaxError(const LogLine& line, Diagnostic& message);
    void nameTypes(const LogLine& line, Diagnostic& message) const;
    /// What the user may have meant by an unknown word, as "; did you mean 'fract'?"; empty if nothing is
    /// near.
    std::string suggestionFor(std::string_view word, bool isType);
    /// The declaration of an input for what an earlier stage delivers by that name, as "in vec2 vST;"; empty
    /// if none does.
    [[nodiscard]] std::string inputFor(std::string_view word) const;

    const TranslatedProgram& program_;
    const TranslatedStage& stage_;
    std::unique_ptr<const Source> source_;  ///< made when it is needed
    int messages_ = 0;
};

}  // namespace glibra::glsl
