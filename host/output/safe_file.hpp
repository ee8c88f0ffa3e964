// Files that are there whole or not at all: written beside their place, then renamed.
#pragma once

#include <functional>
#include <string>

namespace pxm::host {

/// Calls `write` with a path beside `path` (same folder, same extension) and renames what it wrote
/// to `path`. If `write` throws, nothing is left behind and `path` is as before. Throws
/// Error(ExitCode::file) if the file cannot be put into place.
void write_safely(const std::string& path, const std::function<void(const std::string&)>& write);

/// Writes a text file safely.
void write_text_safely(const std::string& path, const std::string& text);

/// Throws Error(ExitCode::file) unless a file could be written at `path`: to be called before work
/// whose result would otherwise be lost.
void require_writable(const std::string& path);

}  // namespace pxm::host
