#pragma once
// Indices that know which list they belong to: an index of a texture cannot be used for a list of programs.

#include <compare>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace glibra::scene {

/// The place of one `Of` in a list, or none. `Of` is only a name: it may be incomplete.
template <class Of>
class Index {
  public:
    constexpr Index() = default;  ///< none
    constexpr explicit Index(std::size_t position) : next_(static_cast<std::uint32_t>(position) + 1) {}

    /// False for none.
    constexpr explicit operator bool() const { return next_ != 0; }
    /// Counts from 0. For none it is beyond the end of every list.
    [[nodiscard]] constexpr std::size_t position() const { return std::size_t{next_} - 1; }

    /// None comes before all others.
    friend constexpr auto operator<=>(Index, Index) = default;

  private:
    std::uint32_t next_ = 0;  // position + 1
};

/// All indices below a count, for range-based for.
template <class Of>
class IndexRange {
  public:
    class Iterator {
      public:
        explicit Iterator(std::size_t position) : position_(position) {}
        Index<Of> operator*() const { return Index<Of>(position_); }
        Iterator& operator++() {
            ++position_;
            return *this;
        }
        friend bool operator==(Iterator, Iterator) = default;

      private:
        std::size_t position_;
    };
    explicit IndexRange(std::size_t count) : count_(count) {}
    [[nodiscard]] Iterator begin() const { return Iterator(0); }
    [[nodiscard]] Iterator end() const { return Iterator(count_); }

  private:
    std::size_t count_;
};

/// A vector whose operator[] takes only an Index<Of>. `Of` differs from `T` where a list holds one value for
/// each element of another list.
template <class T, class Of = T>
class List : public std::vector<T> {
  public:
    using std::vector<T>::vector;

    /// Throws std::out_of_range for none and for an index beyond the end.
    typename std::vector<T>::reference operator[](Index<Of> index) { return this->at(index.position()); }
    typename std::vector<T>::const_reference operator[](Index<Of> index) const {
        return this->at(index.position());
    }

    /// Appends the element and returns its index.
    Index<Of> add(T element) {
        this->push_back(std::move(element));
        return Index<Of>(this->size() - 1);
    }
    [[nodiscard]] IndexRange<Of> indices() const { return IndexRange<Of>(this->size()); }
};

/// The element of a plain vector that the index belongs to. Throws like List.
template <class T>
const T& at(const std::vector<T>& vector, Index<T> index) {
    return vector.at(index.position());
}

}  // namespace glibra::scene
