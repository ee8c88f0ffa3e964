// Random scenes as text, with every block, directive and form of value that the parser's own table
// knows (host/scene/parse/grammar.hpp): a directive that it gets and that has no form here stops
// every scene with a message that says so. What is written is a scene without a mistake.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "host/scene/parse/grammar.hpp"
#include "tests/support/campaign/draw.hpp"
#include "tests/support/campaign/number_forms.hpp"

namespace pxm::test {

class SceneGrammar {
  public:
    explicit SceneGrammar(std::uint64_t seed);

    /// The text; it includes part_file and shows picture_file, which lie beside it.
    [[nodiscard]] std::string scene();

    static constexpr const char* part_file = "part.pxm";
    static constexpr const char* picture_file = "picture.ppm";
    [[nodiscard]] static std::string part_text();
    [[nodiscard]] static std::string picture_bytes();

    /// The blocks and directives that have a form here, as "block.directive".
    [[nodiscard]] std::vector<std::string> known_directives() const;

  private:
    /// What a whole scene is like, so that its directives go together.
    enum class Mode { plain, fast, wide, area, modes };

    using Writer = std::function<std::string()>;
    void add_fractal_writers();
    void add_object_writers();
    void add_floor_writers();
    void add_view_writers();
    void add_render_writers();
    void write(const std::string& directive, Writer writer) { writers_[directive] = writer; }

    /// The directive with its values, as the table says that it has some.
    std::string directive(const std::string& block, const std::string& word);
    std::string block(const host::BlockGrammar& grammar, const std::string& name,
                      const std::vector<std::string>& lines);
    /// Some of a block's directives that stand alone, each with that chance.
    std::vector<std::string> some(const host::BlockGrammar& grammar, int one_in,
                                  const std::vector<std::string>& without = {});
    std::string ifs(const std::string& name, bool flat);
    std::string map(int number, bool flat);
    std::string ends();
    std::string object(int number);
    std::string texture(const std::string& name);
    std::string reference();
    std::string gap();

    template <class Words>
    std::string word_of(const Words& words) {
        return std::string(
            words[static_cast<std::size_t>(draw_.below(static_cast<int>(words.size())))].text);
    }
    std::string rgb() { return forms_.list({draw_.between(0, 1), draw_.between(0, 1), 0.5}); }
    std::string vector(double most);
    std::string point(double most);

    Draw draw_;
    Mode mode_;
    KnownNames names_;
    NumberForms forms_;
    std::map<std::string, Writer> writers_;
    int maps_ = 0;  // of the ifs that is being written
    std::vector<std::string> textures_;
};

}  // namespace pxm::test
