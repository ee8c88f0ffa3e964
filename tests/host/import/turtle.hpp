// An L-system drawn the plain way: the word of level n is written out, and a turtle walks it.
#pragma once

#include <complex>
#include <map>
#include <string>
#include <vector>

#include "host/import/fractint/fractint_l.hpp"

namespace pxm::host::test {

using Complex = std::complex<double>;

/// The word of level n, one character after another as FRACTINT reads them.
inline std::string word_of_level(const FractintL& l, const std::string& axiom, int level) {
    std::string word = axiom;
    for (int n = 0; n < level; ++n) {
        std::string next;
        for (const char c : word) {
            const auto rule = l.rules.find(c);
            rule == l.rules.end() ? next.push_back(c) : void(next += rule->second.text);
        }
        word = next;
    }
    return word;
}

struct Drawing {
    std::vector<Complex> points;  // of the strokes, at most `spacing` apart
    Complex end;
};

inline Drawing draw(const FractintL& l, const std::string& word, double spacing) {
    struct Turtle {
        Complex place{0.0};
        double degrees = 0;
        double step = 1;
        double side = 1;
    };
    Turtle turtle;
    std::vector<Turtle> stack;
    Drawing drawing;
    const double angle = 360 / l.angle.value_or(1);
    for (std::size_t i = 0; i < word.size(); ++i) {
        const char c = word[i];
        const auto number = [&] {
            std::size_t used = 0;
            const double value = std::stod(word.substr(i + 1, 12), &used);
            i += used;
            return value;
        };
        if (c == '+' || c == '-') turtle.degrees += (c == '+' ? 1 : -1) * turtle.side * angle;
        if (c == '\\' || c == '/') turtle.degrees += (c == '\\' ? 1 : -1) * turtle.side * number();
        if (c == '|') turtle.degrees += 180;
        if (c == '!') turtle.side = -turtle.side;
        if (c == '[') stack.push_back(turtle);
        if (c == ']') {
            turtle = stack.back();
            stack.pop_back();
        }
        if (c == '@') {
            bool inverse = false;
            bool root = false;
            for (; word[i + 1] == 'i' || word[i + 1] == 'q'; ++i)
                (word[i + 1] == 'i' ? inverse : root) = true;
            double factor = number();
            if (root) factor = std::sqrt(factor);
            turtle.step *= inverse ? 1 / factor : factor;
        }
        if (c != 'f' && c != 'd' && c != 'g' && c != 'm') continue;
        const Complex step = std::polar(turtle.step, turtle.degrees * std::acos(-1.0) / 180);
        const int parts = std::max(1, static_cast<int>(std::ceil(turtle.step / spacing)));
        for (int k = 0; (c == 'f' || c == 'd') && k <= parts; ++k)
            drawing.points.push_back(turtle.place + step * (static_cast<double>(k) / parts));
        turtle.place += step;
    }
    drawing.end = turtle.place;
    return drawing;
}

}  // namespace pxm::host::test
