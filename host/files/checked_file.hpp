// A file whose every write is checked: the first failure is remembered and reported, whoever caused
// it. The writers of libraries often ignore failures.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "host/files/picture_library.hpp"

namespace pxm::host {

/// What a descriptor can do: a pipe only takes one byte after the other.
enum class Places { any, in_order };

class CheckedFile : public FileBytes {
  public:
    /// Takes over an open descriptor; messages call it `name`.
    CheckedFile(int descriptor, std::string name, Places places);
    CheckedFile(const CheckedFile&) = delete;
    CheckedFile& operator=(const CheckedFile&) = delete;
    ~CheckedFile() override;

    [[nodiscard]] int descriptor() const { return descriptor_; }

    /// Writes at a place in bytes, or soon: what follows on what was written last is collected.
    /// False once any write has failed.
    bool write_at(std::int64_t place, const void* data, std::size_t bytes) noexcept override;
    /// Reads what is there, including what is still collected; returns the bytes read.
    std::size_t read_at(std::int64_t place, void* data, std::size_t bytes) noexcept override;
    /// In bytes, with what is still collected; 0 if it cannot be told.
    [[nodiscard]] std::int64_t size() noexcept override;
    /// Writes at the end of what append() wrote before. Throws Error(ErrorKind::file).
    void append(const void* data, std::size_t bytes);

    /// Throws Error(ErrorKind::file) if any write has failed so far.
    void require() const;
    /// Writes what is collected. Throws Error(ErrorKind::file) unless all that was written is on
    /// the disk, as far as the system can say so.
    void sync();

  private:
    bool flush() noexcept;
    bool put(std::int64_t place, const char* data, std::size_t bytes) noexcept;

    int descriptor_;
    std::string name_;
    Places places_;
    int error_ = 0;  // of the first write that failed, as errno has it
    std::vector<char> collected_;
    std::int64_t collected_at_ = 0;  // in the file
    std::int64_t end_ = 0;           // of what append() wrote
};

}  // namespace pxm::host
