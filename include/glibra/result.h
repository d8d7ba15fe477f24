#pragma once

#include <glibra/diagnostic.h>

#include <optional>
#include <utility>

namespace glibra {

/// A value, or the errors that prevented it. Either may come with warnings and notes.
template <class T>
struct Result {
    std::optional<T> value;
    Diagnostics diagnostics;

    Result() = default;
    Result(T good) : value(std::move(good)) {}
    Result(T good, Diagnostics remarks) : value(std::move(good)), diagnostics(std::move(remarks)) {}
    Result(Diagnostic bad) { diagnostics.push_back(std::move(bad)); }
    Result(Diagnostics bad) : diagnostics(std::move(bad)) {}

    explicit operator bool() const { return value.has_value(); }
    T& operator*() { return *value; }
    const T& operator*() const { return *value; }
    T* operator->() { return &*value; }
    const T* operator->() const { return &*value; }
};

}  // namespace glibra
