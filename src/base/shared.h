#pragma once
// A value that copies of its owner share, because many of them hold equal ones.

#include <memory>

namespace glibra::base {

/// Holds a T that does not change; copying this copies no T. Assigning an equal value keeps the one that is
/// shared.
template <class T>
class Shared {
  public:
    Shared() {
        static const std::shared_ptr<const T> kFirst = std::make_shared<const T>();
        value_ = kFirst;
    }
    Shared& operator=(const T& value) {
        if (!(*value_ == value)) value_ = std::make_shared<const T>(value);
        return *this;
    }
    /// The value for this one alone, to be changed.
    T& change() {
        auto own = std::make_shared<T>(*value_);
        value_ = own;
        return *own;
    }
    const T& operator*() const { return *value_; }
    const T* operator->() const { return value_.get(); }
    friend bool operator==(const Shared& a, const Shared& b) {
        return a.value_ == b.value_ || *a.value_ == *b.value_;
    }

  private:
    std::shared_ptr<const T> value_;
};

}  // namespace glibra::base
