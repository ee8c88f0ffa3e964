// What the options take: one word for a kind of file or text, or all the words there are. It stands
// in the help and in the manual, and is what shells complete.
//   SCENE  a scene's file or name      FILE, FILE.json  a file      DIR  a folder
//   ENTRY  of the file that is imported
//   a|b|c  one of these words          a|b|c,...  several of them
#pragma once

#include <string>
#include <vector>

namespace pxm::host {

struct ValueName {
    std::string command;  // empty: every command that has such an option
    std::string option;
    std::string value;
};

[[nodiscard]] std::vector<ValueName> value_names();

}  // namespace pxm::host
