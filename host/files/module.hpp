// Modules: what few runs need is loaded by those.
#pragma once

namespace pxm::host {

/// The function of that name in the module of that name, which is loaded and stays. Throws Error of
/// kind `failed`: the `library` that it brings, as a sentence begins, cannot be loaded, and why.
[[nodiscard]] void* module_function(const char* name, const char* function, const char* library);

}  // namespace pxm::host
