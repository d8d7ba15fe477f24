#pragma once
// A file in memory, for writers that take only a path and do not notice that a disk is full.

#include <string>
#include <vector>

namespace glibra::module {

/// Exists as long as the object. Throws Failure if the system gives none.
class MemoryFile {
  public:
    /// Where files in memory are refused, as to a confined process, it is one without a name on the disk of
    /// `near`, a path.
    explicit MemoryFile(const std::string& near);
    MemoryFile(const MemoryFile&) = delete;
    MemoryFile& operator=(const MemoryFile&) = delete;
    ~MemoryFile();

    /// Any code of this process can open it.
    [[nodiscard]] std::string path() const;
    /// All of the file, which was written from beginning to end. Throws Failure if it has reached the
    /// largest size that this process may write.
    [[nodiscard]] std::vector<unsigned char> content() const;

  private:
    int descriptor_;
};

}  // namespace glibra::module
