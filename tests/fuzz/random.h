#pragma once
// Random choices that are the same on every machine.

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

namespace glibra::fuzz {

/// splitmix64 (Steele, Lea, Flood 2014) of a counter.
class Random {
  public:
    explicit Random(std::uint64_t seed) : state_(seed) {}
    std::uint64_t next() {
        std::uint64_t z = state_ += 0x9E3779B97F4A7C15U;
        z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9U;
        z = (z ^ (z >> 27)) * 0x94D049BB133111EBU;
        return z ^ (z >> 31);
    }
    /// 0 .. count - 1; 0 if count is 0.
    std::size_t below(std::size_t count) { return count ? static_cast<std::size_t>(next() % count) : 0; }
    bool oneIn(std::size_t count) { return below(count) == 0; }
    /// An element of a range that is not empty.
    const auto& oneOf(const auto& range) { return range[below(std::size(range))]; }

  private:
    std::uint64_t state_;
};

/// Numbers at the limits of common types and sizes.
inline constexpr std::string_view kExtremeNumbers[] = {"0",
                                                       "-0",
                                                       "1",
                                                       "-1",
                                                       "0.5",
                                                       ".",
                                                       "1e38",
                                                       "-1e38",
                                                       "3.5e38",
                                                       "1e-45",
                                                       "1e-400",
                                                       "1e999",
                                                       "nan",
                                                       "inf",
                                                       "0x7f",
                                                       "127",
                                                       "128",
                                                       "255",
                                                       "256",
                                                       "4096",
                                                       "4097",
                                                       "16384",
                                                       "65536",
                                                       "1000000",
                                                       "16777217",
                                                       "2147483647",
                                                       "2147483648",
                                                       "-2147483648",
                                                       "4294967296",
                                                       "9223372036854775808",
                                                       "99999999999999999999"};

}  // namespace glibra::fuzz
