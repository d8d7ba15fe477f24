#pragma once

#include <glibra/diagnostic.h>

#include <cstdio>
#include <cstdlib>
#include <optional>
#include <string>
#include <utility>

namespace glibra {

/// The diagnostics of a Result: a vector that can also be called, so that `result.diagnostics()` reads like
/// the other accessors.
struct Messages : Diagnostics {
    using Diagnostics::Diagnostics;
    Messages() = default;
    Messages(Diagnostics all) : Diagnostics(std::move(all)) {}
    const Diagnostics& operator()() const { return *this; }
};

/// All diagnostics as lines, the way toString() writes one; without a line end after the last.
inline std::string toString(const Diagnostics& diagnostics) {
    std::string text;
    for (const Diagnostic& each : diagnostics) text += (text.empty() ? "" : "\n") + toString(each);
    return text;
}

/// A value, or the errors that prevented it. Either may come with warnings and notes. A value that is not
/// there must not be used: the program ends with the messages on standard error.
template <class T>
struct [[nodiscard]] Result {
    std::optional<T> value;
    Messages diagnostics;

    Result() = default;
    Result(T good) : value(std::move(good)) {}
    Result(T good, Diagnostics remarks) : value(std::move(good)), diagnostics(std::move(remarks)) {}
    Result(Diagnostic bad) { diagnostics.push_back(std::move(bad)); }
    Result(Diagnostics bad) : diagnostics(std::move(bad)) {}

    explicit operator bool() const { return value.has_value(); }
    T& operator*() { return valueOf(*this); }
    const T& operator*() const { return valueOf(*this); }
    T* operator->() { return &valueOf(*this); }
    const T* operator->() const { return &valueOf(*this); }

    /// All diagnostics as lines, as toString() writes them; empty if there is none.
    [[nodiscard]] std::string message() const { return toString(diagnostics); }

  private:
    template <class Self>
    static auto& valueOf(Self& self) {
        if (!self.value) {
            std::fprintf(stderr, "glibra: a result without a value is used\n%s\n", self.message().c_str());
            std::abort();
        }
        return *self.value;
    }
};

/// Success, or the errors that prevented it.
template <>
struct [[nodiscard]] Result<void> {
    Messages diagnostics;

    Result() = default;
    Result(Diagnostic bad) { diagnostics.push_back(std::move(bad)); }
    Result(Diagnostics all) : diagnostics(std::move(all)) {}

    /// False if there is an error; warnings and notes are none.
    explicit operator bool() const { return !hasError(diagnostics); }
    [[nodiscard]] std::string message() const { return toString(diagnostics); }
};

}  // namespace glibra
