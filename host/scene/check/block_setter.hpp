// One directive of one block, set from outside: which block a key names, and its new value.
#pragma once

#include <string>
#include <vector>

#include "host/scene/check/settings.hpp"
#include "host/scene/parse/block_parser.hpp"

namespace pxm::host {

class BlockSetter {
  public:
    BlockSetter(Scene& scene, const Constants& constants, Diagnostics& diagnostics)
        : scene_(scene), constants_(constants), diagnostics_(diagnostics) {}

    /// Reads the value into the block that the key names: BLOCK.DIRECTIVE, BLOCK.NAME.DIRECTIVE, or
    /// ifs.NAME.MAP.DIRECTIVE. Reports what is wrong and throws SyntaxError.
    void set(const Setting& setting);

  private:
    void set_in_map(IfsBlock& ifs);
    void read(const AnyBlock& block);
    template <class Block>
    Block& chosen(std::vector<Block>& blocks);
    template <class Block>
    Block& only(std::optional<Block>& block);
    [[noreturn]] void fail(const std::string& message);

    Scene& scene_;
    const Constants& constants_;
    Diagnostics& diagnostics_;
    std::vector<std::string> key_;  // the words between the dots
    std::string text_;              // the directive as a scene would have it
};

}  // namespace pxm::host
